#include "engine/devices.h"

#include <algorithm>

#include "base/error.h"
#include "engine/cuda/cuda_engine.h"
#include "engine/kernel_engine.h"
#include "engine/opencl/opencl_engine.h"
#include "engine/self_test.h"

namespace haarlight {

namespace {

DeviceDescription describeReference() {
  DeviceDescription reference;
  reference.engine = "reference";
  reference.name = "scalar C++, one thread";
  reference.platform = "host";
  reference.computeUnits = 1;
  return reference;
}

std::unique_ptr<Engine> openEngine(const EngineOptions& options,
                                   std::shared_ptr<const SphereTable> table) {
  if (options.engine == "reference") return makeReferenceEngine(std::move(table));
  if (options.engine == "opencl")
    return makeKernelEngine(openOpenClDevice(options), std::move(table), options.path);
  if (options.engine == "cuda")
    return makeKernelEngine(openCudaDevice(options), std::move(table), options.path);
  if (options.engine == "cuda-host")
    return makeKernelEngine(openCudaHostDevice(options), std::move(table), options.path);
  throw InputError("unknown engine '" + options.engine +
                   "': use auto, reference, opencl, cuda or cuda-host");
}

std::unique_ptr<Engine> openTestedEngine(const EngineOptions& options,
                                         std::shared_ptr<const SphereTable> table) {
  auto engine = openEngine(options, table);
  if (!options.selfTest) return engine;
  const std::string failure = selfTestFailure(*engine, table);
  if (!failure.empty())
    throw InputError(engine->name() + " on " + engine->deviceName() +
                     " fails the self test: " + failure + "; choose another device or engine");
  return engine;
}

/// What `auto` tries, in this order: CUDA, OpenCL on GPUs, OpenCL on CPUs, reference.
std::vector<EngineOptions> candidates(const EngineOptions& options) {
  std::vector<EngineOptions> list;
  const auto add = [&](const DeviceDescription& device) {
    if (!device.problem.empty() || device.emulation) return;
    const EngineOptions named = optionsFor(device);
    list.push_back(options);
    list.back().engine = named.engine;
    list.back().device = named.device;
  };
  std::ranges::for_each(listCudaDevices(), add);
  auto openCl = listOpenClDevices();
  std::ranges::stable_partition(openCl, [](const DeviceDescription& d) { return !d.isCpu; });
  std::ranges::for_each(openCl, add);
  list.push_back(options);
  list.back().engine = "reference";
  return list;
}

}  // namespace

std::vector<DeviceDescription> listDevices() {
  std::vector<DeviceDescription> list{describeReference()};
  for (const auto& devices : {listOpenClDevices(), listCudaDevices(), listCudaHostDevices()})
    list.insert(list.end(), devices.begin(), devices.end());
  if (const std::string advice = cudaAdvice(); !advice.empty()) {
    DeviceDescription none;
    none.engine = "cuda";
    none.name = "none";
    none.platform = "NVIDIA";
    none.problem = advice;
    list.push_back(none);
  }
  return list;
}

EngineOptions optionsFor(const DeviceDescription& device) {
  EngineOptions options;
  options.engine = device.engine;
  options.device = std::to_string(device.index);
  return options;
}

std::unique_ptr<Engine> makeEngine(const EngineOptions& options,
                                   std::shared_ptr<const SphereTable> table) {
  if (options.engine != "auto") return openTestedEngine(options, std::move(table));
  if (!options.device.empty()) {
    EngineOptions openCl = options;
    openCl.engine = "opencl";
    return openTestedEngine(openCl, std::move(table));
  }
  const auto list = candidates(options);
  for (const EngineOptions& candidate : list) {
    if (candidate.engine == "reference") break;
    try {
      return openTestedEngine(candidate, table);
    } catch (const std::exception& problem) {  // a device that does not work; the next one may
      if (options.onRefusal) options.onRefusal(problem.what());
    }
  }
  return openTestedEngine(list.back(), std::move(table));
}

}  // namespace haarlight
