#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "mesh/ray_scene.h"
#include "render/radiance_method.h"
#include "shadow/shaft.h"
#include "visibility/exact_visibility.h"

namespace haarlight {

namespace {

/// Sums over the cube's texels; how a texel is found to be blocked is left to the methods.
class TexelSumMethod : public RadianceMethod {
 public:
  explicit TexelSumMethod(const Scene& scene) : scene_(scene) {}

  std::string deviceName() const override {
    return fmt::format("host, {} thread{}", threadCount(), threadCount() == 1 ? "" : "s");
  }

  std::vector<glm::vec3> radiance(std::span<const SurfaceSample> samples) override {
    const Stopwatch watch;
    std::vector<glm::vec3> radiance(samples.size());
    parallelFor(samples.size(), 16, [&](std::size_t begin, std::size_t end) {
      std::vector<double> lobe;
      for (std::size_t i = begin; i < end; ++i) {
        if (i == begin || samples[i].normal != samples[i - 1].normal)
          lobe = cosineLobe(glm::dvec3(samples[i].normal));
        radiance[i] = radianceOf(samples[i], lobe);
      }
    });
    times_.total += watch.total();
    return radiance;
  }

 protected:
  /// Bits of the texels that something blocks; texels without a lobe need not be looked at.
  virtual BitCube blockedTexels(const SurfaceSample& sample,
                                const std::vector<double>& lobe) const = 0;

  const Scene& scene_;

 private:
  glm::vec3 radianceOf(const SurfaceSample& sample, const std::vector<double>& lobe) const {
    const BitCube blocked = blockedTexels(sample, lobe);
    const RadianceCube& light = scene_.light.projection.cube;
    glm::dvec3 sum(0);
    for (int texel = 0; texel < texelCount; ++texel)
      if (lobe[texel] > 0 && !blocked.blocked(texel)) sum += lobe[texel] * glm::dvec3(light[texel]);
    return sample.albedo * glm::vec3(sum / double(texelsPerFace));
  }
};

class PixelMethod final : public TexelSumMethod {
 public:
  PixelMethod(const Scene& scene, std::shared_ptr<const SphereTable> table)
      : TexelSumMethod(scene), table_(std::move(table)) {
    sceneChanged(true);
  }

  std::string name() const override { return "pixel"; }
  void sceneChanged(bool) override { spheres_ = scene_.blockerSpheres(); }

 private:
  BitCube blockedTexels(const SurfaceSample& sample, const std::vector<double>&) const override {
    return table_ ? table_->bitCube(spheres_, sample.position, sample.normal)
                  : exactBitCube(spheres_, sample.position, sample.normal);
  }

  std::shared_ptr<const SphereTable> table_;
  std::vector<Sphere> spheres_;
};

/// Distance by which rays leave the surface they start on, over the extent of the blockers: well
/// above the rounding of positions of this magnitude, well below anything seen.
constexpr float relativeRayOffset = 1e-4f;

float rayOffset(const std::vector<Occluder>& occluders) {
  float extent = 0;
  for (const Occluder& occluder : occluders) {
    const AxisBox box = boundsOf(occluder);
    if (!box.isEmpty()) extent = std::max(extent, float(largestCoordinate(box)));
  }
  return relativeRayOffset * extent;
}

float rayOffset(const std::vector<Sphere>& spheres) {
  float extent = 0;
  for (const Sphere& sphere : spheres) {
    const glm::vec3 reach = glm::abs(sphere.center) + sphere.radius;
    extent = std::max({extent, reach.x, reach.y, reach.z});
  }
  return relativeRayOffset * extent;
}

class RayMethod : public TexelSumMethod {
 protected:
  explicit RayMethod(const Scene& scene) : TexelSumMethod(scene) {
    for (int texel = 0; texel < texelCount; ++texel)
      directions_[texel] = glm::vec3(texelDirection(texel));
  }

  template <typename Blockers>
  void setBlockers(const Blockers& blockers) {
    rays_.emplace(blockers);
    offset_ = rayOffset(blockers);
  }

 private:
  BitCube blockedTexels(const SurfaceSample& sample,
                        const std::vector<double>& lobe) const override {
    std::array<glm::vec3, 16> origins, directions;
    origins.fill(sample.position + offset_ * sample.geometricNormal);
    BitCube blocked;
    for (int first = 0; first < texelCount; first += 16) {
      std::uint16_t wanted = 0;
      for (int i = 0; i < 16; ++i) {
        directions[i] = directions_[first + i];
        wanted |= std::uint16_t(lobe[first + i] > 0) << i;
      }
      if (!wanted) continue;
      const std::uint32_t hit = rays_->occluded16(origins, directions, wanted);
      blocked.rows[first / faceSize] |= hit << (first % faceSize);
    }
    return blocked;
  }

  std::optional<RayScene> rays_;
  float offset_ = 0;
  std::array<glm::vec3, texelCount> directions_;
};

class PixelMeshMethod final : public RayMethod {
 public:
  explicit PixelMeshMethod(const Scene& scene) : RayMethod(scene) { sceneChanged(true); }

  std::string name() const override { return "pixel-mesh"; }
  void sceneChanged(bool) override { setBlockers(scene_.occluders()); }
};

class PixelRayMethod final : public RayMethod {
 public:
  explicit PixelRayMethod(const Scene& scene) : RayMethod(scene) { sceneChanged(true); }

  std::string name() const override { return "pixel-rays"; }
  void sceneChanged(bool) override { setBlockers(scene_.blockerSpheres()); }
};

}  // namespace

std::unique_ptr<RadianceMethod> makePixelMethod(const Scene& scene,
                                                std::shared_ptr<const SphereTable> table) {
  return std::make_unique<PixelMethod>(scene, std::move(table));
}

std::unique_ptr<RadianceMethod> makePixelMeshMethod(const Scene& scene) {
  return std::make_unique<PixelMeshMethod>(scene);
}

std::unique_ptr<RadianceMethod> makePixelRayMethod(const Scene& scene) {
  return std::make_unique<PixelRayMethod>(scene);
}

}  // namespace haarlight
