// What the caps of a tile's samples may reach, for 16 spheres at a time: an element of a vector has a
// sphere of its own here. All samples lie in a ball; what a sphere blocks from any place in it, a sphere
// that is larger by the ball's radius blocks from its middle.

#if LANES_PER_ITEM == 1
// A sample is a tile of its own, and its caps say themselves what they reach (caps.cl).
#else

inline float addFloats(float16 v) {
  return (((v.s0 + v.s1) + (v.s2 + v.s3)) + ((v.s4 + v.s5) + (v.s6 + v.s7))) +
         (((v.s8 + v.s9) + (v.sa + v.sb)) + ((v.sc + v.sd) + (v.se + v.sf)));
}

inline float largestElement(float16 v) {
  const float a = fmax(fmax(fmax(v.s0, v.s1), fmax(v.s2, v.s3)),
                       fmax(fmax(v.s4, v.s5), fmax(v.s6, v.s7)));
  const float b = fmax(fmax(fmax(v.s8, v.s9), fmax(v.sa, v.sb)),
                       fmax(fmax(v.sc, v.sd), fmax(v.se, v.sf)));
  return fmax(a, b);
}

typedef struct {
  float x, y, z, radius;
} TileBall;

inline TileBall ballOf(const Tile* tile) {
  const float share = 1.0f / TILE;
  const float x = share * addFloats(tile->x), y = share * addFloats(tile->y),
              z = share * addFloats(tile->z);
  const LaneFloat toX = tile->x - x, toY = tile->y - y, toZ = tile->z - z;
  const LaneFloat squares =
      fmin(fmax((toX * toX + toY * toY) + toZ * toZ, (LaneFloat)1e-30f), (LaneFloat)1e30f);
  const TileBall ball = {x, y, z, CAUTION * largestElement(squares * nearInverseRoot(squares))};
  return ball;
}

// Rows or columns that caps may reach, first | end << 8, from the roots of the quadratic
// (major + t along)^2 / (1 + t^2) = rest and a fifth of a row more; `rest` is rim less the square of the
// component along the other axis. All of them where roots are not known to a tenth of a row.
inline LaneInt reachedRange(LaneFloat major, LaneFloat along, LaneFloat rest, LaneFloat rim) {
  const LaneFloat square = along * along, leading = rest - square;
  const LaneFloat scale = 0.5f * FACE_SIZE * nearReciprocal(leading);
  const LaneFloat discriminant =
      fmax(rest * ((major * major + square) - rest), (LaneFloat)1e-30f);
  const LaneFloat reach = discriminant * nearInverseRoot(discriminant) * scale + 0.2f;
  const LaneFloat middle = 0.5f * (FACE_SIZE + 1) + (major * along) * scale;
  const LaneFloat low = (LaneFloat)0.0f, high = (LaneFloat)FACE_SIZE;
  const LaneFloat height = fabs(major) + fabs(along), most = 250.0f * leading;
  const LaneInt known = (leading > 1e-10f) & (64.0f * leading > rim) &
                        (height * height * rim < most * most);
  const LaneFloat first = select(low, fmin(fmax(middle - reach, low), high), known),
                  end = select(high, fmin(fmax(middle + reach, low), high), known);
  return TO_LANE_INT(first) | TO_LANE_INT(end) << 8;
}

// For every sphere the faces it may reach, then face by face rows and columns: first row | end << 8 |
// first column << 16 | end << 24. Rounding is covered by the factors on squares: caps are decided with
// errors of 10^-6 d^2.
#define REACH_VECTORS (1 + FACES)
inline void reachedByTile(const TileBall* ball, __global const float* spheres, uint stride,
                          __local LaneInt* reached) {
  const LaneFloat x = *(__global const LaneFloat*)spheres - ball->x,
                  y = *(__global const LaneFloat*)(spheres + stride) - ball->y,
                  z = *(__global const LaneFloat*)(spheres + 2 * stride) - ball->z,
                  radius = *(__global const LaneFloat*)(spheres + 3 * stride) + ball->radius;
  const LaneFloat distanceSquared = (x * x + y * y) + z * z;
  const LaneFloat rim =
      fmax(distanceSquared * 0.99999f - radius * radius * 1.001f, (LaneFloat)0.0f);
  const LaneInt known = (rim > 1e-20f) & (distanceSquared < 1e15f);
  const LaneFloat restX = rim - x * x, restY = rim - y * y, restZ = rim - z * z;
  const LaneInt everything = FACE_SIZE << 8 | FACE_SIZE << 24;
  reached[0] = select((LaneInt)((1 << FACES) - 1), reachedFaces(x, y, z, rim), known);
#define RANGES(face, major, s, t, restS, restT)                                     \
  reached[1 + (face)] = select(everything,                                          \
                               reachedRange(major, t, restS, rim) |                 \
                                   reachedRange(major, s, restT, rim) << 16, known);
  RANGES(0, x, -z, -y, restZ, restY)
  RANGES(1, -x, z, -y, restZ, restY)
  RANGES(2, y, x, z, restX, restZ)
  RANGES(3, -y, x, -z, restX, restZ)
  RANGES(4, z, x, -y, restX, restY)
  RANGES(5, -z, -x, -y, restX, restY)
#undef RANGES
}

// Rows of a range, as bits, without those whose columns of the range all samples have blocked already.
inline uint openRows(uint range, __local const uint* covered) {
  const uint first = range & 0xff, end = range >> 8 & 0xff;
  const uint columns = (uint)((1ul << (range >> 24)) - (1ul << (range >> 16 & 0xff)));
  if (range >> 24 <= (range >> 16 & 0xff)) return 0;
  uint open = 0;
  for (uint row = first; row < end; ++row) open |= (columns & ~covered[row] ? 1u : 0u) << row;
  return open;
}
#endif
