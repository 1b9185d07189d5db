#include "engine/shape_choice.h"

#include <charconv>
#include <cstdlib>

#include "base/canonical_order.h"
#include "base/error.h"
#include "base/file.h"

namespace haarlight {

namespace {

/// Four samples are 128 work-items: two or four waves of a GPU.
constexpr int samplesOfOneLaneItems = 4, samplesOfFullItems = 1;

/// What is standard for the numbers of `shape` that are 0.
KernelShape completed(KernelShape shape, const DeviceDescription& device) {
  if (!shape.lanesPerItem)
    shape.lanesPerItem = device.engine == "opencl" && device.isCpu ? partialSums : 1;
  if (!shape.samplesPerGroup)
    shape.samplesPerGroup = shape.lanesPerItem == 1 ? samplesOfOneLaneItems : samplesOfFullItems;
  return shape;
}

[[noreturn]] void refuse(const std::string& wanted, const std::string& problem) {
  throw InputError(std::string(shapeVariable) +
                   " takes LANESxSAMPLES such as 32x1, or default, not '" + wanted + "'" +
                   (problem.empty() ? "" : ": " + problem));
}

/// "32x1" as a shape that some engine's kernels come in. Throws InputError.
KernelShape parseShape(const std::string& text) {
  KernelShape shape;
  const char* end = text.data() + text.size();
  const auto [x, lanesError] = std::from_chars(text.data(), end, shape.lanesPerItem);
  if (lanesError != std::errc() || x == end || *x != 'x') refuse(text, {});
  const auto [rest, samplesError] = std::from_chars(x + 1, end, shape.samplesPerGroup);
  if (samplesError != std::errc() || rest != end) refuse(text, {});
  if (const std::string problem = shapeProblem("opencl", shape); !problem.empty())
    refuse(text, problem);
  return shape;
}

}  // namespace

KernelShape standardShape(const DeviceDescription& device) {
  return completed({0, 0}, device);
}

ShapeChoice chooseShape(const EngineOptions& options, const DeviceDescription& device,
                        const char* environment, const TunedShapes& tuned) {
  if (options.lanesPerItem || options.samplesPerGroup) {
    const auto shape = completed({options.lanesPerItem, options.samplesPerGroup}, device);
    if (const std::string problem = shapeProblem(device.engine, shape); !problem.empty())
      throw InputError(problem);
    return {shape, ShapeSource::options};
  }
  const std::string wanted = environment ? environment : "";
  if (wanted == "default") return {standardShape(device), ShapeSource::standard};
  if (!wanted.empty())
    if (const KernelShape shape = parseShape(wanted); shapeProblem(device.engine, shape).empty())
      return {shape, ShapeSource::environment};
  if (const auto shape = tuned.find(device)) return {*shape, ShapeSource::tuned};
  return {standardShape(device), ShapeSource::standard};
}

ShapeChoice chooseShape(const EngineOptions& options, const DeviceDescription& device) {
  return chooseShape(options, device, std::getenv(shapeVariable),
                     TunedShapes::read(cacheFolder(), options.onWarning));
}

}  // namespace haarlight
