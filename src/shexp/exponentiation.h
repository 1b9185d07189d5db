#pragma once

/// Visibility past many spheres by spherical-harmonic exponentiation, in single precision: the
/// scalar reference of engines.
///
/// The logarithms of the spheres' visibilities, each zonal about the direction to its sphere, are
/// added; the sum is exponentiated once. With f the sum, m its mean, f̂ = f − m, and p the number of
/// halvings that bring ‖f̂‖ to the tables' limit:
///
///     V = (e^(m/2^p) (a + b f̂/2^p)) squared p times,    a and b by the norm ‖f̂‖/2^p
///
/// The mean's share goes in before squaring (the paper multiplies by it at the end), so that no
/// intermediate function is far above 1.
///
/// Every engine gives the same bits (docs/numerics.md): float32 additions, products and fma in the
/// order written here, no quotient and no root of the device. Sphere k is added to partial sum
/// k mod 32, coefficient by coefficient, and the partial sums as a tree (base/canonical_order.h).
/// The terms of a square's coefficient go into two sums in turn.

#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "shexp/tables.h"
#include "visibility/sphere.h"

namespace haarlight {

/// Coefficients in the order of sh/basis.h; those beyond order² are 0.
using ShexpVector = std::array<float, largestShexpCount>;

/// Logarithm of the visibility past one sphere, seen from a sample with unit `normal`, added to a
/// sum: by fma, coefficient by coefficient. Spheres that contain the sample or lie below its
/// tangent plane follow the rule of docs/method.md: cos²α = max(1 − R²/d², 0, 16 min(0, v·n)²).
void addSphereLogarithm(const ShexpTables& tables, const Sphere& sphere,
                        const glm::vec3& samplePosition, const glm::vec3& sampleNormal,
                        ShexpVector& sum);

/// The sum over all spheres.
ShexpVector sphereLogarithms(const ShexpTables& tables, std::span<const Sphere> spheres,
                             const glm::vec3& samplePosition, const glm::vec3& sampleNormal);

/// Visibility past all spheres: exp of that sum.
ShexpVector shexpVisibility(const ShexpTables& tables, std::span<const Sphere> spheres,
                            const glm::vec3& samplePosition, const glm::vec3& sampleNormal);

/// The square of a function, projected to its order.
ShexpVector shexpSquare(const ShexpTables& tables, const ShexpVector& g);

/// exp f. A function that `mostHalvings` leave above the limit is not halved further.
ShexpVector shexpExponential(const ShexpTables& tables, const ShexpVector& f,
                             int mostHalvings = 24);

}  // namespace haarlight
