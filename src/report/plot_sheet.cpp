#include "report/plot_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/vec2.hpp>
#include <iterator>
#include <vector>

#include "base/text_format.h"

namespace haarlight {

namespace {

constexpr int plotWidth = 560, plotHeight = 320, gap = 24, margin = 16;
constexpr int firstNamesAt = 40, namesLineHeight = 18, belowNames = 12;
constexpr int cellWidth = plotWidth + gap;
constexpr std::size_t columns = 2;
/// About as many characters fit beside each other above a plot.
constexpr std::size_t namesLineLength = 72;

constexpr char sheetStyle[] = R"(
:root { color-scheme: light dark;
        --page: #fcfcfa; --text: #1d1f24; --soft: #62666f; --line: #d9d9d4; }
@media (prefers-color-scheme: dark) {
  :root { --page: #16181c; --text: #e4e5e8; --soft: #9a9fa9; --line: #34373e; }
}
svg { font-family: system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif; }
.page { fill: var(--page); }
.plot text.title { fill: var(--text); font-size: 14px; font-weight: 600; }
.plot .name { fill: currentColor; font-weight: 600; }
)";

/// What the picture in the figure of a plot holds; empty when there is none. (The size of an <svg>
/// in another one cannot be styled everywhere.)
std::string pictureContent(const LinePlot& plot) {
  const std::string figure = linePlotFigure(plot);
  const std::size_t begin = figure.find('>', figure.find("<svg"));
  if (begin == std::string::npos) return {};
  return figure.substr(begin + 1, figure.find("</svg>") - begin - 1);
}

/// The names of the series in their colours, in as few lines as hold them.
std::vector<std::string> seriesNames(const LinePlot& plot) {
  std::vector<std::string> lines;
  std::size_t named = 0, length = 0;
  for (const PlotSeries& series : plot.series) {
    if (series.name.empty()) continue;
    const std::size_t needed = series.name.size() + 4;
    if (lines.empty() || length + needed > namesLineLength) {
      lines.emplace_back();
      length = 0;
    }
    length += needed;
    lines.back() += fmt::format("<tspan class=\"name series-{}\" dx=\"{}\">{}{}</tspan>",
                                named++ % plotColorCount + 1, lines.back().empty() ? 0 : 14,
                                series.joined ? "\u2015 " : "\u25A0 ", markup(series.name));
  }
  return lines;
}

/// Room above a plot for its title and names.
int headHeightOf(const LinePlot& plot) {
  const int lines = std::max(1, int(seriesNames(plot).size()));
  return firstNamesAt + (lines - 1) * namesLineHeight + belowNames;
}

std::string cell(const LinePlot& plot, const glm::ivec2& place, int headHeight) {
  std::string names;
  int y = firstNamesAt;
  for (const std::string& line : seriesNames(plot)) {
    names += fmt::format("<text x=\"62\" y=\"{}\">{}</text>\n", y, line);
    y += namesLineHeight;
  }
  return fmt::format(
      "<g transform=\"translate({} {})\">\n<text class=\"title\" x=\"62\" "
      "y=\"18\">{}</text>\n{}<g class=\"axes\" transform=\"translate(0 {})\">{}</g>\n</g>\n",
      place.x, place.y, markup(plot.title), names, headHeight, pictureContent(plot));
}

}  // namespace

std::string plotSheetSvg(const std::string& title, std::span<const LinePlot> plots) {
  std::vector<LinePlot> shown;
  std::ranges::copy_if(plots, std::back_inserter(shown),
                       [](const LinePlot& plot) { return !pictureContent(plot).empty(); });
  std::string cells;
  int height = margin;
  for (std::size_t first = 0; first < shown.size(); first += columns) {
    const auto row = std::span(shown).subspan(first, std::min(columns, shown.size() - first));
    int headHeight = 0;
    for (const LinePlot& plot : row) headHeight = std::max(headHeight, headHeightOf(plot));
    for (std::size_t i = 0; i < row.size(); ++i)
      cells += cell(row[i], {margin + cellWidth * int(i), height}, headHeight);
    height += headHeight + plotHeight + gap;
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2}\">\n"
      "<style>{3}{4}</style>\n<rect class=\"page\" width=\"{0}\" height=\"{1}\"/>\n{5}</svg>\n",
      2 * margin + int(columns) * cellWidth - gap, height - gap + margin, markup(title),
      linePlotStyle, sheetStyle, cells);
}

}  // namespace haarlight
