#include "hard_shadow/surface_view.h"

#include <glm/geometric.hpp>
#include <limits>

#include "base/parallel.h"

namespace haarlight {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

SurfaceViewer::SurfaceViewer(std::span<const ShadowParticipant> participants, const Camera& camera,
                             int width, int height, int raysPerSide)
    : participants_(participants.begin(), participants.end()), rays_(shapesOf(participants)) {
  pixels_.eye = camera.position();
  pixels_.column = camera.columnStep() / double(raysPerSide);
  pixels_.row = camera.rowStep() / double(raysPerSide);
  pixels_.corner = camera.topLeft() + 0.5 * (pixels_.column + pixels_.row);
  pixels_.width = width * raysPerSide;
  pixels_.height = height * raysPerSide;
}

SurfaceView SurfaceViewer::rows(int first, int count) const {
  SurfaceView view;
  view.pixels = pixels_;
  view.pixels.corner += double(first) * pixels_.row;
  view.pixels.height = count;
  view.points.resize(std::size_t(pixels_.width) * std::size_t(count));
  view.depths.resize(view.points.size());
  parallelFor(std::size_t(count), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      for (int x = 0; x < pixels_.width; ++x) {
        const std::size_t i = y * std::size_t(pixels_.width) + std::size_t(x);
        const Sight sight =
            look(view.pixels.corner + double(x) * view.pixels.column + double(y) * view.pixels.row);
        view.points[i] = sight.point;
        view.depths[i] = sight.depth;
      }
  });
  return view;
}

SurfaceViewer::Sight SurfaceViewer::look(const glm::dvec3& direction) const {
  const auto hit = rays_.closestHit(glm::vec3(pixels_.eye), glm::vec3(direction));
  if (!hit) return {{}, infinity};
  const auto* solid = std::get_if<const Solid*>(&participants_[hit->object].shape);
  return solid ? onSolid(hit->object, **solid, *hit, direction)
               : onMesh(hit->object, *hit, direction);
}

/// Where the exact ray meets it; a ray that only grazes it may miss, and then sees the point that
/// single precision found.
SurfaceViewer::Sight SurfaceViewer::onSolid(std::uint32_t object, const Solid& solid,
                                            const RayHit& hit, const glm::dvec3& direction) const {
  const Ray ray{pixels_.eye, direction};
  const SolidHit exact =
      solid.intersect(ray).value_or(SolidHit{hit.distance, glm::dvec3(hit.geometricNormal)});
  const bool fromWithin = glm::dot(exact.normal, direction) > 0;
  return {{object, ray.at(exact.t), (fromWithin ? -1. : 1.) * exact.normal, fromWithin}, exact.t};
}

/// The hit's place by its weights of the corners, which single precision does not take off the
/// triangle's plane.
SurfaceViewer::Sight SurfaceViewer::onMesh(std::uint32_t object, const RayHit& hit,
                                           const glm::dvec3& direction) const {
  const TriangleMesh& mesh = *std::get<const TriangleMesh*>(participants_[object].shape);
  const auto& triangle = mesh.triangles[hit.triangle];
  const glm::dvec3 a(mesh.positions[triangle[0]]), b(mesh.positions[triangle[1]]),
      c(mesh.positions[triangle[2]]);
  const glm::dvec2 weights(hit.barycentric);
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double side = glm::dot(normal, direction) > 0 ? -1 : 1;
  const glm::dvec3 position = a + weights.x * (b - a) + weights.y * (c - a);
  const double depth = glm::dot(position - pixels_.eye, direction) / glm::dot(direction, direction);
  return {{object, position, side / glm::length(normal) * normal}, depth};
}

}  // namespace haarlight
