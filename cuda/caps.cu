// Spheres as caps on the directions around a sample, and on the faces of its cube. Twin of
// src/visibility/exact_visibility.cpp where bits are decided: the same operations in the same order.

// Bounds by which faces and rows are passed over get this factor, far above their rounding errors,
// so that no texel is lost.
#define CAUTION 1.00001f

// Within 0.0005 %.
__device__ inline float nearInverseRoot(float x) {
  float inverse = __uint_as_float(0x5f3759dfu - (__float_as_uint(x) >> 1));
  const float part = 0.5f * x;
  inverse = inverse * (1.5f - part * inverse * inverse);
  return inverse * (1.5f - part * inverse * inverse);
}

// Within some roundings.
__device__ inline float nearReciprocal(float x) {
  float inverse = __uint_as_float(0x7ef311c7u - __float_as_uint(x));
  inverse = inverse * (2.0f - x * inverse);
  inverse = inverse * (2.0f - x * inverse);
  return inverse * (2.0f - x * inverse);
}

// A sphere seen from a sample: vector to its centre, d^2 cos^2 alpha and nearly its root.
struct Caps {
  float x, y, z, rim, rimRoot;
};

__device__ inline Caps capsOf(SeenSpheres seen) {
  const float distanceSquared = (seen.x * seen.x + seen.y * seen.y) + seen.z * seen.z;
  const float radiusSquared = seen.radius * seen.radius;
  const float depth = fminf(seen.height, 0.0f);
  const float limit = float(HORIZON_FACTOR) * depth * depth;
  const float rim = fmaxf(fmaxf(distanceSquared - radiusSquared, 0.0f), limit);
  const float positive = fmaxf(rim, 1e-30f);
  const Caps caps = {seen.x, seen.y, seen.z, rim, positive * nearInverseRoot(positive)};
  return caps;
}

// Caps on a face: components of the vector to the centre along the face's direction and its s and t
// axes, and what all rows of the face need for the ends of their intervals.
struct FaceCaps {
  float major, alongS, alongT, rim;
  float leading;         // rim - alongS^2
  float inverseLeading;  // 1 / |leading|, nearly
  float reach, middle;   // of roots, over what depends on the row
};

// scaledRoot() times this is a root.
#define ROOT_SCALE 0.703952253f

__device__ inline FaceCaps faceCaps(float major, float alongS, float alongT, const Caps* caps) {
  const float leading = caps->rim - alongS * alongS;
  const float inverse = nearReciprocal(fabsf(leading));
  const FaceCaps own = {major, alongS, alongT, caps->rim, leading, inverse,
                        ROOT_SCALE * caps->rimRoot * inverse, alongS * inverse};
  return own;
}

__device__ inline FaceCaps onFace(uint face, const Caps* caps) {
  switch (face) {
    case 0: return faceCaps(caps->x, -caps->z, -caps->y, caps);
    case 1: return faceCaps(-caps->x, caps->z, -caps->y, caps);
    case 2: return faceCaps(caps->y, caps->x, caps->z, caps);
    case 3: return faceCaps(-caps->y, caps->x, -caps->z, caps);
    case 4: return faceCaps(caps->z, caps->x, -caps->y, caps);
    default: return faceCaps(-caps->z, -caps->x, -caps->y, caps);
  }
}

// Whether the ends of intervals that intervalOfRow() finds are less than half a column wrong, and
// products stay within float32. Roots are within 300 columns of the face's centre then, so that an
// error of 0.07 % moves them by less than a quarter, and the rounding of `leading` by less than a tenth.
__device__ inline bool haveSafeEnds(const FaceCaps* caps) {
  const float height = fabsf(caps->major) + fabsf(caps->alongT);
  const float most = 18.0f * caps->leading;
  return caps->leading > 1e-10f && caps->rim < 1e15f && 64.0f * caps->leading > caps->rim &&
         height * height * caps->rim < most * most;
}

// Whether caps hold the direction of the face's s axis, clearly, or that against it: rows have one end
// then, and oneSidedRow() finds it.
__device__ inline bool holdAxis(const FaceCaps* caps) {
  return caps->leading < -1e-10f && caps->rim < 1e15f && 64.0f * caps->leading < -caps->rim;
}

// Whether the lane's cap reaches neither beyond the face's rows nor beyond its columns (`alongT`,
// `alongS` exchanged). By Cauchy's inequality
// (c.D)^2 / |c|^2 <= (major + t alongT)^2 / (1 + t^2) + alongS^2,
// which is largest at t = 1 when the sphere's centre is beyond the face's edge.
__device__ inline bool isBeyondEdge(float major, float alongT, float alongS, float rim) {
  const float atEdge = fmaxf(major + fabsf(alongT), 0.0f);
  const float bound = 0.5f * (atEdge * atEdge) + alongS * alongS;
  return fabsf(alongT) > major && bound * CAUTION < rim;
}

// Bit f is set when face f may be reached. The signs of components along s and t do not matter here.
__device__ inline uint reachedFaces(float x, float y, float z, float rim) {
  uint faces = 0;
#define REACH(face, major, s, t) \
  if (!isBeyondEdge(major, t, s, rim) && !isBeyondEdge(major, s, t, rim)) faces |= 1u << (face);
  REACH(0, x, z, y)
  REACH(1, -x, z, y)
  REACH(2, y, x, z)
  REACH(3, -y, x, z)
  REACH(4, z, x, y)
  REACH(5, -z, x, y)
#undef REACH
  return faces;
}
