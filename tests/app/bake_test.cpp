#include <algorithm>
#include <string>

#include "image/read_image.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_file.h"
#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

Image bakePlane(const Arguments& arguments) {
  const TemporaryFolder folder;
  resultsOf(
      joined({"bake", "--spheres", "8", "--size", "9x7", "-o", folder / "plane.exr"}, arguments));
  return readImage(folder / "plane.exr").image;
}

std::string attribute(const ImageFile& file, const std::string& name) {
  for (const auto& [key, value] : file.attributes)
    if (key == name) return value;
  return "";
}

/// A plane under a light of radiance 1 from everywhere, with nothing above it.
const std::string emptyScene =
    R"({"receiver": {"samples": [4, 3], "albedo": [0.25, 0.5, 0.75]},
        "light": {"source": "builtin:constant"}})";

}  // namespace

TEST_CASE("a baked plane has its size and says how it was made") {
  const TemporaryFolder folder;
  const auto results = resultsOf({"bake", "--size", "9x7", "--spheres", "8", "--terms", "100",
                                  "--engine", "reference", "-o", folder / "plane.exr"});
  CHECK(results.at("samples") == 63);
  const ImageFile file = readImage(folder / "plane.exr");
  CHECK(file.image.width == 9);
  CHECK(file.image.height == 7);
  CHECK(attribute(file, "method") == "haar");
  CHECK(attribute(file, "terms") == "100");
  CHECK(attribute(file, "spheres") == "8");
  CHECK(attribute(file, "device") == results.at("device"));
  CHECK(attribute(file, "software").starts_with("haarlight "));
}

TEST_CASE("the engines bake the same bits") {
  if (!haveOpenCl()) return;
  for (const char* visibility : {"exact", "table"}) {
    CAPTURE(visibility);
    const Image reference = bakePlane({"--engine", "reference", "--visibility", visibility});
    const Image openCl = bakePlane({"--engine", "opencl", "--visibility", visibility});
    CHECK(reference.pixels == openCl.pixels);
    const auto [darkest, brightest] =
        std::ranges::minmax(reference.pixels, {}, [](const glm::vec3& pixel) { return pixel.g; });
    CHECK(darkest.g < 0.9f * brightest.g);
  }
}

TEST_CASE("all Haar terms make the sum over all texels") {
  const auto results = resultsOf({"bake", "--size", "9x7", "--spheres", "8", "--terms", "6144",
                                  "--engine", "reference", "--compare-to", "pixel"});
  CHECK(results.at("comparison").at(0).at("rmse_relative_to_mean_percent") < 1e-3);
}

TEST_CASE("an empty plane under a constant light has the radiance of its albedo") {
  const TemporaryFolder folder;
  writeFile(folder / "scene.json", emptyScene);
  for (const char* method : {"haar", "pixel", "pixel-mesh", "shexp", "sh"}) {
    CAPTURE(method);
    resultsOf({"bake", folder / "scene.json", "--method", method, "--engine", "reference", "-o",
               folder / "plane.exr"});
    const Image plane = readImage(folder / "plane.exr").image;
    REQUIRE(plane.pixels.size() == 12);
    for (const glm::vec3& pixel : plane.pixels) {
      CHECK(pixel.r == doctest::Approx(0.25).epsilon(1e-4));
      CHECK(pixel.g == doctest::Approx(0.5).epsilon(1e-4));
      CHECK(pixel.b == doctest::Approx(0.75).epsilon(1e-4));
    }
  }
}

TEST_CASE("an object is baked to a PLY with its vertices and triangles") {
  const TemporaryFolder folder;
  const auto results = resultsOf({"bake", "--mesh", "builtin:sphere", "--spheres", "1", "--object",
                                  "sphere", "--engine", "reference", "-o", folder / "sphere.ply"});
  const TriangleMesh expected = builtinMesh("builtin:sphere");
  CHECK(results.at("samples") == expected.positions.size());
  const LoadedMesh loaded = loadMesh(folder / "sphere.ply");
  CHECK(loaded.mesh.positions.size() == expected.positions.size());
  CHECK(loaded.mesh.triangles == expected.triangles);
  CHECK(loaded.topology.closed);
}

TEST_CASE("a wrong object or size is refused with what there is") {
  checkRefused({"bake", "--spheres", "8", "--object", "teapot", "--quiet"}, "it has knot");
  const TemporaryFolder folder;
  writeFile(folder / "scene.json", R"({"objects": [{"mesh": "builtin:sphere", "spheres": 1}]})");
  checkRefused({"bake", folder / "scene.json", "--size", "4x4", "--quiet"}, "--size");
  checkRefused({"bake", folder / "scene.json", "--quiet"}, "--object");
}
