#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "motion/gltf_file.h"

namespace haarlight {

/// What an animation may change of a node. Its transform is `matrix` where it has one, else scale,
/// then rotation, then translation.
struct NodeState {
  glm::dvec3 translation{0};
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 scale{1};
  std::optional<glm::dmat4> matrix;
  std::vector<double> morphWeights;  ///< one per morph target of the node's mesh

  glm::dmat4 transform() const;
};

/// A place for messages: "node 3".
std::string nodePlace(int node);

/// `matrix` with the last row 0 0 0 1, which files have up to rounding.
glm::dmat4 affine(const glm::dmat4& matrix);

/// The nodes of a glTF file: what hangs on what, and their state at rest.
class NodeHierarchy {
 public:
  /// Throws InputError when a node has two parents, is its own ancestor or has a wrong number of
  /// values, or when the primitives of its mesh differ in how many morph targets they have.
  explicit NodeHierarchy(const GltfFile& file);

  const std::vector<NodeState>& rest() const { return rest_; }

  /// The transforms from nodes to the scene.
  std::vector<glm::dmat4> globalTransforms(const std::vector<NodeState>& states) const;

  /// The marked nodes and all nodes below them.
  std::vector<bool> withDescendants(std::vector<bool> marked) const;
  /// The marked nodes and all nodes above them.
  std::vector<bool> withAncestors(std::vector<bool> marked) const;

 private:
  void findParents(const GltfFile& file);
  void orderFromRoots(const GltfFile& file);

  std::vector<int> parents_;  ///< −1: none
  std::vector<int> order_;    ///< parents come before their children
  std::vector<NodeState> rest_;
};

}  // namespace haarlight
