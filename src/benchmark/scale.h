#pragma once

#include <vector>

#include "benchmark/measure.h"
#include "benchmark/record.h"

namespace haarlight::benchmark {

/// What is swept, each in ascending order, and where the others stay meanwhile.
struct ScalePlan {
  std::vector<std::size_t> samples;
  std::vector<int> spheres;
  std::vector<int> terms;
  std::size_t fixedSamples = 16384;
  Setting fixed;
};

/// Powers of two from 2¹⁰ to `mostSamples` samples, 8 … 1024 spheres, and 0, then powers of two up
/// to 4096, and 6144 terms.
ScalePlan scalePlan(std::size_t mostSamples);

/// A plane of 8 × 8 units with `count` receivers, a power of two, that face up: the plane of
/// verify::paperFrame, whose spheres stand along a torus knot above it.
Receivers planeReceivers(std::size_t count);

/// Measures one engine on that plane. At a size frames are measured until there are effort.frames,
/// or at least three and two seconds have passed. When interrupted, sizes without a frame are
/// left out.
Scale measureScale(Engine& engine, const RadianceCube& light, const ScalePlan& plan,
                   const Effort& effort);

}  // namespace haarlight::benchmark
