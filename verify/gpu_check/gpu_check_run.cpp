#include "verify/gpu_check/gpu_check_run.h"

#include <chrono>
#include <fstream>

#include "verify/subjects.h"

namespace haarlight::verify {

namespace {

/// Without a driver there is no such file.
std::string nvidiaDriver() {
  std::string line;
  std::getline(std::ifstream("/proc/driver/nvidia/version"), line);
  return line;
}

std::unique_ptr<Engine> openInGpuShape(const DeviceDescription& device,
                                       std::shared_ptr<const SphereTable> table) {
  EngineOptions options = optionsFor(device);
  options.lanesPerItem = 1;
  return makeEngine(options, std::move(table));
}

void measurePaperTable(Engine& engine, VisibilityKind visibility, std::vector<FrameRate>& rates) {
  for (const int spheres : paperSphereCounts) {
    const Case frame = paperFrame(spheres);
    for (const Setting& setting : paperSettings) {
      engine.setShading(buildShadingTables(frame.light, {setting.terms, setting.levels},
                                           countLobes(frame.receivers.lobes)));
      FrameRate rate = measureFrame(engine, frame);
      rate.visibility = visibility;
      rate.spheres = spheres;
      rate.terms = setting.terms;
      rate.levels = setting.levels;
      rates.push_back(rate);
    }
  }
}

DeviceMeasurement measure(const DeviceDescription& device,
                          const std::shared_ptr<const SphereTable>& table) {
  DeviceMeasurement measurement;
  measurement.engine = device.engine;
  measurement.device = device.name;
  try {
    measurement.budget = budgetOf(*openInGpuShape(device, table));
    if (device.emulation) return measurement;
    for (const VisibilityKind visibility : {VisibilityKind::table, VisibilityKind::exact}) {
      const auto engine =
          makeEngine(optionsFor(device), visibility == VisibilityKind::table ? table : nullptr);
      measurePaperTable(*engine, visibility, measurement.frameRates);
    }
  } catch (const std::exception& problem) {  // of this device; others may work
    measurement.failure = problem.what();
  }
  return measurement;
}

}  // namespace

FrameRate measureFrame(Engine& engine, const Case& frame) {
  std::vector<StageTimes> stages;
  FrameRate rate;
  rate.receivers = frame.receivers.size();
  rate.timing = timeFrames([&] {
    const auto start = std::chrono::steady_clock::now();
    engine.shade(frame.spheres, frame.receivers, &stages.emplace_back());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  });
  stages.erase(stages.begin());  // the frame that warmed up
  rate.stageMedians = stageMedians(stages);
  return rate;
}

GpuCheckRecord checkGpus(const GpuCheckOptions& options, std::shared_ptr<const SphereTable> table) {
  GpuCheckRecord record;
  record.nvidiaDriver = nvidiaDriver();
  record.devices = listDevices();
  record.report = run(options.run, table).report;
  if (!options.measures) return record;
  for (const DeviceDescription& device : record.devices) {
    if (device.engine == "reference" || !device.problem.empty()) continue;
    if (options.run.progress)
      options.run.progress("measuring " + device.engine + " on " + device.name, 0);
    record.measurements.push_back(measure(device, table));
  }
  return record;
}

}  // namespace haarlight::verify
