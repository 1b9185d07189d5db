#include <string>

#include "error_text.h"
#include "scene/scene_file.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// What parseScene complains about; empty when it does not.
std::string complaint(const std::string& text) {
  return inputErrorOf([&] { parseScene(text, "scene.json"); });
}

std::string complaintAboutSolid(const std::string& solid, const std::string& fields = "") {
  return complaint(R"({"objects": [{"solid": )" + solid + fields + "}]}");
}

std::string complaintAboutDirection(const std::string& light) {
  return complaint(R"({"receiver": {}, "directionalLights": [{"irradiance": [1, 1, 1], )" + light +
                   "}]}");
}

const std::string solids = R"({
  "objects": [
    { "solid": { "sphere": { "radius": 0.5 } } },
    { "solid": { "ellipsoid": { "radii": [1, 2, 3] } }, "name": "egg", "family": "food" },
    { "solid": { "box": { "halfSizes": [4, 5, 6] } },
      "transform": { "scale": 2, "rotateDegrees": [0, 45, 0], "rest": "ground",
                     "translate": [1, 0, 0] } },
    { "solid": { "cylinder": { "radius": 0.25, "height": 3 } },
      "motion": { "keys": [{ "seconds": 0, "scale": 2, "rotation": [0, 1, 0, 1] }] } },
    { "solid": { "cone": { "radius": 0.5, "height": 1.2, "topRadius": 0.125 } } },
    { "solid": { "torus": { "majorRadius": 2, "minorRadius": 2 } } },
    { "solid": { "cone": {} } }
  ],
  "pointLights": [
    { "position": [1, 2, 3], "intensity": [100, 50, 1e12],
      "motion": { "keys": [{ "seconds": 0 }, { "seconds": 1, "position": [4, 5, 6],
                                               "ease": "smooth" }], "repeat": "loop" } },
    { "position": [0, 0, 0], "intensity": [0, 0, 0] }
  ],
  "directionalLights": [
    { "towards": [0, 1e-300, 0], "irradiance": [3, 2, 1],
      "motion": { "keys": [{ "seconds": 2, "towards": [0, 0, 1] }], "repeat": "pingpong" } }
  ]
})";

}  // namespace

TEST_CASE("every field of a solid reaches the description") {
  const SceneDescription scene = parseScene(solids, "scenes/solids.json");
  REQUIRE(scene.objects.size() == 7);
  const auto shape = [&]<typename S>(std::size_t i, S) {
    return std::get<S>(*scene.objects[i].solid);
  };
  CHECK(shape(0, SphereShape{}).radius == 0.5);
  CHECK(shape(1, EllipsoidShape{}).radii == glm::dvec3(1, 2, 3));
  CHECK(shape(2, BoxShape{}).halfSizes == glm::dvec3(4, 5, 6));
  CHECK(shape(3, CylinderShape{}).radius == 0.25);
  CHECK(shape(3, CylinderShape{}).height == 3);
  CHECK(shape(4, ConeShape{}).radius == 0.5);
  CHECK(shape(4, ConeShape{}).height == 1.2);
  CHECK(shape(4, ConeShape{}).topRadius == 0.125);
  CHECK(shape(5, TorusShape{}).majorRadius == 2);
  CHECK(shape(5, TorusShape{}).minorRadius == 2);
  CHECK(shape(6, ConeShape{}).topRadius == 0);
  CHECK(scene.objects[2].transform.scale == glm::dvec3(2));
  CHECK(scene.objects[2].transform.rest == Rest::Ground);
  CHECK(scene.objects[3].motion->keys[0].scale == 2);
}

TEST_CASE("a solid is named by its shape, and has no mesh and no family unless told") {
  const SceneDescription scene = parseScene(solids, "scenes/solids.json");
  CHECK(scene.objects[0].name == "sphere");
  CHECK(scene.objects[1].name == "egg");
  CHECK(scene.objects[2].name == "box");
  CHECK(scene.objects[5].name == "torus");
  CHECK(scene.objects[0].mesh.empty());
  CHECK(scene.objects[1].family == "food");
  CHECK_FALSE(scene.objects[0].family);
  CHECK_FALSE(parseScene(R"({"objects": [{"mesh": "a"}]})", "x.json").objects[0].solid);
}

TEST_CASE("every field of a light with hard shadows reaches the description") {
  const SceneDescription scene = parseScene(solids, "scenes/solids.json");
  REQUIRE(scene.pointLights.size() == 2);
  const PointLightDescription& point = scene.pointLights[0];
  CHECK(point.position == glm::dvec3(1, 2, 3));
  CHECK(point.intensity == glm::dvec3(100, 50, 1e12));
  REQUIRE(point.motion->keys.size() == 2);
  CHECK_FALSE(point.motion->keys[0].position);
  CHECK(point.motion->keys[1].position == glm::dvec3(4, 5, 6));
  CHECK(point.motion->keys[1].ease == Ease::smooth);
  CHECK(point.motion->repeat == Repeat::loop);
  CHECK_FALSE(scene.pointLights[1].motion);
  REQUIRE(scene.directionalLights.size() == 1);
  const DirectionalLightDescription& directional = scene.directionalLights[0];
  CHECK(directional.towards == glm::dvec3(0, 1e-300, 0));
  CHECK(directional.irradiance == glm::dvec3(3, 2, 1));
  CHECK(directional.motion->keys[0].towards == glm::dvec3(0, 0, 1));
  CHECK(directional.motion->repeat == Repeat::pingpong);
}

