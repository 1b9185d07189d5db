#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

#include "motion/gltf_file.h"

namespace haarlight {

/// Offsets to the positions and normals of all vertices; empty where the target has none.
struct MorphTarget {
  std::vector<glm::vec3> positions, normals;
};

/// How much a vertex follows a joint.
struct JointInfluence {
  std::uint32_t joint = 0;  ///< its number in the skin
  float weight = 0;
};

/// The vertices of a primitive, in the coordinates of its mesh.
struct VertexBlock {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  ///< as many, or none
  std::vector<MorphTarget> morphTargets;
  /// Vertex i follows influences[influenceStart[i]] … influences[influenceStart[i + 1] − 1], whose
  /// weights are above 0 and have the sum 1. Both are empty without skinning.
  std::vector<std::size_t> influenceStart;
  std::vector<JointInfluence> influences;
  std::uint32_t largestJoint = 0;
};

/// The accessors of a primitive that its VertexBlock is made of, to find primitives that share one.
struct VertexSources {
  int positions = -1, normals = -1;
  std::vector<int> joints, weights;         ///< JOINTS_0, JOINTS_1, …
  std::vector<std::pair<int, int>> morphs;  ///< positions and normals of each morph target

  explicit VertexSources(const tinygltf::Primitive& primitive);
  auto operator<=>(const VertexSources&) const = default;
};

/// Adds what it reads to `count` (addToGltfCount). Throws InputError when accessors do not fit to
/// one another, or a vertex's weights are negative or have the sum 0.
VertexBlock readVertexBlock(const GltfFile& file, const VertexSources& sources,
                            const std::string& place, std::size_t& count);

/// The corners of the triangles of a primitive, three each: a list, strip or fan, with or without
/// indices; none for points and lines. Throws InputError at an index that is no vertex's.
std::vector<std::uint32_t> readTriangleCorners(const GltfFile& file,
                                               const tinygltf::Primitive& primitive,
                                               std::size_t vertexCount, const std::string& place);

}  // namespace haarlight
