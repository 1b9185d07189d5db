#include "engine/kernel_shape.h"

#include "base/canonical_order.h"
#include "base/text_format.h"

namespace haarlight {

std::string nameOf(const KernelShape& shape) {
  return countText(std::uint64_t(shape.lanesPerItem), "lane") + " an item, " +
         countText(std::uint64_t(shape.samplesPerGroup), "sample") + " a group";
}

std::string shapeProblem(const std::string& engine, const KernelShape& shape) {
  if (shape.samplesPerGroup < 1 || shape.samplesPerGroup > maximumSamplesPerGroup)
    return "kernels take 1 to " + std::to_string(maximumSamplesPerGroup) +
           " samples a group, not " + std::to_string(shape.samplesPerGroup);
  if (shape.lanesPerItem == 1) return {};
  const std::string lanes = std::to_string(shape.lanesPerItem);
  if (engine != "opencl") return "CUDA kernels have one lane a thread, not " + lanes;
  if (shape.lanesPerItem != partialSums)
    return "OpenCL kernels take 1 or 32 lanes an item, not " + lanes;
  return {};
}

std::vector<KernelShape> shapesOf(const std::string& engine) {
  std::vector<KernelShape> shapes;
  for (const int lanes : {1, partialSums})
    for (int samples = 1; samples <= maximumSamplesPerGroup; samples *= 2)
      if (shapeProblem(engine, {lanes, samples}).empty()) shapes.push_back({lanes, samples});
  return shapes;
}

}  // namespace haarlight
