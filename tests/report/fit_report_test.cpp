#include "report/fit_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/html.h"
#include "image/write_image.h"
#include "mesh/builtin_meshes.h"
#include "report/fit_pictures.h"
#include "test_support.h"
#include "verify/report_test_support.h"

using namespace haarlight;
using haarlight::test::Element;
using haarlight::test::named;
using haarlight::test::readFile;
using haarlight::test::readXml;
using haarlight::test::TemporaryFolder;

namespace {

using Json = nlohmann::json;

const std::string oddName = "<b>&\"' \xff.obj";

/// A report and what it refers to.
struct Example {
  LoadedMesh mesh = loadMeshOrBuiltin("builtin:sphere");
  SphereFit fit;

  Example() {
    fit.set.spheres = {{{0, 0, 0}, 1.125f}, {{0.5f, 0, 0}, 0.25f}};
    fit.set.meshName = "ball.obj";
    fit.set.meshHash = 0xabc;
    fit.set.objective = FitObjective::shadow;
    fit.set.measures = {0.75, 0.5, 0.25, 0.125, SilhouetteError{0.0625, 0.375, 0.05, 0.0125}};
    fit.set.method = "by hand";
    fit.set.seed = 11;
    fit.history = {{"start", 0, 1, 0.5}, {"refine", 0.25, 2, 0.125}, {"refine", 1.5, 2, 0.0625}};
    fit.seconds = 1.75;
    fit.warnings = {"first", "<second>"};
  }

  FitReport report() const {
    return {.program = "haarlight 0.1.0",
            .host = "Some CPU",
            .date = "2026-01-02T03:04:05Z",
            .requestedSpheres = 3,
            .maximumError = {},
            .timeLimit = {},
            .mesh = mesh,
            .fit = fit};
  }
};

std::vector<std::string> textsOf(const std::vector<Element>& elements, const std::string& name) {
  std::vector<std::string> texts;
  for (const Element& element : named(elements, name)) texts.push_back(element.text);
  return texts;
}

bool contains(const std::vector<std::string>& texts, const std::string& text) {
  return std::ranges::find(texts, text) != texts.end();
}

}  // namespace

TEST_CASE("the JSON report of a fit") {
  const Example example;
  FitReport report = example.report();
  report.maximumError = 0.03125;
  const Json json = Json::parse(fitReportJson(report));
  CHECK(json.at("program") == "haarlight 0.1.0");
  CHECK(json.at("host") == "Some CPU");
  CHECK(json.at("date") == "2026-01-02T03:04:05Z");
  // 20 · 4^k triangles and 10 · 4^k + 2 vertices.
  const std::size_t triangles = json.at("mesh").at("triangles");
  CHECK(triangles == builtinMesh("builtin:sphere").triangles.size());
  CHECK(json.at("mesh").at("vertices") == triangles / 2 + 2);
  CHECK(json.at("mesh").at("name") == "ball.obj");
  CHECK(json.at("mesh").at("hash") == "0000000000000abc");
  CHECK(json.at("mesh").at("closed") == true);
  CHECK(json.at("requested") == Json{{"objective", "shadow"},
                                     {"spheres", 3},
                                     {"maximum_error", 0.03125},
                                     {"time_limit", nullptr},
                                     {"seed", 11}});
  CHECK(json.at("result") ==
        Json{{"spheres", 2},
             {"method", "by hand"},
             {"stop", "converged"},
             {"seconds", 1.75},
             {"covered_surface", 0.75},
             {"outside_volume_ratio", 0.5},
             {"union_outside_ratio", 0.25},
             {"uncovered_volume_ratio", 0.125},
             {"silhouette_error",
              {{"mean", 0.0625}, {"worst", 0.375}, {"over", 0.05}, {"under", 0.0125}}}});
  CHECK(json.at("warnings") == Json{"first", "<second>"});
  CHECK(json.at("spheres").at(1) == Json{{"center", {0.5, 0, 0}}, {"radius", 0.25}});
}

TEST_CASE("the JSON report holds the history of the fit") {
  const Example example;
  const Json history = Json::parse(fitReportJson(example.report())).at("history");
  REQUIRE(history.size() == 3);
  CHECK(history[0] == Json{{"phase", "start"}, {"seconds", 0}, {"spheres", 1}, {"error", 0.5}});
  CHECK(history[2] ==
        Json{{"phase", "refine"}, {"seconds", 1.5}, {"spheres", 2}, {"error", 0.0625}});
}

TEST_CASE("measures that there are none of are not in the reports") {
  Example example;
  example.fit.set.measures = {0.75, std::nullopt, std::nullopt, std::nullopt, std::nullopt};
  const Json result = Json::parse(fitReportJson(example.report())).at("result");
  CHECK(result.at("covered_surface") == 0.75);
  for (const char* name : {"outside_volume_ratio", "union_outside_ratio", "uncovered_volume_ratio",
                           "silhouette_error"})
    CHECK_FALSE(result.contains(name));
  const auto cells = textsOf(readXml(fitReportHtml(example.report())), "td");
  CHECK(std::ranges::count(cells, "-") == 7);
}

