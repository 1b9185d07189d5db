#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solids/axis_box.h"

namespace haarlight {

/// Objects, by their numbers, and smaller families that belong together.
struct Family {
  std::vector<std::uint32_t> objects;
  std::vector<Family> families;
};

/// A binary tree of axis-parallel boxes over the boxes of objects.
class BoxTree {
 public:
  /// A leaf has an object; any other node two children, and the smallest box around theirs.
  struct Node {
    static constexpr std::uint32_t none = ~std::uint32_t(0);

    AxisBox box;
    std::uint32_t children[2]{none, none};
    std::uint32_t object = none;

    bool isLeaf() const { return object != none; }
  };

  /// Object i has boxes[i]; one whose box is empty is left out. Each family gets a node of its own,
  /// below which there is nothing else. Inside of a family, and among all families and objects that
  /// belong to none, the tree is built by itself: halved by number along the axis on which the
  /// boxes' middles lie furthest apart. Throws InputError when a box is not finite, or a family
  /// names an object that does not exist or is named elsewhere too.
  explicit BoxTree(std::span<const AxisBox> boxes, std::span<const Family> families = {});

  /// Children come before parents.
  const std::vector<Node>& nodes() const { return nodes_; }

  /// Whether there is no object.
  bool isEmpty() const { return nodes_.empty(); }

  /// Not for an empty tree.
  std::uint32_t root() const { return std::uint32_t(nodes_.size() - 1); }

 private:
  class Builder;

  std::vector<Node> nodes_;
};

}  // namespace haarlight
