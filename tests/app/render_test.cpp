#include <cstdint>

#include "image/read_image.h"
#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

const Arguments tinyOnAnyEngine{"--size",    "32x18", "--samples", "1",
                                "--spheres", "8",     "--threads", "1"};
const Arguments tiny = joined(tinyOnAnyEngine, {"--engine", "reference"});

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | std::uint8_t(bytes.at(at + i));
  return number;
}

Outcome renderMesh(const std::string& objText, const TemporaryFolder& folder) {
  writeFile(folder / "mesh.obj", objText);
  return runHaarlight(joined(
      {"render", "--mesh", folder / "mesh.obj", "-o", folder / "picture.png", "--quiet"}, tiny));
}

}  // namespace

TEST_CASE("the default scene is written as PNG and EXR from one call") {
  const TemporaryFolder folder;
  const auto results = resultsOf(
      joined({"render", "-o", folder / "picture.png", "-o", folder / "picture.exr"}, tiny));
  CHECK(results.at("size") == "32x18");
  CHECK(results.at("method") == "haar");
  CHECK(results.at("spheres") == 8);

  const std::string png = readFile(folder / "picture.png");
  CHECK(png.starts_with("\x89PNG\r\n\x1a\n"));
  CHECK(bigEndian(png, 16) == 32);
  CHECK(bigEndian(png, 20) == 18);
  const ImageFile exr = readImage(folder / "picture.exr");
  CHECK(exr.image.width == 32);
  CHECK(exr.image.height == 18);
  for (const char* channel : {"R", "albedo.R", "N.R"})
    CHECK(std::ranges::find(exr.channels, channel) != exr.channels.end());
}

TEST_CASE("a scene may stand after an output and after a method to compare with") {
  const TemporaryFolder folder;
  const auto results =
      resultsOf(joined({"render", "-o", folder / "picture.png", "builtin:smooth", "--compare-to",
                        "pixel", "--compare-to", "haar", "--sheet", folder / "sheet.png"},
                       tiny));
  CHECK(results.at("light") == "builtin:sky");
  REQUIRE(results.at("comparison").size() == 2);
  CHECK(results.at("comparison")[0].at("reference") == "pixel");
  CHECK(results.at("comparison")[1].at("rmse") == 0);
  CHECK(readFile(folder / "sheet.png").starts_with("\x89PNG"));
}

TEST_CASE("a mesh in the place of a scene is pointed out") {
  checkRefused({"render", "bunny.obj", "-o", "x.png"}, "--mesh");
}

TEST_CASE("results go to standard output, messages to standard error") {
  const TemporaryFolder folder;
  const Arguments arguments = joined({"render", "-o", folder / "picture.png"}, tiny);
  const Outcome outcome = runHaarlight(arguments);
  CHECK(outcome.exitCode == 0);
  CHECK(contains(outcome.output, "picture: "));
  CHECK(contains(outcome.errors, "light: "));
  CHECK_FALSE(contains(outcome.errors, "\x1b"));
  CHECK_FALSE(contains(outcome.errors, "\r"));
  const Outcome quiet = runHaarlight(joined(arguments, {"--quiet"}));
  CHECK(quiet.exitCode == 0);
  CHECK(contains(quiet.output, "picture: "));
  CHECK(quiet.errors == "");
}

TEST_CASE("every method renders, and is compared to another") {
  const TemporaryFolder folder;
  for (const char* method : {"pixel", "pixel-mesh"}) {
    const auto results = resultsOf(
        joined({"render", "-o", folder / "picture.exr", "--method", method, "--compare-to", method},
               tiny));
    CHECK(results.at("method") == method);
    const auto comparison = results.at("comparison").at(0);
    CHECK(comparison.at("reference") == method);
    CHECK(comparison.at("rmse") == 0);
    CHECK(comparison.at("mean") > 0);
  }
  // Some of the light is left out, so that the two must differ, but not by much.
  const auto haar = resultsOf(joined({"render", "-o", folder / "picture.exr", "--terms", "50",
                                      "--light", "builtin:sky", "--compare-to", "pixel"},
                                     tiny));
  const double error = haar.at("comparison").at(0).at("rmse_relative_to_mean_percent");
  CHECK(error > 0);
  CHECK(error < 10);
}

TEST_CASE("exponentiation renders the same picture on every engine, near the exact one") {
  const TemporaryFolder folder;
  for (const std::string engine : {"reference", "auto", "cuda-host"}) {
    CAPTURE(engine);
    const auto picture = folder / (engine + ".exr");
    const auto results = resultsOf(
        joined({"render", "-o", picture, "--method", "shexp", "--order", "5", "--engine", engine,
                "--light", "builtin:sky", "--compare-to", "shexp", "--compare-to", "pixel"},
               tinyOnAnyEngine));
    CHECK(results.at("method") == "shexp");
    CHECK(results.at("order") == 5);
    const auto comparisons = results.at("comparison");
    CHECK(comparisons.at(0).at("rmse") == 0);
    CHECK(comparisons.at(1).at("reference") == "pixel");
    CHECK(comparisons.at(1).at("rmse_relative_to_mean_percent") > 0);
    CHECK(comparisons.at(1).at("rmse_relative_to_mean_percent") < 5);
    CHECK(readImage(picture).image.pixels == readImage(folder / "reference.exr").image.pixels);
  }
}

TEST_CASE("the exposure of a PNG does not change the EXR") {
  const TemporaryFolder folder;
  const auto render = [&](const std::string& stops) {
    resultsOf(joined({"render", "--exposure", stops, "-o", folder / (stops + ".png"), "-o",
                      folder / (stops + ".exr")},
                     tiny));
  };
  render("0");
  render("2");
  CHECK(readFile(folder / "0.png") != readFile(folder / "2.png"));
  CHECK(readImage(folder / "0.exr").image.pixels == readImage(folder / "2.exr").image.pixels);
}

TEST_CASE("open and non-manifold meshes work, with a warning") {
  const TemporaryFolder folder;
  const std::string bent = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\n";
  const Outcome open = renderMesh(bent, folder);
  CHECK(open.exitCode == 0);
  CHECK(contains(open.errors, "haarlight: warning: "));
  CHECK(contains(open.errors, "mesh.obj: 4 boundary edges: the surface is open"));
  const Outcome fan = renderMesh(bent + "v 0 -1 0\nf 1 2 5\n", folder);
  CHECK(fan.exitCode == 0);
  CHECK(contains(fan.errors, "mesh.obj: 1 edges of more than two triangles"));
  CHECK(std::filesystem::exists(folder / "picture.png"));
}
