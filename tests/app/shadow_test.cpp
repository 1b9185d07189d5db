#include <cmath>
#include <numeric>

#include "image/read_image.h"
#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;
using nlohmann::json;

namespace {

const Arguments tiny{"--size", "64x36", "--samples", "1"};

json shadowOf(const Arguments& arguments) {
  return resultsOf(joined({"shadow", "--quiet"}, arguments));
}

json runsOf(const Arguments& arguments) {
  return shadowOf(joined(arguments, tiny)).at("run");
}

using Counts = std::vector<std::uint64_t>;

std::uint64_t sumOf(const Counts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t(0));
}

std::uint64_t at(const Counts& counts, std::size_t depth) {
  return depth < counts.size() ? counts[depth] : 0;
}

/// Checks that cells are leaves, reached by no surface, or divided into eight of the next depth.
/// Returns the number of leaves.
std::uint64_t checkCells(const json& octrees) {
  const Counts cells = octrees.at("cells_by_depth"), unreached = octrees.at("unreached_by_depth"),
               dark = octrees.at("leaves_in_shadow_by_depth"),
               light = octrees.at("leaves_in_light_by_depth");
  for (std::size_t depth = 0; depth < cells.size(); ++depth) {
    const std::uint64_t ended = at(unreached, depth) + at(dark, depth) + at(light, depth);
    CAPTURE(depth);
    REQUIRE(ended <= cells[depth]);
    CHECK(at(cells, depth + 1) == 8 * (cells[depth] - ended));
  }
  CHECK(octrees.at("leaves_by_ray") <= sumOf(dark) + sumOf(light));
  return sumOf(dark) + sumOf(light);
}

/// Checks that a run's steps take all of its time, and that there are no others.
void checkSeconds(const json& run, const std::vector<std::string>& steps) {
  const json& seconds = run.at("seconds");
  CHECK(seconds.size() == steps.size() + 1);
  double sum = 0;
  for (const std::string& step : steps) {
    CHECK(seconds.at(step) >= 0);
    sum += seconds.at(step).get<double>();
  }
  CHECK(sum > 0);
  CHECK(seconds.at("total").get<double>() == doctest::Approx(sum));
}

/// A number of four bytes, the most significant one first, of a PNG's header.
int headerNumber(const std::string& png, std::size_t place) {
  int number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = number * 256 + static_cast<unsigned char>(png[place + i]);
  return number;
}

/// A ball over a plane; `place` is more of the object.
std::string ball(const std::string& place) {
  return R"({"objects": [{"solid": {"sphere": {"radius": 0.5}}, )" + place + R"(}],
      "receiver": {}, "directionalLights": [{"towards": [1, 2, 0.5], "irradiance": [3, 3, 3]}]})";
}

}  // namespace

TEST_CASE("shadow writes pictures, and tells of cells, rays and the time of each step") {
  const TemporaryFolder folder;
  const std::string png = folder / "knot.png", exr = folder / "knot.exr";
  const json results = shadowOf(joined({"--detail", "0.1", "-o", png, "-o", exr}, tiny));
  CHECK(readFile(png).starts_with("\x89PNG"));
  const Image picture = readImage(exr).image;
  CHECK(picture.width == 64);
  CHECK(picture.height == 36);
  CHECK(results.at("picture") == png);
  CHECK(results.at("size") == "64x36");
  CHECK(results.at("camera_rays_per_pixel") == 1);
  CHECK(results.at("objects") == 2);
  CHECK(results.at("lights") == 1);
  CHECK(std::isfinite(results.at("exposure_stops").get<double>()));
  CHECK(results.at("camera_seconds") > 0);
  CHECK(results.at("peak_memory_mib") > 0);
  REQUIRE(results.at("run").size() == 1);
  const json& run = results.at("run")[0];
  CHECK(run.at("method") == "octree 0.1");
  CHECK_FALSE(run.contains("difference"));
  CHECK(run.at("bytes") == 12 * run.at("leaves").get<int>());
  checkSeconds(run, {"prepare", "pairs", "octrees", "look_up"});
  REQUIRE(run.at("light").size() == 1);
  const json& octrees = run.at("light")[0].at("octrees");
  CHECK(checkCells(octrees) == run.at("leaves"));
  CHECK(octrees.at("cells_by_depth")[0] == 2);  // of each receiver one
  CHECK(octrees.at("rays") > 0);
  double stages = 0;
  for (const char* stage : {"proof_seconds", "ray_seconds", "sort_seconds"})
    stages += octrees.at(stage).get<double>();
  CHECK(stages > 0);
  CHECK(stages <= run.at("seconds").at("octrees"));
  const json& pairs = run.at("light")[0].at("pairs");
  CHECK(pairs.at("tested") == 2);
  CHECK(pairs.at("dropped") == 0);
  CHECK(pairs.at("excluded") == 0);
  CHECK(pairs.at("kept") == 2);  // the knot shadows the plane and itself
}

