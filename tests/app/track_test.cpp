#include <sstream>

#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight::test;

namespace {

/// A ball that turns and grows to twice its size within frames 0 to 4.
const std::string growingBall = R"({
  "objects": [{
    "mesh": "builtin:sphere", "spheres": 4,
    "motion": { "keys": [{ "seconds": 0 },
                         { "seconds": 2, "scale": 2, "rotation": [0, 0.6, 0, 0.8] }] }
  }],
  "receiver": { "center": [0, -1.5, 0], "samples": [16, 16] },
  "light": { "source": "builtin:lamps" },
  "animation": { "lastFrame": 4, "framesPerSecond": 2 }
})";

const Arguments onReference{"--engine", "reference"};

}  // namespace

TEST_CASE("track measures the frames of a scene's animation") {
  const TemporaryFolder folder;
  writeFile(folder / "scene.json", growingBall);
  const auto results = resultsOf({"track", folder / "scene.json"});
  CHECK(results.at("scene") == (folder / "scene.json").string());
  REQUIRE(results.at("frames").size() == 5);
  CHECK(results.at("frames")[3].at("seconds") == 1.5);
  const auto& last = results.at("frames")[4].at("objects").at(0);
  CHECK(last.at("radius_ratio").at("mean").get<double>() == doctest::Approx(2));
  const auto& object = results.at("summary").at("object").at(0);
  CHECK(object.at("radius_ratio_largest").get<double>() == doctest::Approx(2));
  CHECK(object.at("radius_ratio_smallest").get<double>() == doctest::Approx(1));
}

TEST_CASE("track measures the frames asked for and prints a table") {
  const TemporaryFolder folder;
  writeFile(folder / "scene.json", growingBall);
  const Outcome outcome =
      runHaarlight({"track", folder / "scene.json", "--frames", "1:8", "--every", "3", "--plot",
                    folder / "track.svg", "--report", folder / "track.html", "--quiet"});
  CHECK(outcome.exitCode == 0);
  CHECK(outcome.errors == "");
  std::istringstream lines(outcome.output);
  std::string line;
  std::getline(lines, line);
  CHECK(contains(line, "covered %"));
  for (const int frame : {1, 4, 7}) {
    int number = -1;
    std::getline(lines, line);
    std::istringstream(line) >> number;
    CHECK(number == frame);
  }
  CHECK(contains(outcome.output, "frames measured: 3\n"));
  CHECK(readFile(folder / "track.svg").starts_with("<?xml"));
  CHECK(contains(readFile(folder / "track.html"), "surface not covered"));
}

TEST_CASE("track compares the plane as bake does, and with spheres fitted anew") {
  const TemporaryFolder folder;
  writeFile(folder / "scene.json", growingBall);
  const Arguments compare =
      joined({folder / "scene.json", "--compare-to", "pixel-mesh"}, onReference);
  const auto baked = resultsOf(joined({"bake"}, compare)).at("comparison").at(0);
  const auto tracked = resultsOf(joined({"track", "--frames", "0:2", "--refit", "2"}, compare));
  const auto& frames = tracked.at("frames");
  const auto error = [](const auto& figures) {
    return figures.at("rmse_relative_to_mean_percent").template get<double>();
  };
  CHECK(error(frames[0].at("plane").at("moved")) == doctest::Approx(error(baked)).epsilon(1e-9));
  CHECK(frames[0].at("plane").contains("refitted"));
  CHECK_FALSE(frames[1].at("plane").contains("refitted"));
  CHECK(frames[2].at("objects").at(0).contains("refitted"));
  CHECK(tracked.at("summary").at("plane_error").at("moved_to_refitted").at("frames") == 2);
  CHECK(tracked.at("summary").at("plane_error").at("method") == "haar");
}

TEST_CASE("track refuses what it cannot follow in one line") {
  const TemporaryFolder folder;
  writeFile(folder / "scene.json", growingBall);
  checkRefused({"track"}, "nothing to track");
  checkRefused({"track", "builtin:default"}, "moves and casts shadows");
  checkRefused({"track", folder / "scene.json", "--frames", "3:1"}, "--frames");
  checkRefused({"track", folder / "scene.json", "--every", "0"}, "--every");
  checkRefused({"track", folder / "scene.json", "--compare-to", "haar"}, "--compare-to");
  checkRefused({"track", folder / "scene.json", "--plot", folder / "track.png"}, ".svg");
  checkRefused(
      {"track", folder / "scene.json", "--method", "pixel-mesh", "--compare-to", "pixel-mesh"},
      "with itself");
  const auto withObject = [&](const std::string& extra) {
    writeFile(folder / "bad.json",
              R"({"objects": [{"mesh": "builtin:sphere", "spheres": 4, )" + extra + "}]}");
    return Arguments{"track", folder / "bad.json"};
  };
  writeFile(folder / "short.pc2", "POINTCACHE2");
  checkRefused(withObject(R"("deformation": {"pointCache": "short.pc2"})"), "short.pc2");
  checkRefused(withObject(R"("deformation": {"pointCache": "missing.pc2"})"), "missing.pc2");
  checkRefused(joined(withObject(R"("motion": {"keys": [{"seconds": 0, "scale": 2}]})"),
                      {"--compare-to", "pixel-mesh"}),
               "receiver");
}
