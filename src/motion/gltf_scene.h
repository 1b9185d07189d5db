#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "motion/gltf_animation.h"
#include "motion/gltf_pose.h"
#include "motion/gltf_vertices.h"

namespace haarlight {

struct GltfSkin {
  std::vector<int> joints;  ///< nodes
  std::vector<glm::dmat4> inverseBindMatrices;
};

/// The vertices of a block, placed by a node or by the joints of a skin.
struct PlacedBlock {
  std::size_t block = 0;
  int node = 0;   ///< its transform is without effect where there is a skin
  int skin = -1;  ///< −1: none
  std::size_t firstVertex = 0;
};

/// All triangle meshes of a scene of a glTF file as one list of vertices that can be posed
/// (gltf_deformation.h), without the file. The scene is the file's default, else its first, else
/// all there is.
struct GltfScene {
  std::filesystem::path path;
  NodeHierarchy nodes;
  std::optional<GltfAnimation> animation;  ///< nothing when it moves no vertex
  std::vector<GltfSkin> skins;
  std::vector<VertexBlock> blocks;
  std::vector<PlacedBlock> placedBlocks;
  std::size_t vertexCount = 0;
  /// Three per triangle, counter-clockwise from outside at second 0.
  std::vector<std::uint32_t> corners;
  std::size_t primitivesWithoutTriangles = 0;

  /// 0 when nothing moves.
  double duration() const { return animation ? animation->duration : 0; }
};

/// Throws InputError when there is no such animation (gltf_animation.h), and when what the scene
/// uses does not exist or does not fit together.
GltfScene readGltfScene(const GltfFile& file, const std::string& animation);

}  // namespace haarlight
