// Spheres as caps on the directions around a sample, and on the faces of its cube. Twin of
// src/visibility/exact_visibility.cpp where bits are decided: the same operations in the same order.

// Bounds by which faces and rows are passed over get this factor, far above their rounding errors,
// so that no texel is lost.
#define CAUTION 1.00001f

// Within 0.0005 %.
inline LaneFloat nearInverseRoot(LaneFloat x) {
  LaneFloat inverse = LANE_FLOAT_OF_BITS(0x5f3759dfu - (BITS_OF_LANE_FLOAT(x) >> 1));
  const LaneFloat part = 0.5f * x;
  inverse = inverse * (1.5f - part * inverse * inverse);
  return inverse * (1.5f - part * inverse * inverse);
}

// Within some roundings.
inline LaneFloat nearReciprocal(LaneFloat x) {
  LaneFloat inverse = LANE_FLOAT_OF_BITS(0x7ef311c7u - BITS_OF_LANE_FLOAT(x));
  inverse = inverse * (2.0f - x * inverse);
  inverse = inverse * (2.0f - x * inverse);
  return inverse * (2.0f - x * inverse);
}

// A sphere seen from a sample: vector to its centre, d^2 cos^2 alpha and nearly its root.
typedef struct {
  LaneFloat x, y, z, rim, rimRoot;
} Caps;

inline Caps capsOf(SeenSpheres seen) {
  const LaneFloat distanceSquared = (seen.x * seen.x + seen.y * seen.y) + seen.z * seen.z;
  const LaneFloat radiusSquared = seen.radius * seen.radius;
  const LaneFloat depth = fmin(seen.height, (LaneFloat)0.0f);
  const LaneFloat limit = (float)HORIZON_FACTOR * depth * depth;
  const LaneFloat rim = fmax(fmax(distanceSquared - radiusSquared, (LaneFloat)0.0f), limit);
  const LaneFloat positive = fmax(rim, (LaneFloat)1e-30f);
  const Caps caps = {seen.x, seen.y, seen.z, rim, positive * nearInverseRoot(positive)};
  return caps;
}

// Caps on a face: components of the vector to the centre along the face's direction and its s and t
// axes, and what all rows of the face need for the ends of their intervals.
typedef struct {
  LaneFloat major, alongS, alongT, rim;
  LaneFloat leading;         // rim - alongS^2
  LaneFloat inverseLeading;  // 1 / |leading|, nearly
  LaneFloat reach, middle;   // of roots, over what depends on the row
} FaceCaps;

// scaledRoot() times this is a root.
#define ROOT_SCALE 0.703952253f

inline FaceCaps faceCaps(LaneFloat major, LaneFloat alongS, LaneFloat alongT, const Caps* caps) {
  const LaneFloat leading = caps->rim - alongS * alongS;
  const LaneFloat inverse = nearReciprocal(fabs(leading));
  const FaceCaps own = {major, alongS, alongT, caps->rim, leading, inverse,
                        ROOT_SCALE * caps->rimRoot * inverse, alongS * inverse};
  return own;
}

inline FaceCaps onFace(uint face, const Caps* caps) {
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
inline LaneInt haveSafeEnds(const FaceCaps* caps) {
  const LaneFloat height = fabs(caps->major) + fabs(caps->alongT);
  const LaneFloat most = 18.0f * caps->leading;
  return (caps->leading > 1e-10f) & (caps->rim < 1e15f) & (64.0f * caps->leading > caps->rim) &
         (height * height * caps->rim < most * most);
}

// Whether caps hold the direction of the face's s axis, clearly, or that against it: rows have one end
// then, and oneSidedRow() finds it.
inline LaneInt holdAxis(const FaceCaps* caps) {
  return (caps->leading < -1e-10f) & (caps->rim < 1e15f) & (64.0f * caps->leading < -caps->rim);
}

// Whether caps reach neither beyond the face's rows nor beyond its columns (`alongT`, `alongS`
// exchanged), a cap per lane. By Cauchy's inequality (c.D)^2 / |c|^2 <= (major + t alongT)^2 /
// (1 + t^2) + alongS^2, which is largest at t = 1 when the sphere's centre is beyond the face's edge.
inline LaneInt isBeyondEdge(LaneFloat major, LaneFloat alongT, LaneFloat alongS, LaneFloat rim) {
  const LaneFloat atEdge = fmax(major + fabs(alongT), (LaneFloat)0.0f);
  const LaneFloat bound = 0.5f * (atEdge * atEdge) + alongS * alongS;
  return (fabs(alongT) > major) & (bound * CAUTION < rim);
}

// Bit f is set when face f may be reached. The signs of components along s and t do not matter here.
inline LaneInt reachedFaces(LaneFloat x, LaneFloat y, LaneFloat z, LaneFloat rim) {
  LaneInt faces = 0;
#define REACH(face, major, s, t)                                                                \
  faces |= select((LaneInt)(1 << (face)), (LaneInt)0,                                           \
                  isBeyondEdge(major, t, s, rim) | isBeyondEdge(major, s, t, rim));
  REACH(0, x, z, y)
  REACH(1, -x, z, y)
  REACH(2, y, x, z)
  REACH(3, -y, x, z)
  REACH(4, z, x, y)
  REACH(5, -z, x, y)
#undef REACH
  return faces;
}
