#include "benchmark/roofline_report.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "base/text_format.h"
#include "benchmark/reports.h"
#include "benchmark/text_table.h"

namespace haarlight::benchmark {

namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(double StageTimes::*stage) {
  return std::ranges::find(namedStages, stage, &NamedStage::seconds)->name;
}

std::string titleOf(double StageTimes::*stage) {
  std::string title = nameOf(stage);
  std::ranges::replace(title, '_', ' ');
  return title;
}

RowName rowName(const Record& record, const RowRoofline& roofline) {
  return namedTimes(record)[roofline.row].name;
}

Json ceilingsJson(const Ceilings& ceilings) {
  Json json{{"threads", ceilings.threads},
            {"instructions", ceilings.instructions},
            {"memory", Json::array()},
            {"joins_per_second", ceilings.joins},
            {"multiply_add_operations_per_second", ceilings.multiplyAdds}};
  for (const MemoryCeiling& level : ceilings.memory)
    json["memory"].push_back(
        {{"name", level.name},
         {"bytes_per_thread", level.bytesPerThread},
         {"holds_bytes", std::isfinite(level.holdsBytes) ? Json(level.holdsBytes) : Json()},
         {"copy_bytes_per_second", level.copy},
         {"read_bytes_per_second", level.read}});
  return json;
}

Json countsJson(const FrameCounts& counts) {
  return {{"samples", counts.samples},
          {"spheres", counts.spheres},
          {"lobes", counts.lobes},
          {"different_lobes", counts.differentLobes},
          {"squares", counts.squares},
          {"blocked_rows", counts.blockedRows},
          {"weight_rows", counts.weightRows},
          {"different_blocked_rows", counts.differentBlockedRows},
          {"mask_groups", counts.maskGroups},
          {"mask_groups_of_tiles", counts.maskGroupsOfTiles},
          {"masks_of_tiles", counts.masksOfTiles},
          {"mask_groups_of_frame", counts.maskGroupsOfFrame},
          {"masks_of_frame", counts.masksOfFrame},
          {"reached_faces", counts.reachedFaces},
          {"reached_rows", counts.reachedRows}};
}

Json stageJson(const StageRoofline& stage) {
  return {{"stage", nameOf(stage.work.stage)},
          {"operations", stage.work.operations},
          {"bytes", stage.work.bytes()},
          {"least_seconds", stage.limit.seconds},
          {"bound_by", stage.limit.boundBy},
          {"measured_seconds", stage.measuredSeconds},
          {"share", stage.share()}};
}

Cells stageCells(const std::string& name, const Cells& work, double least, double measured) {
  Cells cells{name};
  cells.insert(cells.end(), work.begin(), work.end());
  cells.insert(cells.end(), {fixedText(1e3 * least, 3), fixedText(1e3 * measured, 3),
                             fixedText(100 * least / measured, 1)});
  return cells;
}

std::string rowText(const Record& record, const RowRoofline& roofline) {
  std::vector<Cells> lines{
      {"stage", "Mop", "MB", "op/B", "bound by", "least ms", "measured ms", "share %"}};
  for (const StageRoofline& stage : roofline.stages) {
    const StageWork& work = stage.work;
    lines.push_back(
        stageCells(titleOf(work.stage),
                   {fixedText(1e-6 * work.operations, 1), fixedText(1e-6 * work.bytes(), 1),
                    fixedText(work.operations / work.bytes(), 2), stage.limit.boundBy},
                   stage.limit.seconds, stage.measuredSeconds));
  }
  lines.push_back(stageCells("frame", {"", "", "", ""}, roofline.leastSeconds(),
                             record.rows[roofline.row].frame.median));
  return "\n" + visible(rowName(record, roofline).text()) + "\n" + alignedText(lines, 1, "  ");
}

std::string ceilingsText(const Ceilings& ceilings) {
  std::vector<Cells> lines{{"memory", "KiB a thread", "copy GB/s", "read GB/s"}};
  for (const MemoryCeiling& level : ceilings.memory)
    lines.push_back({level.name, countText(level.bytesPerThread / 1024),
                     fixedText(1e-9 * level.copy, 1), fixedText(1e-9 * level.read, 1)});
  return "\nCeilings of the host's processor, " + countText(ceilings.threads, "thread") + ", " +
         ceilings.instructions + "\n" + alignedText(lines, 1, "  ") +
         "  OR of 32-bit words: " + fixedText(1e-9 * ceilings.joins, 1) +
         " G/s; fused multiply-adds in float32: " + fixedText(1e-9 * ceilings.multiplyAdds, 1) +
         " GFLOP/s, two operations each\n";
}

/// The stages of a device with one kind of visibility, on all its paths, that compute anything.
std::vector<PlotSeries> stagePoints(const Record& record, const RowName& name) {
  std::vector<PlotSeries> points;
  for (const RowRoofline& roofline : record.roofline->rows) {
    const RowName own = rowName(record, roofline);
    if (std::tie(own.engine, own.device, own.visibility) !=
        std::tie(name.engine, name.device, name.visibility))
      continue;
    for (const StageRoofline& stage : roofline.stages)
      if (const double operations = stage.work.operations; operations > 0)
        points.push_back(
            {titleOf(stage.work.stage),
             {{operations / stage.work.bytes(), 1e-9 * operations / stage.measuredSeconds}},
             false,
             true});
  }
  return points;
}

/// Lines over operations a byte between `from` and `to`: what memory allows up to the roof, and the
/// roofs themselves.
std::vector<PlotSeries> ceilingLines(const Ceilings& ceilings, double from, double to) {
  std::vector<PlotSeries> lines;
  for (const MemoryCeiling& level : ceilings.memory) {
    const double end = std::min(to, ceilings.operations() / level.fastest());
    if (from < end)
      lines.push_back(
          {level.name,
           {{from, 1e-9 * from * level.fastest()}, {end, 1e-9 * end * level.fastest()}}});
  }
  const auto add = [&](const char* name, double rate) {
    lines.push_back({name, {{from, 1e-9 * rate}, {to, 1e-9 * rate}}});
  };
  add("OR", ceilings.joins);
  add("multiply-add", ceilings.multiplyAdds);
  return lines;
}

LinePlot rooflinePlot(const Record& record, const RowName& name) {
  LinePlot plot;
  plot.title = joined({name.engine, name.device, name.visibility}, " · ");
  plot.xLabel = "operations per byte (lines: ceilings; symbols: stages)";
  plot.yLabel = "10\u2079 operations per second";
  plot.logarithmicX = plot.logarithmicY = true;
  const std::vector<PlotSeries> points = stagePoints(record, name);
  const Ceilings& ceilings = record.roofline->ceilings;
  double least = ceilings.operations() / ceilings.memory.front().fastest(),
         most = ceilings.operations() / ceilings.memory.back().fastest();
  for (const PlotSeries& series : points) {
    least = std::min(least, series.points[0].x);
    most = std::max(most, series.points[0].x);
  }
  plot.series = ceilingLines(ceilings, least / 2, 2 * most);
  plot.series.insert(plot.series.end(), points.begin(), points.end());
  return plot;
}

}  // namespace