TEST_CASE("a scene of solids that is written and read again is the same") {
  const std::string once = sceneToJson(parseScene(solids, "solids.json"));
  CHECK(sceneToJson(parseScene(once, "again.json")) == once);
  CHECK(once.find("\"mesh\"") == std::string::npos);
}

TEST_CASE("an object is a mesh or a solid") {
  CHECK(complaint(R"({"objects": [{"mesh": "a.obj", "solid": {"sphere": {}}}]})") ==
        "scene.json: objects[0]: give a mesh or a solid, not both");
  const std::string kinds = "sphere, ellipsoid, box, cylinder, cone, torus";
  CHECK(complaintAboutSolid("{}") == "scene.json: objects[0].solid: give exactly one of " + kinds);
  CHECK(complaintAboutSolid(R"({"box": {}, "cone": {}})") ==
        "scene.json: objects[0].solid: give exactly one of " + kinds);
  CHECK(complaintAboutSolid(R"({"cylindre": {}})") ==
        "scene.json: objects[0].solid: unknown field 'cylindre'; did you mean 'cylinder'?");
  CHECK(complaintAboutSolid(R"({"box": {"radius": 1}})") ==
        "scene.json: objects[0].solid.box: unknown field 'radius'; known are halfSizes");
}

TEST_CASE("measures that give no solid are refused with their place") {
  CHECK(complaintAboutSolid(R"({"sphere": {"radius": 0}})") ==
        "scene.json: objects[0].solid.sphere.radius: must be >= 1e-06, is 0");
  CHECK(complaintAboutSolid(R"({"box": {"halfSizes": [1, -1, 1]}})") ==
        "scene.json: objects[0].solid.box.halfSizes[1]: must be >= 1e-06, is -1");
  CHECK(complaintAboutSolid(R"({"cone": {"height": 1e7}})") ==
        "scene.json: objects[0].solid.cone.height: must be <= 1000000, is 10000000.0");
  CHECK(complaintAboutSolid(R"({"cone": {"topRadius": 1e-7}})") ==
        "scene.json: objects[0].solid.cone.topRadius: must be 0 or >= 1e-06, is 1e-07");
  CHECK(complaintAboutSolid(R"({"cone": {"topRadius": 1e-6}})").empty());
  CHECK(complaintAboutSolid(R"({"torus": {"majorRadius": 1, "minorRadius": 2}})") ==
        "scene.json: objects[0].solid: torus: its minor radius 2 exceeds its major radius 1, so "
        "that its surface would pass through itself");
  CHECK(complaintAboutSolid(R"({"torus": {"majorRadius": 0.1}})")
            .starts_with("scene.json: objects[0].solid: torus: its minor radius "));
}

TEST_CASE("what would bend or stretch a solid is refused") {
  const std::string sphere = R"({"sphere": {}})", place = "scene.json: objects[0].";
  CHECK(complaintAboutSolid(sphere, R"(, "transform": {"fit": 2})") ==
        place + "transform.fit: a solid's size is given by its measures");
  CHECK(complaintAboutSolid(sphere, R"(, "transform": {"scale": [1, 2, 1]})") ==
        place + "transform.scale: a solid's is one number; stretch it by its measures");
  CHECK(complaintAboutSolid(sphere, R"(, "transform": {"fit": "none", "scale": 2})").empty());
  CHECK(complaintAboutSolid(sphere, R"(, "deformation": {})") ==
        place + "deformation: a solid keeps its shape; give a mesh for one that changes");
  CHECK(complaintAboutSolid(sphere, R"(, "transfer": "a.prt")") ==
        place + "transfer: transfer is for the vertices of a mesh, and a solid has none");
}

TEST_CASE("directions to a light are not zero, and neighbours are not opposite") {
  const std::string place = "scene.json: directionalLights[0].";
  const auto keys = [](const std::string& first, const std::string& second) {
    return complaintAboutDirection(R"("towards": [0, 1, 0], "motion": {"keys": [{"seconds": 0, )" +
                                   first + R"(}, {"seconds": 1)" + second + "}]}");
  };
  CHECK(complaintAboutDirection(R"("towards": [0, 0, 0])") == place + "towards: must not be zero");
  CHECK(keys(R"("towards": [0, 0, 0])", "") == place + "motion.keys[0].towards: must not be zero");
  const std::string opposite =
      place + "motion.keys[1]: towards is opposite to that of the key before; put a key in between";
  CHECK(keys(R"("towards": [1, 2, 3])", R"(, "towards": [-2, -4, -6])") == opposite);
  CHECK(keys(R"("towards": [0, -1e-300, 0])", "") == opposite);
  CHECK(keys(R"("towards": [1, 2, 3], "ease": "hold")", R"(, "towards": [-2, -4, -6])").empty());
  CHECK(keys(R"("towards": [1, 2, 3])", R"(, "towards": [-2, -4, -6.00001])").empty());
}

TEST_CASE("there are at most sixteen lights of a kind") {
  const auto lights = [](int count) {
    std::string list;
    for (int i = 0; i < count; ++i)
      list += std::string(i ? "," : "") + R"({"position": [0, 1, 0], "intensity": [1, 1, 1]})";
    return complaint(R"({"receiver": {}, "pointLights": [)" + list + "]}");
  };
  CHECK(lights(16).empty());
  CHECK(lights(17) == "scene.json: pointLights: must be an array of at most 16, is an array of 17");
}
