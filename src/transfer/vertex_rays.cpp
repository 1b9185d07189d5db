#include "transfer/vertex_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

#include "mesh/random.h"

namespace haarlight {

namespace {

constexpr std::size_t packet = 16;

const TriangleMesh& checked(const TriangleMesh& mesh) {
  if (mesh.normals.size() != mesh.positions.size())
    throw std::invalid_argument("transfer needs a normal for every vertex");
  const auto finite = [](const glm::vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  if (!std::ranges::all_of(mesh.positions, finite))
    throw std::invalid_argument("transfer needs finite coordinates");
  return mesh;
}

/// Some sixteen times what coordinates are rounded by: nearer hits are rounding.
float nearestHit(const TriangleMesh& mesh) {
  float largest = 0;
  for (const glm::vec3& p : mesh.positions)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest * 1e-6f;
}

SurfacePlace placeAt(std::uint32_t triangle, const glm::vec2& barycentric) {
  const glm::vec2 units = glm::clamp(barycentric, 0.0f, 1.0f) * 65535.0f + 0.5f;
  return {triangle, static_cast<std::uint16_t>(units.x), static_cast<std::uint16_t>(units.y)};
}

/// The corner of a triangle as a place.
SurfacePlace placeAt(const VertexFan::Face& face) {
  return placeAt(face.triangle, {face.corner == 1, face.corner == 2});
}

}  // namespace

VertexRays::VertexRays(const TriangleMesh& mesh, int raysPerVertex, std::uint64_t seed)
    : mesh_(checked(mesh)),
      scene_(mesh),
      faces_(mesh),
      directions_(raysPerVertex),
      seed_(Random(seed).next()),
      near_(nearestHit(mesh)) {}

bool VertexRays::hasCornerAt(std::uint32_t triangle, const glm::vec3& position) const {
  const glm::uvec3& t = mesh_.triangles[triangle];
  return mesh_.positions[t.x] == position || mesh_.positions[t.y] == position ||
         mesh_.positions[t.z] == position;
}

std::optional<TriangleHit> VertexRays::beyondOwnFaces(std::uint32_t vertex,
                                                      const glm::vec3& direction,
                                                      TriangleHit hit) const {
  const glm::vec3& origin = mesh_.positions[vertex];
  while (hasCornerAt(hit.triangle, origin)) {
    const float near = std::nextafter(hit.distance + near_, std::numeric_limits<float>::max());
    const auto next = scene_.closestHit(origin, direction, near);
    if (!next) return std::nullopt;
    hit = {next->object, next->triangle, next->barycentric, next->distance};
  }
  return hit;
}

bool VertexRays::meetsLitSide(const TriangleHit& hit, const glm::vec3& direction) const {
  const glm::uvec3& t = mesh_.triangles[hit.triangle];
  const glm::dvec3 a = mesh_.positions[t.x], b = mesh_.positions[t.y], c = mesh_.positions[t.z];
  const glm::dvec3 faceNormal = glm::cross(b - a, c - a);
  const glm::vec2 w = hit.barycentric;
  const glm::dvec3 shadingNormal =
      (1 - w.x - w.y) * mesh_.normals[t.x] + w.x * mesh_.normals[t.y] + w.y * mesh_.normals[t.z];
  return glm::dot(faceNormal, glm::dvec3(direction)) * glm::dot(faceNormal, shadingNormal) < 0;
}

void VertexRays::castPacket(std::uint32_t vertex, const VertexFan& fan, std::size_t first,
                            VertexView& view) const {
  const std::span<const glm::vec3, packet> directions(&view.directions[first], packet);
  const std::size_t count = std::min(packet, view.blocked.size() - first);
  auto open = static_cast<std::uint16_t>((1u << count) - 1);
  for (std::size_t i = 0; fan.mayBlock() && i < count; ++i) {
    const auto face = fan.blockingFace(directions[i]);
    if (!face) continue;
    open = static_cast<std::uint16_t>(open & ~(1u << i));
    view.blocked[first + i] = 1;
    if (face->lit) view.reflectors.push_back(placeAt(*face));
  }
  std::array<TriangleHit, packet> hits{};
  const std::uint16_t met =
      scene_.closestHits16(mesh_.positions[vertex], directions, hits, open, near_);
  for (std::size_t i = 0; i < count; ++i) {
    if (!(met >> i & 1)) continue;
    const auto hit = beyondOwnFaces(vertex, directions[i], hits[i]);
    if (!hit) continue;
    view.blocked[first + i] = 1;
    if (meetsLitSide(*hit, directions[i]))
      view.reflectors.push_back(placeAt(hit->triangle, hit->barycentric));
  }
}

void VertexRays::cast(std::uint32_t vertex, VertexView& view) const {
  Random random(seed_ + vertex);
  const auto turn = static_cast<float>(random.uniform());
  const auto shift = static_cast<float>(random.uniform());
  const auto count = static_cast<std::size_t>(directions_.count());
  view.directions.resize((count + packet - 1) / packet * packet);
  directions_.about(mesh_.normals[vertex], turn, shift, view.directions);
  view.blocked.assign(count, 0);
  view.reflectors.clear();
  const VertexFan fan(mesh_, vertex, faces_.around(vertex));
  for (std::size_t first = 0; first < count; first += packet) castPacket(vertex, fan, first, view);
  view.blockedCount = static_cast<std::size_t>(std::ranges::count(view.blocked, 1));
}

}  // namespace haarlight
