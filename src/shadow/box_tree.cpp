#include "shadow/box_tree.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"

namespace haarlight {

namespace {

void checkBox(std::size_t object, const AxisBox& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(box.lower[axis]) || !std::isfinite(box.upper[axis]))
      throw InputError("object " + std::to_string(object) +
                       ": its box must have finite coordinates to take part in shadows");
}

int longestAxis(const AxisBox& box) {
  const glm::dvec3 size = box.upper - box.lower;
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

}  // namespace

class BoxTree::Builder {
 public:
  Builder(std::vector<Node>& nodes, std::span<const AxisBox> boxes)
      : nodes_(nodes), boxes_(boxes), taken_(boxes.size(), false) {}

  void build(std::span<const Family> families) {
    std::vector<std::uint32_t> items = joinedFamilies(families);
    for (std::uint32_t object = 0; object < boxes_.size(); ++object)
      if (!taken_[object]) addObject(items, object);
    if (!items.empty()) join(items);
  }

 private:
  using Items = std::vector<std::uint32_t>;  ///< nodes without a parent

  Items joinedFamilies(std::span<const Family> families) {
    Items result;
    for (const Family& family : families) {
      Items members = joinedFamilies(family.families);
      for (const std::uint32_t object : family.objects) addMember(members, object);
      if (!members.empty()) result.push_back(join(members));
    }
    return result;
  }

  void addMember(Items& members, std::uint32_t object) {
    if (object >= boxes_.size())
      throw InputError("a family names object " + std::to_string(object) + ", but there are only " +
                       std::to_string(boxes_.size()) + ", counted from 0");
    if (taken_[object])
      throw InputError("object " + std::to_string(object) +
                       " is named twice in families; it can have one place only");
    addObject(members, object);
  }

  void addObject(Items& items, std::uint32_t object) {
    taken_[object] = true;
    if (boxes_[object].isEmpty()) return;
    checkBox(object, boxes_[object]);
    items.push_back(add({boxes_[object], {Node::none, Node::none}, object}));
  }

  std::uint32_t add(const Node& node) {
    nodes_.push_back(node);
    return std::uint32_t(nodes_.size() - 1);
  }

  /// One node over some, which are reordered.
  std::uint32_t join(std::span<std::uint32_t> items) {
    if (items.size() == 1) return items[0];
    AxisBox middles;
    for (const std::uint32_t item : items) middles = united(middles, {middle(item), middle(item)});
    const int axis = longestAxis(middles);
    const std::size_t half = items.size() / 2;
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(middle(a)[axis], a) < std::pair(middle(b)[axis], b);
    };
    std::nth_element(items.begin(), items.begin() + std::ptrdiff_t(half), items.end(), before);
    const std::uint32_t first = join(items.first(half)), second = join(items.subspan(half));
    return add({united(nodes_[first].box, nodes_[second].box), {first, second}, Node::none});
  }

  glm::dvec3 middle(std::uint32_t node) const { return nodes_[node].box.center(); }

  std::vector<Node>& nodes_;
  std::span<const AxisBox> boxes_;
  std::vector<bool> taken_;
};

BoxTree::BoxTree(std::span<const AxisBox> boxes, std::span<const Family> families) {
  Builder(nodes_, boxes).build(families);
}

}  // namespace haarlight
