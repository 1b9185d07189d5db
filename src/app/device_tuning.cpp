#include "app/device_tuning.h"

#include <fmt/format.h>

#include <cstdio>

#include "app/interrupt.h"
#include "base/error.h"
#include "base/file.h"
#include "base/text_format.h"
#include "benchmark/subject.h"
#include "benchmark/text_table.h"
#include "engine/shape_choice.h"

namespace haarlight {

namespace fs = std::filesystem;

namespace {

using namespace benchmark;

struct TunedDevice {
  DeviceDescription device;
  std::vector<ShapeTiming> timings;

  const ShapeTiming* chosen() const { return chosenShape(timings, standardShape(device)); }
  std::string name() const { return visible(joined({device.engine, device.name}, " · ")); }
};

std::vector<TunedDevice> devicesToTune(const TuneOptions& options) {
  SubjectFilter filter;
  if (!options.engine.empty()) filter.engines = {options.engine};
  filter.device = options.device;
  std::vector<TunedDevice> list;
  for (DeviceDescription& device : selectDevices(listDevices(), filter))
    list.push_back({std::move(device), {}});
  if (list.empty())
    throw InputError(
        joined({"no such device to tune; `haarlight devices` lists them", openClAdvice()}, "; "));
  return list;
}

/// The folder to keep shapes in; whether that is possible is found out before anything is measured.
fs::path writableFolder() {
  const fs::path folder = cacheFolder();
  if (folder.empty())
    throw InputError("there is no folder to keep shapes in: set HAARLIGHT_CACHE_DIR");
  std::error_code ignored;  // then there is no folder, which checkTarget says
  fs::create_directories(folder, ignored);
  checkTarget(tunedShapesFile(folder), {".txt"});
  return folder;
}

std::string milliseconds(double seconds) {
  return fixedText(1e3 * seconds, 2);
}

void measure(TunedDevice& tuned, const TuningFrames& frames, Console& console) {
  const auto shapes = shapesOf(tuned.device.engine);
  const auto progress = console.progress();
  double finished = 0;
  const auto time = [&](const KernelShape& shape) {
    if (progress) progress("tuning " + tuned.name(), finished++ / double(shapes.size()));
    const ShapeSeconds seconds = timePaperFrame(tuned.device, shape, frames);
    if (!frames.interrupted())
      console.message(fmt::format("{}, {}: exact {} ms, table {} ms", tuned.name(), nameOf(shape),
                                  milliseconds(seconds.exact), milliseconds(seconds.table)));
    return seconds;
  };
  tuned.timings = timeShapes(shapes, time, frames.interrupted);
}

void keepShapes(const std::vector<TunedDevice>& devices, const fs::path& folder, Console& console) {
  TunedShapes shapes =
      TunedShapes::read(folder, [&](const std::string& warning) { console.warning(warning); });
  for (const TunedDevice& tuned : devices) {
    const ShapeTiming* chosen = tuned.chosen();
    shapes.keep(tuned.device, chosen ? std::optional(chosen->shape) : std::nullopt);
    if (!chosen) console.warning(tuned.name() + ": no shape passes; none is kept");
  }
  shapes.write(folder);
}

nlohmann::ordered_json describe(const TunedDevice& tuned) {
  nlohmann::ordered_json entry{{"engine", tuned.device.engine},
                               {"index", tuned.device.index},
                               {"name", tuned.device.name},
                               {"driver", tuned.device.driver}};
  for (const ShapeTiming& timing : tuned.timings) {
    nlohmann::ordered_json row = describeShape(timing.shape);
    if (timing.failure.empty()) {
      row["exact_milliseconds"] = 1e3 * timing.seconds.exact;
      row["table_milliseconds"] = 1e3 * timing.seconds.table;
    } else {
      row["failure"] = timing.failure;
    }
    entry["timings"].push_back(row);
  }
  if (const ShapeTiming* chosen = tuned.chosen()) entry["chosen"] = describeShape(chosen->shape);
  return entry;
}

std::string tableOf(const TunedDevice& tuned) {
  std::vector<Cells> lines{{"lanes an item", "samples a group", "exact, ms", "table, ms", ""}};
  std::string failures;
  for (const ShapeTiming& timing : tuned.timings) {
    const auto& [shape, seconds, failure] = timing;
    if (failure.empty())
      lines.push_back({std::to_string(shape.lanesPerItem), std::to_string(shape.samplesPerGroup),
                       milliseconds(seconds.exact), milliseconds(seconds.table),
                       &timing == tuned.chosen() ? "chosen" : ""});
    else
      failures += "  " + nameOf(shape) + ": " + visible(failure) + "\n";
  }
  return tuned.name() + "\n" + alignedText(lines, 0, "  ") + failures;
}

void print(const std::vector<TunedDevice>& devices, const fs::path& file, bool isKept, bool json,
           Console& console) {
  if (json) {
    nlohmann::ordered_json results{{"device", nlohmann::ordered_json::array()}};
    for (const TunedDevice& tuned : devices) results["device"].push_back(describe(tuned));
    if (isKept) results["kept_in"] = file.string();
    return console.results(results);
  }
  std::string text;
  for (const TunedDevice& tuned : devices) text += tableOf(tuned);
  if (isKept) text += "kept in " + file.string() + "\n";
  std::fwrite(text.data(), 1, text.size(), stdout);  // main looks for errors on the stream
}

}  // namespace

nlohmann::ordered_json describeShape(const KernelShape& shape) {
  return {{"lanes_per_item", shape.lanesPerItem}, {"samples_per_group", shape.samplesPerGroup}};
}

void tuneDevices(const TuneOptions& options, bool json, Console& console) {
  std::vector<TunedDevice> devices = devicesToTune(options);
  const fs::path folder = writableFolder(), file = tunedShapesFile(folder);
  const InterruptWatch watch;
  TuningFrames frames;
  frames.table = std::make_shared<const SphereTable>(SphereTable::load(folder));
  frames.frames = options.frames;
  frames.samples = options.samples;
  frames.interrupted = [&] { return watch.interrupted(); };
  for (TunedDevice& tuned : devices) measure(tuned, frames, console);
  const bool isComplete = !watch.interrupted();
  if (isComplete)
    keepShapes(devices, folder, console);
  else
    console.warning("interrupted; these are the times so far, and " + file.string() +
                    " is as it was");
  print(devices, file, isComplete, json, console);
}

}  // namespace haarlight
