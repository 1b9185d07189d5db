#pragma once

#include <span>
#include <vector>

#include "engine/receivers.h"
#include "render/progress.h"
#include "render/scene.h"
#include "render/surface_sample.h"

namespace haarlight::benchmark {

/// The scene with as many spheres fitted to each of its objects.
struct FittedScene {
  int spheres = 0;
  Scene scene;
};

/// What all rows share: samples of the receiver plane, the light, and the scene by sphere counts.
struct Inputs {
  /// White, so that radiance is the engine's own.
  std::vector<SurfaceSample> samples;
  Receivers receivers;
  std::vector<FittedScene> scenes;

  const RadianceCube& light() const { return scenes.front().scene.light.projection.cube; }
};

/// Loads the scene once per count; fits that have been made before are found in the cache folder.
/// Throws InputError, also where the scene has no receiver plane.
Inputs loadInputs(const SceneDescription& description, std::span<const int> sphereCounts,
                  const Progress& progress);

/// Samples as engines take them.
Receivers receiversOf(std::span<const SurfaceSample> samples);

}  // namespace haarlight::benchmark
