#include "mesh/soup_mesh.h"

#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "mesh/mesh_measures.h"
#include "mesh/triangulate.h"
#include "mesh/vertex_normals.h"

namespace haarlight {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

bool hasArea(const TriangleMesh& mesh, const glm::uvec3& t) {
  return triangleHasArea(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
}

class SoupAssembler {
 public:
  explicit SoupAssembler(const PolygonSoup& soup) : soup_(soup) {
    result_.mesh.positions = soup.positions;
    result_.sourceVertices.resize(soup.positions.size());
    std::iota(result_.sourceVertices.begin(), result_.sourceVertices.end(), 0u);
    used_.resize(soup.positions.size());
    normals_.resize(soup.positions.size());
    nextCopy_.resize(soup.positions.size(), none);
  }

  SoupMesh run() {
    for (std::size_t face = 0; face < soup_.faceCount(); ++face) addFace(face);
    for (const bool used : used_) result_.unusedVertices += !used;
    finishNormals();
    return std::move(result_);
  }

 private:
  void addFace(std::size_t face) {
    const std::size_t begin = soup_.faceStart[face], end = soup_.faceStart[face + 1];
    if (end - begin < 3) {
      ++result_.degenerateTriangles;
      return;
    }
    points_.clear();
    for (std::size_t i = begin; i < end; ++i) points_.push_back(soup_.positions[soup_.corners[i]]);
    for (const auto& t : triangulatePolygon(points_))
      addTriangle(begin + t[0], begin + t[1], begin + t[2]);
  }

  void addTriangle(std::size_t a, std::size_t b, std::size_t c) {
    const auto& corners = soup_.corners;
    if (!hasArea(result_.mesh, {corners[a], corners[b], corners[c]})) {
      ++result_.degenerateTriangles;
      return;
    }
    result_.mesh.triangles.emplace_back(vertexOf(a), vertexOf(b), vertexOf(c));
  }

  /// The copy of the corner's vertex that has the corner's normal; a new one when there is none.
  std::uint32_t vertexOf(std::size_t corner) {
    std::uint32_t vertex = soup_.corners[corner];
    const glm::vec3 normal =
        soup_.cornerNormals.empty() ? glm::vec3(0) : normalizedOrZero(soup_.cornerNormals[corner]);
    if (!used_[vertex]) {
      used_[vertex] = true;
      normals_[vertex] = normal;
    }
    while (normals_[vertex] != normal) {
      if (nextCopy_[vertex] == none) nextCopy_[vertex] = addCopy(vertex, normal);
      vertex = nextCopy_[vertex];
    }
    return vertex;
  }

  std::uint32_t addCopy(std::uint32_t vertex, const glm::vec3& normal) {
    result_.mesh.positions.push_back(glm::vec3(result_.mesh.positions[vertex]));
    result_.sourceVertices.push_back(std::uint32_t(result_.sourceVertices[vertex]));
    used_.push_back(true);
    normals_.push_back(normal);
    nextCopy_.push_back(none);
    return static_cast<std::uint32_t>(normals_.size() - 1);
  }

  void finishNormals() {
    TriangleMesh& mesh = result_.mesh;
    mesh.normals = computeVertexNormals(mesh.positions, mesh.triangles);
    if (soup_.cornerNormals.empty()) return;
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      if (normals_[i] != glm::vec3(0))
        mesh.normals[i] = normals_[i];
      else
        result_.badNormals += used_[i];
    }
  }

  const PolygonSoup& soup_;
  SoupMesh result_;
  std::vector<bool> used_;
  std::vector<glm::vec3> normals_;  ///< of every mesh vertex; zero: to be computed
  std::vector<std::uint32_t> nextCopy_;
  std::vector<glm::vec3> points_;
};

}  // namespace

SoupMesh meshOfSoup(const PolygonSoup& soup) {
  return SoupAssembler(soup).run();
}

}  // namespace haarlight
