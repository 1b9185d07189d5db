#include "motion/mesh_sequence.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "motion/file_stamp.h"
#include "motion/file_vertices.h"
#include "motion/sampled_motion.h"
#include "scene/numbered_files.h"

namespace haarlight {

namespace {

namespace fs = std::filesystem;

class MeshSequence final : public SampledMotion {
 public:
  MeshSequence(std::vector<fs::path> files, const LoadedMesh& mesh, double framesPerSecond)
      : SampledMotion(mesh.sourceVertices.size(), evenSeconds(files.size(), 1, framesPerSecond)),
        files_(std::move(files)),
        vertices_(fileVertexCount(mesh)),
        triangles_(trianglesInFile(mesh)),
        sourceVertices_(mesh.sourceVertices) {
    stamps_.reserve(files_.size());
    for (const fs::path& file : files_) stamps_.push_back(fileStamp(file, "mesh"));
  }

 protected:
  std::vector<glm::vec3> readFrame(std::size_t frame) override {
    const fs::path& file = files_[frame];
    const LoadedMesh loaded = loadMesh(file);
    requireUnchanged(file, "mesh", stamps_[frame]);
    checkTopology(file, loaded);
    return inMeshOrder(loaded.mesh.positions, sourceVertices_);
  }

 private:
  void checkTopology(const fs::path& file, const LoadedMesh& loaded) const {
    const auto check = [&](std::size_t has, std::size_t expected, const std::string& things) {
      if (has != expected)
        throw InputError("cannot use mesh " + file.string() + " as a frame: it has " +
                         std::to_string(has) + " " + things + ", but the mesh that moves has " +
                         std::to_string(expected));
    };
    check(fileVertexCount(loaded), vertices_, "vertices");
    const std::vector<glm::uvec3> triangles = trianglesInFile(loaded);
    check(triangles.size(), triangles_.size(), "triangles with an area");
    const auto differing = std::ranges::mismatch(triangles, triangles_).in1;
    if (differing != triangles.end())
      throw InputError("cannot use mesh " + file.string() + " as a frame: its triangle " +
                       std::to_string(differing - triangles.begin()) +
                       " (from 0) joins other vertices than that of the mesh that moves");
  }

  std::vector<fs::path> files_;
  std::vector<FileStamp> stamps_;
  std::size_t vertices_;
  std::vector<glm::uvec3> triangles_;
  std::vector<std::uint32_t> sourceVertices_;
};

}  // namespace

std::unique_ptr<VertexMotion> openMeshSequence(const fs::path& pattern, const LoadedMesh& mesh,
                                               double framesPerSecond) {
  return std::make_unique<MeshSequence>(NumberedFiles(pattern).list(), mesh, framesPerSecond);
}

}  // namespace haarlight
