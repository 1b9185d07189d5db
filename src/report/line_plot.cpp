#include "report/line_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/html.h"
#include "base/text_format.h"
#include "report/axis_ticks.h"

namespace haarlight {

const char* const linePlotStyle = R"(
:root { --series-1: #1f6fbf; --series-2: #c8590c; --series-3: #23824a; --series-4: #8747b8;
        --series-5: #b8324a; --series-6: #127f8c; --series-7: #857004; --series-8: #c2378f; }
@media (prefers-color-scheme: dark) {
  :root { --series-1: #6cb0f5; --series-2: #f79a55; --series-3: #6fcf8f; --series-4: #c79bf0;
          --series-5: #f58298; --series-6: #5fcbd8; --series-7: #d3bd4c; --series-8: #f08ac8; }
}
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr));
         gap: 0 2rem; }
.plot svg { display: block; }
.plot .axes { width: 100%; height: auto; }
.plot text { fill: var(--soft); font-size: 12px; font-variant-numeric: tabular-nums; }
.plot .grid { stroke: var(--line); }
.plot .line { fill: none; stroke-width: 1.5; stroke-linejoin: round; }
.plot .mark { fill: currentColor; stroke: var(--page); stroke-width: .75; }
.plot .series-0 { color: var(--soft); }
.plot .series-1 { color: var(--series-1); } .plot .series-2 { color: var(--series-2); }
.plot .series-3 { color: var(--series-3); } .plot .series-4 { color: var(--series-4); }
.plot .series-5 { color: var(--series-5); } .plot .series-6 { color: var(--series-6); }
.plot .series-7 { color: var(--series-7); } .plot .series-8 { color: var(--series-8); }
.plot .line { stroke: currentColor; }
ul.legend { list-style: none; display: flex; flex-wrap: wrap; gap: .1rem 1.25rem; margin: .5rem 0;
            padding: 0; font-size: .85rem; color: var(--soft); }
ul.legend li { display: flex; align-items: center; gap: .4rem; }
)";

namespace {

constexpr double width = 560, height = 320;
constexpr double left = 62, right = 548, top = 10, bottom = 274;
constexpr double smallestMarkDistance = 8;
constexpr std::size_t colorCount = plotColorCount;

/// Symbols around the origin.
constexpr std::array marks{"M-3.5,0a3.5,3.5 0 1 0 7,0a3.5,3.5 0 1 0 -7,0z",
                           "M-3.2,-3.2h6.4v6.4h-6.4z",
                           "M0,-4.4L4.2,3H-4.2z",
                           "M0,-4.6L4.6,0L0,4.6L-4.6,0z",
                           "M0,4.4L4.2,-3H-4.2z",
                           "M-4.5,-1.5h3v-3h3v3h3v3h-3v3h-3v-3h-3z",
                           "M-4.8,-2h9.6v4h-9.6z",
                           "M-2,-4.8h4v9.6h-4z"};
static_assert(marks.size() == colorCount);

using Attributes = std::vector<std::pair<std::string, std::string>>;

std::string tag(const std::string& name, const Attributes& attributes,
                const std::string& content = {}) {
  std::string text = "<" + name;
  for (const auto& [key, value] : attributes) text += " " + key + "=\"" + value + "\"";
  return text + (content.empty() ? "/>" : ">" + content + "</" + name + ">") + "\n";
}

std::string coordinate(double value) {
  return fixedText(value, 1);
}

/// A direction of the plot and where its numbers lie in the picture.
struct Axis {
  bool logarithmic = false;
  std::vector<double> ticks;
  double begin = 0, end = 0;  ///< of the axis, in the picture

  double scaled(double value) const { return logarithmic ? std::log10(value) : value; }
  double position(double value) const {
    const double first = scaled(ticks.front()), last = scaled(ticks.back());
    return begin + (scaled(value) - first) / (last - first) * (end - begin);
  }
};

bool drawable(const LinePlot& plot, const glm::dvec2& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && (!plot.logarithmicX || point.x > 0) &&
         (!plot.logarithmicY || point.y > 0);
}

struct Bounds {
  glm::dvec2 lower{std::numeric_limits<double>::infinity()};
  glm::dvec2 upper{-std::numeric_limits<double>::infinity()};
};

/// Of all points that can be drawn.
Bounds boundsOf(const LinePlot& plot) {
  Bounds bounds;
  for (const PlotSeries& series : plot.series)
    for (const glm::dvec2& point : series.points)
      if (drawable(plot, point)) {
        bounds.lower = glm::min(bounds.lower, point);
        bounds.upper = glm::max(bounds.upper, point);
      }
  return bounds;
}

struct Axes {
  Axis x, y;