TEST_CASE("shadow tells the same as text") {
  const Outcome outcome = runHaarlight(joined({"shadow", "--detail", "depth=3"}, tiny));
  CHECK(outcome.exitCode == 0);
  for (const char* line : {"\n  method: octree depth=3\n", "\n      cells by depth: [2,16,",
                           "\n    look up: ", "\npeak memory mib: "})
    CHECK(contains(outcome.output, line));
}

TEST_CASE("the smaller the detail, the more leaves") {
  const json runs = runsOf({"--detail", "depth=0", "--detail", "depth=4", "--detail", "0.1",
                            "--detail", "0.02", "--detail", "0.001"});
  REQUIRE(runs.size() == 5);
  CHECK(runs[0].at("leaves") == 2);
  for (std::size_t i = 1; i < runs.size(); ++i) {
    CHECK(runs[i].at("leaves") > 2 * runs[i - 1].at("leaves").get<int>());
    CHECK(checkCells(runs[i].at("light")[0].at("octrees")) == runs[i].at("leaves"));
  }
  CHECK(runs[4].at("method") == "octree 0.001");
}

TEST_CASE("cells that are all in shadow or in light are divided where it is asked for") {
  const auto octreesWith = [](const char* interior) {
    return runsOf({"--detail", "depth=6", "--interior", interior})[0].at("light")[0].at("octrees");
  };
  const json coarse = octreesWith("0"), fine = octreesWith("5");
  const Counts dark = fine.at("leaves_in_shadow_by_depth");
  CHECK(checkCells(fine) > checkCells(coarse));
  for (std::size_t depth = 0; depth < 5; ++depth) CHECK(dark[depth] == 0);
  CHECK(sumOf(coarse.at("leaves_in_shadow_by_depth")) > coarse.at("leaves_in_shadow_by_depth")[6]);
}

TEST_CASE("the shadow's area comes to the exact one's as cells become smaller") {
  for (const char* scene : {"builtin:lamp-knot", "builtin:cone-and-sphere"}) {
    const json runs =
        shadowOf({scene, "--size", "240x135", "--detail", "depth=4", "--detail", "depth=6",
                  "--detail", "depth=8", "--detail", "depth=10", "--compare-to", "exact"})
            .at("run");
    REQUIRE(runs.size() == 5);
    double last = 100;
    for (std::size_t i = 0; i < 4; ++i) {
      const json& difference = runs[i].at("difference");
      const double rays = difference.at("shadow_rays"), wrong = difference.at("wrong_percent"),
                   area = difference.at("area_error_percent"), extra = difference.at("extra"),
                   missing = difference.at("missing");
      CAPTURE(runs[i].at("method"));
      CHECK(rays > 10000);
      CHECK(wrong == doctest::Approx(100 * (extra + missing) / rays));
      CHECK(area == doctest::Approx(100 * (extra - missing) / rays));
      CHECK(wrong < last / 2);
      last = wrong;
      if (i == 3) CHECK(std::abs(area) <= 0.5);
    }
    CHECK(runs[4].at("method") == "exact");
    CHECK_FALSE(runs[4].contains("difference"));
  }
}

TEST_CASE("classic shadow volumes, of silhouettes and of all triangles, agree with exact rays") {
  const json runs =
      runsOf({"--method", "classic", "--compare-to", "classic-triangles", "--compare-to", "exact"});
  REQUIRE(runs.size() == 3);
  for (const std::size_t i : {0, 1}) {
    CHECK(runs[i].at("difference").at("shadow_rays") > 150);
    CHECK(runs[i].at("difference").at("wrong_percent") < 0.2);
    CHECK(runs[i].at("bytes") > 0);
    checkSeconds(runs[i], {"prepare", "draw"});
  }
  CHECK(runs[0].at("method") == "classic");
  CHECK(runs[1].at("method") == "classic-triangles");
  CHECK(runs[1].at("faces") > 2 * runs[0].at("faces").get<int>());
  CHECK(runs[2].at("rays") > 0);
  checkSeconds(runs[2], {"prepare", "cast"});
}

