#pragma once

#include <string>
#include <vector>

namespace haarlight {

/// How kernels share samples among work-items (opencl/lanes.cl, cuda/lanes.cu). No result depends
/// on it.
struct KernelShape {
  /// Lanes a work-item carries: 1, or all 32 of a sample.
  int lanesPerItem = 1;
  /// Samples a work-group holds, 1 … maximumSamplesPerGroup.
  int samplesPerGroup = 1;

  bool operator==(const KernelShape&) const = default;
};

/// 8 samples of 32 lanes are groups of 256 work-items (method.md §9).
inline constexpr int maximumSamplesPerGroup = 8;

/// "32 lanes an item, 1 sample a group".
std::string nameOf(const KernelShape& shape);

/// Why the kernels of an engine ("opencl", "cuda", "cuda-host") do not come in a shape, in words;
/// empty when they do.
std::string shapeProblem(const std::string& engine, const KernelShape& shape);

/// The shapes worth trying: all lanes that the engine offers, with 1, 2, 4 and 8 samples.
std::vector<KernelShape> shapesOf(const std::string& engine);

}  // namespace haarlight
