#include "shadow/shadow_pairs.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "shadow/box_shadow.h"

namespace haarlight {

namespace {

class PairWalk {
 public:
  PairWalk(const BoxTree& tree, const ShadowLight& light) : nodes_(tree.nodes()), light_(light) {}

  /// All pairs within one node.
  void visit(std::uint32_t index) {
    const BoxTree::Node& node = nodes_[index];
    if (node.isLeaf()) {
      result_.kept.push_back({node.object, node.object});
      return;
    }
    const auto [first, second] = node.children;
    visit(first);
    visit(second);
    visit({first, second, true, true});
  }

  ShadowPairs result() {
    std::sort(result_.kept.begin(), result_.kept.end());
    return std::move(result_);
  }

 private:
  /// Two nodes without a common object, and which of them may still shadow the other. What is
  /// closed for them is closed for all pairs below: the exclusion sets of all objects in them.
  struct NodePair {
    std::uint32_t first, second;
    bool firstOnSecond, secondOnFirst;
  };

  void visit(NodePair pair) {
    // The nearer one first: of the two, it is the one that may have the other wholly behind.
    if (depth(pair.first) > depth(pair.second)) {
      std::swap(pair.first, pair.second);
      std::swap(pair.firstOnSecond, pair.secondOnFirst);
    }
    test(pair.first, pair.second, pair.firstOnSecond, pair.secondOnFirst);
    test(pair.second, pair.first, pair.secondOnFirst, pair.firstOnSecond);
    if (!pair.firstOnSecond && !pair.secondOnFirst) return;
    if (nodes_[pair.first].isLeaf() && nodes_[pair.second].isLeaf())
      record(pair);
    else
      descend(pair);
  }

  /// Closes what the shadow of the caster's box rules out.
  void test(std::uint32_t caster, std::uint32_t receiver, bool& open, bool& mirroredOpen) {
    if (!open) return;
    ++result_.tested;
    const BoxShadow shadow = shadowOf(nodes_[caster].box, nodes_[receiver].box, light_);
    open = shadow != BoxShadow::none;
    result_.dropped += !open;
    if (shadow != BoxShadow::behind || !mirroredOpen) return;
    mirroredOpen = false;
    ++result_.excluded;
  }

  void record(const NodePair& pair) {
    const std::uint32_t first = nodes_[pair.first].object, second = nodes_[pair.second].object;
    if (pair.firstOnSecond) result_.kept.push_back({first, second});
    if (pair.secondOnFirst) result_.kept.push_back({second, first});
  }

  /// To the children of both; a leaf stays as it is.
  void descend(const NodePair& pair) {
    for (const std::uint32_t first : parts(pair.first))
      for (const std::uint32_t second : parts(pair.second))
        visit({first, second, pair.firstOnSecond, pair.secondOnFirst});
  }

  /// The children of a node, or the leaf itself.
  std::span<const std::uint32_t> parts(const std::uint32_t& index) const {
    if (nodes_[index].isLeaf()) return {&index, 1};
    return nodes_[index].children;
  }

  /// Grows away from the light.
  double depth(std::uint32_t index) const {
    const glm::dvec3 center = nodes_[index].box.center();
    if (const auto* point = std::get_if<PointLight>(&light_))
      return glm::distance(center, point->position);
    return -glm::dot(center, std::get<DirectionalLight>(light_).towards);
  }

  const std::vector<BoxTree::Node>& nodes_;
  const ShadowLight& light_;
  ShadowPairs result_;
};

}  // namespace

ShadowPairs findShadowPairs(const BoxTree& tree, const ShadowLight& light) {
  checkLight(light);
  PairWalk walk(tree, light);
  if (!tree.isEmpty()) walk.visit(tree.root());
  return walk.result();
}

}  // namespace haarlight
