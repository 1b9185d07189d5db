#include "mesh_shadow/embree_occlusion.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "mesh_shadow/lit_mesh.h"
#include "shadow/solid_occlusion.h"

namespace haarlight {

namespace {

constexpr std::size_t packetSize = 16;

}  // namespace

EmbreeOcclusion::EmbreeOcclusion(std::span<const Occluder> occluders, const ShadowLight& light)
    : occluders_(occluders.size()), light_(light) {
  for (std::uint32_t i = 0; i < occluders.size(); ++i) replace(i, occluders[i]);
}

void EmbreeOcclusion::replace(std::uint32_t caster, const Occluder& shape) {
  occluders_[caster] = shape;
  meshes_.erase(caster);
  if (const auto* mesh = std::get_if<const TriangleMesh*>(&shape))
    meshes_.emplace(caster, Mesh{boundsOf(shape), RayScene(**mesh)});
}

Ray EmbreeOcclusion::startBefore(const OcclusionRay& ray, const AxisBox& bounds) const {
  const Ray way = segmentToLight(ray.from, light_);
  const double length = glm::length(way.direction);
  if (ray.leavesCaster || length == 0) return way;
  const double margin = singlePrecisionMargin(united(bounds, {ray.from, ray.from}));
  return segmentToLight(way.at(-margin / length), light_);
}

void EmbreeOcclusion::castPacket(const Mesh& mesh, std::span<const OcclusionRay> rays, Order order,
                                 std::span<std::uint8_t> blocked) const {
  std::array<glm::vec3, packetSize> origins{}, directions{};
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Ray ray = startBefore(rays[order[i]], mesh.bounds);
    origins[i] = ray.origin, directions[i] = ray.direction;
  }
  const bool isPoint = std::holds_alternative<PointLight>(light_);
  const float far = isPoint ? 1 : std::numeric_limits<float>::infinity();
  const auto valid = std::uint16_t((1u << order.size()) - 1);
  const std::uint16_t hits = mesh.rays.occluded16(origins, directions, valid, 0, far);
  for (std::size_t i = 0; i < order.size(); ++i) blocked[order[i]] = hits >> i & 1;
}

/// For rays that all ask about one caster.
void EmbreeOcclusion::answerFor(std::uint32_t caster, std::span<const OcclusionRay> rays,
                                Order order, std::span<std::uint8_t> blocked) const {
  if (const auto* solid = std::get_if<const Solid*>(&occluders_[caster])) {
    for (const std::uint32_t i : order)
      blocked[i] = blocksLight(**solid, rays[i].from, light_, rays[i].leavesCaster);
    return;
  }
  const Mesh& mesh = meshes_.at(caster);
  for (std::size_t first = 0; first < order.size(); first += packetSize)
    castPacket(mesh, rays, order.subspan(first, std::min(packetSize, order.size() - first)),
               blocked);
}

void EmbreeOcclusion::answerHere(std::span<const OcclusionRay> rays,
                                 std::span<std::uint8_t> blocked) const {
  std::vector<std::uint32_t> order(rays.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto casterOf = [&](std::uint32_t i) { return rays[i].caster; };
  if (!std::ranges::is_sorted(order, {}, casterOf)) std::ranges::stable_sort(order, {}, casterOf);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const std::uint32_t caster = casterOf(order[begin]);
    while (end < order.size() && casterOf(order[end]) == caster) ++end;
    answerFor(caster, rays, Order(order).subspan(begin, end - begin), blocked);
  }
}

}  // namespace haarlight
