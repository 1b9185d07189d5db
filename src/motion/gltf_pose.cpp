#include "motion/gltf_pose.h"

#include <glm/gtc/type_ptr.hpp>

namespace haarlight {

namespace {

/// Copies `values`, where the file has them, to the `count` numbers of `target`.
void assign(const GltfFile& file, const std::string& place, const std::string& name,
            const std::vector<double>& values, std::size_t count, double* target) {
  if (values.empty()) return;
  if (values.size() != count)
    file.fail(place, name + " has " + countText(values.size(), "number") + " instead of " +
                         std::to_string(count) + "; export it again");
  std::copy(values.begin(), values.end(), target);
}

std::size_t morphTargetCount(const GltfFile& file, const tinygltf::Mesh& mesh,
                             const std::string& place) {
  const std::size_t count = mesh.primitives.empty() ? 0 : mesh.primitives[0].targets.size();
  for (const tinygltf::Primitive& primitive : mesh.primitives)
    if (primitive.targets.size() != count)
      file.fail(place,
                "the primitives of its mesh have different numbers of morph targets; "
                "export it again");
  return count;
}

NodeState restState(const GltfFile& file, int index) {
  const tinygltf::Node& node = file.model.nodes[index];
  const std::string place = nodePlace(index);
  NodeState state;
  assign(file, place, "translation", node.translation, 3, glm::value_ptr(state.translation));
  assign(file, place, "scale", node.scale, 3, glm::value_ptr(state.scale));
  glm::dvec4 rotation(0, 0, 0, 1);
  assign(file, place, "rotation", node.rotation, 4, glm::value_ptr(rotation));
  state.rotation = glm::normalize(glm::dquat(rotation.w, rotation.x, rotation.y, rotation.z));
  if (!node.matrix.empty()) {
    state.matrix.emplace(1);
    assign(file, place, "matrix", node.matrix, 16, glm::value_ptr(*state.matrix));
    state.matrix = affine(*state.matrix);
  }
  if (node.mesh < 0) return state;
  const tinygltf::Mesh& mesh = file.element(file.model.meshes, node.mesh, "mesh", place);
  state.morphWeights.resize(morphTargetCount(file, mesh, place));
  for (const std::vector<double>* weights : {&mesh.weights, &node.weights})
    assign(file, place, "weights", *weights, state.morphWeights.size(), state.morphWeights.data());
  return state;
}

}  // namespace

glm::dmat4 NodeState::transform() const {
  if (matrix) return *matrix;
  glm::dmat4 result = glm::mat4_cast(rotation);
  for (int axis = 0; axis < 3; ++axis) result[axis] *= scale[axis];
  result[3] = glm::dvec4(translation, 1);
  return result;
}

std::string nodePlace(int node) {
  return "node " + std::to_string(node);
}

glm::dmat4 affine(const glm::dmat4& matrix) {
  return glm::dmat4(glm::dmat4x3(matrix));
}

NodeHierarchy::NodeHierarchy(const GltfFile& file) : parents_(file.model.nodes.size(), -1) {
  findParents(file);
  orderFromRoots(file);
  for (int node = 0; node < int(parents_.size()); ++node) rest_.push_back(restState(file, node));
}

void NodeHierarchy::findParents(const GltfFile& file) {
  for (int parent = 0; parent < int(parents_.size()); ++parent) {
    for (const int child : file.model.nodes[parent].children) {
      file.element(file.model.nodes, child, "node", nodePlace(parent));
      if (parents_[child] >= 0)
        file.fail(nodePlace(child), "it is the child of two nodes; export it again");
      parents_[child] = parent;
    }
  }
}

void NodeHierarchy::orderFromRoots(const GltfFile& file) {
  for (int node = 0; node < int(parents_.size()); ++node)
    if (parents_[node] < 0) order_.push_back(node);
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const std::vector<int>& children = file.model.nodes[order_[i]].children;
    order_.insert(order_.end(), children.begin(), children.end());
  }
  // Every node has one parent at most, so those that no root leads to lie on or below a cycle.
  if (order_.size() < parents_.size())
    file.fail("nodes", "some of them are their own ancestors; export it again");
}

std::vector<glm::dmat4> NodeHierarchy::globalTransforms(
    const std::vector<NodeState>& states) const {
  std::vector<glm::dmat4> transforms(states.size());
  for (const int node : order_) {
    const int parent = parents_[node];
    const glm::dmat4 local = states[node].transform();
    transforms[node] = parent < 0 ? local : transforms[parent] * local;
  }
  return transforms;
}

std::vector<bool> NodeHierarchy::withDescendants(std::vector<bool> marked) const {
  for (const int node : order_) {
    const int parent = parents_[node];
    if (parent >= 0 && marked[parent]) marked[node] = true;
  }
  return marked;
}

std::vector<bool> NodeHierarchy::withAncestors(std::vector<bool> marked) const {
  for (auto node = order_.rbegin(); node != order_.rend(); ++node) {
    const int parent = parents_[*node];
    if (parent >= 0 && marked[*node]) marked[parent] = true;
  }
  return marked;
}

}  // namespace haarlight
