#pragma once

#include <optional>

#include "benchmark/inputs.h"
#include "benchmark/measure.h"
#include "benchmark/record.h"

namespace haarlight::benchmark {

/// Other ways to the picture of the rows with `spheres` spheres:
///
///   pixel basis   all texels in double, blocked by rays to the mesh (Embree), by rays to the
///                 spheres (Embree), and exactly by the spheres (without rays);
///   reference     the scalar engine, part by part on all threads;
///   static light  products of light and lobe made beforehand (benchmark/double_product.h), on bit
///                 cubes or coefficients that the device of `staged` makes.
///
/// Also the errors of the engines' own rows. Each peer runs once to warm up, then effort.frames
/// times, but only three times where a frame takes over a tenth of a second. When interrupted,
/// returns what it has; nothing without the pictures that errors are measured against.
std::optional<PeerComparison> measurePeers(std::span<const OpenSubject> subjects,
                                           std::span<const Row> rows, const Inputs& inputs,
                                           const FittedScene& scene, const OpenSubject& staged,
                                           const Effort& effort);

/// Root mean square error over the mean of the reference, of equally many values.
double relativeError(std::span<const glm::vec3> radiance, std::span<const glm::vec3> reference);

}  // namespace haarlight::benchmark
