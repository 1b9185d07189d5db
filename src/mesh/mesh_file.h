#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace haarlight {

/// Coordinates in files lie between −1e9 and 1e9: so far the squared area of a triangle does not
/// leave float32.
inline constexpr float largestCoordinate = 1e9f;

struct LoadedMesh {
  TriangleMesh mesh;
  MeshTopology topology;
  /// The number, from 0, that each vertex of `mesh` has in the file. The file's vertices come first
  /// and in its order, used or not; further ones repeat those that have several normals.
  std::vector<std::uint32_t> sourceVertices;
  /// One line each: what is unusual in the file and what was done about it.
  std::vector<std::string> warnings;
};

/// Loads a mesh from OBJ, PLY, OFF or STL, told apart by the extension, through OpenMesh's readers.
///
/// Polygons are cut into triangles. Triangles without area are left out; every other one is kept,
/// also where the surface is open, not manifold or doubled, with a warning. Normals in the file are
/// used where they are finite and not zero, others are computed (computeVertexNormals); a vertex
/// with several normals becomes several vertices. Throws InputError when the file is missing, a
/// folder, empty, damaged or of an unknown kind, has a coordinate beyond largestCoordinate or NaN,
/// or holds no triangle.
LoadedMesh loadMesh(const std::filesystem::path& path);

/// The built-in mesh for a name that starts with "builtin:", else loadMesh. Throws InputError with
/// the names that exist when there is no such built-in mesh.
LoadedMesh loadMeshOrBuiltin(const std::string& name);

}  // namespace haarlight
