#pragma once

/// Coefficients of other conventions to those of sh/basis.h and back. All are exact up to rounding:
/// changes of sign, or rotations by a right angle.

#include "sh/rotation.h"
#include "sh/vector.h"

namespace haarlight {

/// Adds or takes away the Condon–Shortley sign (−1)^m; applied twice it changes nothing. Without
/// the sign band 1 is √(3/4π) (y, z, x), as in many shaders.
template <typename Value>
ShVector<Value> flipCondonShortley(ShVector<Value> f) {
  for (int l = 0; l < f.order(); ++l)
    for (int m = -l; m <= l; ++m)
      if (m % 2) f.at(l, m) = -f.at(l, m);
  return f;
}

/// The world's axes: a function whose coefficients were taken with directions of a y-up world, for
/// use with directions of a z-up world, both right-handed: up (0, 1, 0) becomes (0, 0, 1), x stays,
/// (x, y, z) is (x, −z, y).
template <typename Value>
ShVector<Value> yUpToZUp(const ShVector<Value>& f) {
  return ShRotation(glm::dmat3(1, 0, 0, 0, 0, 1, 0, -1, 0), f.order())(f);
}

/// The inverse of yUpToZUp: (x, y, z) is (x, z, −y).
template <typename Value>
ShVector<Value> zUpToYUp(const ShVector<Value>& f) {
  return ShRotation(glm::dmat3(1, 0, 0, 0, 0, -1, 0, 1, 0), f.order())(f);
}

/// The basis' axes, in one and the same world: libraries for y-up worlds often measure θ from +y
/// and φ from +z towards +x, so that their functions are y_lm(z, x, y). Takes their coefficients to
/// this library's, whose θ is measured from +z.
template <typename Value>
ShVector<Value> polarYToPolarZ(const ShVector<Value>& f) {
  return ShRotation(glm::dmat3(0, 0, 1, 1, 0, 0, 0, 1, 0), f.order())(f);
}

/// The inverse of polarYToPolarZ.
template <typename Value>
ShVector<Value> polarZToPolarY(const ShVector<Value>& f) {
  return ShRotation(glm::dmat3(0, 1, 0, 0, 0, 1, 1, 0, 0), f.order())(f);
}

}  // namespace haarlight
