#include "hard_shadow/shadow_picture.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/parallel.h"

namespace haarlight {

namespace {

/// Irradiance from all around: a part of that which the lights bring to the scene's middle, or to
/// a quarter of its size if they are nearer.
glm::dvec3 ambientOf(const PunctualLight& light, const AxisBox& scene) {
  constexpr double part = 0.2;
  const double nearest = glm::length(scene.upper - scene.lower) / 4;
  const auto* point = std::get_if<PointLight>(&light.light);
  const double distance =
      point ? std::max(nearest, glm::distance(point->position, scene.center())) : 1;
  return part / (distance * distance) * glm::dvec3(light.strength);
}

/// How dark a leaf is drawn: every second one of its size, fading out where it covers few pixels.
double brightnessOf(const ShadowOctree& octree, const ShadowLeaf& leaf, double pixelSize) {
  constexpr double darker = 0.55, fewestPixels = 2, shownFromPixels = 4;
  const double pixels = octree.cube().edgeAt(leaf.cell.depth) / pixelSize;
  const double shown =
      std::clamp((pixels - fewestPixels) / (shownFromPixels - fewestPixels), 0., 1.);
  const glm::uvec3 place = leaf.cell.coordinates() >> std::uint32_t(deepestCell - leaf.cell.depth);
  const bool isSecond = (place.x + place.y + place.z) % 2 == 1;
  return isSecond ? 1 - (1 - darker) * shown : 1;
}

}  // namespace

ShadowPicture::ShadowPicture(int width, int height, int raysPerSide,
                             std::vector<glm::dvec3> albedos, std::vector<PunctualLight> lights,
                             const AxisBox& scene)
    : raysPerSide_(raysPerSide),
      albedos_(std::move(albedos)),
      lights_(std::move(lights)),
      image_(width, height) {
  if (scene.isEmpty()) return;
  for (const PunctualLight& light : lights_) ambient_ += ambientOf(light, scene);
}

glm::dvec3 ShadowPicture::radiance(const SurfaceView& view, std::size_t index,
                                   std::span<const std::vector<std::uint8_t>> inShadow,
                                   const HardShadowMethod* cells) const {
  const ReceiverPoint& point = view.points[index];
  if (point.object == ReceiverPoint::nothing) return ambient_ / std::numbers::pi;
  glm::dvec3 irradiance(0);
  double brightness = 1;
  for (std::size_t k = 0; k < lights_.size(); ++k) {
    if (!inShadow[k][index]) {
      irradiance += irradianceOf(lights_[k], point.position, point.normal);
      continue;
    }
    const SceneOctrees* octrees = cells ? cells->octreesOf(k) : nullptr;
    if (!octrees) continue;
    const ShadowOctree& octree = octrees->octrees()[point.object];
    const double pixelSize = view.depths[index] * glm::length(view.pixels.column) * raysPerSide_;
    if (const auto leaf = octree.leafAt(point.position); leaf && leaf->inShadow)
      brightness *= brightnessOf(octree, *leaf, pixelSize);
  }
  return albedos_[point.object] / std::numbers::pi * (irradiance + brightness * ambient_);
}

void ShadowPicture::addRows(int first, const SurfaceView& view,
                            std::span<const std::vector<std::uint8_t>> inShadow,
                            const HardShadowMethod* cells) {
  const float weight = 1 / float(raysPerSide_ * raysPerSide_);
  const auto side = std::size_t(raysPerSide_), columns = std::size_t(view.pixels.width);
  parallelFor(std::size_t(view.pixels.height) / side, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * side * columns; i < end * side * columns; ++i) {
      const std::size_t x = i % columns / side, y = (std::size_t(first) + i / columns) / side;
      image_.pixels[y * std::size_t(image_.width) + x] +=
          weight * glm::vec3(radiance(view, i, inShadow, cells));
    }
  });
}

}  // namespace haarlight
