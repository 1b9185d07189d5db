#include <compare>
#include <set>

#include "base/text_format.h"
#include "benchmark/paper_table.h"
#include "benchmark/reports.h"
#include "benchmark/roofline_report.h"
#include "report/plot_sheet.h"
#include "verify/gpu_check/gpu_check_run.h"

namespace haarlight::benchmark {

namespace {

PlotSeries& seriesNamed(LinePlot& plot, const std::string& name) {
  for (PlotSeries& series : plot.series)
    if (series.name == name) return series;
  plot.series.push_back({.name = name, .points = {}, .joined = true, .marked = true});
  return plot.series.back();
}

std::string settingName(int terms, int levels) {
  return countText(std::uint64_t(terms), "term") + (levels == 1 ? ", level I" : ", level II");
}

/// "exact, fused".
std::string variantName(const Record& record, const Row& row) {
  const Subject& subject = record.subjects[row.subject].subject;
  return joined({subject.visibilityName(), subject.pathName()}, ", ");
}

/// What panels are made for: a device, with one number of terms and levels.
struct Panel {
  std::string device;
  int terms = 0, levels = 0;

  auto operator<=>(const Panel&) const = default;
};

Panel panelOf(const Record& record, const Row& row) {
  const DeviceDescription& device = record.subjects[row.subject].subject.device;
  return {joined({device.engine, device.name}, " · "), row.setting.terms, row.setting.levels};
}

/// The subjects of a panel, and the paper's figures where it has them.
LinePlot rateLines(const Record& record, const Panel& panel) {
  LinePlot plot;
  plot.title = panel.device + ", " + settingName(panel.terms, panel.levels);
  plot.xLabel = "spheres";
  plot.yLabel = "frames per second";
  for (const Row& row : record.rows)
    if (panelOf(record, row) == panel)
      seriesNamed(plot, variantName(record, row))
          .points.emplace_back(row.setting.spheres, row.frame.perSecond());
  for (const int spheres : verify::paperSphereCounts)
    if (const auto paper = paperFigures(spheres, panel.terms, panel.levels)) {
      seriesNamed(plot, panel.levels == 1 ? "paper, GPU-I" : "paper, GPU-II")
          .points.emplace_back(spheres, paper->gpu);
      seriesNamed(plot, "paper, CPU").points.emplace_back(spheres, paper->cpu);
    }
  return plot;
}

/// Linear and logarithmic, side by side.
void addRates(std::vector<LinePlot>& plots, const Record& record) {
  std::set<Panel> drawn;
  for (const Row& row : record.rows) {
    const Panel panel = panelOf(record, row);
    if (!drawn.insert(panel).second) continue;
    plots.push_back(rateLines(record, panel));
    plots.push_back(plots.back());
    plots.back().logarithmicY = true;
  }
}

LinePlot errorLines(const Record& record, const std::string& reference, double Errors::*error) {
  LinePlot plot;
  plot.title = "Root mean square error against " + reference + ", " +
               countText(std::uint64_t(record.peers->spheres), "sphere");
  plot.xLabel = "milliseconds a frame";
  plot.yLabel = "error (% of mean)";
  plot.logarithmicX = true;
  const auto add = [&](const std::string& name, const Quartiles& frame, const Errors& errors) {
    seriesNamed(plot, name).points.emplace_back(1e3 * frame.median, 100 * (errors.*error));
  };
  for (const RowErrors& errors : record.peers->rowErrors) {
    const Row& row = record.rows[errors.row];
    const Subject& subject = record.subjects[row.subject].subject;
    add(joined({subject.device.engine, subject.visibilityName()}, ", "), row.frame, errors.errors);
  }
  for (const Peer& peer : record.peers->peers) add(kindOf(peer), peer.frame, peer.errors);
  for (PlotSeries& series : plot.series) series.joined = false;
  return plot;
}

LinePlot sweepLines(const Sweep& sweep) {
  LinePlot plot;
  plot.title = "Time over " + sweep.parameter;
  if (sweep.law)
    plot.title += ": exponent " + fixedText(sweep.law->upperHalfExponent, 2) + " in the upper half";
  plot.xLabel = sweep.parameter;
  plot.yLabel = "milliseconds a frame";
  plot.logarithmicX = plot.logarithmicY = true;
  for (const ScalePoint& point : sweep.points)
    seriesNamed(plot, "median").points.emplace_back(point.size, 1e3 * point.frame.median);
  return plot;
}

}  // namespace

std::string svgReport(const Record& record) {
  std::vector<LinePlot> plots;
  addRates(plots, record);
  if (record.peers) {
    plots.push_back(errorLines(record, "rays to the mesh", &Errors::againstMesh));
    plots.push_back(errorLines(record, "all texels", &Errors::againstSpheres));
  }
  if (record.scale)
    for (const Sweep& sweep : record.scale->sweeps) plots.push_back(sweepLines(sweep));
  const std::vector<LinePlot> rooflines = rooflinePlots(record);
  plots.insert(plots.end(), rooflines.begin(), rooflines.end());
  return plotSheetSvg("haarlight bench: " + record.scene, plots);
}

}  // namespace haarlight::benchmark
