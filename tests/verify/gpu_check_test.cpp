#include <sys/wait.h>

#include <cstdlib>

#include "base/error.h"
#include "base/file.h"
#include "report_test_support.h"
#include "test_support.h"
#include "verify/cases/random_cases.h"
#include "verify/gpu_check/gpu_check_run.h"

using namespace haarlight;
using namespace haarlight::test;
using namespace haarlight::verify;

namespace {

std::shared_ptr<const SphereTable> sphereTable() {
  return std::make_shared<const SphereTable>(SphereTable::load(cacheFolder()));
}

GpuCheckRecord tinyRecord() {
  GpuCheckOptions options;
  options.run.engines = {"cuda-host"};
  options.run.knownCases = false;
  options.run.randomCases = 1;
  options.measures = false;
  return checkGpus(options, sphereTable());
}

DeviceMeasurement measurementWithKnownFigures() {
  FrameRate rate;
  rate.visibility = VisibilityKind::table;
  rate.spheres = 96;
  rate.terms = 200;
  rate.levels = 2;
  rate.receivers = 16384;
  rate.timing = {20, 0.25, 0.125};
  rate.stageMedians.tripleProduct = 0.0625;
  DeviceMeasurement measurement{"cuda", "a GPU", Budget{1000, 2000, 128}, {rate}, ""};
  return measurement;
}

int exitCodeOf(const std::string& arguments) {
  const std::string command = HAARLIGHT_GPU_CHECK " " + arguments + " >/dev/null 2>&1";
  return WEXITSTATUS(std::system(command.c_str()));
}

}  // namespace

TEST_CASE("GPU check: the record of a run without a GPU says so") {
  const GpuCheckRecord record = tinyRecord();
  CHECK(record.passes());
  CHECK(!record.showsGpuRun());
  const Json json = readJson(jsonRecord(record));
  CHECK(namesBelow(json, "") == std::set<std::string>{"program", "host", "date_utc",
                                                      "nvidia_driver", "shows_gpu_run", "note",
                                                      "passes", "devices", "verify"});
  CHECK(json.at("/shows_gpu_run") == "false");
  CHECK(json.at("/note") == "\"no GPU: this record shows no GPU run\"");
  CHECK(json.at("/verify/agrees") == "true");
  CHECK(json.at("/verify/cases/random") == "1");
  CHECK(json.at("/verify/rows/0/engine") == "\"cuda-host\"");
  CHECK(namesBelow(json, "/devices").size() == record.devices.size());
  CHECK(namesBelow(json, "/devices/0") ==
        std::set<std::string>{"engine", "index", "name", "platform", "version", "driver",
                              "compute_units", "global_memory_bytes", "local_memory_bytes", "cpu",
                              "emulation", "numeric_limitation", "problem"});
  CHECK(textRecord(record).ends_with("no GPU: this record shows no GPU run\n\nPASSED\n"));
}

TEST_CASE("GPU check: a GPU run is one whose rows compared something on a GPU") {
  GpuCheckRecord record = tinyRecord();
  DeviceDescription& device = record.devices.emplace_back();
  device.engine = "cuda";
  device.name = "a GPU";
  CHECK(!record.showsGpuRun());
  Row& row = record.report.rows.emplace_back();
  row.engine = device.engine;
  row.device = device.name;
  CHECK(!record.showsGpuRun());
  row.compared = 1;
  CHECK(record.showsGpuRun());
  CHECK(readJson(jsonRecord(record)).at("/note") == "null");
  device.isCpu = true;
  CHECK(!record.showsGpuRun());
}

