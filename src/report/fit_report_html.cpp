#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/html.h"
#include "base/text_format.h"
#include "image/write_image.h"
#include "report/fit_pictures.h"
#include "report/fit_report.h"
#include "report/line_plot.h"
#include "scene/names.h"

namespace haarlight {

namespace {

constexpr char pageStyle[] = R"(
td.meaning { color: var(--soft); }
@media (min-width: 50rem) { td.name { white-space: nowrap; } }
.pictures { display: grid; grid-template-columns: repeat(3, minmax(0, 360px)); gap: .5rem .75rem; }
.pictures h3 { margin: .5rem 0 0; }
.pictures .side { grid-column: 1 / -1; margin: .75rem 0 -.25rem; font-weight: 600; }
.pictures figure { margin: 0; }
.pictures figcaption { font-weight: 400; font-size: .85rem; color: var(--soft); margin: 0; }
.pictures img { display: block; width: 100%; height: auto; border-radius: 4px; }
@media (prefers-color-scheme: dark) { .pictures img { filter: brightness(.85); } }
.swatch { width: .8rem; height: .8rem; border-radius: 3px; }
)";

std::string requestText(const FitReport& report) {
  const auto number = [](const std::optional<double>& value) {
    return value ? numberText(*value) : "";
  };
  return joined({countText(report.requestedSpheres, "sphere") + " at most",
                 report.maximumError ? "error " + number(report.maximumError) : "",
                 report.timeLimit ? "within " + number(report.timeLimit) + " s" : ""},
                ", ");
}

std::string meshText(const FitReport& report) {
  const MeshTopology& topology = report.mesh.topology;
  return joined({countText(report.mesh.mesh.triangles.size(), "triangle"),
                 countText(topology.vertices) + (topology.vertices == 1 ? " vertex" : " vertices"),
                 countText(topology.components, "part"), topology.closed ? "closed" : "open"},
                ", ");
}

std::string fitSection(const FitReport& report) {
  const SphereSet& set = report.fit.set;
  return element("h1", "Sphere fit") + "\n" +
         element("p", markup(report.conclusion()),
                 report.complete() ? "conclusion agrees" : "conclusion within") +
         "\n" +
         element("dl", "\n" + definition("mesh", set.meshName) + definition("", meshText(report)) +
                           definition("mesh hash", fmt::format("{:016x}", set.meshHash)) +
                           definition("objective", std::string(nameOf(set.objective))) +
                           definition("asked for", requestText(report)) +
                           definition("method", set.method) +
                           definition("seed", numberText(set.seed)) +
                           definition("duration", fixedText(report.fit.seconds, 1) + " s; " +
                                                      stopText(report.fit.stop)) +
                           definition("program", report.program) + definition("host", report.host) +
                           definition("date", report.date)) +
         "\n";
}

std::string measureRow(const std::string& name, const std::string& value,
                       const std::string& meaning) {
  return element("tr", element("td", name, "name") + element("td", value, "number") +
                           element("td", meaning, "meaning")) +
         "\n";
}

std::string percentOrDash(const std::optional<double>& part) {
  return part ? percentText(*part, 2) : "-";
}

std::string silhouetteRows(const std::optional<SilhouetteError>& error) {
  const auto value = [&](double SilhouetteError::*part) {
    return error ? percentText(*error.*part, 2) : "-";
  };
  return measureRow("silhouette error, mean", value(&SilhouetteError::mean),
                    "The solid angle in which exactly one of mesh and spheres blocks the view, as "
                    "a part of the mesh's own: mean over viewpoints all around. It is what makes a "
                    "shadow wrong.") +
         measureRow("silhouette error, worst", value(&SilhouetteError::worst),
                    "The same from the worst of the viewpoints.") +
         measureRow("blocked too much", value(&SilhouetteError::over),
                    "The part of the mean in which only the spheres block.") +
         measureRow("blocked too little", value(&SilhouetteError::under),
                    "The part of the mean in which only the mesh blocks.");
}

std::string measuresTable(const SphereMeasures& measures) {
  const auto& summed = measures.outsideVolumeRatio;
  return wideTable(
      "\n<thead><tr><th>measure</th><th "
      "class=\"number\">value</th><th>meaning</th></tr></thead>\n" +
      element("tbody",
              "\n" + silhouetteRows(measures.silhouette) +
                  measureRow("surface covered", percentText(measures.coveredFraction, 2),
                             "Part of the mesh's surface that lies in a sphere.") +
                  measureRow("summed outside volume E", summed ? fixedText(*summed, 4) : "-",
                             "Volumes of the spheres outside the mesh, added up, over the volume "
                             "of the mesh (Wang et al. 2006). Overlaps count once per sphere.") +
                  measureRow("outside volume", percentOrDash(measures.unionOutsideRatio),
                             "Volume outside the mesh that lies in a sphere, as a part of the "
                             "volume of the mesh.") +
                  measureRow("uncovered volume", percentOrDash(measures.uncoveredVolumeRatio),
                             "Volume inside the mesh that lies in no sphere, as a part of the "
                             "volume of the mesh.")) +
      "\n");
}

std::vector<std::string> phasesOf(const std::vector<FitStep>& history) {
  std::vector<std::string> phases;
  for (const FitStep& step : history)
    if (std::ranges::find(phases, step.phase) == phases.end()) phases.push_back(step.phase);
  return phases;
}

/// The error over x(index of a step): a line through all steps, a symbol for each phase.
template <typename X>
std::string errorPlot(const FitReport& report, const std::string& title, const std::string& xLabel,
                      const X& x) {
  const std::vector<FitStep>& history = report.fit.history;
  const bool shadow = report.fit.set.objective == FitObjective::shadow;
  const auto pointsOf = [&](const auto& wanted) {
    std::vector<glm::dvec2> points;
    for (std::size_t i = 0; i < history.size(); ++i)
      if (wanted(history[i])) points.push_back({x(i), (shadow ? 100 : 1) * history[i].error});
    return points;
  };
  LinePlot plot;
  plot.title = title;
  plot.xLabel = xLabel;
  plot.yLabel = shadow ? "silhouettes and own sky (%)" : "E: summed outside volume / mesh volume";
  plot.series.push_back({"", pointsOf([](const FitStep&) { return true; })});
  for (const std::string& phase : phasesOf(history))
    plot.series.push_back({.name = phase,
                           .points = pointsOf([&](const FitStep& s) { return s.phase == phase; }),
                           .joined = false,
                           .marked = true});
  const auto [least, most] = std::ranges::minmax(history, {}, &FitStep::error);
  plot.logarithmicY = least.error > 0 && most.error > 10 * least.error;
  return linePlotFigure(plot);
}

std::string historySection(const FitReport& report) {
  const std::vector<FitStep>& history = report.fit.history;
  if (history.empty()) return {};
  const auto step = [](std::size_t i) { return static_cast<double>(i); };
  const auto seconds = [&](std::size_t i) { return history[i].seconds; };
  return section("Error during the fit",
                 element("p", "The error of the best set so far, as the fit itself estimates it.") +
                     "\n" +
                     element("div",
                             "\n" + errorPlot(report, "by step", "step", step) +
                                 errorPlot(report, "over time", "time (s)", seconds),
                             "plots") +
                     "\n");
}

std::string legendEntry(Silhouette silhouette, const std::string& text) {
  const glm::ivec3 color = silhouetteColor(silhouette);
  return element("li", fmt::format("<span class=\"swatch\" style=\"background: rgb({}, {}, {})\">"
                                   "</span>",
                                   color.r, color.g, color.b) +
                           element("span", text)) +
         "\n";
}

std::string picture(const std::string& label, const std::string& caption, const Image& image) {
  return element("figure", pngImage(label, encodePng(image)) + element("figcaption", caption)) +
         "\n";
}

std::string viewRow(const FitView& view) {
  return element("p", view.name, "side") + "\n" + picture("mesh, " + view.name, "mesh", view.mesh) +
         picture("spheres, " + view.name, "spheres", view.spheres) +
         picture("silhouettes compared, " + view.name,
                 "silhouettes: " + percentText(view.over, 2) + " too much, " +
                     percentText(view.under, 2) + " too little",
                 view.silhouettes);
}

std::string picturesSection(const FitReport& report) {
  std::string rows = "\n";
  for (const FitView& view : drawFit(report.mesh.mesh, report.fit.set.spheres).views)
    rows += viewRow(view);
  const std::string legend = "\n" + legendEntry(Silhouette::both, "both block") +
                             legendEntry(Silhouette::spheresOnly, "only spheres: too much") +
                             legendEntry(Silhouette::meshOnly, "only the mesh: too little");
  return section("Mesh and spheres",
                 element("p",
                         "Without perspective; front: seen from +z, side: from +x, top: from +y. "
                         "Below the silhouettes: the differing areas as parts of the mesh's.") +
                     "\n" + element("ul", legend, "legend") + "\n" +
                     element("div", rows, "pictures") + "\n");
}

std::string warningsList(const FitReport& report) {
  std::string items;
  for (const auto* warnings : {&report.mesh.warnings, &report.fit.warnings})
    for (const std::string& warning : *warnings) items += element("li", markup(warning)) + "\n";
  return items.empty() ? "" : element("ul", "\n" + items) + "\n";
}

}  // namespace

std::string fitReportHtml(const FitReport& report) {
  return htmlPage("Sphere fit of " + report.fit.set.meshName,
                  std::string(linePlotStyle) + pageStyle,
                  fitSection(report) + section("Measures", measuresTable(report.fit.set.measures)) +
                      section("Notes", warningsList(report)) + historySection(report) +
                      picturesSection(report));
}

}  // namespace haarlight
