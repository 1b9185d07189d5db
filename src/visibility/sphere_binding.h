#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "visibility/sphere.h"

namespace haarlight {

/// How spheres follow the vertices of a mesh (docs/dynamic.md), for any number of meshes and
/// spheres. A sphere has a list of entries, one for each vertex x_k that it follows:
///
///   centre  c = o + Σ a_k (x_k − o), o the position of the list's first vertex
///   radius² = mean · Σ b_k |x_k − c|² + reach · max g_k |x_k − c|²
///
/// With Σ a_k = 1 and Σ a_k x_k = c at rest every affine motion of the vertices moves the centre by
/// that motion. Spheres decide bits, so the numeric contract holds (docs/numerics.md): float32, fma
/// for all three products that are summed, the canonical order (base/canonical_order.h), and
/// squareRoot(). Twins: opencl/move_spheres.cl and cuda/move_spheres.cu.
struct SphereBinding {
  /// Entries listStarts[i] … listStarts[i + 1] − 1 belong to sphere i; multiples of 32. Lists are
  /// filled up with entries of weight 0 that repeat their first vertex.
  std::vector<std::uint32_t> listStarts{0};
  /// By entry: number of the vertex.
  std::vector<std::uint32_t> vertices;
  /// By entry: a_k, b_k, g_k, 0; b_k and g_k are not negative.
  std::vector<glm::vec4> weights;
  /// By sphere: mean, reach; not negative.
  std::vector<glm::vec2> radiusFactors;

  std::size_t sphereCount() const { return radiusFactors.size(); }

  /// Adds a sphere with a list of at least one entry, and fills the list up; `factors` are mean and
  /// reach.
  void add(std::span<const std::uint32_t> listVertices, std::span<const glm::vec4> listWeights,
           const glm::vec2& factors);

  /// Puts the spheres of another binding behind these; its vertex 0 is vertex `firstVertex` of the
  /// positions that both get.
  void append(const SphereBinding& other, std::uint32_t firstVertex);
};

/// Where the spheres are when the vertices are at `positions` (x, y, z, any).
std::vector<Sphere> moveSpheres(const SphereBinding& binding, std::span<const glm::vec4> positions);

/// √x for finite x >= 0 with the same bits on every device, without the device's own square root:
/// an estimate from the exponent, three steps of Newton's method for 1/√x, and one correction by
/// fma. 0 for 0, the nearest float32 number from 2⁻¹⁰² on, and at most 1 ULP from the exact root
/// from 2⁻¹²⁶ on; for denormal x some number below 2⁻⁵⁰.
float squareRoot(float x);

}  // namespace haarlight
