#include "mesh/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

#include "base/error.h"
#include "base/file.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_file_formats.h"
#include "mesh/polygon_soup.h"
#include "mesh/soup_mesh.h"

namespace haarlight {

namespace {

using Prepare = PreparedMeshFile (*)(const std::filesystem::path&, std::string_view);

const std::map<std::string, Prepare> formats = {
    {"obj", prepareObj}, {"off", prepareOff}, {"ply", preparePly}, {"stl", prepareStl}};

std::string lowerCaseExtension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

void warn(LoadedMesh& loaded, std::size_t count, const std::string& what) {
  if (count > 0) loaded.warnings.push_back(std::to_string(count) + " " + what);
}

void addTopologyWarnings(LoadedMesh& loaded) {
  const MeshTopology& topology = loaded.topology;
  warn(loaded, topology.boundaryEdges, "boundary edges: the surface is open");
  warn(loaded, topology.nonManifoldEdges, "edges of more than two triangles: kept as they are");
  warn(loaded, topology.misorientedEdges, "edges between triangles that face opposite sides");
  warn(loaded, topology.duplicateTriangles, "triangles are there more than once: kept");
}

}  // namespace

LoadedMesh loadMesh(const std::filesystem::path& path) {
  const std::string extension = lowerCaseExtension(path);
  const auto format = formats.find(extension);
  std::error_code missing;
  if (format == formats.end() && std::filesystem::exists(path, missing) &&
      !std::filesystem::is_directory(path, missing))
    meshFileError(path, "its extension is none of .obj, .off, .ply, .stl");
  const std::vector<std::uint8_t> bytes = readWholeFile(path, "mesh");
  if (bytes.empty()) meshFileError(path, "it is empty");
  if (format == formats.end())
    meshFileError(path, "its extension is none of .obj, .off, .ply, .stl");

  const PreparedMeshFile file = format->second(
      path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  const PolygonSoup soup = readPolygonSoup(path, extension, file);
  SoupMesh assembled = meshOfSoup(soup);
  if (assembled.mesh.triangles.empty())
    meshFileError(path, "there is no triangle with an area in it (" +
                            std::to_string(file.faceCount) + " faces)");

  LoadedMesh loaded;
  loaded.mesh = std::move(assembled.mesh);
  loaded.sourceVertices = std::move(assembled.sourceVertices);
  loaded.topology = measureTopology(loaded.mesh);
  // Readers leave out faces that name a vertex twice.
  warn(loaded, assembled.degenerateTriangles + file.faceCount - soup.faceCount(),
       "triangles without area left out");
  warn(loaded, assembled.badNormals, "normals missing, zero or not finite: computed instead");
  warn(loaded, assembled.unusedVertices, "vertices belong to no triangle");
  addTopologyWarnings(loaded);
  return loaded;
}

LoadedMesh loadMeshOrBuiltin(const std::string& name) {
  if (!name.starts_with("builtin:")) return loadMesh(name);
  LoadedMesh loaded;
  loaded.mesh = builtinMesh(name);
  loaded.topology = measureTopology(loaded.mesh);
  loaded.sourceVertices.resize(loaded.mesh.positions.size());
  std::iota(loaded.sourceVertices.begin(), loaded.sourceVertices.end(), 0u);
  return loaded;
}

}  // namespace haarlight
