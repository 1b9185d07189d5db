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

namespace {

constexpr int allVotes = 6;

/// Means over two cells each way; cells beyond the end of an odd side are outside.
std::vector<float> halved(const std::vector<float>& inside, const glm::ivec3& size) {
  const glm::ivec3 half = (size + 1) / 2;
  std::vector<float> means(std::size_t(half.x) * half.y * half.z);
  const float* cell = inside.data();
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        means[(std::size_t(z / 2) * half.y + y / 2) * half.x + x / 2] += *cell++ / 8;
  return means;
}

}  // namespace

SolidGrid::SolidGrid(const TriangleMesh& mesh, int cells) {
  const BoundingBox box = boundingBox(mesh);
  const glm::dvec3 extent = glm::dvec3(box.upper) - glm::dvec3(box.lower);
  cellSize_ = std::max({extent.x, extent.y, extent.z}) / cells;
  lower_ = box.lower;
  size_ = glm::max(glm::ivec3(glm::ceil(extent / cellSize_)), glm::ivec3(1));

  std::vector<std::uint8_t> votes(std::size_t(size_.x) * size_.y * size_.z);
  const RayScene scene(mesh);
  for (int axis = 0; axis < 3; ++axis) vote(scene, axis, votes);

  constexpr int smallestSide = 8;
  std::vector<float> inside(votes.size());
  settleVotes(mesh, votes);
  std::ranges::transform(votes, inside.begin(), [](int count) { return count == allVotes; });
  glm::ivec3 size = size_;
  double cellSize = cellSize_;
  addLevel(inside, size, cellSize);
  while (std::max({size.x, size.y, size.z}) > smallestSide) {
    inside = halved(inside, size);
    size = (size + 1) / 2;
    addLevel(inside, size, cellSize *= 2);
  }
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

/// Rays are quick but see touching faces as one and look through holes: where they do not agree,
/// the winding number decides.
void SolidGrid::settleVotes(const TriangleMesh& mesh, std::vector<std::uint8_t>& votes) const {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < votes.size(); ++i)
    if (votes[i] > 0 && votes[i] < allVotes) open.push_back(i);
  if (open.empty()) return;
  const InsideTest inside(mesh);
  parallelFor(open.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const auto i = static_cast<int>(open[k]);
      const glm::ivec3 cell(i % size_.x, i / size_.x % size_.y, i / size_.x / size_.y);
      votes[open[k]] = inside.contains(glm::vec3(cellCenter(cell))) ? allVotes : 0;
    }
  });
}

void SolidGrid::addLevel(const std::vector<float>& inside, const glm::ivec3& size,
                         double cellSize) {
  Level level{cellSize, size, {}};
  level.insideBefore.reserve(inside.size() + std::size_t(2) * size.y * size.z);
  const float* cell = inside.data();
  for (int row = 0; row < size.y * size.z; ++row) {
    float sum = 0;
    level.insideBefore.push_back(0);
    for (int x = 0; x < size.x; ++x) level.insideBefore.push_back(sum += *cell++);
    level.insideBefore.push_back(sum);
  }
  levels_.push_back(std::move(level));
}

int SolidGrid::levelFor(double radius, double cells) const {
  int level = 0;
  while (level + 1 < int(levels_.size()) && levels_[level + 1].cellSize * cells <= radius) ++level;
  return level;
}

double SolidGrid::volume() const {
  double cells = 0;
  for (int row = 0; row < size_.y * size_.z; ++row)
    cells += levels_[0].insideBefore[std::size_t(row + 1) * (size_.x + 2) - 1];
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
        passed += levels_[0].insideLength(y, z, float(x), float(x) + 1);
        if (passed < next) continue;
        points.emplace_back(cellCenter({x, y, z}));
        next += step;
      }
  return points;
}

/// Inside length of a row between two places, all in cells.
inline float SolidGrid::Level::insideLength(int y, int z, float begin, float end) const {
  const float* row = &insideBefore[(std::size_t(z) * size.y + y) * (std::size_t(size.x) + 2)];
  const auto last = static_cast<float>(size.x);
  const auto before = [&](float place) {
    place = std::min(std::max(place, 0.0f), last);
    const int cell = static_cast<int>(place);
    return row[cell] + (place - static_cast<float>(cell)) * (row[cell + 1] - row[cell]);
  };
  return before(end) - before(begin);
}

double SolidGrid::outsideVolume(const Ball& ball, int level) const {
  const Level& grid = levels_[std::size_t(level)];
  const glm::vec3 center((ball.center - lower_) / grid.cellSize);
  const auto radius = static_cast<float>(ball.radius / grid.cellSize);
  const auto firstRow = [&](float at) { return static_cast<int>(std::ceil(at - radius - 0.5f)); };
  const auto lastRow = [&](float at) { return static_cast<int>(std::floor(at + radius - 0.5f)); };
  double whole = 0, inside = 0;
  for (int z = firstRow(center.z); z <= lastRow(center.z); ++z) {
    const float dz = float(z) + 0.5f - center.z, disc = radius * radius - dz * dz;
    float wholeSlice = 0, insideSlice = 0;
    for (int y = firstRow(center.y), last = lastRow(center.y); y <= last; ++y) {
      const float dy = float(y) + 0.5f - center.y, square = disc - dy * dy;
      if (square <= 0) continue;
      const float half = std::sqrt(square);
      wholeSlice += 2 * half;
      if (unsigned(y) < unsigned(grid.size.y) && unsigned(z) < unsigned(grid.size.z))
        insideSlice += grid.insideLength(y, z, center.x - half, center.x + half);
    }
    whole += wholeSlice;
    inside += insideSlice;
  }
  const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(ball.radius, 3);
  if (whole > 0) return volume * (1 - inside / whole);
  // A ball between the rows: as the cell that it lies in.
  const glm::ivec3 cell(glm::floor(center));
  const bool inGrid = cell.x >= 0 && cell.x < grid.size.x && cell.y >= 0 && cell.y < grid.size.y &&
                      cell.z >= 0 && cell.z < grid.size.z;
  return inGrid ? volume * (1 - grid.insideLength(cell.y, cell.z, float(cell.x), float(cell.x) + 1))
                : volume;
}

}  // namespace haarlight
