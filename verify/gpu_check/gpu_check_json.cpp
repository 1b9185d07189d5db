#include "verify/gpu_check/gpu_check_record.h"
#include "verify/report/json_writer.h"
#include "verify/report/report_writers.h"
#include "verify/subjects.h"

namespace haarlight::verify {

namespace {

void writeDevice(JsonWriter& json, const DeviceDescription& device) {
  json.beginObject();
  json.member("engine", device.engine);
  json.member("index", device.index);
  json.member("name", device.name);
  json.member("platform", device.platform);
  json.textOrNull("version", device.version);
  json.textOrNull("driver", device.driver);
  json.member("compute_units", device.computeUnits);
  json.member("global_memory_bytes", device.globalMemory);
  json.member("local_memory_bytes", device.localMemory);
  json.member("cpu", device.isCpu);
  json.member("emulation", device.emulation);
  json.textOrNull("numeric_limitation", device.numericLimitation);
  json.textOrNull("problem", device.problem);
  json.end();
}

void writeBudget(JsonWriter& json, const Budget& budget) {
  json.beginObject();
  json.member("memory_bytes", budget.memoryBytes);
  json.member("memory_limit_bytes", Budget::memoryLimit);
  json.member("largest_local_bytes", budget.largestLocalBytes);
  json.member("local_limit_bytes", Budget::localLimit);
  json.member("items_per_group", budget.itemsPerGroup);
  json.member("items_limit", Budget::itemsLimit);
  json.member("kept", budget.isKept());
  json.end();
}

void writeFrameRate(JsonWriter& json, const FrameRate& rate) {
  json.beginObject();
  json.member("visibility", nameOf(rate.visibility));
  json.member("spheres", rate.spheres);
  json.member("terms", rate.terms);
  json.member("levels", rate.levels);
  json.member("receivers", rate.receivers);
  json.member("frames_measured", rate.timing.frames);
  json.member("frames_per_second", rate.timing.framesPerSecond());
  json.member("seconds_per_frame_median", rate.timing.medianSeconds);
  json.member("seconds_per_frame_minimum", rate.timing.minimumSeconds);
  json.key("stage_seconds_median").beginObject();
  for (const NamedStage& stage : namedStages)
    json.member(stage.name, rate.stageMedians.*stage.seconds);
  json.end().end();
}

void writeMeasurement(JsonWriter& json, const DeviceMeasurement& measurement) {
  json.beginObject();
  json.member("engine", measurement.engine);
  json.member("device", measurement.device);
  json.textOrNull("failure", measurement.failure);
  json.key("budget");
  if (measurement.budget)
    writeBudget(json, *measurement.budget);
  else
    json.null();
  json.key("frame_rates").beginArray();
  for (const FrameRate& rate : measurement.frameRates) writeFrameRate(json, rate);
  json.end().end();
}

void writeStep(JsonWriter& json, const Step& step) {
  json.beginObject();
  json.member("name", step.name);
  json.member("result", nameOf(step.result));
  json.textOrNull("details", step.details);
  json.end();
}

}  // namespace

std::string jsonRecord(const GpuCheckRecord& record) {
  JsonWriter json;
  json.beginObject();
  json.member("program", record.report.program);
  json.member("host", record.report.host);
  json.member("date_utc", record.report.date);
  json.textOrNull("nvidia_driver", record.nvidiaDriver);
  json.member("shows_gpu_run", record.showsGpuRun());
  json.textOrNull("note", record.showsGpuRun() ? "" : noGpuNote);
  json.member("passes", record.passes());
  json.key("devices").beginArray();
  for (const DeviceDescription& device : record.devices) writeDevice(json, device);
  json.end().key("verify");
  writeReport(json, record.report);
  json.key("measurements").beginArray();
  for (const DeviceMeasurement& measurement : record.measurements)
    writeMeasurement(json, measurement);
  json.end().key("steps").beginArray();
  for (const Step& step : record.steps) writeStep(json, step);
  json.end().end();
  return json.text();
}

}  // namespace haarlight::verify
