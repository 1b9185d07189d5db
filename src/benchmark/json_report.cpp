#include "benchmark/paper_table.h"
#include "benchmark/reports.h"
#include "benchmark/roofline_report.h"
#include "engine/stage_times.h"

namespace haarlight::benchmark {

namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json secondsJson(const Quartiles& frame) {
  return {{"median", frame.median},
          {"minimum", frame.minimum},
          {"lower_quartile", frame.lower},
          {"upper_quartile", frame.upper}};
}

Json stagesJson(const StageTimes& medians) {
  Json json;
  for (const NamedStage& stage : namedStages) json[stage.name] = medians.*stage.seconds;
  json["total"] = medians.total;
  return json;
}

Json paperJson(const Row& row) {
  const Setting& at = row.setting;
  const auto paper = paperFigures(at.spheres, at.terms, at.levels);
  if (!paper) return nullptr;
  return {{"cpu_frames_per_second", paper->cpu},
          {"gpu_frames_per_second", paper->gpu},
          {"times_cpu", row.frame.perSecond() / paper->cpu},
          {"times_gpu", row.frame.perSecond() / paper->gpu}};
}

Json subjectJson(const MeasuredSubject& subject, const RowName& name) {
  const DeviceDescription& device = subject.subject.device;
  return {{"engine", name.engine},
          {"device", name.device},
          {"visibility", name.visibility},
          {"path", name.path},
          {"platform", orNull(device.platform)},
          {"version", orNull(device.version)},
          {"driver", orNull(device.driver)},
          {"compute_units", device.computeUnits},
          {"open_seconds", subject.openSeconds},
          {"compile_seconds", subject.compileSeconds},
          {"device_bytes", subject.deviceBytes}};
}

Json rowJson(const Record& record, const Row& row, const RowName& name) {
  Json json = nameJson(name);
  json["spheres_in_scene"] = row.blockers;
  json["frames_measured"] = row.frame.count;
  json["frames_per_second"] = row.frame.perSecond();
  json["frame_seconds"] = secondsJson(row.frame);
  json["stage_seconds_median"] = stagesJson(row.stageMedians);
  json["light_upload_seconds"] = row.lightUploadSeconds;
  json["paper"] = paperJson(row);
  const auto embree = embreeSeconds(record);
  json["times_embree"] = embree ? Json(*embree / row.frame.median) : Json();
  return json;
}

Json errorsJson(const Errors& errors) {
  return {{"against_mesh_percent", 100 * errors.againstMesh},
          {"against_spheres_percent", 100 * errors.againstSpheres}};
}

Json peersJson(const Record& record, const std::vector<NamedTimes>& names) {
  if (!record.peers) return nullptr;
  Json json{{"spheres", record.peers->spheres},
            {"threads", record.peers->threads},
            {"staged_subject", record.peers->stagedSubject},
            {"methods", Json::array()},
            {"rows", Json::array()}};
  for (const Peer& peer : record.peers->peers)
    json["methods"].push_back({{"name", peer.name},
                               {"description", peer.description},
                               {"frames_measured", peer.frame.count},
                               {"frame_seconds", secondsJson(peer.frame)},
                               {"device_seconds", peer.deviceSeconds},
                               {"times_embree", *embreeSeconds(record) / peer.frame.median},
                               {"error", errorsJson(peer.errors)}});
  for (const RowErrors& errors : record.peers->rowErrors) {
    json["rows"].push_back(nameJson(names[errors.row].name));
    json["rows"].back()["error"] = errorsJson(errors.errors);
  }
  return json;
}

Json sweepJson(const Sweep& sweep) {
  Json json{{"parameter", sweep.parameter}, {"points", Json::array()}, {"exponents", nullptr}};
  for (const ScalePoint& point : sweep.points)
    json["points"].push_back({{"size", point.size},
                              {"frames_measured", point.frame.count},
                              {"frame_seconds", secondsJson(point.frame)}});
  if (const auto& law = sweep.law)
    json["exponents"] = {{"all", law->exponent},
                         {"upper_half", law->upperHalfExponent},
                         {"above_fixed_cost", law->exponentAboveFixed},
                         {"fixed_seconds", law->fixedSeconds}};
  return json;
}

Json scaleJson(const Record& record) {
  if (!record.scale) return nullptr;
  const Scale& scale = *record.scale;
  Json json{{"subject", record.subjects[scale.subject].subject.name()},
            {"samples", scale.samples},
            {"spheres", scale.setting.spheres},
            {"terms", scale.setting.terms},
            {"levels", scale.setting.levels},
            {"sweeps", Json::array()}};
  for (const Sweep& sweep : scale.sweeps) json["sweeps"].push_back(sweepJson(sweep));
  return json;
}

Json comparisonJson(const Comparison* comparison) {
  if (!comparison) return nullptr;
  Json json{{"file", comparison->earlier.file},
            {"host", comparison->earlier.host},
            {"date_utc", comparison->earlier.date},
            {"rows", Json::array()},
            {"only_now", Json::array()},
            {"only_before", Json::array()}};
  for (const RowRatio& row : comparison->ratios) {
    json["rows"].push_back(nameJson(row.name));
    json["rows"].back().update(Json{{"ratio", row.ratio},
                                    {"lowest", row.lowest},
                                    {"highest", row.highest},
                                    {"verdict", row.verdict()}});
  }
  for (const RowName& name : comparison->onlyNow) json["only_now"].push_back(nameJson(name));
  for (const RowName& name : comparison->onlyBefore) json["only_before"].push_back(nameJson(name));
  return json;
}

}  // namespace

nlohmann::ordered_json nameJson(const RowName& name) {
  return {{"engine", name.engine},           {"device", name.device},
          {"visibility", name.visibility},   {"path", name.path},
          {"spheres", name.setting.spheres}, {"terms", name.setting.terms},
          {"levels", name.setting.levels}};
}

nlohmann::ordered_json jsonReport(const Record& record, const Comparison* comparison) {
  Json json{{"program", record.program},
            {"build", record.build},
            {"host", record.host},
            {"date_utc", record.date},
            {"threads", record.threads},
            {"scene", record.scene},
            {"light", record.light},
            {"samples", record.samples},
            {"interrupted", record.interrupted},
            {"peak_memory_mebibytes", record.peakMemoryMebibytes},
            {"timing",
             {{"frames", record.frames},
              {"rounds", record.rounds},
              {"warm_up_frames", record.warmUpFrames},
              {"notes", timingNotes(record)}}},
            {"subjects", Json::array()},
            {"rows", Json::array()}};
  for (const MeasuredSubject& subject : record.subjects)
    json["subjects"].push_back(subjectJson(subject, nameOf(subject.subject)));
  const std::vector<NamedTimes> names = namedTimes(record);
  for (std::size_t i = 0; i < names.size(); ++i)
    json["rows"].push_back(rowJson(record, record.rows[i], names[i].name));
  json["peers"] = peersJson(record, names);
  json["scale"] = scaleJson(record);
  json["roofline"] = rooflineJson(record);
  json["comparison"] = comparisonJson(comparison);
  return json;
}

}  // namespace haarlight::benchmark
