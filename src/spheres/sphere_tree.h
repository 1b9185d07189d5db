#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "visibility/sphere.h"

namespace haarlight {

/// A ball around a group of spheres. The layout (32 bytes, two float4) is made for upload.
struct SphereTreeNode {
  glm::vec3 center;  ///< world units, like the spheres
  float radius;
  std::uint32_t firstLeaf;  ///< the group is leaves()[firstLeaf … firstLeaf + leafCount - 1]
  std::uint32_t leafCount;  ///< 1: the node is a leaf, and its ball is the sphere itself
  std::uint32_t next;       ///< the node after this one's subtree
  /// The part of the ball's disc that the group leaves free, as a mean over the directions from
  /// which it is seen from afar: what the ball would block wrongly. 0 … 1, 0 for a leaf.
  float error;
};
static_assert(sizeof(SphereTreeNode) == 32);

/// Whether the node's ball may stand for its group at `receiver`: the receiver lies outside the
/// ball, and error · (the ball's solid angle / 4π) is at most `maximumError`. A leaf always may.
/// With error 1 this is the test R < sin θ · d of Ren et al. 2006. Neither divides nor takes roots.
bool mayStandForGroup(const SphereTreeNode& node, const glm::vec3& receiver, double maximumError);

/// A binary tree of balls over a set of spheres, to skip groups that a receiver cannot see and to
/// let one ball stand for a group that is far away.
///
/// The nodes lie in depth-first order in one array: the first child follows its parent, the second
/// follows the first's subtree, so that a traversal needs an index and no stack. Two children
/// rather than four give the finest choice of groups. Every ball contains the spheres of its group
/// exactly (distance + radius, in double, of the floats), but not always its children's balls.
class SphereTree {
 public:
  /// A tree without nodes, as for an empty set.
  SphereTree() = default;

  /// Splits the set top-down where the sum of (spheres × squared radius of the ball around them) of
  /// the two parts is least, and takes for each group its smallest enclosing ball. For n spheres
  /// there are 2n - 1 nodes on at most 16 + ln n / ln (32/31) levels. Needs finite spheres. The
  /// result does not depend on the number of threads.
  explicit SphereTree(std::span<const Sphere> spheres);

  /// In depth-first order; the root is the first.
  std::span<const SphereTreeNode> nodes() const { return nodes_; }

  /// For each leaf, the index of its sphere in the set.
  std::span<const std::uint32_t> leaves() const { return leaves_; }

  /// Encloses the same spheres where they have moved, in the order of the set, without building the
  /// tree again: bottom-up, each ball has the centre of the ball around its children's and reaches
  /// just around its group, in O(levels · n). Such balls are no longer the smallest ones, and the
  /// errors stay those of the set that the tree was built for. Throws std::invalid_argument when
  /// the number of spheres differs.
  void refit(std::span<const Sphere> moved);

  /// Goes through the tree: where descend(node) holds, on to the node's children or, at a leaf, to
  /// leaf(index of the sphere in the set); else past the subtree. Asks about leaves, too.
  template <typename Descend, typename Leaf>
  void visit(const Descend& descend, const Leaf& leaf) const {
    for (std::uint32_t i = 0; i < nodes_.size();) {
      const SphereTreeNode& node = nodes_[i];
      const bool enter = descend(node);
      if (enter && node.leafCount == 1) leaf(leaves_[node.firstLeaf]);
      i = enter ? i + 1 : node.next;
    }
  }

  /// The balls that stand for the set at `receiver`: the largest groups with mayStandForGroup, in
  /// depth-first order; with maximumError 0 these are spheres and balls that add nothing. The part
  /// of all directions that is blocked wrongly is at most about maximumError per ball; 1 / 6144
  /// is a texel of a bit cube.
  std::vector<Sphere> cut(const glm::vec3& receiver, double maximumError) const;

 private:
  std::vector<SphereTreeNode> nodes_;
  std::vector<std::uint32_t> leaves_;
};

}  // namespace haarlight
