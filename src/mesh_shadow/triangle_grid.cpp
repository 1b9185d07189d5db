#include "mesh_shadow/triangle_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>

namespace haarlight {

TriangleGrid::TriangleGrid(std::span<const BoxedTriangle> triangles) : triangles_(triangles) {
  chooseSize();
  ends_.assign(index(size_ - 1) + 1, 0);
  firsts_.reserve(triangles_.size());
  for (const BoxedTriangle& triangle : triangles_)
    firsts_.push_back(coordinatesAt(triangle.bounds.lower));
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    forEachCell(i, [&](std::size_t cell) { ++ends_[cell]; });
  std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
  items_.resize(ends_.back());
  // Backwards, so that each cell's end becomes its begin, and its triangles ascend.
  for (std::size_t i = triangles_.size(); i-- > 0;)
    forEachCell(i, [&](std::size_t cell) { items_[--ends_[cell]] = std::uint32_t(i); });
  std::shift_left(ends_.begin(), ends_.end(), 1);
  ends_.back() = std::uint32_t(items_.size());
}

/// Cells about as large as the mean triangle, and no more of them than a few for each triangle.
void TriangleGrid::chooseSize() {
  AxisBox bounds;
  double sum = 0;
  for (const BoxedTriangle& triangle : triangles_) {
    bounds = united(bounds, triangle.bounds);
    sum += triangle.size;
  }
  if (triangles_.empty() || sum == 0) return;
  lower_ = bounds.lower;
  const glm::dvec3 extent = bounds.upper - bounds.lower;
  const double mostCells = 8.0 * double(triangles_.size()) + 1;
  double edge = sum / double(triangles_.size());
  const auto cells = [&] { return glm::floor(extent / edge) + 1.0; };
  while (cells().x * cells().y * cells().z > mostCells) edge *= 1.25;
  size_ = glm::ivec3(cells());
  perLength_ = glm::dvec3(1 / edge);
}

glm::ivec3 TriangleGrid::coordinatesAt(const glm::dvec3& point) const {
  return glm::min(glm::ivec3((point - lower_) * perLength_), size_ - 1);
}

std::span<const std::uint32_t> TriangleGrid::inCell(std::size_t cell) const {
  const std::size_t begin = cell == 0 ? 0 : ends_[cell - 1];
  return std::span(items_).subspan(begin, ends_[cell] - begin);
}

std::uint64_t TriangleGrid::pairCount() const {
  std::uint64_t count = 0;
  for (std::size_t cell = 0; cell < cellCount(); ++cell) {
    const std::uint64_t own = inCell(cell).size();
    count += own * (own - (own > 0)) / 2;
  }
  return count;
}

template <typename Visit>
void TriangleGrid::forEachCell(std::size_t triangle, const Visit& visit) const {
  const glm::ivec3 first = firsts_[triangle],
                   last = coordinatesAt(triangles_[triangle].bounds.upper);
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x) visit(index({x, y, z}));
}

}  // namespace haarlight
