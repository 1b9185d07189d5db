#include <fmt/format.h>

#include <algorithm>
#include <glm/vec3.hpp>

#include "image/read_image.h"
#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

enum class Expected {
  anything,
  darkness,       ///< nothing that is seen is in light
  noCastShadows,  ///< what faces the light is in light
};

struct DegenerateScene {
  std::string name;
  std::vector<std::string> objects;
  std::string lights;
  Expected expected = Expected::anything;
};

std::string solid(const std::string& shape, const std::string& place) {
  return fmt::format(R"({{"solid": {{{}}}, "transform": {{"translate": [{}]}}}})", shape, place);
}

std::string sphere(double radius, const std::string& place) {
  return solid(fmt::format(R"("sphere": {{"radius": {}}})", radius), place);
}

/// Of height 1, from the plane up unless it is said otherwise.
std::string cone(double topRadius, const std::string& place = "0, 0.5, 0") {
  return solid(fmt::format(R"("cone": {{"radius": 0.5, "height": 1, "topRadius": {}}})", topRadius),
               place);
}

std::string box(double half, const std::string& place) {
  return solid(fmt::format(R"("box": {{"halfSizes": [{0}, {0}, {0}]}})", half), place);
}

std::string torus(double minorRadius) {
  return solid(fmt::format(R"("torus": {{"majorRadius": 0.5, "minorRadius": {}}})", minorRadius),
               "0, 0.5, 0");
}

std::string mesh(const std::string& file) {
  return fmt::format(R"({{"mesh": "{}", "spheres": 1}})", file);
}

std::string lamp(const std::string& place, double intensity = 30) {
  return fmt::format(R"("pointLights": [{{"position": [{0}], "intensity": [{1}, {1}, {1}]}}], )",
                     place, intensity);
}

std::string sun(const std::string& towards) {
  return fmt::format(R"("directionalLights": [{{"towards": [{}], "irradiance": [3, 3, 3]}}], )",
                     towards);
}

std::string listOf(const std::vector<std::string>& parts) {
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// How many colours a picture has.
std::size_t colourCount(const Image& image) {
  std::vector<glm::vec3> colours = image.pixels;
  const auto before = [](const glm::vec3& a, const glm::vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::sort(colours.begin(), colours.end(), before);
  return std::size_t(std::unique(colours.begin(), colours.end()) - colours.begin());
}

class Setting {
 public:
  void addMesh(const std::string& name, const std::string& content) const {
    writeFile(folder_ / name, content);
  }

  /// What is seen of the scene, and what the program tells.
  nlohmann::json show(const DegenerateScene& scene, Image& picture) const {
    writeFile(folder_ / "scene.json", fmt::format(R"({{"objects": [{}], "receiver": {{}}, {}
                  "camera": {{"position": [3, 4, 5], "target": [0, 0.5, 0]}},
                  "image": {{"width": 64, "height": 48, "samplesPerPixel": 1}}}})",
                                                  listOf(scene.objects), scene.lights));
    const auto results = resultsOf({"shadow", folder_ / "scene.json", "--quiet", "--plain",
                                    "--detail", "depth=7", "--compare-to", "exact", "--compare-to",
                                    "classic", "-o", folder_ / "picture.exr"});
    picture = readImage(folder_ / "picture.exr").image;
    return results;
  }

  void check(const DegenerateScene& scene) const {
    CAPTURE(scene.name);
    Image picture;
    const auto results = show(scene, picture);
    const auto& octree = results.at("run")[0];
    const double rays = octree.at("difference").at("shadow_rays");
    CHECK(octree.at("leaves") >= scene.objects.size() + 1);
    for (const glm::vec3& pixel : picture.pixels)
      REQUIRE(std::min({pixel.x, pixel.y, pixel.z}) > 0);
    // No edge of a shadow here is longer than 60 pixels, of which one in six is wrong.
    CHECK(octree.at("difference").at("missing").get<double>() +
              octree.at("difference").at("extra").get<double>() <=
          std::min(10., rays + 3));
    if (scene.expected == Expected::noCastShadows) CHECK(rays == 0);
    if (scene.expected != Expected::darkness) return;
    CHECK(rays > 1000);
    CHECK(colourCount(picture) <= 3);  // object, plane, background
  }

 private:
  TemporaryFolder folder_;
};

void checkAll(const std::vector<DegenerateScene>& scenes) {
  const Setting setting;
  setting.addMesh("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  setting.addMesh("both_ways.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n");
  setting.addMesh("carpet.obj", "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 1 4 3\nf 1 3 2\n");
  for (const DegenerateScene& scene : scenes) setting.check(scene);
}

const std::string above = lamp("1, 4, 2");

}  // namespace

