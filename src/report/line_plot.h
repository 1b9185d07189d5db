#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace haarlight {

/// Points of one kind in a plot.
struct PlotSeries {
  std::string name;  ///< for the legend; without a name the series is drawn in grey and not listed
  std::vector<glm::dvec2>
      points;          ///< those that are not finite, or have no logarithm, are left out
  bool joined = true;  ///< a line through the points, in their order
  /// A symbol at each point, other than that of other series; where they would overlap, at fewer.
  bool marked = false;
};

struct LinePlot {
  std::string title;
  std::string xLabel, yLabel;  ///< with the unit
  bool logarithmicX = false;
  bool logarithmicY = false;  ///< else the y axis starts at zero or below
  std::vector<PlotSeries> series;
};

/// A <figure> with an SVG plot and a legend of its series; empty when there is no point to draw. It
/// needs linePlotStyle in its page, whose common style (base/html.h) gives the colours for light
/// and dark screens.
std::string linePlotFigure(const LinePlot& plot);

extern const char* const linePlotStyle;

/// Named series that differ in colour and symbol; a plot with more of them starts again.
inline constexpr int plotColorCount = 8;

}  // namespace haarlight
