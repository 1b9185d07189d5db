#include "motion/gltf_mesh.h"

#include <algorithm>
#include <utility>

#include "mesh/mesh_file_formats.h"
#include "mesh/polygon_soup.h"
#include "mesh/soup_mesh.h"
#include "motion/gltf_deformation.h"
#include "motion/gltf_file.h"
#include "motion/gltf_scene.h"

namespace haarlight {

namespace {

PolygonSoup soupOf(const GltfScene& scene) {
  PolygonSoup soup;
  soup.positions = gltfPositions(scene, 0);
  soup.corners = scene.corners;
  for (std::size_t end = 3; end <= soup.corners.size(); end += 3) soup.faceStart.push_back(end);
  const std::vector<glm::vec3> normals = gltfNormals(scene, 0);
  if (normals.empty()) return soup;
  for (const std::uint32_t vertex : soup.corners) soup.cornerNormals.push_back(normals[vertex]);
  return soup;
}

void warn(LoadedMesh& loaded, std::size_t count, const std::string& what) {
  if (count > 0) loaded.warnings.push_back(std::to_string(count) + " " + what);
}

LoadedMesh meshOf(const GltfScene& scene) {
  SoupMesh assembled = meshOfSoup(soupOf(scene));
  if (assembled.mesh.triangles.empty())
    meshFileError(scene.path,
                  "there is no triangle with an area in its scene at second 0; choose "
                  "another animation, or export meshes too");
  LoadedMesh loaded;
  loaded.mesh = std::move(assembled.mesh);
  loaded.sourceVertices = std::move(assembled.sourceVertices);
  loaded.topology = measureTopology(loaded.mesh);
  warn(loaded, scene.primitivesWithoutTriangles, "primitives are points or lines: passed over");
  warn(loaded, assembled.degenerateTriangles, "triangles without area left out");
  warn(loaded, assembled.badNormals, "normals missing, zero or not finite: computed instead");
  warn(loaded, assembled.unusedVertices, "vertices belong to no triangle");
  warn(loaded, loaded.topology.boundaryEdges, "boundary edges: the surface is open");
  warn(loaded, loaded.topology.nonManifoldEdges,
       "edges of more than two triangles: kept as they are");
  warn(loaded, loaded.topology.misorientedEdges,
       "edges between triangles that face opposite sides");
  warn(loaded, loaded.topology.duplicateTriangles, "triangles are there more than once: kept");
  return loaded;
}

class GltfMotion : public VertexMotion {
 public:
  GltfMotion(GltfScene scene, std::vector<std::uint32_t> sourceVertices)
      : scene_(std::move(scene)), sourceVertices_(std::move(sourceVertices)) {}

  std::size_t vertexCount() const override { return sourceVertices_.size(); }
  double duration() const override { return scene_.duration(); }

  std::vector<glm::vec3> positions(double seconds) override {
    const auto posed = gltfPositions(scene_, std::clamp(seconds, 0.0, scene_.duration()));
    std::vector<glm::vec3> result;
    result.reserve(sourceVertices_.size());
    for (const std::uint32_t vertex : sourceVertices_) result.push_back(posed[vertex]);
    return result;
  }

 private:
  GltfScene scene_;
  std::vector<std::uint32_t> sourceVertices_;  ///< of the mesh's vertices
};

}  // namespace

AnimatedMesh loadGltf(const std::filesystem::path& path, const std::string& animation) {
  GltfScene scene = readGltfScene(readGltf(path), animation);
  AnimatedMesh result{meshOf(scene), nullptr};
  scene.corners = {};
  if (scene.duration() > 0)
    result.motion = std::make_unique<GltfMotion>(std::move(scene), result.mesh.sourceVertices);
  return result;
}

}  // namespace haarlight
