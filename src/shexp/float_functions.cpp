#include "shexp/float_functions.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace haarlight {

float inverseSquareRoot(float x) {
  float inverse = std::bit_cast<float>(0x5f3759dfu - (std::bit_cast<std::uint32_t>(x) >> 1));
  const float halved = 0.5f * x;
  for (int step = 0; step < 3; ++step)
    inverse = inverse * std::fma(-(halved * inverse), inverse, 1.5f);
  return inverse;
}

float exponential(float x) {
  // ln 2 in two parts; the first has so few digits that its multiples are exact.
  constexpr float log2e = 0x1.715476p0f, ln2High = 0x1.62e4p-1f, ln2Low = 0x1.7f7d1cp-20f;
  constexpr float inverseFactorials[] = {1 / 5040.0f, 1 / 720.0f, 1 / 120.0f, 1 / 24.0f,
                                         1 / 6.0f,    0.5f,       1.0f,       1.0f};
  const float clamped = std::max(-87.0f, std::min(x, 87.0f));
  const int exponent = int(std::fma(clamped, log2e, clamped < 0 ? -0.5f : 0.5f));
  const float multiple = float(exponent);
  const float rest = std::fma(-multiple, ln2Low, std::fma(-multiple, ln2High, clamped));
  float sum = inverseFactorials[0];
  for (int power = 1; power < 8; ++power) sum = std::fma(sum, rest, inverseFactorials[power]);
  return sum * std::bit_cast<float>(std::uint32_t(exponent + 127) << 23);
}

}  // namespace haarlight