TEST_CASE("light inside a solid, or on its surface, leaves everything in shadow") {
  checkAll({{"in a sphere", {sphere(0.5, "0, 1, 0")}, lamp("0, 1, 0"), Expected::darkness},
            {"in a torus's tube", {torus(0.2)}, lamp("0.5, 0.5, 0"), Expected::darkness},
            {"in a torus's middle", {torus(0.5)}, lamp("0, 0.5, 0"), Expected::darkness},
            {"on a sphere", {sphere(0.5, "0, 1, 0")}, lamp("0, 1.5, 0"), Expected::darkness},
            {"on a face", {box(0.5, "0, 0.5, 0")}, lamp("0.1, 1, 0.2"), Expected::darkness},
            {"on an edge", {box(0.5, "0, 0.5, 0")}, lamp("0.5, 1, 0"), Expected::darkness},
            {"on a corner", {box(0.5, "0, 0.5, 0")}, lamp("0.5, 1, 0.5"), Expected::darkness},
            {"on an apex", {cone(0)}, lamp("0, 1, 0"), Expected::darkness},
            {"between nested solids",
             {sphere(1, "0, 1, 0"), box(0.2, "0, 1, 0")},
             lamp("0.9, 1, 0"),
             Expected::darkness},
            {"in a torus's hole", {torus(0.2)}, lamp("0, 0.5, 0")}});
}

TEST_CASE("light straight along an axis, or level with a face or with the floor") {
  checkAll(
      {{"above an apex", {cone(0)}, lamp("0, 4, 0"), Expected::noCastShadows},
       {"straight down on an apex", {cone(0)}, sun("0, 1, 0"), Expected::noCastShadows},
       {"below a cone", {cone(0)}, lamp("0, -4, 0"), Expected::noCastShadows},
       {"above a cylinder's axis", {cone(0.5)}, sun("0, 1, 0"), Expected::noCastShadows},
       {"along a torus's axis", {torus(0.2)}, lamp("0, 3, 0")},
       {"through a horn torus", {torus(0.5)}, sun("0, 1, 0")},
       {"level with a box's top", {box(0.5, "0, 0.5, 0")}, lamp("3, 1, 0")},
       {"level with the floor", {sphere(0.5, "0, 1, 0")}, lamp("3, 0, 0"), Expected::noCastShadows},
       {"along the floor", {sphere(0.5, "0, 1, 0")}, sun("1, 0, 0"), Expected::noCastShadows},
       {"on the floor", {sphere(0.5, "0, 1, 0")}, lamp("2, 0, 1"), Expected::noCastShadows},
       {"below the floor", {sphere(0.5, "0, 1, 0")}, lamp("3, -2, 0"), Expected::noCastShadows}});
}

TEST_CASE("solids that touch, nest or coincide") {
  checkAll({{"side by side", {sphere(0.5, "-0.5, 0.5, 0"), sphere(0.5, "0.5, 0.5, 0")}, above},
            {"one upon the other", {box(0.5, "0, 0.5, 0"), box(0.5, "0, 1.5, 0")}, above},
            {"one in the other", {sphere(0.5, "0, 1, 0"), sphere(0.2, "0, 1, 0")}, above},
            {"the same sphere", {sphere(0.5, "0, 1, 0"), sphere(0.5, "0, 1, 0")}, above},
            {"the same cone", {cone(0), cone(0)}, above},
            {"the same box", {box(0.5, "0, 0.5, 0"), box(0.5, "0, 0.5, 0")}, above},
            {"the same torus", {torus(0.2), torus(0.2)}, above}});
}

TEST_CASE("cones that are cylinders or stand on their tops, needles, specks and worlds") {
  checkAll({{"a cylinder", {cone(0.5)}, above},
            {"wider at the top", {cone(0.9)}, above},
            {"a needle", {solid(R"("cylinder": {"radius": 1e-6, "height": 2})", "0, 1, 0")}, above},
            {"a sheet", {solid(R"("box": {"halfSizes": [0.7, 1e-6, 0.7]})", "0, 1, 0")}, above},
            {"a speck", {sphere(1e-6, "0, 1, 0")}, above},
            {"far away", {sphere(1, "1000000, 1, 0")}, above},
            {"under far light", {sphere(0.5, "0, 1, 0")}, lamp("1e6, 1e6, 1e6", 1e12)}});
}

TEST_CASE("meshes of one triangle or two") {
  checkAll(
      {{"a triangle", {mesh("triangle.obj")}, above},
       {"a triangle edge-on", {mesh("triangle.obj")}, lamp("1, 4, 0"), Expected::noCastShadows},
       {"light on a corner", {mesh("triangle.obj")}, lamp("0, 1, 0")},
       {"a triangle both ways", {mesh("both_ways.obj")}, above},
       {"the same twice", {mesh("triangle.obj"), mesh("triangle.obj")}, above},
       {"in the floor", {mesh("carpet.obj")}, above}});
  const TemporaryFolder folder;
  writeFile(folder / "line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  checkRefused({"shadow", "--quiet", "--mesh", folder / "line.obj"}, "line.obj");
}

TEST_CASE("a plane alone is in light") {
  checkAll({{"a lamp above", {}, above, Expected::noCastShadows},
            {"a lamp on it", {}, lamp("1, 0, 1"), Expected::noCastShadows},
            {"the sun", {}, sun("1, 1, 1"), Expected::noCastShadows}});
}

TEST_CASE("a light without intensity leaves the picture black") {
  Image picture;
  Setting().show({"off", {sphere(0.5, "0, 1, 0")}, lamp("1, 4, 2", 0)}, picture);
  for (const glm::vec3& pixel : picture.pixels) REQUIRE(pixel == glm::vec3(0));
}
