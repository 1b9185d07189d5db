// The texels of a face's row that caps block: one interval.

// Coordinates of the centres of rows or columns.
inline LaneFloat centerCoordinate(LaneInt index) {
  return TO_LANE_FLOAT(2 * index + 1 - FACE_SIZE) * 0.03125f;
}

// A row of a face: c.D = atCenter + s * alongS, |c|^2 = lengthSquared + s^2.
typedef struct {
  LaneFloat atCenter, lengthSquared, alongS, rim;
} Rows;

inline Rows rowsAt(const FaceCaps* caps, LaneFloat t) {
  const Rows rows = {caps->major + t * caps->alongT, 1.0f + t * t, caps->alongS, caps->rim};
  return rows;
}

inline LaneInt isBlocked(Rows rows, LaneInt column) {
  const LaneFloat s = centerCoordinate(column);
  const LaneFloat dotProduct = rows.atCenter + s * rows.alongS;
  return (dotProduct >= 0.0f) &
         (dotProduct * dotProduct >= (rows.lengthSquared + s * s) * rows.rim);
}

// By Cauchy's inequality (c.D)^2 <= (atCenter^2 / lengthSquared + alongS^2) |c|^2.
inline LaneInt mayBeBlocked(Rows rows) {
  const LaneFloat ahead = fmax(rows.atCenter, (LaneFloat)0.0f);
  const LaneFloat bound = ahead * ahead + rows.alongS * rows.alongS * rows.lengthSquared;
  return bound * CAUTION >= rows.lengthSquared * rows.rim;
}

// Column of the place where the angle to the sphere's centre is least.
inline LaneInt nearestColumn(Rows rows) {
  const LaneFloat place = rows.alongS * rows.lengthSquared;
  LaneInt column = 0;
  for (int step = 16; step > 0; step /= 2) {
    const LaneFloat border = TO_LANE_FLOAT(column + step - 16) * 0.0625f * rows.atCenter;
    column = select(column, column + step, place >= border);
  }
  const LaneInt end = select((LaneInt)0, (LaneInt)(FACE_SIZE - 1), (LaneInt)(rows.alongS > 0.0f));
  return select(end, column, rows.atCenter > 0.0f);
}

// A blocked column, if there is one; else any.
inline LaneInt blockedColumn(Rows rows) {
  const LaneInt nearest = nearestColumn(rows);
  const LaneInt left = max(nearest - 1, 0), right = min(nearest + 1, FACE_SIZE - 1);
  return select(select(right, left, isBlocked(rows, left)), nearest, isBlocked(rows, nearest));
}

inline LaneUint columnBits(LaneInt first, LaneInt last) {
  const LaneUint all = ~0u;
  return (all << TO_LANE_UINT(first)) & (all >> TO_LANE_UINT(FACE_SIZE - 1 - last));
}

// The ends of the interval by bisection with the test itself.
inline LaneUint rowBitsByBisection(Rows rows) {
  const LaneInt inside = blockedColumn(rows);
  LaneInt first = inside, last = inside;
  for (int step = 16; step > 0; step /= 2) {
    first = select(first, first - step, (first >= step) & isBlocked(rows, first - step));
    last = select(last, last + step, (last + step < FACE_SIZE) & isBlocked(rows, last + step));
  }
  return select((LaneUint)0, columnBits(first, last), isBlocked(rows, inside));
}

// sqrt(x) / ROOT_SCALE within 0.07 %: one step of Newton's method, with factors that spread its error.
inline LaneFloat scaledRoot(LaneFloat x) {
  const LaneFloat inverse = LANE_FLOAT_OF_BITS(0x5f1ffff9u - (BITS_OF_LANE_FLOAT(x) >> 1));
  const LaneFloat root = x * inverse;
  return root * (2.38924456f - root * inverse);
}

// Added to a place that is counted from the centre of column 0, this rounds it to the nearest column and
// leaves the column's number in the last bits: float32 has steps of 1/16 there, a column's width.
#define COLUMN_ROUNDER 786432.0f
#define FIRST_COLUMN 0.96875f
#define LAST_BITS (FACE_SIZE - 1u)

