#include "spheres/sphere_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "base/parallel.h"
#include "spheres/enclosing_ball.h"
#include "spheres/free_disc_part.h"

namespace haarlight {

namespace {

float roundedUp(double value) {
  const float nearest = static_cast<float>(value);
  return nearest < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
                         : nearest;
}

/// Gives the node the ball with that centre that reaches just around the spheres.
void enclose(SphereTreeNode& node, const glm::vec3& center, std::span<const Sphere> spheres) {
  double radius = 0;
  for (const Sphere& sphere : spheres) radius = std::max(radius, reach(ballOf(sphere), center));
  node.center = center;
  node.radius = roundedUp(radius);
}

std::vector<Sphere> gathered(std::span<const Sphere> spheres,
                             std::span<const std::uint32_t> indices) {
  std::vector<Sphere> result;
  result.reserve(indices.size());
  for (const std::uint32_t index : indices) result.push_back(spheres[index]);
  return result;
}

/// Sorts groups of a set into the order of a tree's leaves.
class TopDownSplit {
 public:
  explicit TopDownSplit(std::span<const Sphere> spheres) : spheres_(spheres) {}

  /// Adds the nodes of the subtree over `group`, which stands in the leaves from `firstLeaf` on,
  /// and sorts it; balls and errors are left open.
  void build(std::span<std::uint32_t> group, std::uint32_t firstLeaf,
             std::vector<SphereTreeNode>& nodes) const {
    const auto count = static_cast<std::uint32_t>(group.size());
    const auto next = static_cast<std::uint32_t>(nodes.size()) + 2 * count - 1;
    nodes.push_back({{}, 0, firstLeaf, count, next, 0});
    if (count == 1) return;
    const std::uint32_t firstCount = split(group);
    build(group.first(firstCount), firstLeaf, nodes);
    build(group.subspan(firstCount), firstLeaf + firstCount, nodes);
  }

 private:
  static constexpr std::size_t bins = 16;

  struct Choice {
    /// Cost in float, lest rounding decides between equal ones; then how uneven the parts are.
    std::pair<float, std::uint32_t> cost{std::numeric_limits<float>::infinity(), 0};
    int axis = 0;
    std::uint32_t firstCount = 0;
  };

  void sort(std::span<std::uint32_t> group, int axis) const {
    std::sort(group.begin(), group.end(), [&](std::uint32_t i, std::uint32_t j) {
      return std::pair(spheres_[i].center[axis], i) < std::pair(spheres_[j].center[axis], j);
    });
  }

  /// Sorts the group so that its two parts follow each other; returns the first's size.
  std::uint32_t split(std::span<std::uint32_t> group) const {
    Choice best;
    for (int axis = 0; axis < 3; ++axis) {
      sort(group, axis);
      const Choice choice = bestAlong(axis, gathered(spheres_, group));
      if (axis == 0 || choice.cost < best.cost) best = choice;
    }
    sort(group, best.axis);
    return best.firstCount;
  }

  static double cost(std::span<const Sphere> part) {
    const double radius = minimumEnclosingBall(part).radius;
    return double(part.size()) * radius * radius;
  }

  /// Where the gap between consecutive centres of the sorted group is widest, of the sizes of the
  /// first part from `begin` up to, not including, `end`.
  static std::uint32_t widestGap(int axis, std::span<const Sphere> group, std::uint32_t begin,
                                 std::uint32_t end) {
    const auto gap = [&](std::uint32_t i) {
      return double(group[i].center[axis]) - group[i - 1].center[axis];
    };
    std::uint32_t widest = begin;
    for (std::uint32_t i = begin + 1; i < end; ++i)
      if (gap(i) > gap(widest)) widest = i;
    return widest;
  }

  /// Compares splits of the sorted group about its quantiles, one each.
  static Choice bestAlong(int axis, std::span<const Sphere> group) {
    const std::size_t count = group.size(), parts = std::min(bins, count);
    const auto halfBins = [&](std::size_t number) {
      return static_cast<std::uint32_t>((number * count + 2 * parts - 1) / (2 * parts));
    };
    Choice best;
    for (std::size_t i = 1; i < parts; ++i) {
      const std::uint32_t firstCount =
          widestGap(axis, group, halfBins(2 * i - 1), halfBins(2 * i + 1));
      const double sum = cost(group.first(firstCount)) + cost(group.subspan(firstCount));
      const std::pair key(static_cast<float>(sum),
                          std::max(firstCount, std::uint32_t(count) - firstCount));
      if (i == 1 || key < best.cost) best = {key, axis, firstCount};
    }
    return best;
  }

  std::span<const Sphere> spheres_;
};

}  // namespace

bool mayStandForGroup(const SphereTreeNode& node, const glm::vec3& receiver, double maximumError) {
  if (node.leafCount == 1) return true;
  const glm::dvec3 toBall = glm::dvec3(node.center) - glm::dvec3(receiver);
  const double squaredDistance = glm::dot(toBall, toBall);
  const double squaredRadius = double(node.radius) * node.radius, error = node.error;
  if (error <= 2 * maximumError) return squaredRadius < squaredDistance;
  // error · (1 - cos θ) / 2 ≤ m with sin θ = R / d, solved for R² / d².
  return error * error * squaredRadius <=
         4 * maximumError * (error - maximumError) * squaredDistance;
}

SphereTree::SphereTree(std::span<const Sphere> spheres) : leaves_(spheres.size()) {
  if (spheres.empty()) return;
  std::iota(leaves_.begin(), leaves_.end(), 0u);
  nodes_.reserve(2 * spheres.size() - 1);
  TopDownSplit(spheres).build(leaves_, 0, nodes_);
  const std::vector<Sphere> ordered = gathered(spheres, leaves_);
  parallelFor(nodes_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      SphereTreeNode& node = nodes_[i];
      const auto group = std::span(ordered).subspan(node.firstLeaf, node.leafCount);
      enclose(node, minimumEnclosingBall(group).center, group);
      if (node.leafCount > 1)
        node.error = static_cast<float>(meanFreePart({node.center, node.radius}, group));
    }
  });
}

void SphereTree::refit(std::span<const Sphere> moved) {
  if (moved.size() != leaves_.size())
    throw std::invalid_argument("a sphere tree is refitted to as many spheres as it was built for");
  const std::vector<Sphere> ordered = gathered(moved, leaves_);
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    SphereTreeNode& node = nodes_[i];
    const auto group = std::span(ordered).subspan(node.firstLeaf, node.leafCount);
    glm::vec3 center = group[0].center;
    if (node.leafCount > 1) {
      const SphereTreeNode &first = nodes_[i + 1], &second = nodes_[first.next];
      const Sphere children[] = {{first.center, first.radius}, {second.center, second.radius}};
      center = minimumEnclosingBall(children).center;
    }
    enclose(node, center, group);
  }
}

std::vector<Sphere> SphereTree::cut(const glm::vec3& receiver, double maximumError) const {
  std::vector<Sphere> balls;
  visit(
      [&](const SphereTreeNode& node) {
        const bool enough = mayStandForGroup(node, receiver, maximumError);
        if (enough) balls.push_back({node.center, node.radius});
        return !enough;
      },
      [](std::uint32_t) {});
  return balls;
}

}  // namespace haarlight
