// The texels of a face's row that caps block: one interval.

// Coordinate of the centre of a row or column.
__device__ inline float centerCoordinate(int index) {
  return float(2 * index + 1 - FACE_SIZE) * 0.03125f;
}

// A row of a face: c.D = atCenter + s * alongS, |c|^2 = lengthSquared + s^2.
struct Rows {
  float atCenter, lengthSquared, alongS, rim;
};

__device__ inline Rows rowsAt(const FaceCaps* caps, float t) {
  const Rows rows = {caps->major + t * caps->alongT, 1.0f + t * t, caps->alongS, caps->rim};
  return rows;
}

__device__ inline bool isBlocked(Rows rows, int column) {
  const float s = centerCoordinate(column);
  const float dotProduct = rows.atCenter + s * rows.alongS;
  return dotProduct >= 0.0f && dotProduct * dotProduct >= (rows.lengthSquared + s * s) * rows.rim;
}

// By Cauchy's inequality (c.D)^2 <= (atCenter^2 / lengthSquared + alongS^2) |c|^2.
__device__ inline bool mayBeBlocked(Rows rows) {
  const float ahead = fmaxf(rows.atCenter, 0.0f);
  const float bound = ahead * ahead + rows.alongS * rows.alongS * rows.lengthSquared;
  return bound * CAUTION >= rows.lengthSquared * rows.rim;
}

// Column of the place where the angle to the sphere's centre is least.
__device__ inline int nearestColumn(Rows rows) {
  const float place = rows.alongS * rows.lengthSquared;
  int column = 0;
  for (int step = 16; step > 0; step /= 2) {
    const float border = float(column + step - 16) * 0.0625f * rows.atCenter;
    column = place >= border ? column + step : column;
  }
  const int end = rows.alongS > 0.0f ? FACE_SIZE - 1 : 0;
  return rows.atCenter > 0.0f ? column : end;
}

// A blocked column, if there is one; else any.
__device__ inline int blockedColumn(Rows rows) {
  const int nearest = nearestColumn(rows);
  const int left = max(nearest - 1, 0), right = min(nearest + 1, FACE_SIZE - 1);
  return isBlocked(rows, nearest) ? nearest : isBlocked(rows, left) ? left : right;
}

__device__ inline uint columnBits(int first, int last) {
  return (~0u << first) & (~0u >> (FACE_SIZE - 1 - last));
}

// The ends of the interval by bisection with the test itself.
__device__ inline uint rowBitsByBisection(Rows rows) {
  const int inside = blockedColumn(rows);
  int first = inside, last = inside;
  for (int step = 16; step > 0; step /= 2) {
    first = first >= step && isBlocked(rows, first - step) ? first - step : first;
    last = last + step < FACE_SIZE && isBlocked(rows, last + step) ? last + step : last;
  }
  return isBlocked(rows, inside) ? columnBits(first, last) : 0u;
}

// sqrt(x) / ROOT_SCALE within 0.07 %: one step of Newton's method, with factors that spread its error.
__device__ inline float scaledRoot(float x) {
  const float inverse = __uint_as_float(0x5f1ffff9u - (__float_as_uint(x) >> 1));
  const float root = x * inverse;
  return root * (2.38924456f - root * inverse);
}

// Added to a place that is counted from the centre of column 0, this rounds it to the nearest column and
// leaves the column's number in the last bits: float32 has steps of 1/16 there, a column's width.
#define COLUMN_ROUNDER 786432.0f
#define FIRST_COLUMN 0.96875f
#define LAST_BITS (FACE_SIZE - 1u)

// For places ahead of the sample, where c.D > 0.
__device__ inline bool isBlockedAt(Rows rows, float place) {
  const float s = place - FIRST_COLUMN;
  const float dotProduct = rows.atCenter + s * rows.alongS;
  return dotProduct * dotProduct >= (rows.lengthSquared + s * s) * rows.rim;
}

// The interval from the roots of (c.D)^2 = |c|^2 rim, a quadratic in s. A root is so near to the true
// one that all columns but the nearest are clear; that one is left to the test.
__device__ inline uint intervalOfRow(const FaceCaps* caps, Rows rows) {
  const float discriminant = rows.atCenter * rows.atCenter - rows.lengthSquared * caps->leading;
  const float reach = scaledRoot(fmaxf(discriminant, 1e-30f)) * caps->reach;
  const float middle = FIRST_COLUMN + rows.atCenter * caps->middle;
  const float low = 0.0f, high = 2.0f * FIRST_COLUMN;
  const float begin = fminf(fmaxf(middle - reach, low), high) + COLUMN_ROUNDER,
              end = fminf(fmaxf(middle + reach, low), high) + COLUMN_ROUNDER;
  const uint all = ~0u;
  const uint fromBegin = isBlockedAt(rows, begin - COLUMN_ROUNDER) ? all : all << 1,
             toEnd = isBlockedAt(rows, end - COLUMN_ROUNDER) ? all : all >> 1;
  const uint bits = (fromBegin << (__float_as_uint(begin) & LAST_BITS)) &
                    (toEnd >> (~__float_as_uint(end) & LAST_BITS));
  return rows.atCenter > 0.0f ? bits : 0;
}

// From -1 to 32.
__device__ inline int nearestColumnTo(float place) {
  const float low = -1.0f, high = float(FACE_SIZE);
  return int(fminf(fmaxf(place, low), high) + 1.5f) - 1;
}

// Where a cap holds one end of the s axis, all columns from the root on that side: the root is
// (lengthSquared rim - atCenter^2) / (product + root) or (root - product) / |leading|, of which one
// takes no difference of nearly equal numbers. s runs towards the held end here.
__device__ inline uint oneSidedRow(const FaceCaps* caps, Rows rows) {
  const bool turned = rows.alongS < 0.0f;
  const float product = rows.atCenter * fabsf(rows.alongS), square = rows.atCenter * rows.atCenter;
  const float discriminant =
      fmaxf(caps->rim * (square - rows.lengthSquared * caps->leading), 1e-30f);
  const float root = discriminant * nearInverseRoot(discriminant);
  const float inverse = nearInverseRoot(fmaxf(product + root, 1e-30f));
  const float ahead = (rows.lengthSquared * caps->rim - square) * (inverse * inverse),
              behind = (root - product) * caps->inverseLeading;
  const float begin = product > 0.0f ? ahead : behind;
  const int near = nearestColumnTo(15.5f + 16.0f * begin);
  const int column = turned ? FACE_SIZE - 1 - near : near;
  const int first = max(isBlocked(rows, column) ? near : near + 1, 0);
  const uint all = ~0u, shift = uint(min(first, FACE_SIZE - 1));
  return first < FACE_SIZE ? (turned ? all >> shift : all << shift) : 0;
}
