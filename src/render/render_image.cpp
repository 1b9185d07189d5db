#include "render/render_image.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>

#include "base/parallel.h"
#include "engine/tile_order.h"
#include "mesh/ray_scene.h"
#include "render/receiver_grid.h"

namespace haarlight {

namespace {

struct CameraRay {
  glm::vec3 direction;
  std::optional<SurfaceSample> hit;
};

/// Samples shaded at a time, so that a picture of any size fits into memory.
constexpr int samplesPerBlock = 1 << 16;

}  // namespace

struct ScreenSampler::Implementation {
  Implementation(const Scene& s, const CameraDescription& cameraDescription,
                 const ImageDescription& imageDescription)
      : scene(s),
        image(imageDescription),
        camera(cameraDescription, imageDescription.width, imageDescription.height),
        gridSide(raysPerPixelSide(imageDescription)) {
    std::vector<Occluder> occluders;
    for (const SceneObject& object : scene.objects) {
      occluders.push_back(object.occluder());
      albedos.push_back(object.albedo);
    }
    TriangleMesh plane;
    if (scene.receiver) {
      plane = receiverRectangle(*scene.receiver);
      occluders.push_back(&plane);
      albedos.push_back(glm::vec3(scene.receiver->albedo));
    }
    rays = std::make_unique<RayScene>(occluders);
  }

  CameraRay trace(double x, double y) const {
    CameraRay ray{glm::vec3(camera.direction(x, y)), std::nullopt};
    const auto hit = rays->closestHit(glm::vec3(camera.position()), ray.direction);
    if (!hit) return ray;
    const bool fromBehind = glm::dot(hit->geometricNormal, ray.direction) > 0;
    const float side = fromBehind ? -1.0f : 1.0f;
    ray.hit = {hit->position, side * hit->shadingNormal, side * hit->geometricNormal,
               albedos[hit->object], meshPoint(*hit, ray.direction)};
    return ray;
  }

  MeshPoint meshPoint(const RayHit& hit, const glm::vec3& direction) const {
    MeshPoint point;
    const float side = glm::dot(hit.geometricNormal, hit.shadingNormal);
    point.fromBehind = side * glm::dot(hit.geometricNormal, direction) > 0;
    if (hit.object == scene.objects.size()) return point;
    point.object = hit.object;
    if (scene.objects[hit.object].solid) return point;
    const glm::vec2 b = hit.barycentric;
    point.vertices = scene.objects[hit.object].mesh.triangles[hit.triangle];
    point.weights = {1 - b.x - b.y, b.x, b.y};
    return point;
  }

  int raysPerPixel() const { return gridSide * gridSide; }
  int rowsPerBlock() const {
    const int rows = samplesPerBlock / (image.width * raysPerPixel());
    return std::max(4, rows / 4 * 4);
  }

  /// Rays of some pixels, pixel by pixel.
  std::vector<CameraRay> trace(std::span<const std::uint32_t> pixels) const {
    const int perPixel = raysPerPixel();
    std::vector<CameraRay> block(pixels.size() * perPixel);
    parallelFor(block.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::uint32_t pixel = pixels[i / perPixel];
        const int cell = int(i % perPixel);
        block[i] = trace(double(pixel % image.width) + (cell % gridSide + 0.5) / gridSide,
                         double(pixel / image.width) + (cell / gridSide + 0.5) / gridSide);
      }
    });
    return block;
  }

  glm::vec3 background(const glm::vec3& direction) const {
    return image.background ? glm::vec3(*image.background) : scene.light.radiance(direction);
  }

  /// Means over the rays of every pixel; `radiance` is that of the rays that hit something.
  void addToPixels(std::span<const std::uint32_t> pixels, std::span<const CameraRay> traced,
                   std::span<const std::uint32_t> firstSamples, std::span<const glm::vec3> radiance,
                   RenderedImage& result) const {
    const int perPixel = raysPerPixel();
    const float weight = 1.0f / float(perPixel);
    parallelFor(pixels.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        std::size_t next = firstSamples[i];
        const std::uint32_t pixel = pixels[i];
        for (const CameraRay& ray : traced.subspan(i * perPixel, perPixel)) {
          if (!ray.hit) {
            result.radiance.pixels[pixel] += weight * background(ray.direction);
            result.surfaceMask[pixel] = 0;
            continue;
          }
          result.radiance.pixels[pixel] += weight * radiance[next++];
          result.albedo.pixels[pixel] += weight * ray.hit->albedo;
          result.normal.pixels[pixel] += weight * ray.hit->normal;
        }
      }
    });
  }

  const Scene& scene;
  ImageDescription image;
  Camera camera;
  int gridSide;
  std::vector<glm::vec3> albedos;
  std::unique_ptr<RayScene> rays;
};

int raysPerPixelSide(const ImageDescription& image) {
  return std::max(1, int(std::ceil(std::sqrt(double(image.samplesPerPixel)))));
}

ScreenSampler::ScreenSampler(const Scene& scene, const CameraDescription& camera,
                             const ImageDescription& image)
    : implementation_(std::make_unique<Implementation>(scene, camera, image)) {}

ScreenSampler::~ScreenSampler() = default;

std::vector<SurfaceSample> ScreenSampler::overview() const {
  constexpr int step = 8;
  std::vector<SurfaceSample> samples;
  for (int y = 0; y < implementation_->image.height; y += step)
    for (int x = 0; x < implementation_->image.width; x += step)
      if (const CameraRay ray = implementation_->trace(x + step / 2, y + step / 2); ray.hit)
        samples.push_back(*ray.hit);
  return samples;
}

RenderedImage ScreenSampler::render(RadianceMethod& method, const Progress& progress) const {
  const Implementation& self = *implementation_;
  const int width = self.image.width, height = self.image.height;
  RenderedImage result{Image(width, height), Image(width, height), Image(width, height),
                       std::vector<std::uint8_t>(std::size_t(width) * height, 1), 0};
  for (int row = 0; row < height; row += self.rowsPerBlock()) {
    const int rows = std::min(self.rowsPerBlock(), height - row);
    auto pixels = tileOrder(width, rows);
    for (std::uint32_t& pixel : pixels) pixel += std::uint32_t(row) * width;
    const auto rays = self.trace(pixels);
    std::vector<SurfaceSample> samples;
    std::vector<std::uint32_t> firstSamples;  // of a pixel
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (i % self.raysPerPixel() == 0) firstSamples.push_back(std::uint32_t(samples.size()));
      if (rays[i].hit) samples.push_back(*rays[i].hit);
    }
    const auto radiance = method.radiance(samples);
    result.surfaceSamples += samples.size();
    self.addToPixels(pixels, rays, firstSamples, radiance, result);
    if (progress) progress("rendering", std::min(1.0, double(row + rows) / height));
  }
  return result;
}

}  // namespace haarlight
