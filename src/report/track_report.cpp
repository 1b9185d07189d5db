#include "report/track_report.h"

#include <functional>

#include "base/error.h"
#include "base/file.h"
#include "base/html.h"
#include "base/text_format.h"
#include "render/track_summary.h"
#include "report/plot_sheet.h"
#include "report/track_table.h"

namespace haarlight {

namespace {

/// A figure of a frame; none where the frame does not have it.
using Figure = std::function<std::optional<double>(const TrackFrame&)>;
using ObjectFigure = std::function<std::optional<double>(const ObjectFrame&)>;

PlotSeries seriesOf(const TrackReport& report, const std::string& name, const Figure& figure,
                    bool marked) {
  PlotSeries series{.name = name, .points = {}, .joined = true, .marked = marked};
  for (const TrackFrame& frame : report.frames)
    if (const auto value = figure(frame)) series.points.emplace_back(frame.frame, *value);
  return series;
}

void addSeries(LinePlot& plot, const PlotSeries& series) {
  if (!series.points.empty()) plot.series.push_back(series);
}

/// A series for each object, named after it where there are several.
void addObjects(LinePlot& plot, const TrackReport& report, const std::string& name,
                const ObjectFigure& figure, bool marked = false) {
  for (std::size_t i = 0; i < report.objects.size(); ++i)
    addSeries(plot,
              seriesOf(
                  report, joined({name, report.objects.size() > 1 ? report.objects[i] : ""}, ", "),
                  [&](const TrackFrame& f) { return figure(f.objects[i]); }, marked));
}

/// A measure of the moved spheres and of those fitted anew.
void addMeasure(LinePlot& plot, const TrackReport& report, const std::string& name,
                const std::function<std::optional<double>(const SphereMeasures&)>& measure) {
  addObjects(plot, report, joined({name, "moved"}, " "),
             [&](const ObjectFrame& object) { return measure(object.moved); });
  addObjects(
      plot, report, joined({name, "refitted"}, " "),
      [&](const ObjectFrame& object) {
        return object.refitted ? measure(*object.refitted) : std::nullopt;
      },
      true);
}

LinePlot emptyPlot(const std::string& title, const std::string& yLabel) {
  LinePlot plot;
  plot.title = title;
  plot.xLabel = "frame";
  plot.yLabel = yLabel;
  return plot;
}

LinePlot coveragePlot(const TrackReport& report) {
  LinePlot plot = emptyPlot("Surface in no sphere (100 % − covered)", "surface not covered (%)");
  addMeasure(plot, report, "",
             [](const SphereMeasures& m) { return 100 * (1 - m.coveredFraction); });
  return plot;
}

LinePlot outsidePlot(const TrackReport& report) {
  LinePlot plot =
      emptyPlot("Volume outside the mesh (E: summed over spheres)", "volume / mesh volume");
  addMeasure(plot, report, "E", [](const SphereMeasures& m) { return m.outsideVolumeRatio; });
  addMeasure(plot, report, "union", [](const SphereMeasures& m) { return m.unionOutsideRatio; });
  return plot;
}

LinePlot radiusPlot(const TrackReport& report) {
  LinePlot plot = emptyPlot("Radii of the moved spheres", "radius / radius at second 0");
  addObjects(plot, report, "largest", [](const ObjectFrame& o) { return o.radii.largest; });
  addObjects(plot, report, "mean", [](const ObjectFrame& o) { return o.radii.mean; });
  addObjects(plot, report, "smallest", [](const ObjectFrame& o) { return o.radii.smallest; });
  return plot;
}

LinePlot silhouettePlot(const TrackReport& report) {
  LinePlot plot = emptyPlot("Mean silhouette error", "of the mesh's silhouettes (%)");
  addMeasure(plot, report, "", [](const SphereMeasures& m) {
    return m.silhouette ? std::optional(100 * m.silhouette->mean) : std::nullopt;
  });
  return plot;
}

LinePlot planePlot(const TrackReport& report) {
  LinePlot plot = emptyPlot("Error of the plane's radiance against pixel-mesh",
                            "root mean square error / mean (%)");
  const auto percent = [](const ImageError& error) { return 100 * error.relativeRootMeanSquare; };
  addSeries(plot, seriesOf(
                      report, "moved",
                      [&](const TrackFrame& frame) {
                        return frame.plane ? std::optional(percent(frame.plane->moved))
                                           : std::nullopt;
                      },
                      false));
  addSeries(plot, seriesOf(
                      report, "refitted",
                      [&](const TrackFrame& frame) {
                        return frame.plane && frame.plane->refitted
                                   ? std::optional(percent(*frame.plane->refitted))
                                   : std::nullopt;
                      },
                      true));
  return plot;
}

std::vector<LinePlot> plotsOf(const TrackReport& report) {
  return {coveragePlot(report), outsidePlot(report), radiusPlot(report), silhouettePlot(report),
          planePlot(report)};
}

std::string headSection(const TrackReport& report) {
  const std::string range = numberText(report.frames.front().frame) + " to " +
                            numberText(report.frames.back().frame) + " at " +
                            numberText(report.framesPerSecond) + " per second";
  return element("h1", "Moved spheres") + "\n" +
         element("p", markup(report.conclusion()),
                 report.interrupted ? "conclusion within" : "conclusion agrees") +
         "\n" +
         element("dl", "\n" + definition("scene", report.scene) + definition("frames", range) +
                           (report.method.empty() ? "" : definition("method", report.method)) +
                           definition("program", report.program) + definition("host", report.host) +
                           definition("date", report.date)) +
         "\n";
}

std::string tableRow(const std::vector<std::string>& cells, const std::string& tag) {
  std::string text;
  for (const std::string& cell : cells) text += element(tag, markup(cell), "number");
  return element("tr", text) + "\n";
}

std::string tableSection(const TrackReport& report) {
  const TrackTable table = trackTable(report);
  std::string rows;
  for (const auto& row : table.rows) rows += tableRow(row, "td");
  return section("Frames", wideTable("\n" + element("thead", tableRow(table.header, "th")) + "\n" +
                                     element("tbody", "\n" + rows) + "\n"));
}

}  // namespace

std::string TrackReport::conclusion() const {
  const TrackSummary summary = summarize(frames);
  std::string text;
  for (std::size_t i = 0; i < objects.size(); ++i)
    text += (i > 0 ? "; " : "") + visible(objects[i]) + ": at least " +
            percentText(summary.objects[i].lowestCoverage, 2) +
            " of the surface is covered (frame " +
            numberText(summary.objects[i].lowestCoverageFrame) + "), the silhouettes differ by " +
            percentText(summary.objects[i].meanSilhouetteError, 1) + " on average";
  if (summary.plane)
    text +=
        "; the plane's radiance is off by " + percentText(summary.plane->mean, 2) + " of the mean";
  if (summary.planeRefits)
    text += ", " + fixedText(summary.planeRefits->ratioOfMeans, 2) +
            " times as much as with spheres fitted anew";
  return text + (interrupted ? "; interrupted before the last frame" : "");
}

std::string trackSvg(const TrackReport& report) {
  return plotSheetSvg("Moved spheres over frames: " + report.scene, plotsOf(report));
}

std::string trackHtml(const TrackReport& report) {
  std::string plots;
  for (const LinePlot& plot : plotsOf(report)) plots += linePlotFigure(plot);
  return htmlPage("Moved spheres: " + report.scene, linePlotStyle,
                  headSection(report) +
                      section("Over frames", element("div", "\n" + plots, "plots") + "\n") +
                      tableSection(report));
}

void writeTrackReport(const std::filesystem::path& path, const TrackReport& report) {
  const std::string extension = path.extension().string();
  if (extension == ".html")
    writeFileAtomically(path, trackHtml(report));
  else if (extension == ".svg")
    writeFileAtomically(path, trackSvg(report));
  else if (extension == ".json")
    writeFileAtomically(
        path,
        trackJson(report).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  else
    throw InputError("cannot write report " + path.string() +
                     ": its name must end in .html, .json or .svg");
}

}  // namespace haarlight