nlohmann::ordered_json rooflineJson(const Record& record) {
  if (!record.roofline) return nullptr;
  Json json{{"ceilings", ceilingsJson(record.roofline->ceilings)}, {"rows", Json::array()}};
  for (const RowRoofline& roofline : record.roofline->rows) {
    Json row = nameJson(rowName(record, roofline));
    row["counts"] = countsJson(roofline.counts);
    row["least_seconds"] = roofline.leastSeconds();
    row["stages"] = Json::array();
    for (const StageRoofline& stage : roofline.stages) row["stages"].push_back(stageJson(stage));
    json["rows"].push_back(row);
  }
  return json;
}

std::string rooflineText(const Record& record) {
  if (!record.roofline) return {};
  std::string text = ceilingsText(record.roofline->ceilings);
  for (const RowRoofline& roofline : record.roofline->rows) text += rowText(record, roofline);
  return text;
}

std::vector<LinePlot> rooflinePlots(const Record& record) {
  std::vector<LinePlot> plots;
  if (!record.roofline) return plots;
  std::set<std::tuple<std::string, std::string, std::string>> drawn;
  for (const RowRoofline& roofline : record.roofline->rows) {
    const RowName name = rowName(record, roofline);
    if (drawn.insert({name.engine, name.device, name.visibility}).second)
      plots.push_back(rooflinePlot(record, name));
  }
  return plots;
}

}  // namespace haarlight::benchmark
