#include "motion/gltf_scene.h"

#include <algorithm>
#include <glm/matrix.hpp>
#include <map>

#include "motion/gltf_accessor.h"

namespace haarlight {

namespace {

std::vector<GltfSkin> readSkins(const GltfFile& file) {
  std::vector<GltfSkin> skins;
  for (const tinygltf::Skin& skin : file.model.skins) {
    const std::string place = "skin " + std::to_string(skins.size());
    for (const int joint : skin.joints) file.element(file.model.nodes, joint, "node", place);
    GltfSkin& result = skins.emplace_back(
        GltfSkin{skin.joints, std::vector<glm::dmat4>(skin.joints.size(), glm::dmat4(1))});
    if (skin.inverseBindMatrices < 0) continue;
    const auto matrices = readGltfElements<glm::mat4>(file, skin.inverseBindMatrices, place);
    if (matrices.size() < skin.joints.size())
      file.fail(place, "it has more joints than inverse bind matrices; export it again");
    for (std::size_t i = 0; i < skin.joints.size(); ++i)
      result.inverseBindMatrices[i] = affine(matrices[i]);
  }
  return skins;
}

/// Which nodes belong to the scene.
std::vector<bool> sceneNodes(const GltfFile& file, const NodeHierarchy& nodes) {
  const tinygltf::Model& model = file.model;
  if (model.scenes.empty()) return std::vector<bool>(model.nodes.size(), true);
  const int index = std::max(0, model.defaultScene);
  std::vector<bool> marked(model.nodes.size(), false);
  for (const int root : file.element(model.scenes, index, "scene", "scene").nodes) {
    file.element(model.nodes, root, "node", "scene " + std::to_string(index));
    marked[root] = true;
  }
  return nodes.withDescendants(marked);
}

class SceneReader {
 public:
  SceneReader(const GltfFile& file, const std::string& animation)
      : file_(file), scene_{file.path, NodeHierarchy(file), {}, readSkins(file), {}, {}, 0, {}, 0} {
    scene_.animation = readGltfAnimation(file, scene_.nodes, animation);
  }

  GltfScene run() {
    std::vector<NodeState> states = scene_.nodes.rest();
    if (scene_.animation) scene_.animation->apply(0, states);
    transforms_ = scene_.nodes.globalTransforms(states);
    const std::vector<bool> inScene = sceneNodes(file_, scene_.nodes);
    for (std::size_t node = 0; node < inScene.size(); ++node)
      if (inScene[node] && file_.model.nodes[node].mesh >= 0) addMesh(int(node));
    if (scene_.animation && !animationMoves()) scene_.animation.reset();
    return std::move(scene_);
  }

 private:
  void addMesh(int node) {
    placedInNode_.clear();
    const int mesh = file_.model.nodes[node].mesh;
    const auto& primitives = file_.model.meshes[mesh].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const std::string place = "mesh " + std::to_string(mesh) + ", primitive " + std::to_string(i);
      if (primitives[i].mode < TINYGLTF_MODE_TRIANGLES)
        ++scene_.primitivesWithoutTriangles;
      else
        addPrimitive(node, primitives[i], place);
    }
  }

  void addPrimitive(int node, const tinygltf::Primitive& primitive, const std::string& place) {
    const PlacedBlock placed = placeBlock(node, blockOf(primitive, place), place);
    const std::size_t vertices = scene_.blocks[placed.block].positions.size();
    const auto corners = readTriangleCorners(file_, primitive, vertices, place);
    addToGltfCount(file_, count_, corners.size());
    const bool mirrored =
        placed.skin < 0 && glm::determinant(glm::dmat3(transforms_[placed.node])) < 0;
    for (std::size_t i = 0; i < corners.size(); i += 3)
      for (const std::size_t corner : {i, i + (mirrored ? 2 : 1), i + (mirrored ? 1 : 2)})
        scene_.corners.push_back(std::uint32_t(placed.firstVertex + corners[corner]));
  }

  /// Primitives often share their vertices; these are read once in a file ...
  std::size_t blockOf(const tinygltf::Primitive& primitive, const std::string& place) {
    const VertexSources sources(primitive);
    const auto known = blocks_.find(sources);
    if (known != blocks_.end()) return known->second;
    scene_.blocks.push_back(readVertexBlock(file_, sources, place, count_));
    return blocks_[sources] = scene_.blocks.size() - 1;
  }

  /// ... and placed once in a node.
  PlacedBlock placeBlock(int node, std::size_t block, const std::string& place) {
    const auto known = placedInNode_.find(block);
    if (known != placedInNode_.end()) return known->second;
    const VertexBlock& vertices = scene_.blocks[block];
    const PlacedBlock placed{block, node, file_.model.nodes[node].skin, scene_.vertexCount};
    if (placed.skin >= 0) requireSkin(placed, vertices, place);
    addToGltfCount(file_, count_, vertices.positions.size());
    scene_.vertexCount += vertices.positions.size();
    scene_.placedBlocks.push_back(placed);
    return placedInNode_[block] = placed;
  }

  void requireSkin(const PlacedBlock& placed, const VertexBlock& vertices,
                   const std::string& place) const {
    const GltfSkin& skin = file_.element(scene_.skins, placed.skin, "skin", nodePlace(placed.node));
    if (vertices.influenceStart.empty())
      file_.fail(place, "its node has a skin, but it has no JOINTS_0; export it again");
    if (vertices.largestJoint >= skin.joints.size())
      file_.fail(place, "a vertex follows joint " + std::to_string(vertices.largestJoint) +
                            " of a skin of " + countText(skin.joints.size(), "joint") +
                            "; export it again");
  }

  bool animationMoves() const {
    std::vector<bool> moving(scene_.nodes.rest().size(), false);
    for (const PlacedBlock& placed : scene_.placedBlocks) {
      if (placed.skin < 0)
        moving[placed.node] = true;
      else
        for (const int joint : scene_.skins[placed.skin].joints) moving[joint] = true;
    }
    moving = scene_.nodes.withAncestors(moving);
    return std::ranges::any_of(scene_.animation->tracks, [&](const AnimationTrack& track) {
      return track.property == AnimatedProperty::morphWeights ? placesMesh(track.node)
                                                              : moving[track.node];
    });
  }

  bool placesMesh(int node) const {
    return std::ranges::find(scene_.placedBlocks, node, &PlacedBlock::node) !=
           scene_.placedBlocks.end();
  }

  const GltfFile& file_;
  GltfScene scene_;
  std::vector<glm::dmat4> transforms_;  ///< of the nodes at second 0
  std::map<VertexSources, std::size_t> blocks_;
  std::map<std::size_t, PlacedBlock> placedInNode_;
  std::size_t count_ = 0;
};

}  // namespace

GltfScene readGltfScene(const GltfFile& file, const std::string& animation) {
  return SceneReader(file, animation).run();
}

}  // namespace haarlight
