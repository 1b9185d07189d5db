#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "mesh/mesh_file_formats.h"

namespace haarlight {

/// Polygons without any connection but their vertex numbers: face i has the corners
/// faceStart[i] … faceStart[i + 1] - 1.
struct PolygonSoup {
  std::vector<glm::vec3> positions;
  std::vector<std::size_t> faceStart{0};
  std::vector<std::uint32_t> corners;
  /// One per corner, zero where the file gives none; empty when the file gives none at all.
  std::vector<glm::vec3> cornerNormals;

  std::size_t faceCount() const { return faceStart.size() - 1; }
};

/// Lets OpenMesh's reader of the format `extension` ("obj", "ply", "off", "stl") read the file.
/// OpenMesh's own meshes refuse faces that would make them non-manifold; collecting what its reader
/// delivers before it becomes such a mesh keeps every face. Throws InputError when the content is
/// cut off, a coordinate is not finite or a face refers to a vertex that does not exist.
PolygonSoup readPolygonSoup(const std::filesystem::path& path, const std::string& extension,
                            const PreparedMeshFile& file);

}  // namespace haarlight
