// Functions of float32 numbers that give the same bits everywhere, and tables of equal steps: twins
// of src/shexp/float_functions.h and of src/shexp/exponentiation.cpp.

__device__ inline float smaller(float a, float b) { return b < a ? b : a; }

__device__ inline float larger(float a, float b) { return a < b ? b : a; }

// Radiance that is not above zero, which ringing can give, is none; nor does zero keep a sign.
__device__ inline float positivePart(float x) { return x > 0.0f ? x : 0.0f; }

__device__ inline float inverseSquareRoot(float x) {
  float inverse = __uint_as_float(0x5f3759dfu - (__float_as_uint(x) >> 1));
  const float halved = 0.5f * x;
  for (int step = 0; step < 3; ++step)
    inverse = inverse * __fmaf_rn(-(halved * inverse), inverse, 1.5f);
  return inverse;
}

__device__ inline float rootOf(float x) { return x * inverseSquareRoot(x); }

__device__ inline float exponential(float x) {
  const float clamped = larger(-87.0f, smaller(x, 87.0f));
  const float toNearest = clamped < 0.0f ? -0.5f : 0.5f;
  const int exponent = int(__fmaf_rn(clamped, 0x1.715476p0f, toNearest));
  const float multiple = float(exponent);
  const float rest = __fmaf_rn(-multiple, 0x1.7f7d1cp-20f,
                               __fmaf_rn(-multiple, 0x1.62e4p-1f, clamped));
  float sum = 0x1.a01a02p-13f;
  sum = __fmaf_rn(sum, rest, 0x1.6c16c2p-10f);
  sum = __fmaf_rn(sum, rest, 0x1.111112p-7f);
  sum = __fmaf_rn(sum, rest, 0x1.555556p-5f);
  sum = __fmaf_rn(sum, rest, 0x1.555556p-3f);
  sum = __fmaf_rn(sum, rest, 0.5f);
  sum = __fmaf_rn(sum, rest, 1.0f);
  sum = __fmaf_rn(sum, rest, 1.0f);
  return sum * __uint_as_float(uint(exponent + 127) << 23);
}

__device__ inline float interpolate(float fraction, float a, float b) {
  return __fmaf_rn(fraction, b - a, a);
}

// Between a row of a table and the next.
struct TablePlace {
  int row;
  float fraction;
};

__device__ inline TablePlace placeInTable(float scaled, int rows) {
  const int row = int(smaller(float(rows - 1), scaled));
  const TablePlace place = {row, scaled - float(row)};
  return place;
}