// For places ahead of the sample, where c.D > 0.
inline LaneInt isBlockedAt(Rows rows, LaneFloat place) {
  const LaneFloat s = place - FIRST_COLUMN;
  const LaneFloat dotProduct = rows.atCenter + s * rows.alongS;
  return dotProduct * dotProduct >= (rows.lengthSquared + s * s) * rows.rim;
}

// The interval from the roots of (c.D)^2 = |c|^2 rim, a quadratic in s. A root is so near to the true
// one that all columns but the nearest are clear; that one is left to the test.
inline LaneUint intervalOfRow(const FaceCaps* caps, Rows rows) {
  const LaneFloat discriminant =
      rows.atCenter * rows.atCenter - rows.lengthSquared * caps->leading;
  const LaneFloat reach = scaledRoot(fmax(discriminant, (LaneFloat)1e-30f)) * caps->reach;
  const LaneFloat middle = FIRST_COLUMN + rows.atCenter * caps->middle;
  const LaneFloat low = (LaneFloat)0.0f, high = (LaneFloat)(2.0f * FIRST_COLUMN);
  const LaneFloat begin = fmin(fmax(middle - reach, low), high) + COLUMN_ROUNDER,
                  end = fmin(fmax(middle + reach, low), high) + COLUMN_ROUNDER;
  const LaneUint all = ~0u;
  const LaneUint fromBegin = select(all << 1, all, isBlockedAt(rows, begin - COLUMN_ROUNDER)),
                 toEnd = select(all >> 1, all, isBlockedAt(rows, end - COLUMN_ROUNDER));
  const LaneUint bits = (fromBegin << (BITS_OF_LANE_FLOAT(begin) & LAST_BITS)) &
                        (toEnd >> (~BITS_OF_LANE_FLOAT(end) & LAST_BITS));
  return select((LaneUint)0, bits, (LaneInt)(rows.atCenter > 0.0f));
}

// From -1 to 32.
inline LaneInt nearestColumnTo(LaneFloat place) {
  const LaneFloat low = (LaneFloat)-1.0f, high = (LaneFloat)FACE_SIZE;
  return TO_LANE_INT(fmin(fmax(place, low), high) + 1.5f) - 1;
}

// Where a cap holds one end of the s axis, all columns from the root on that side: the root is
// (lengthSquared rim - atCenter^2) / (product + root) or (root - product) / |leading|, of which one
// takes no difference of nearly equal numbers. s runs towards the held end here.
inline LaneUint oneSidedRow(const FaceCaps* caps, Rows rows) {
  const LaneInt turned = rows.alongS < 0.0f;
  const LaneFloat product = rows.atCenter * fabs(rows.alongS), square = rows.atCenter * rows.atCenter;
  const LaneFloat discriminant =
      fmax(caps->rim * (square - rows.lengthSquared * caps->leading), (LaneFloat)1e-30f);
  const LaneFloat root = discriminant * nearInverseRoot(discriminant);
  const LaneFloat inverse = nearInverseRoot(fmax(product + root, (LaneFloat)1e-30f));
  const LaneFloat ahead = (rows.lengthSquared * caps->rim - square) * (inverse * inverse),
                  behind = (root - product) * caps->inverseLeading;
  const LaneFloat begin = select(behind, ahead, (LaneInt)(product > 0.0f));
  const LaneInt near = nearestColumnTo(15.5f + 16.0f * begin);
  const LaneInt column = select(near, FACE_SIZE - 1 - near, turned);
  const LaneInt first = max(select(near + 1, near, isBlocked(rows, column)), (LaneInt)0);
  const LaneUint all = ~0u, shift = TO_LANE_UINT(min(first, (LaneInt)(FACE_SIZE - 1)));
  return select((LaneUint)0, select(all << shift, all >> shift, turned),
                (LaneInt)(first < FACE_SIZE));
}