TEST_CASE("the HTML report of a fit is one page of its own") {
  const Example example;
  const std::string page = fitReportHtml(example.report());
  const auto elements = readXml(page);
  for (const char* outside : {"http:", "https:", "url(", "@import", "<script", "<link"})
    CHECK(page.find(outside) == std::string::npos);
  CHECK(page.find("prefers-color-scheme: dark") != std::string::npos);
  const auto cells = textsOf(elements, "td"), terms = textsOf(elements, "dd");
  for (const char* value : {"6.25", "37.50", "5.00", "1.25", "75.00", "25.00", "12.50"})
    CHECK(contains(cells, std::string(value) + "\u00A0%"));
  CHECK(contains(cells, "0.5000"));
  for (const char* text : {"ball.obj", "shadow", "by hand", "11", "0000000000000abc", "Some CPU"})
    CHECK(contains(terms, text));
  CHECK(contains(textsOf(elements, "li"), "<second>"));
}

TEST_CASE("the HTML report plots the error by step and over time") {
  Example example;
  const auto count = [&](const std::string& name) {
    const auto elements = readXml(fitReportHtml(example.report()));
    return std::ranges::count_if(named(elements, "figure"), [&](const Element& element) {
      return element.attributes.contains("class") && element.attributes.at("class") == name;
    });
  };
  CHECK(count("plot") == 2);
  const auto elements = readXml(fitReportHtml(example.report()));
  const auto labels = textsOf(elements, "text"), legend = textsOf(elements, "span");
  CHECK(contains(labels, "step"));
  CHECK(contains(labels, "time (s)"));
  CHECK(contains(labels, "silhouettes and own sky (%)"));
  CHECK(std::ranges::count(legend, "start") == 2);
  CHECK(std::ranges::count(legend, "refine") == 2);
  example.fit.history.clear();
  CHECK(count("plot") == 0);
}

TEST_CASE("the HTML report shows the pictures of mesh and spheres") {
  const Example example;
  const auto images = named(readXml(fitReportHtml(example.report())), "img");
  const auto pictures = drawFit(example.mesh.mesh, example.fit.set.spheres);
  REQUIRE(images.size() == 9);
  for (std::size_t i = 0; i < 3; ++i) {
    const FitView& view = pictures.views[i];
    const auto checkImage = [&](std::size_t column, const Image& image) {
      CHECK(images[3 * i + column].attributes.at("src") ==
            "data:image/png;base64," + base64(encodePng(image)));
    };
    checkImage(0, view.mesh);
    checkImage(1, view.spheres);
    checkImage(2, view.silhouettes);
  }
}

TEST_CASE("foreign text does the reports no harm") {
  Example example;
  example.fit.set.meshName = example.fit.set.method = oddName;
  for (FitStep& step : example.fit.history) step.phase = oddName;
  example.fit.warnings = {oddName};
  const std::string shown = "<b>&\"' \uFFFD.obj";
  const auto elements = readXml(fitReportHtml(example.report()));
  CHECK(contains(textsOf(elements, "dd"), shown));
  CHECK(contains(textsOf(elements, "li"), shown));
  CHECK(contains(textsOf(elements, "span"), shown));
  CHECK(textsOf(elements, "title").at(0) == "Sphere fit of " + shown);
  CHECK(named(elements, "b").empty());
  const Json json = Json::parse(fitReportJson(example.report()));
  CHECK(json.at("mesh").at("name") == shown);
}

TEST_CASE("conclusions of fits") {
  Example example;
  const std::string whole =
      "2 spheres stand in for ball.obj: the silhouettes differ by 6.2\u00A0% of the mesh's on "
      "average "
      "(5.0\u00A0% too much, 1.2\u00A0% too little)";
  CHECK(example.report().conclusion() == whole);
  CHECK(example.report().complete());
  FitReport limited = example.report();
  limited.maximumError = 0.01;
  CHECK(limited.conclusion() == whole + "; the error asked for was not reached");
  CHECK_FALSE(limited.complete());
  example.fit.stop = FitStop::errorReached;
  CHECK(limited.conclusion() == whole);
  example.fit.stop = FitStop::timeLimit;
  CHECK(example.report().conclusion() == whole + "; the time limit cut the fit off");
  example.fit.stop = FitStop::cancelled;
  CHECK(example.report().conclusion() == whole + "; the fit was cancelled");
  CHECK(Json::parse(fitReportJson(example.report())).at("result").at("stop") == "cancelled");
  const auto paragraphs = named(readXml(fitReportHtml(example.report())), "p");
  CHECK(paragraphs.at(0).attributes.at("class") == "conclusion within");
}

TEST_CASE("a conclusion without silhouettes tells what is covered") {
  Example example;
  example.fit.set.measures.silhouette.reset();
  example.fit.set.spheres.resize(1);
  CHECK(example.report().conclusion() ==
        "1 sphere stands in for ball.obj: 75.0\u00A0% of the surface is covered");
}

TEST_CASE("the name of a report's file decides its kind") {
  const Example example;
  const TemporaryFolder folder;
  writeFitReport(folder / "fit.html", example.report());
  writeFitReport(folder / "fit.json", example.report());
  CHECK(readFile(folder / "fit.html") == fitReportHtml(example.report()));
  CHECK(readFile(folder / "fit.json") == fitReportJson(example.report()));
  for (const char* name : {"fit.txt", "fit", "fit.html.bak"}) {
    CHECK_THROWS_WITH_AS(writeFitReport(folder / name, example.report()),
                         doctest::Contains(".html or .json"), InputError);
    CHECK_FALSE(std::filesystem::exists(folder / name));
  }
  CHECK_THROWS_AS(writeFitReport(folder / "none" / "fit.json", example.report()), InputError);
}
