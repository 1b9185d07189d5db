#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh_shadow/triangle_box.h"

namespace haarlight {

/// Which triangles lie next to each other: a grid of cells about as large as triangles, each with
/// the numbers of those whose boxes it meets.
class TriangleGrid {
 public:
  /// The triangles must stay.
  explicit TriangleGrid(std::span<const BoxedTriangle> triangles);

  std::size_t cellCount() const { return ends_.size(); }
  /// How many pairs forEachPair compares in all cells.
  std::uint64_t pairCount() const;

  /// Calls visit(a, b) for pairs whose boxes have a point in common; in all cells together, once
  /// for each pair.
  template <typename Visit>
  void forEachPair(std::size_t cell, const Visit& visit) const {
    const std::span<const std::uint32_t> own = inCell(cell);
    for (std::size_t i = 0; i < own.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        // The first cell that both meet.
        const glm::ivec3 first = glm::max(firsts_[own[i]], firsts_[own[k]]);
        if (index(first) == cell && overlap(triangles_[own[i]].bounds, triangles_[own[k]].bounds))
          visit(own[k], own[i]);
      }
  }

 private:
  glm::ivec3 coordinatesAt(const glm::dvec3& point) const;
  std::size_t index(const glm::ivec3& c) const {
    return (std::size_t(c.z) * std::size_t(size_.y) + std::size_t(c.y)) * std::size_t(size_.x) +
           std::size_t(c.x);
  }
  std::span<const std::uint32_t> inCell(std::size_t cell) const;
  void chooseSize();
  template <typename Visit>
  void forEachCell(std::size_t triangle, const Visit& visit) const;

  std::span<const BoxedTriangle> triangles_;
  glm::dvec3 lower_{0}, perLength_{0};  ///< cells per length
  glm::ivec3 size_{1};
  std::vector<glm::ivec3> firsts_;  ///< the lowest cell of each triangle
  std::vector<std::uint32_t> ends_, items_;
};

}  // namespace haarlight