TEST_CASE("GPU check: the record holds budgets, frame rates and steps") {
  GpuCheckRecord record = tinyRecord();
  record.measurements.push_back(measurementWithKnownFigures());
  record.steps = {{"tests", StepResult::passed, "all"},
                  {"compute-sanitizer memcheck", StepResult::notRun, ""}};
  CHECK(record.passes());
  const Json json = readJson(jsonRecord(record));
  CHECK(json.at("/measurements/0/device") == "\"a GPU\"");
  CHECK(json.at("/measurements/0/budget/memory_bytes") == "1000");
  CHECK(json.at("/measurements/0/budget/largest_local_bytes") == "2000");
  CHECK(json.at("/measurements/0/budget/kept") == "true");
  const std::string rate = "/measurements/0/frame_rates/0/";
  CHECK(json.at(rate + "visibility") == "\"table\"");
  CHECK(json.at(rate + "spheres") == "96");
  CHECK(json.at(rate + "terms") == "200");
  CHECK(json.at(rate + "levels") == "2");
  CHECK(json.at(rate + "receivers") == "16384");
  CHECK(json.at(rate + "frames_measured") == "20");
  CHECK(json.at(rate + "frames_per_second") == "4");
  CHECK(json.at(rate + "seconds_per_frame_median") == "0.25");
  CHECK(json.at(rate + "seconds_per_frame_minimum") == "0.125");
  CHECK(json.at(rate + "stage_seconds_median/triple_product") == "0.0625");
  CHECK(json.at("/steps/0/result") == "\"passed\"");
  CHECK(json.at("/steps/0/details") == "\"all\"");
  CHECK(json.at("/steps/1/result") == "\"not run\"");
  CHECK(textRecord(record).find(" 4.00 ") != std::string::npos);
}

TEST_CASE("GPU check: a failed step or device is a failure, a missing one is not") {
  GpuCheckRecord record = tinyRecord();
  record.steps = {{"tests", StepResult::notRun, ""}};
  CHECK(record.passes());
  record.steps[0].result = StepResult::failed;
  CHECK(!record.passes());
  CHECK(textRecord(record).ends_with("\nFAILED\n"));
  record.steps.clear();
  record.measurements.push_back({"cuda", "a GPU", std::nullopt, {}, "out of memory"});
  CHECK(!record.passes());
  CHECK(readJson(jsonRecord(record)).at("/measurements/0/budget") == "null");
}

TEST_CASE("GPU check: frames are timed from call to return") {
  const Case frame = randomCase(1, 0);
  EngineOptions options;
  options.engine = "cuda-host";
  const auto engine = makeEngine(options, nullptr);
  engine->setShading(buildShadingTables(frame.light, {50, 1}, countLobes(frame.receivers.lobes)));
  const FrameRate rate = measureFrame(*engine, frame);
  CHECK(rate.receivers == frame.receivers.size());
  CHECK(rate.timing.frames >= 5);
  CHECK(rate.timing.frames <= 100);
  CHECK(rate.timing.minimumSeconds > 0);
  CHECK(rate.timing.medianSeconds >= rate.timing.minimumSeconds);
  CHECK(rate.timing.framesPerSecond() * rate.timing.medianSeconds == doctest::Approx(1));
  const double stages = rate.stageMedians.fused + rate.stageMedians.merge;
  CHECK(stages > 0);
  CHECK(rate.stageMedians.total >= stages);
  CHECK(rate.stageMedians.total <= rate.timing.medianSeconds);
}

TEST_CASE("GPU check: wrong usage ends with exit code 2 before any work") {
  const TemporaryFolder folder;
  CHECK(exitCodeOf("--help") == 0);
  for (const char* arguments : {"--speed", "record.json", "-o", "-o /nowhere/record.json",
                                "--step tests", "--step tests perhaps ''", "--step tests passed"}) {
    CAPTURE(arguments);
    CHECK(exitCodeOf(arguments) == 2);
  }
  CHECK_THROWS_AS(stepResult("perhaps"), InputError);
  for (const StepResult result : {StepResult::passed, StepResult::failed, StepResult::notRun})
    CHECK(stepResult(nameOf(result)) == result);
}

TEST_CASE("a median is the middle value") {
  CHECK(median({3}) == 3);
  CHECK(median({5, 1, 3}) == 3);
  CHECK(median({4, 1, 3, 2}) == 3);
}

TEST_CASE("frames are timed after a first one that does not count") {
  int calls = 0;
  const FrameTiming timing = timeFrames([&] { return calls++ ? 0.5 : 9.0; });
  CHECK(timing.frames >= 5);
  CHECK(timing.frames <= 100);
  CHECK(calls == int(timing.frames) + 1);
  CHECK(timing.medianSeconds == 0.5);
  CHECK(timing.minimumSeconds == 0.5);
  CHECK(timing.framesPerSecond() == 2);
}
