#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/devices.h"
#include "render/scene.h"
#include "render/scene_transfer.h"
#include "render/surface_sample.h"

namespace haarlight {

/// A way to compute the radiance that leaves diffuse surfaces, chosen by `--method`.
class RadianceMethod {
 public:
  virtual ~RadianceMethod() = default;

  /// "haar", "pixel", "pixel-mesh", "pixel-rays", "shexp" or "sh".
  virtual std::string name() const = 0;
  /// What computes it, in words.
  virtual std::string deviceName() const = 0;

  /// To be called when the scene that the method was made for has changed: its meshes and spheres,
  /// and its light only where `lightToo` says so.
  virtual void sceneChanged(bool lightToo) = 0;

  /// Whether the light is read from its projection onto the cube.
  virtual bool readsLightCube() const { return true; }

  /// To be called before the samples of another frame, where one is shaded again for measuring.
  virtual void newFrame() {}

  /// Radiance (albedo included) of every sample.
  virtual std::vector<glm::vec3> radiance(std::span<const SurfaceSample> samples) = 0;

  /// Seconds of all calls so far; only `haar`, `shexp` and `sh` know their stages, the others their
  /// total.
  const StageTimes& times() const { return times_; }
  /// Of the total: for the light of punctual lights and its shadows.
  double punctualSeconds() const { return punctualSeconds_; }
  /// How many octrees of punctual lights' shadows were built so far, one for an object and a light
  /// that no octree was kept for.
  std::size_t builtShadowOctrees() const { return builtShadowOctrees_; }

 protected:
  StageTimes times_;
  double punctualSeconds_ = 0;
  std::size_t builtShadowOctrees_ = 0;
};

/// Methods keep a reference to the scene.

/// The paper's method on an engine. Light terms are ranked for the normals of `typicalSamples`;
/// where `anyNormal` is set other normals may follow, else only those.
std::unique_ptr<RadianceMethod> makeHaarMethod(const Scene& scene, std::shared_ptr<Engine> engine,
                                               const ShadingSettings& settings,
                                               std::span<const SurfaceSample> typicalSamples,
                                               bool anyNormal);

/// Spherical-harmonic exponentiation on an engine: the spheres' visibility as one function of
/// `order` bands (engine/exponentiation_tables.h). The rest is as for makeHaarMethod.
std::unique_ptr<RadianceMethod> makeShexpMethod(const Scene& scene, std::shared_ptr<Engine> engine,
                                                int order,
                                                std::span<const SurfaceSample> typicalSamples,
                                                bool anyNormal);

/// Precomputed diffuse transfer on an engine. Objects and receiver stay where they are: only the
/// light of the scene may change. Backs of surfaces, of which no transfer is known, are black.
std::unique_ptr<RadianceMethod> makeTransferMethod(const Scene& scene,
                                                   std::shared_ptr<Engine> engine,
                                                   std::shared_ptr<const SceneTransfer> transfer,
                                                   ShadedPer per);

/// The exact sum over the 6144 texels, blocked by the spheres as the table has them or, without
/// one, exactly; in double on all threads.
std::unique_ptr<RadianceMethod> makePixelMethod(const Scene& scene,
                                                std::shared_ptr<const SphereTable> table);

/// The same, blocked by the meshes: a ray through every texel's centre above the horizon, on all
/// threads. The reference image of the paper.
std::unique_ptr<RadianceMethod> makePixelMeshMethod(const Scene& scene);

/// The same with rays to the spheres instead; a sphere that holds a sample blocks all of it.
std::unique_ptr<RadianceMethod> makePixelRayMethod(const Scene& scene);

}  // namespace haarlight