TEST_CASE("a sheet shows every run, and below it what is wrong if exact is among them") {
  const TemporaryFolder folder;
  const Arguments options{"--size",  "400x225",  "--samples", "1",      "--detail",
                          "depth=4", "--detail", "depth=6",   "--sheet"};
  const std::string plain = folder / "plain.png", compared = folder / "compared.png";
  shadowOf(joined(options, {plain, "--method", "classic", "--compare-to", "octree"}));
  CHECK(shadowOf(joined(options, {compared, "--compare-to", "exact"})).at("sheet") == compared);
  for (const std::string& path : {plain, compared}) {
    const std::string sheet = readFile(path);
    REQUIRE(sheet.starts_with("\x89PNG"));
    const int width = headerNumber(sheet, 16), height = headerNumber(sheet, 20);
    CHECK(width >= 3 * 400);
    CHECK(width < 4 * 400);
    CHECK(height >= (path == plain ? 1 : 2) * 225);
    CHECK(height < (path == plain ? 2 : 3) * 225);
  }
}

TEST_CASE("a mesh stands on the ground under lights of the command line") {
  const json results = shadowOf(joined({"--mesh", "builtin:sphere"}, tiny));
  CHECK(results.at("objects") == 2);
  CHECK(results.at("lights") == 1);
  const json both = shadowOf(joined({"--mesh", "builtin:sphere", "--point-light", "1,4,2",
                                     "--directional-light", "-1,1,0", "--compare-to", "exact"},
                                    tiny));
  CHECK(both.at("lights") == 2);
  CHECK(both.at("run")[0].at("light").size() == 2);
  CHECK(both.at("run")[0].at("difference").at("shadow_rays") > 0);
}

TEST_CASE("no shadow is seen from where the light is, but some from elsewhere") {
  const TemporaryFolder folder;
  writeFile(folder / "ball.json", ball(R"("transform": {"translate": [0, 1, 0]})"));
  writeFile(folder / "seen.json", readFile(folder / "ball.json").insert(1, R"("camera": {
      "position": [3, 4, 5], "target": [0, 0.5, 0]}, )"));
  const auto shadowRays = [&](const char* light) {
    return runsOf({folder / "seen.json", "--point-light", light, "--method", "exact",
                   "--compare-to", "octree"})[1]
        .at("difference")
        .at("shadow_rays");
  };
  CHECK(shadowRays("3,4,5") == 0);
  CHECK(shadowRays("-3,4,5") > 10);
}

TEST_CASE("a scene that moves is shown at the second that is asked for") {
  const TemporaryFolder folder;
  writeFile(folder / "moving.json",
            ball(R"("motion": {"keys": [{"seconds": 1, "translate": [0, 1, 0]},
                                        {"seconds": 3, "translate": [1, 2, 0]}]})"));
  writeFile(folder / "still.json", ball(R"("transform": {"translate": [0.5, 1.5, 0]})"));
  const auto picture = [&](const char* scene, const char* seconds) {
    const std::string path = folder / "picture.exr";
    runsOf({folder / scene, "--seconds", seconds, "-o", path});
    return readImage(path).image.pixels;
  };
  const auto expected = picture("still.json", "0");
  CHECK(picture("moving.json", "2") == expected);
  CHECK(picture("moving.json", "1") != expected);
  CHECK(picture("moving.json", "-7") == picture("moving.json", "1"));
}

TEST_CASE("shadow draws the same picture with any number of threads") {
  const TemporaryFolder folder;
  for (const char* threads : {"1", "3"})
    runsOf({"--threads", threads, "-o", folder / (threads + std::string(".png"))});
  CHECK(readFile(folder / "1.png") == readFile(folder / "3.png"));
  runsOf({"--plain", "-o", folder / "plain.png"});
  CHECK(readFile(folder / "1.png") != readFile(folder / "plain.png"));
}
