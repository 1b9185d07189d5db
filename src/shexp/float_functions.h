#pragma once

/// Functions of float32 numbers that give the same bits on every engine: additions, products, fma,
/// comparisons and bits only (docs/numerics.md).

namespace haarlight {

/// 1/√x for a normal x > 0 within 2e-7 relative: an estimate from the exponent and three steps of
/// Newton's method. For 0 some finite number.
float inverseSquareRoot(float x);

/// e^x within 3e-7 relative for −87 ≤ x ≤ 87; beyond, its value at that end.
float exponential(float x);

/// x above 0, and else +0: radiance is never below zero, which ringing can give, and zero keeps no
/// sign.
inline float positivePart(float x) {
  return x > 0 ? x : 0.0f;
}

}  // namespace haarlight
