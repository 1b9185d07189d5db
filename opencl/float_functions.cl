// Functions of float32 numbers that give the same bits everywhere, and tables of equal steps: twins
// of src/shexp/float_functions.h and of src/shexp/exponentiation.cpp.

// Elements of a table, another one for every lane.
#if LANES_PER_ITEM == 1
#define OF_TABLE(table, index) ((table)[index])
#else
#define OF_TABLE(table, index)                                                                    \
  (LaneFloat)((table)[(index).s0], (table)[(index).s1], (table)[(index).s2], (table)[(index).s3], \
              (table)[(index).s4], (table)[(index).s5], (table)[(index).s6], (table)[(index).s7], \
              (table)[(index).s8], (table)[(index).s9], (table)[(index).sa], (table)[(index).sb], \
              (table)[(index).sc], (table)[(index).sd], (table)[(index).se], (table)[(index).sf])
#endif

inline LaneFloat smaller(LaneFloat a, LaneFloat b) { return select(a, b, b < a); }

inline LaneFloat larger(LaneFloat a, LaneFloat b) { return select(a, b, a < b); }

// Radiance that is not above zero, which ringing can give, is none; nor does zero keep a sign.
inline float positivePart(float x) { return x > 0.0f ? x : 0.0f; }

inline LaneFloat inverseSquareRoot(LaneFloat x) {
  LaneFloat inverse = LANE_FLOAT_OF_BITS(0x5f3759dfu - (BITS_OF_LANE_FLOAT(x) >> 1));
  const LaneFloat halved = 0.5f * x;
  for (int step = 0; step < 3; ++step)
    inverse = inverse * fma(-(halved * inverse), inverse, (LaneFloat)(1.5f));
  return inverse;
}

inline LaneFloat rootOf(LaneFloat x) { return x * inverseSquareRoot(x); }

inline LaneFloat exponential(LaneFloat x) {
  const LaneFloat clamped = larger((LaneFloat)(-87.0f), smaller(x, (LaneFloat)(87.0f)));
  const LaneFloat toNearest = select((LaneFloat)(0.5f), (LaneFloat)(-0.5f), clamped < 0.0f);
  const LaneInt exponent = TO_LANE_INT(fma(clamped, (LaneFloat)(0x1.715476p0f), toNearest));
  const LaneFloat multiple = TO_LANE_FLOAT(exponent);
  const LaneFloat rest = fma(-multiple, (LaneFloat)(0x1.7f7d1cp-20f),
                             fma(-multiple, (LaneFloat)(0x1.62e4p-1f), clamped));
  LaneFloat sum = (LaneFloat)(0x1.a01a02p-13f);
  sum = fma(sum, rest, (LaneFloat)(0x1.6c16c2p-10f));
  sum = fma(sum, rest, (LaneFloat)(0x1.111112p-7f));
  sum = fma(sum, rest, (LaneFloat)(0x1.555556p-5f));
  sum = fma(sum, rest, (LaneFloat)(0x1.555556p-3f));
  sum = fma(sum, rest, (LaneFloat)(0.5f));
  sum = fma(sum, rest, (LaneFloat)(1.0f));
  sum = fma(sum, rest, (LaneFloat)(1.0f));
  return sum * LANE_FLOAT_OF_BITS(TO_LANE_UINT(exponent + 127) << 23);
}

inline LaneFloat interpolate(LaneFloat fraction, LaneFloat a, LaneFloat b) {
  return fma(fraction, b - a, a);
}

// Between a row of a table and the next.
typedef struct {
  LaneInt row;
  LaneFloat fraction;
} TablePlace;

inline TablePlace placeInTable(LaneFloat scaled, int rows) {
  const LaneInt row = TO_LANE_INT(smaller((LaneFloat)(rows - 1), scaled));
  const TablePlace place = {row, scaled - TO_LANE_FLOAT(row)};
  return place;
}
