#pragma once

#include <string>
#include <vector>

#include "app/options.h"
#include "benchmark/record.h"
#include "benchmark/subject.h"
#include "verify/gpu_check/gpu_check_run.h"

namespace haarlight {

/// What `haarlight bench` is to measure and where results go.
struct BenchOptions {
  GeneralOptions general;
  SceneOptions scene;
  benchmark::SubjectFilter subjects;
  std::string visibility = "both";
  std::string path = "both";
  std::string size;
  std::vector<int> spheres{verify::paperSphereCounts.begin(), verify::paperSphereCounts.end()};
  std::vector<int> terms{50, 200};
  std::vector<int> levels{1, 2};
  std::size_t frames = 20;
  bool peers = false;
  bool scale = false;
  bool ceilings = false;
  std::size_t scaleSamples = std::size_t(1) << 21;
  std::string output, csv, svg, compare;
};

/// Loads, opens and measures what the options ask for; Ctrl-C ends it early with the figures so
/// far. Throws InputError for what cannot be measured.
benchmark::Record runBench(const BenchOptions& options, Console& console);

}  // namespace haarlight
