#include "mesh/polygon_soup.h"

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/IO/reader/OBJReader.hh>
#include <OpenMesh/Core/IO/reader/OFFReader.hh>
#include <OpenMesh/Core/IO/reader/PLYReader.hh>
#include <OpenMesh/Core/IO/reader/STLReader.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>
#include <glm/common.hpp>
#include <mutex>
#include <sstream>
#include <utility>

#include "mesh/mesh_file.h"

namespace haarlight {

namespace {

using namespace OpenMesh;

/// What an importer must have and a polygon soup does not need.
class EmptyImporter : public IO::BaseImporter {
 public:
  HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
  FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>&) override {}
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override {}
  void set_face_texindex(FaceHandle, int) override {}
  void set_halfedge(VertexHandle, HalfedgeHandle) override {}
  void set_color(VertexHandle, const Vec3uc&) override {}
  void set_color(VertexHandle, const Vec4uc&) override {}
  void set_color(VertexHandle, const Vec3f&) override {}
  void set_color(VertexHandle, const Vec4f&) override {}
  void set_texcoord(VertexHandle, const Vec2f&) override {}
  void set_status(VertexHandle, const Attributes::StatusInfo&) override {}
  void set_next(HalfedgeHandle, HalfedgeHandle) override {}
  void set_face(HalfedgeHandle, FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
  void set_texcoord(VertexHandle, const Vec3f&) override {}
  void set_texcoord(HalfedgeHandle, const Vec3f&) override {}
  void set_status(HalfedgeHandle, const Attributes::StatusInfo&) override {}
  void set_color(EdgeHandle, const Vec3uc&) override {}
  void set_color(EdgeHandle, const Vec4uc&) override {}
  void set_color(EdgeHandle, const Vec3f&) override {}
  void set_color(EdgeHandle, const Vec4f&) override {}
  void set_status(EdgeHandle, const Attributes::StatusInfo&) override {}
  void set_normal(FaceHandle, const Vec3f&) override {}
  void set_normal(FaceHandle, const Vec3d&) override {}
  void set_color(FaceHandle, const Vec3uc&) override {}
  void set_color(FaceHandle, const Vec4uc&) override {}
  void set_color(FaceHandle, const Vec3f&) override {}
  void set_color(FaceHandle, const Vec4f&) override {}
  void set_status(FaceHandle, const Attributes::StatusInfo&) override {}
  void add_texture_information(int, std::string) override {}
};

/// Collects vertices, faces and normals. The OBJ reader sets the normal of a vertex anew before
/// each face that uses it, the others once: a corner gets the normal its vertex has at that moment.
class SoupImporter : public EmptyImporter {
 public:
  explicit SoupImporter(std::vector<glm::vec3> normals) : normals_(std::move(normals)) {
    hasNormals_ = !normals_.empty();
  }

  VertexHandle add_vertex() override { return add_vertex(Vec3f(0, 0, 0)); }
  VertexHandle add_vertex(const Vec3f& point) override {
    soup_.positions.emplace_back(point[0], point[1], point[2]);
    return VertexHandle(static_cast<int>(soup_.positions.size() - 1));
  }
  void set_point(VertexHandle vertex, const Vec3f& point) override {
    soup_.positions.at(std::size_t(vertex.idx())) = {point[0], point[1], point[2]};
  }
  void set_normal(VertexHandle vertex, const Vec3f& normal) override {
    normals_.resize(soup_.positions.size(), glm::vec3(0));
    normals_.at(std::size_t(vertex.idx())) = {normal[0], normal[1], normal[2]};
    hasNormals_ = true;
  }
  void set_normal(VertexHandle vertex, const Vec3d& normal) override {
    set_normal(vertex, Vec3f(normal));
  }

  FaceHandle add_face(const VHandles& vertices) override {
    if (hasNormals_) soup_.cornerNormals.resize(soup_.corners.size(), glm::vec3(0));
    for (const VertexHandle vertex : vertices) {
      const auto index = static_cast<std::uint32_t>(vertex.idx());
      soup_.corners.push_back(index);
      if (hasNormals_)
        soup_.cornerNormals.push_back(index < normals_.size() ? normals_[index] : glm::vec3(0));
    }
    soup_.faceStart.push_back(soup_.corners.size());
    return FaceHandle(static_cast<int>(soup_.faceCount() - 1));
  }

  std::size_t n_vertices() const override { return soup_.positions.size(); }
  std::size_t n_faces() const override { return soup_.faceCount(); }
  std::size_t n_edges() const override { return 0; }

  PolygonSoup& soup() { return soup_; }

 private:
  PolygonSoup soup_;
  std::vector<glm::vec3> normals_;
  bool hasNormals_ = false;
};

/// A program with a static OpenMesh has only those readers that it mentions.
void useReaders() {
  IO::OBJReader();
  IO::PLYReader();
  IO::OFFReader();
  IO::STLReader();
}

std::string collected(const SoupImporter& importer) {
  return std::to_string(importer.n_vertices()) + " vertices and " +
         std::to_string(importer.n_faces()) + " faces";
}

void readContent(const std::filesystem::path& path, const std::string& extension,
                 const PreparedMeshFile& file, SoupImporter& importer) {
  std::istringstream stream(file.content);
  if (file.everyReadMustSucceed) stream.exceptions(std::ios::failbit | std::ios::badbit);
  IO::Options options(IO::Options::VertexNormal);
  if (file.binary) options += IO::Options::Binary;

  static std::mutex readersHaveState;
  const std::lock_guard lock(readersHaveState);
  useReaders();
  omerr().disable();
  omlog().disable();
  try {
    if (!IO::IOManager().read(stream, extension, importer, options))
      meshFileError(path, "its content cannot be understood");
  } catch (const std::ios::failure&) {
    stream.exceptions(std::ios::goodbit);
    const bool atEnd = stream.eof();
    meshFileError(path, "after " + collected(importer) +
                            (atEnd ? " it ends too early; the file is cut off"
                                   : " there is no number where one is expected"));
  }
}

void checkSoup(const std::filesystem::path& path, const PolygonSoup& soup) {
  const auto isUsable = [](const glm::vec3& p) {
    const glm::vec3 size = glm::abs(p);
    return size.x <= largestCoordinate && size.y <= largestCoordinate &&
           size.z <= largestCoordinate;
  };
  const auto bad = std::find_if_not(soup.positions.begin(), soup.positions.end(), isUsable);
  if (bad != soup.positions.end())
    meshFileError(path, "vertex " + std::to_string(bad - soup.positions.begin()) +
                            " (from 0) has a coordinate that is not finite or beyond 1e9; correct "
                            "it or scale the mesh down");
  for (std::size_t face = 0; face < soup.faceCount(); ++face)
    for (std::size_t i = soup.faceStart[face]; i < soup.faceStart[face + 1]; ++i)
      if (soup.corners[i] >= soup.positions.size())
        meshFileError(path, "face " + std::to_string(face) + " (from 0) refers to vertex " +
                                std::to_string(static_cast<std::int32_t>(soup.corners[i])) +
                                ", but there are " + std::to_string(soup.positions.size()) +
                                " (from 0); the file is damaged");
}

}  // namespace

PolygonSoup readPolygonSoup(const std::filesystem::path& path, const std::string& extension,
                            const PreparedMeshFile& file) {
  SoupImporter importer(file.vertexNormals);
  readContent(path, extension, file, importer);
  checkSoup(path, importer.soup());
  return std::move(importer.soup());
}

}  // namespace haarlight