  glm::dvec2 position(const glm::dvec2& point) const {
    return {x.position(point.x), y.position(point.y)};
  }
};

Axes axesOf(const LinePlot& plot, const Bounds& bounds) {
  return {{plot.logarithmicX,
           plot.logarithmicX ? logarithmicTicks(bounds.lower.x, bounds.upper.x)
                             : linearTicks(bounds.lower.x, bounds.upper.x, 8),
           left, right},
          {plot.logarithmicY,
           plot.logarithmicY ? logarithmicTicks(bounds.lower.y, bounds.upper.y)
                             : linearTicks(std::min(bounds.lower.y, 0.0), bounds.upper.y),
           bottom, top}};
}

std::string gridLine(double x1, double y1, double x2, double y2) {
  return tag("line", {{"class", "grid"},
                      {"x1", coordinate(x1)},
                      {"y1", coordinate(y1)},
                      {"x2", coordinate(x2)},
                      {"y2", coordinate(y2)}});
}

std::string label(double x, double y, const std::string& anchor, const std::string& text) {
  return tag("text", {{"x", coordinate(x)}, {"y", coordinate(y)}, {"text-anchor", anchor}},
             markup(text));
}

std::string gridAndLabels(const LinePlot& plot, const Axes& axes) {
  std::string text;
  for (const double tick : axes.x.ticks) {
    const double x = axes.x.position(tick);
    text += gridLine(x, top, x, bottom) + label(x, bottom + 17, "middle", tickLabel(tick));
  }
  for (const double tick : axes.y.ticks) {
    const double y = axes.y.position(tick);
    text += gridLine(left, y, right, y) + label(left - 7, y + 4, "end", tickLabel(tick));
  }
  const double middle = (top + bottom) / 2;
  return text + label((left + right) / 2, height - 8, "middle", plot.xLabel) +
         tag("text",
             {{"text-anchor", "middle"},
              {"transform", "translate(13 " + coordinate(middle) + ") rotate(-90)"}},
             markup(plot.yLabel));
}

std::string mark(std::size_t color, const glm::dvec2& at) {
  return tag("path", {{"class", "mark"},
                      {"transform", "translate(" + coordinate(at.x) + " " + coordinate(at.y) + ")"},
                      {"d", marks[(color + colorCount - 1) % colorCount]}});
}

std::string lineThrough(const std::vector<glm::dvec2>& positions) {
  std::string path;
  for (const glm::dvec2& at : positions)
    path += (path.empty() ? "M" : "L") + coordinate(at.x) + "," + coordinate(at.y);
  return tag("path", {{"class", "line"}, {"d", path}});
}

std::string marksAt(std::size_t color, const std::vector<glm::dvec2>& positions) {
  std::string text;
  glm::dvec2 last{-std::numeric_limits<double>::infinity()};
  for (const glm::dvec2& at : positions)
    if (!(glm::distance(at, last) < smallestMarkDistance)) text += mark(color, last = at);
  return text;
}

/// `color`: 0 for grey, else from 1 to colorCount.
std::string seriesMarkup(const LinePlot& plot, const PlotSeries& series, const Axes& axes,
                         std::size_t color) {
  std::vector<glm::dvec2> positions;
  for (const glm::dvec2& point : series.points)
    if (drawable(plot, point)) positions.push_back(axes.position(point));
  if (positions.empty()) return {};
  return tag("g", {{"class", "series-" + numberText(color)}},
             "\n" + (series.joined ? lineThrough(positions) : "") +
                 (series.marked ? marksAt(color, positions) : ""));
}

std::string legendEntry(const PlotSeries& series, std::size_t color) {
  const std::string symbol = (series.joined ? lineThrough({{-11, 0}, {11, 0}}) : "") +
                             (series.marked ? mark(color, {0, 0}) : "");
  return element("li", tag("svg",
                           {{"class", "series-" + numberText(color)},
                            {"width", series.joined ? "24" : "12"},
                            {"height", "12"},
                            {"viewBox", series.joined ? "-12 -6 24 12" : "-6 -6 12 12"}},
                           symbol) +
                           element("span", markup(series.name))) +
         "\n";
}

}  // namespace

std::string linePlotFigure(const LinePlot& plot) {
  const Bounds bounds = boundsOf(plot);
  if (bounds.lower.x > bounds.upper.x) return {};
  const Axes axes = axesOf(plot, bounds);
  std::string content = "\n" + gridAndLabels(plot, axes), legend;
  std::size_t named = 0;
  for (const PlotSeries& series : plot.series) {
    const std::size_t color = series.name.empty() ? 0 : named++ % colorCount + 1;
    content += seriesMarkup(plot, series, axes, color);
    if (!series.name.empty()) legend += legendEntry(series, color);
  }
  const std::string box = "0 0 " + numberText(width) + " " + numberText(height);
  const std::string svg = tag(
      "svg",
      {{"class", "axes"}, {"role", "img"}, {"aria-label", markup(plot.title)}, {"viewBox", box}},
      content);
  return element("figure",
                 "\n" + element("figcaption", markup(plot.title)) + "\n" + svg +
                     (legend.empty() ? "" : element("ul", "\n" + legend, "legend") + "\n"),
                 "plot") +
         "\n";
}

}  // namespace haarlight
