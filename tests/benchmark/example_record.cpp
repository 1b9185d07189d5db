#include "example_record.h"

#include "engine/shading_tables.h"

namespace haarlight::test {

using namespace benchmark;

namespace {

Subject subjectWith(VisibilityKind visibility) {
  Subject subject;
  subject.device.engine = "opencl";
  subject.device.name = "Some \"CPU\", fast";
  subject.device.platform = "platform";
  subject.device.version = "1.2";
  subject.device.computeUnits = 2;
  subject.visibility = visibility;
  subject.path = FramePath::staged;
  return subject;
}

Row rowOf(std::size_t subject, const Setting& setting, double milliseconds) {
  Row row;
  row.subject = subject;
  row.setting = setting;
  row.blockers = std::size_t(setting.spheres);
  row.frame = quartilesOf({milliseconds / 1e3, milliseconds / 1e3, 2 * milliseconds / 1e3,
                           milliseconds / 2e3, milliseconds / 1e3});
  row.stageMedians.merge = 0.75 * row.frame.median;
  row.stageMedians.total = row.frame.median;
  row.lightUploadSeconds = 0.0005;
  return row;
}

Peer peerOf(const std::string& name, double seconds, const Errors& errors) {
  return {name, "what it does", quartilesOf({seconds}), 0.001, errors};
}

}  // namespace

Record exampleRecord() {
  Record record;
  record.program = "haarlight 0.1.0";
  record.build = "GNU 1, Release";
  record.host = "Some CPU";
  record.date = "2026-01-02T03:04:05Z";
  record.threads = 2;
  record.scene = "builtin:default";
  record.light = "builtin:lamps";
  record.samples = 16384;
  record.frames = 5;
  record.rounds = 5;
  record.warmUpFrames = 2;
  record.peakMemoryMebibytes = 100;
  record.subjects = {{subjectWith(VisibilityKind::exact), 1.5, 0.5, 1000},
                     {subjectWith(VisibilityKind::table), 2.5, 0.5, 2000}};
  record.rows = {rowOf(0, {64, 200, 2}, 4), rowOf(0, {7, 200, 2}, 1), rowOf(1, {64, 200, 2}, 8)};
  return record;
}

Record recordWithPeers() {
  Record record = exampleRecord();
  record.peers = PeerComparison{64, 2, "staged", {}, {}};
  record.peers->peers = {peerOf(embreePeer, 2, {0, 0.01}),
                         peerOf("double product; 50 terms", 0.005, {0.02, 0.03}),
                         peerOf("double product; 200 terms", 0.0055, {0.01, 0.001})};
  record.peers->rowErrors = {{0, {0.015, 0.004}}, {2, {0.025, 0.014}}};
  return record;
}

Record recordWithRoofline() {
  Record record = exampleRecord();
  record.roofline.emplace();
  Ceilings& ceilings = record.roofline->ceilings;
  ceilings.threads = 2;
  ceilings.instructions = "some vectors";
  ceilings.memory = ceilingPlan(2).memory;
  for (double rate = 4e11; MemoryCeiling & level : ceilings.memory) {
    level.copy = rate;
    level.read = rate /= 2;
  }
  ceilings.joins = 2e11;
  ceilings.multiplyAdds = 1e11;
  FrameCounts counts;
  counts.samples = 16384;
  counts.spheres = 64;
  counts.maskGroups = counts.maskGroupsOfTiles = counts.maskGroupsOfFrame = 1.5e6;
  counts.masksOfTiles = counts.masksOfFrame = 1e6;
  record.roofline->rows = {rooflineOf(record, 2, counts, ceilings)};
  return record;
}

Record recordWithScale() {
  Record record = exampleRecord();
  record.rows.clear();
  record.scale = Scale{0, 16384, {64, 200, 2}, {}};
  for (const char* parameter : {"samples", "spheres", "terms"}) {
    Sweep sweep{parameter, {}, std::nullopt};
    std::vector<glm::dvec2> times;
    for (const double size : {8, 16, 32, 64}) {
      sweep.points.push_back({size, quartilesOf({size / 1e3})});
      times.emplace_back(size, size / 1e3);
    }
    sweep.law = fitPowerLaw(times);
    record.scale->sweeps.push_back(sweep);
  }
  record.scale->sweeps.back().law.reset();
  return record;
}

}  // namespace haarlight::test
