#pragma once

#include "app/options.h"
#include "benchmark/tuning.h"

namespace haarlight {

/// Which devices `haarlight devices --tune` measures, and how long.
struct TuneOptions {
  std::string engine;
  std::string device;
  std::size_t frames = 10;
  std::size_t samples = benchmark::paperSamples;
};

/// Measures every shape of work on the devices, prints the times, and keeps the shape chosen for
/// each in the cache folder. Ctrl-C ends it with the times so far, and what was kept before stays.
/// Throws InputError when there is no such device or no folder to write to.
void tuneDevices(const TuneOptions& options, bool json, Console& console);

/// A shape as JSON results have it.
nlohmann::ordered_json describeShape(const KernelShape& shape);

}  // namespace haarlight
