#include "report/plot_sheet.h"

#include <fmt/format.h>

#include "base/text_format.h"

namespace haarlight {

namespace {

constexpr int plotWidth = 560, plotHeight = 320, headHeight = 52, gap = 24, margin = 16;
constexpr int cellWidth = plotWidth + gap, cellHeight = headHeight + plotHeight + gap;
constexpr std::size_t columns = 2;
constexpr std::size_t colorCount = 6;  // of linePlotStyle

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

std::string seriesNames(const LinePlot& plot) {
  std::string spans;
  std::size_t named = 0;
  for (const PlotSeries& series : plot.series)
    if (!series.name.empty())
      spans += fmt::format("<tspan class=\"name series-{}\" dx=\"{}\">{}{}</tspan>",
                           named++ % colorCount + 1, spans.empty() ? 0 : 14,
                           series.joined ? "\u2015 " : "\u25A0 ", markup(series.name));
  return fmt::format("<text x=\"62\" y=\"40\">{}</text>\n", spans);
}

std::string cell(const LinePlot& plot, const std::string& content, std::size_t place) {
  return fmt::format(
      "<g transform=\"translate({} {})\">\n<text class=\"title\" x=\"62\" y=\"18\">{}</text>\n{}"
      "<g class=\"axes\" transform=\"translate(0 {})\">{}</g>\n</g>\n",
      margin + cellWidth * (place % columns), margin + cellHeight * (place / columns),
      markup(plot.title), seriesNames(plot), headHeight, content);
}

}  // namespace

std::string plotSheetSvg(const std::string& title, std::span<const LinePlot> plots) {
  std::string cells;
  std::size_t count = 0;
  for (const LinePlot& plot : plots)
    if (const std::string content = pictureContent(plot); !content.empty())
      cells += cell(plot, content, count++);
  const std::size_t width = 2 * margin + columns * cellWidth - gap;
  const std::size_t height = 2 * margin + (count + columns - 1) / columns * cellHeight - gap;
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2}\">\n"
      "<style>{3}{4}</style>\n<rect class=\"page\" width=\"{0}\" height=\"{1}\"/>\n{5}</svg>\n",
      width, height, markup(title), linePlotStyle, sheetStyle, cells);
}

}  // namespace haarlight
