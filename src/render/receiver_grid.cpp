#include "render/receiver_grid.h"

#include <glm/common.hpp>

namespace haarlight {

TriangleMesh receiverRectangle(const ReceiverDescription& receiver) {
  const glm::dvec3 half(receiver.size.x / 2, 0, receiver.size.y / 2);
  TriangleMesh mesh;
  for (const glm::dvec3 corner : {glm::dvec3(-1, 0, -1), {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}})
    mesh.positions.push_back(glm::vec3(receiver.center + corner * half));
  mesh.normals.assign(4, {0, 1, 0});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

std::size_t ReceiverGrid::vertexCount() const {
  return std::size_t(receiver_.samples.x + 1) * std::size_t(receiver_.samples.y + 1);
}

TriangleMesh ReceiverGrid::vertices() const {
  TriangleMesh grid;
  grid.positions.reserve(vertexCount());
  for (int row = 0; row <= receiver_.samples.y; ++row)
    for (int column = 0; column <= receiver_.samples.x; ++column) {
      const double x = (double(column) / receiver_.samples.x - 0.5) * receiver_.size.x;
      const double z = (double(row) / receiver_.samples.y - 0.5) * receiver_.size.y;
      grid.positions.push_back(glm::vec3(receiver_.center + glm::dvec3(x, 0, z)));
    }
  grid.normals.assign(grid.positions.size(), glm::vec3(0, 1, 0));
  return grid;
}

MeshPoint ReceiverGrid::pointAt(const glm::vec3& position) const {
  const glm::dvec3 offset = glm::dvec3(position) - receiver_.center;
  const glm::dvec2 cells(receiver_.samples);
  const glm::dvec2 place = glm::clamp(
      (glm::dvec2(offset.x, offset.z) / receiver_.size + 0.5) * cells, glm::dvec2(0), cells);
  const glm::ivec2 cell = glm::min(glm::ivec2(place), receiver_.samples - 1);
  const glm::vec2 within(place - glm::dvec2(cell));
  const auto stride = std::uint32_t(receiver_.samples.x + 1);
  const std::uint32_t first = std::uint32_t(cell.y) * stride + std::uint32_t(cell.x);
  const std::uint32_t opposite = first + stride + 1;
  const bool alongRow = within.x >= within.y;
  const float longer = alongRow ? within.x : within.y, shorter = alongRow ? within.y : within.x;
  MeshPoint point;
  point.vertices = {first, first + (alongRow ? 1 : stride), opposite};
  point.weights = {1 - longer, longer - shorter, shorter};
  return point;
}

}  // namespace haarlight
