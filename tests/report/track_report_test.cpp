#include "report/track_report.h"

#include <algorithm>

#include "base/error.h"
#include "report/plot_sheet.h"
#include "test_support.h"
#include "verify/report_test_support.h"

using namespace haarlight;
using haarlight::test::Element;
using haarlight::test::named;
using haarlight::test::readFile;
using haarlight::test::readXml;
using haarlight::test::TemporaryFolder;

namespace {

SphereMeasures measures(double covered, double silhouette) {
  return {covered, 0.5, 0.25, 0.125, SilhouetteError{silhouette, 2 * silhouette, silhouette, 0}};
}

ImageError planeError(double relative) {
  return {.rootMeanSquare = relative / 2, .referenceMean = 0.5, .relativeRootMeanSquare = relative};
}

/// Frames 4, 6 and 8; in the first and the last spheres are fitted anew.
TrackReport example() {
  TrackReport report{.program = "haarlight 0.1.0",
                     .host = "Some CPU",
                     .date = "2026-01-02T03:04:05Z",
                     .scene = "walk.json",
                     .framesPerSecond = 8,
                     .method = "haar",
                     .objects = {"elephant"},
                     .frames = {}};
  report.frames = {
      {4,
       0.5,
       {{measures(1, 0.25), {0.5, 1, 1.25}, measures(1, 0.125)}},
       PlaneErrors{planeError(0.02), planeError(0.01)}},
      {6, 0.75, {{measures(0.9375, 0.375), {0.75, 1.5, 3}, {}}}, PlaneErrors{planeError(0.03), {}}},
      {8,
       1,
       {{measures(0.96875, 0.125), {0.625, 1, 2}, measures(1, 0.125)}},
       PlaneErrors{planeError(0.04), planeError(0.04)}}};
  return report;
}

std::vector<std::string> textsOf(const std::vector<Element>& elements, const std::string& name) {
  std::vector<std::string> texts;
  for (const Element& element : named(elements, name)) texts.push_back(element.text);
  return texts;
}

bool contains(const std::vector<std::string>& texts, const std::string& text) {
  return std::ranges::find(texts, text) != texts.end();
}

std::size_t countOfClass(const std::vector<Element>& elements, const std::string& name) {
  return std::size_t(std::ranges::count_if(elements, [&](const Element& element) {
    return element.attributes.contains("class") && element.attributes.at("class") == name;
  }));
}

}  // namespace

TEST_CASE("the JSON report of a track sums the frames up") {
  const auto summary = trackSummaryJson(example());
  CHECK(summary.at("frames_measured") == 3);
  CHECK_FALSE(summary.contains("interrupted"));
  const auto& object = summary.at("object").at(0);
  CHECK(object.at("name") == "elephant");
  CHECK(object.at("covered_surface_lowest") == 0.9375);
  CHECK(object.at("covered_surface_lowest_frame") == 6);
  // √(p (1 − p) / n) with p = 15/16 and n = 50000.
  CHECK(object.at("covered_surface_standard_error").get<double>() ==
        doctest::Approx(0.0010825).epsilon(1e-3));
  CHECK(object.at("silhouette_error_mean").get<double>() == doctest::Approx(0.25));
  CHECK(object.at("silhouette_error_largest") == 0.375);
  CHECK(object.at("radius_ratio_smallest") == 0.5);
  CHECK(object.at("radius_ratio_largest") == 3);
  // Moved 0.25 and 0.125, refitted 0.125 each.
  const auto& silhouettes = object.at("silhouette_moved_to_refitted");
  CHECK(silhouettes.at("ratio_of_means").get<double>() == doctest::Approx(1.5));
  CHECK(silhouettes.at("mean_ratio").get<double>() == doctest::Approx(1.5));
  const auto& plane = summary.at("plane_error");
  CHECK(plane.at("mean_percent").get<double>() == doctest::Approx(3));
  CHECK(plane.at("largest_percent").get<double>() == doctest::Approx(4));
  CHECK(plane.at("largest_frame") == 8);
  const auto& refits = plane.at("moved_to_refitted");
  CHECK(refits.at("frames") == 2);
  CHECK(refits.at("mean_moved_percent").get<double>() == doctest::Approx(3));
  CHECK(refits.at("mean_refitted_percent").get<double>() == doctest::Approx(2.5));
  CHECK(refits.at("ratio_of_means").get<double>() == doctest::Approx(1.2));
  CHECK(refits.at("mean_ratio").get<double>() == doctest::Approx(1.5));
}

TEST_CASE("the JSON report of a track holds every frame") {
  const auto json = trackJson(example());
  CHECK(json.at("scene") == "walk.json");
  CHECK(json.at("frames_per_second") == 8);
  REQUIRE(json.at("frames").size() == 3);
  const auto& first = json.at("frames")[0];
  CHECK(first.at("frame") == 4);
  CHECK(first.at("seconds") == 0.5);
  const auto& object = first.at("objects").at(0);
  CHECK(object.at("moved").at("covered_surface") == 1);
  CHECK(object.at("moved").at("outside_volume_ratio") == 0.5);
  CHECK(object.at("refitted").at("silhouette_error").at("mean") == 0.125);
  CHECK(object.at("radius_ratio") ==
        nlohmann::ordered_json{{"smallest", 0.5}, {"mean", 1.0}, {"largest", 1.25}});
  CHECK(first.at("plane").at("moved").at("rmse_relative_to_mean_percent") == 2);
  CHECK(first.at("plane").at("refitted").at("rmse") == 0.005);
  CHECK_FALSE(json.at("frames")[1].at("objects").at(0).contains("refitted"));
  CHECK_FALSE(json.at("frames")[1].at("plane").contains("refitted"));
}

