#include "report/line_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "test_support.h"
#include "verify/report_test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

std::vector<Element> elementsOf(const LinePlot& plot) {
  return readXml("<!DOCTYPE html>\n" + linePlotFigure(plot));
}

PlotSeries marks(const std::string& name, const std::vector<glm::dvec2>& points) {
  return {.name = name, .points = points, .joined = false, .marked = true};
}

LinePlot plotOf(const std::vector<PlotSeries>& series) {
  LinePlot plot;
  plot.title = "title";
  plot.xLabel = "time (s)";
  plot.yLabel = "error";
  plot.series = series;
  return plot;
}

bool hasClass(const Element& element, const std::string& name) {
  return element.attributes.contains("class") && element.attributes.at("class") == name;
}

/// Where the symbols of the plot itself stand; `inLegend`: how many follow them in the legend.
std::vector<glm::dvec2> markPositions(const std::vector<Element>& elements, std::size_t inLegend) {
  std::vector<glm::dvec2> positions;
  for (const Element& element : named(elements, "path")) {
    if (!hasClass(element, "mark")) continue;
    glm::dvec2 at;
    REQUIRE(std::sscanf(element.attributes.at("transform").c_str(), "translate(%lf %lf)", &at.x,
                        &at.y) == 2);
    positions.push_back(at);
  }
  REQUIRE(positions.size() >= inLegend);
  positions.resize(positions.size() - inLegend);
  return positions;
}

Element labelled(const std::vector<Element>& elements, const std::string& text) {
  for (const Element& element : named(elements, "text"))
    if (element.text == text) return element;
  FAIL("no label " << text);
  return {};
}

double attribute(const Element& element, const std::string& name) {
  return std::stod(element.attributes.at(name));
}

}  // namespace

TEST_CASE("points stand where the labels of their numbers are") {
  const auto elements = elementsOf(plotOf({marks("a", {{0, 10}, {4, 0}, {2, 5}})}));
  const auto at = markPositions(elements, 1);
  REQUIRE(at.size() == 3);
  CHECK(at[0].x == attribute(labelled(elements, "0"), "x"));
  CHECK(at[1].x == attribute(labelled(elements, "4"), "x"));
  CHECK(at[2].x == doctest::Approx((at[0].x + at[1].x) / 2));
  CHECK(at[2].y == doctest::Approx((at[0].y + at[1].y) / 2));
  CHECK(at[0].y < at[1].y);
  // A label's baseline lies 4 below the middle of its letters.
  CHECK(at[0].y + 4 == attribute(labelled(elements, "10"), "y"));
}

TEST_CASE("equal factors are equal distances on a logarithmic axis") {
  LinePlot plot = plotOf({marks("a", {{0, 1}, {1, 10}, {2, 100}, {3, 0}, {3, -1}})});
  plot.logarithmicY = true;
  const auto at = markPositions(elementsOf(plot), 1);
  REQUIRE(at.size() == 3);  // zero and less have no place
  CHECK(at[0].y - at[1].y == doctest::Approx(at[1].y - at[2].y).epsilon(0.01));
  CHECK(at[0].y - at[1].y > 20);
}

TEST_CASE("a linear axis shows zero") {
  const auto elements = elementsOf(plotOf({marks("a", {{1, 41}, {2, 43}})}));
  CHECK(attribute(labelled(elements, "0"), "x") < 100);
}

TEST_CASE("a line goes through its points in their order") {
  LinePlot plot = plotOf({marks("a", {{0, 3}, {1, 7}, {2, 5}})});
  plot.series[0].joined = true;
  const auto elements = elementsOf(plot);
  std::string expected;
  for (const glm::dvec2& at : markPositions(elements, 1)) {
    char text[64];
    std::snprintf(text, sizeof text, "%s%.1f,%.1f", expected.empty() ? "M" : "L", at.x, at.y);
    expected += text;
  }
  const auto paths = named(elements, "path");
  CHECK(std::ranges::any_of(paths, [&](const Element& path) {
    return hasClass(path, "line") && path.attributes.at("d") == expected;
  }));
}

TEST_CASE("what is not finite is left out, and nothing gives no figure") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto elements = elementsOf(plotOf({marks("a", {{0, nan}, {1, 2}, {infinity, 1}, {3, 4}})}));
  CHECK(markPositions(elements, 1).size() == 2);
  CHECK(linePlotFigure(plotOf({})).empty());
  CHECK(linePlotFigure(plotOf({marks("a", {{nan, 1}})})).empty());
}

TEST_CASE("one point is enough for a plot") {
  CHECK(markPositions(elementsOf(plotOf({marks("a", {{0, 0}})})), 1).size() == 1);
}

TEST_CASE("symbols do not lie on each other, however many points there are") {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 10000; ++i) points.emplace_back(i, 1);
  const auto at = markPositions(elementsOf(plotOf({marks("a", points)})), 1);
  CHECK(at.size() > 20);
  for (std::size_t i = 1; i < at.size(); ++i) CHECK(at[i].x - at[i - 1].x >= 7.9);
}

TEST_CASE("series differ in colour and symbol, and the legend names them") {
  const std::vector<std::string> names{"a", "b", "<i>&\"", "d", "e", "f"};
  LinePlot plot = plotOf({{.name = "", .points = {{0, 0}, {1, 1}}}});
  for (const std::string& name : names) plot.series.push_back(marks(name, {{0, 1}}));
  const auto elements = elementsOf(plot);
  std::set<std::string> colors, symbols;
  std::vector<std::string> listed;
  for (const Element& group : named(elements, "g")) colors.insert(group.attributes.at("class"));
  for (const Element& path : named(elements, "path"))
    if (hasClass(path, "mark")) symbols.insert(path.attributes.at("d"));
  for (const Element& item : named(elements, "span")) listed.push_back(item.text);
  CHECK(colors.size() == 7);
  CHECK(symbols.size() == 6);
  CHECK(listed == names);
}

TEST_CASE("title and axes are named, and foreign text does no harm") {
  LinePlot plot = plotOf({marks("a", {{0, 1}, {1, 2}})});
  plot.title = "<b>&\"'";
  plot.yLabel = "<y>";
  const auto elements = elementsOf(plot);
  CHECK(named(elements, "figcaption").at(0).text == "<b>&\"'");
  CHECK(named(elements, "svg").at(0).attributes.at("aria-label") == "<b>&\"'");
  labelled(elements, "<y>");
  labelled(elements, "time (s)");
}
