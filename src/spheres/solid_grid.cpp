#include "spheres/solid_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <numeric>

#include "base/parallel.h"
#include "mesh/inside_test.h"
#include "mesh/mesh_measures.h"
#include "mesh/ray_scene.h"

namespace haarlight {

SolidGrid::SolidGrid(const TriangleMesh& mesh, int cells) {
  const BoundingBox box = boundingBox(mesh);
  const glm::dvec3 extent = glm::dvec3(box.upper) - glm::dvec3(box.lower);
  cellSize_ = std::max({extent.x, extent.y, extent.z}) / cells;
  lower_ = box.lower;
  size_ = glm::max(glm::ivec3(glm::ceil(extent / cellSize_)), glm::ivec3(1));

  std::vector<std::uint8_t> votes(std::size_t(size_.x) * size_.y * size_.z);
  const RayScene scene(mesh);
  for (int axis = 0; axis < 3; ++axis) vote(scene, axis, votes);
  sumRows(votes);
}

std::size_t SolidGrid::cellIndex(const glm::ivec3& cell) const {
  return (std::size_t(cell.z) * size_.y + cell.y) * size_.x + cell.x;
}

glm::dvec3 SolidGrid::cellCenter(const glm::ivec3& cell) const {
  return lower_ + (glm::dvec3(cell) + 0.5) * cellSize_;
}

/// A cell gets a vote from each of the two ends of its row from which it lies behind an unequal
/// number of surface sides entered and left.
void SolidGrid::vote(const RayScene& scene, int axis, std::vector<std::uint8_t>& votes) const {
  const int second = (axis + 1) % 3, third = (axis + 2) % 3;
  glm::vec3 direction(0);
  direction[axis] = 1;
  const auto castRow = [&](std::size_t row) {
    glm::ivec3 cell(0);
    cell[second] = static_cast<int>(row) % size_[second];
    cell[third] = static_cast<int>(row) / size_[second];
    glm::dvec3 start = cellCenter(cell);
    // Off the centre by a little, since rays through vertices and edges of a regular mesh are
    // where counts may go wrong.
    start[second] += 0.0137 * cellSize_;
    start[third] += 0.0073 * cellSize_;
    start[axis] = lower_[axis] - cellSize_;
    const auto crossings = crossingsAlong(scene, glm::vec3(start), direction);
    int ahead = 0, behind = 0;
    for (const Crossing& crossing : crossings) ahead += crossing.turn;
    auto next = crossings.begin();
    for (int i = 0; i < size_[axis]; ++i) {
      cell[axis] = i;
      for (; next != crossings.end() && next->distance < (i + 1.5) * cellSize_; ++next) {
        behind -= next->turn;
        ahead -= next->turn;
      }
      votes[cellIndex(cell)] += static_cast<std::uint8_t>((behind != 0) + (ahead != 0));
    }
  };
  parallelFor(std::size_t(size_[second]) * size_[third], 256,
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t row = begin; row < end; ++row) castRow(row);
              });
}

void SolidGrid::sumRows(const std::vector<std::uint8_t>& votes) {
  constexpr int allVotes = 6;
  insideBefore_.reserve(votes.size() + std::size_t(size_.y) * size_.z);
  for (int z = 0; z < size_.z; ++z)
    for (int y = 0; y < size_.y; ++y) {
      std::uint16_t count = 0;
      insideBefore_.push_back(0);
      for (int x = 0; x < size_.x; ++x)
        insideBefore_.push_back(count += 2 * votes[cellIndex({x, y, z})] > allVotes);
    }
}

double SolidGrid::volume() const {
  double cells = 0;
  for (int row = 0; row < size_.y * size_.z; ++row)
    cells += insideBefore_[std::size_t(row + 1) * (size_.x + 1) - 1];
  return cells * cellSize_ * cellSize_ * cellSize_;
}

std::vector<glm::vec3> SolidGrid::insidePoints(std::size_t count) const {
  const double cells = volume() / (cellSize_ * cellSize_ * cellSize_);
  const double step = std::max(1.0, cells / static_cast<double>(count));
  std::vector<glm::vec3> points;
  double next = step / 2;
  double passed = 0;
  for (int z = 0; z < size_.z; ++z)
    for (int y = 0; y < size_.y; ++y)
      for (int x = 0; x < size_.x; ++x) {
        passed += insideLength(y, z, x, x + 1.0);
        if (passed < next) continue;
        points.emplace_back(cellCenter({x, y, z}));
        next += step;
      }
  return points;
}

/// Inside length of a row between two places, all in cells.
inline double SolidGrid::insideLength(int y, int z, double begin, double end) const {
  const std::uint16_t* row =
      &insideBefore_[(std::size_t(z) * size_.y + y) * (std::size_t(size_.x) + 1)];
  const auto before = [&](double place) {
    if (place <= 0) return 0.0;
    if (place >= size_.x) return double(row[size_.x]);
    const int cell = static_cast<int>(place);
    return row[cell] + (place - cell) * (row[cell + 1] - row[cell]);
  };
  return before(end) - before(begin);
}

double SolidGrid::outsideVolume(const Ball& ball) const {
  const glm::dvec3 center = (ball.center - lower_) / cellSize_;
  const double radius = ball.radius / cellSize_;
  const auto firstRow = [&](double at) { return static_cast<int>(std::ceil(at - radius - 0.5)); };
  const auto lastRow = [&](double at) { return static_cast<int>(std::floor(at + radius - 0.5)); };
  double whole = 0, inside = 0;
  for (int z = firstRow(center.z); z <= lastRow(center.z); ++z) {
    const double dz = z + 0.5 - center.z;
    for (int y = firstRow(center.y); y <= lastRow(center.y); ++y) {
      const double dy = y + 0.5 - center.y;
      const double square = radius * radius - dy * dy - dz * dz;
      if (square <= 0) continue;
      const double half = std::sqrt(square);
      whole += 2 * half;
      if (y >= 0 && y < size_.y && z >= 0 && z < size_.z)
        inside += insideLength(y, z, center.x - half, center.x + half);
    }
  }
  const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(ball.radius, 3);
  if (whole > 0) return volume * (1 - inside / whole);
  // A ball between the rows: as the cell that it lies in.
  const glm::ivec3 cell = glm::floor(center);
  const bool inGrid = cell.x >= 0 && cell.x < size_.x && cell.y >= 0 && cell.y < size_.y &&
                      cell.z >= 0 && cell.z < size_.z;
  return inGrid && insideLength(cell.y, cell.z, cell.x, cell.x + 1.0) > 0.5 ? 0 : volume;
}

}  // namespace haarlight