TEST_CASE("the table of a track has a line per frame and no column without figures") {
  TrackReport report = example();
  const std::string text = trackText(report);
  CHECK(std::ranges::count(text, '\n') == 4);
  const std::string header = text.substr(0, text.find('\n'));
  for (const char* title : {"frame", "covered %", "E", "outside %", "uncovered %", "silhouette %",
                            "radius min", "plane %", "refit covered %", "refit plane %"})
    CHECK(header.find(title) != std::string::npos);
  CHECK(header.find("object") == std::string::npos);
  CHECK(text.find("93.750") != std::string::npos);
  for (std::size_t at = 0; at < text.size(); at += header.size() + 1)
    CHECK(text.at(at + header.size()) == '\n');  // aligned columns

  for (TrackFrame& frame : report.frames) {
    frame.plane.reset();
    frame.objects[0].refitted.reset();
    frame.objects.push_back(frame.objects[0]);
  }
  report.objects.push_back("calf");
  const std::string plain = trackText(report);
  CHECK(std::ranges::count(plain, '\n') == 7);
  for (const char* absent : {"refit", "plane"}) CHECK(plain.find(absent) == std::string::npos);
  CHECK(plain.find("calf") != std::string::npos);
}

TEST_CASE("the plots of a track stand by themselves") {
  TrackReport report = example();
  const std::string svg = trackSvg(report);
  const auto elements = readXml(svg);
  CHECK(countOfClass(elements, "axes") == 5);
  const auto labels = textsOf(elements, "text"), names = textsOf(elements, "tspan");
  CHECK(std::ranges::count(labels, "frame") == 5);
  for (const char* label : {"surface not covered (%)", "volume / mesh volume",
                            "radius / radius at second 0", "root mean square error / mean (%)"})
    CHECK(contains(labels, label));
  for (const char* name : {"\u2015 moved", "\u2015 refitted", "\u2015 largest"})
    CHECK(contains(names, name));
  for (const char* outside : {"href", "url(", "@import", "<script", "https:"})
    CHECK(svg.find(outside) == std::string::npos);

  for (TrackFrame& frame : report.frames) frame.plane.reset();
  CHECK(countOfClass(readXml(trackSvg(report)), "axes") == 4);
}

TEST_CASE("a sheet of plots has rows of two and leaves out plots without a point") {
  LinePlot plot;
  plot.title = "first";
  plot.series.push_back({"a", {{0, 1}, {1, 2}}});
  const auto sizeOf = [](const std::vector<LinePlot>& plots) {
    const Element root = readXml(plotSheetSvg("sheet", plots)).front();
    return std::pair(std::stod(root.attributes.at("width")),
                     std::stod(root.attributes.at("height")));
  };
  const auto two = sizeOf({plot, plot}), three = sizeOf({plot, LinePlot{}, plot, plot});
  CHECK(two.first == three.first);
  CHECK(three.second > 1.7 * two.second);
  CHECK(three.second < 2 * two.second);
}

TEST_CASE("the HTML report of a track has conclusion, plots and table") {
  TrackReport report = example();
  const auto elements = readXml(trackHtml(report));
  CHECK(countOfClass(elements, "plot") == 5);
  CHECK(named(elements, "tr").size() == 4);
  CHECK(contains(textsOf(elements, "td"), "93.750"));
  CHECK(contains(textsOf(elements, "dd"), "walk.json"));
  const std::string conclusion = named(elements, "p").at(0).text;
  CHECK(conclusion ==
        "elephant: at least 93.75\u00A0% of the surface is covered (frame 6), the silhouettes "
        "differ by 25.0\u00A0% on average; the plane's radiance is off by 3.00\u00A0% of the mean, "
        "1.20 times as much as with spheres fitted anew");
  report.interrupted = true;
  CHECK(trackSummaryJson(report).at("interrupted") == true);
  CHECK(report.conclusion() == conclusion + "; interrupted before the last frame");
}

TEST_CASE("foreign text does the reports of a track no harm") {
  TrackReport report = example();
  report.scene = report.objects[0] = "<b>&\"' \xff.json";
  report.objects.push_back("other");
  for (TrackFrame& frame : report.frames) frame.objects.push_back(frame.objects[0]);
  const std::string shown = "<b>&\"' \uFFFD.json";
  CHECK(contains(textsOf(readXml(trackHtml(report)), "dd"), shown));
  CHECK(contains(textsOf(readXml(trackSvg(report)), "tspan"), "\u2015 moved, " + shown));
  CHECK(named(readXml(trackHtml(report)), "b").empty());
}

TEST_CASE("the name of a track's report decides its kind") {
  const TemporaryFolder folder;
  const TrackReport report = example();
  for (const char* name : {"track.html", "track.svg", "track.json"})
    writeTrackReport(folder / name, report);
  CHECK(readFile(folder / "track.html") == trackHtml(report));
  CHECK(readFile(folder / "track.svg") == trackSvg(report));
  CHECK(nlohmann::ordered_json::parse(readFile(folder / "track.json")) == trackJson(report));
  CHECK_THROWS_WITH_AS(writeTrackReport(folder / "track.txt", report),
                       doctest::Contains("must end in"), InputError);
}
