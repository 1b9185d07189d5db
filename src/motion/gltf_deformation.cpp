#include "motion/gltf_deformation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <glm/matrix.hpp>

#include "base/parallel.h"
#include "base/text_format.h"
#include "mesh/mesh_file.h"
#include "mesh/mesh_file_formats.h"

namespace haarlight {

namespace {

constexpr std::size_t verticesPerTask = 4096;

/// Takes normals along: the inverse of the transpose, but for a factor above 0.
glm::dmat3 normalTransform(const glm::dmat4x3& transform) {
  const glm::dvec3 x = transform[0], y = transform[1], z = transform[2];
  const double side = glm::dot(glm::cross(x, y), z) < 0 ? -1 : 1;
  return {side * glm::cross(y, z), side * glm::cross(z, x), side * glm::cross(x, y)};
}

/// Where everything in a scene is at one time.
class ScenePose {
 public:
  ScenePose(const GltfScene& scene, double seconds)
      : scene_(scene), seconds_(seconds), states_(scene.nodes.rest()) {
    if (scene.animation) scene.animation->apply(seconds, states_);
    nodes_ = scene.nodes.globalTransforms(states_);
    for (const GltfSkin& skin : scene.skins) {
      std::vector<glm::dmat4x3>& joints = joints_.emplace_back();
      for (std::size_t i = 0; i < skin.joints.size(); ++i)
        joints.emplace_back(nodes_[skin.joints[i]] * skin.inverseBindMatrices[i]);
    }
  }

  std::vector<glm::vec3> positions() const {
    std::vector<glm::vec3> result(scene_.vertexCount);
    forEachVertex([&](const PlacedBlock& placed, std::size_t vertex) {
      const glm::dvec3 morphed = morphedVector(
          placed, vertex, scene_.blocks[placed.block].positions, &MorphTarget::positions);
      result[placed.firstVertex + vertex] =
          glm::vec3(transform(placed, vertex) * glm::dvec4(morphed, 1));
    });
    for (const PlacedBlock& placed : scene_.placedBlocks)
      for (std::size_t i = 0; i < scene_.blocks[placed.block].positions.size(); ++i)
        requireRange(result[placed.firstVertex + i], placed, i);
    return result;
  }

  std::vector<glm::vec3> normals() const {
    std::vector<glm::vec3> result(scene_.vertexCount, glm::vec3(0));
    forEachVertex([&](const PlacedBlock& placed, std::size_t vertex) {
      const std::vector<glm::vec3>& normals = scene_.blocks[placed.block].normals;
      if (normals.empty()) return;
      const glm::dvec3 morphed = morphedVector(placed, vertex, normals, &MorphTarget::normals);
      const glm::dvec3 normal = normalTransform(transform(placed, vertex)) * morphed;
      // In double a product of tiny or huge scales keeps its direction, in float it need not.
      const double length = glm::length(normal);
      if (length > 0) result[placed.firstVertex + vertex] = glm::vec3(normal / length);
    });
    return result;
  }

 private:
  void forEachVertex(const auto& visit) const {
    for (const PlacedBlock& placed : scene_.placedBlocks)
      parallelFor(scene_.blocks[placed.block].positions.size(), verticesPerTask,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t vertex = begin; vertex < end; ++vertex) visit(placed, vertex);
                  });
  }

  glm::dvec3 morphedVector(const PlacedBlock& placed, std::size_t vertex,
                           const std::vector<glm::vec3>& base,
                           std::vector<glm::vec3> MorphTarget::*offsets) const {
    glm::dvec3 sum = base[vertex];
    const std::vector<double>& weights = states_[placed.node].morphWeights;
    const std::vector<MorphTarget>& targets = scene_.blocks[placed.block].morphTargets;
    for (std::size_t i = 0; i < targets.size(); ++i)
      if (weights[i] != 0 && !(targets[i].*offsets).empty())
        sum += weights[i] * glm::dvec3((targets[i].*offsets)[vertex]);
    return sum;
  }

  glm::dmat4x3 transform(const PlacedBlock& placed, std::size_t vertex) const {
    if (placed.skin < 0) return glm::dmat4x3(nodes_[placed.node]);
    const VertexBlock& block = scene_.blocks[placed.block];
    glm::dmat4x3 sum(0);
    for (std::size_t i = block.influenceStart[vertex]; i < block.influenceStart[vertex + 1]; ++i)
      sum += double(block.influences[i].weight) * joints_[placed.skin][block.influences[i].joint];
    return sum;
  }

  void requireRange(const glm::vec3& position, const PlacedBlock& placed,
                    std::size_t vertex) const {
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(position[axis]) <= largestCoordinate))
        meshFileError(scene_.path, nodePlace(placed.node) + ": at second " +
                                       fixedText(seconds_, 3) + " vertex " +
                                       std::to_string(vertex) +
                                       " of it is not a number or lies beyond 1e9; scale it down");
  }

  const GltfScene& scene_;
  double seconds_;
  std::vector<NodeState> states_;
  std::vector<glm::dmat4> nodes_;                  ///< from nodes to the scene
  std::vector<std::vector<glm::dmat4x3>> joints_;  ///< from meshes to the scene, of every skin
};

}  // namespace

std::vector<glm::vec3> gltfPositions(const GltfScene& scene, double seconds) {
  return ScenePose(scene, seconds).positions();
}

std::vector<glm::vec3> gltfNormals(const GltfScene& scene, double seconds) {
  const bool given = std::ranges::any_of(
      scene.blocks, [](const VertexBlock& block) { return !block.normals.empty(); });
  return given ? ScenePose(scene, seconds).normals() : std::vector<glm::vec3>();
}

}  // namespace haarlight
