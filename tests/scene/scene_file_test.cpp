#include "scene/scene_file.h"

#include <string>
#include <vector>

#include "base/error.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

const std::string fullScene = R"({
  "$schema": "../docs/scene.schema.json",
  "version": 1,
  "objects": [
    {
      "name": "bunny",
      "mesh": "meshes/bunny.obj",
      "transform": {
        "fit": 2.5, "scale": [1, 2, 3], "rotateDegrees": [10, 20, 30], "rest": "ground",
        "translate": [-1, 0.1, 1e-3]
      },
      "albedo": [0, 0.25, 1],
      "spheres": "bunny.spheres",
      "castsShadow": false,
      "transfer": "bunny.prt"
    },
    { "mesh": "builtin:sphere", "transform": { "fit": "none", "scale": 0.5 }, "spheres": 1 }
  ],
  "receiver": { "center": [1, 2, 3], "size": [4, 5], "samples": [64, 32], "albedo": [0.1, 0.2, 0.3] },
  "light": { "source": "/probes/grace.hdr", "layout": "vcross", "rotateDegrees": -90, "scale": 0,
             "samples": [ { "position": [1, 0, 2], "source": "near.hdr", "layout": "angular",
                            "rotateDegrees": 30, "scale": 2 }, { "source": "builtin:sky" } ] },
  "camera": {
    "position": [1, 2, 3], "target": [4, 5, 7], "up": [0, 0, 1], "verticalFieldOfViewDegrees": 45.5
  },
  "image": {
    "width": 320, "height": 200, "samplesPerPixel": 16, "exposure": -1.5, "background": [0, 0.5, 2]
  },
  "shading": { "method": "pixel-mesh", "terms": 6144, "levels": 1, "order": 6, "per": "pixel",
               "visibility": "table", "engine": "reference" }
})";

constexpr const char* smallScene = R"({"receiver": {}})";

/// The examples in JSON that a page of docs shows.
std::vector<std::string> examplesIn(const char* name) {
  const std::string page = readFile(std::filesystem::path(HAARLIGHT_SOURCE_FOLDER) / "docs" / name);
  const std::string opening = "```json\n";
  std::vector<std::string> examples;
  for (std::size_t at = page.find(opening); at != std::string::npos; at = page.find(opening, at)) {
    at += opening.size();
    examples.push_back(page.substr(at, page.find("```", at) - at));
  }
  return examples;
}

}  // namespace

TEST_CASE("every field of a scene reaches the description") {
  const SceneDescription scene = parseScene(fullScene, "scenes/full.json");
  REQUIRE(scene.objects.size() == 2);
  const ObjectDescription& bunny = scene.objects[0];
  CHECK(bunny.name == "bunny");
  CHECK(bunny.mesh == "scenes/meshes/bunny.obj");
  CHECK(bunny.transform.fit == 2.5);
  CHECK(bunny.transform.scale == glm::dvec3(1, 2, 3));
  CHECK(bunny.transform.rotateDegrees == glm::dvec3(10, 20, 30));
  CHECK(bunny.transform.rest == Rest::Ground);
  CHECK(bunny.transform.translate == glm::dvec3(-1, 0.1, 1e-3));
  CHECK(bunny.albedo == glm::dvec3(0, 0.25, 1));
  CHECK(std::get<std::filesystem::path>(bunny.spheres) == "scenes/bunny.spheres");
  CHECK_FALSE(bunny.castsShadow);
  CHECK(bunny.transfer == "scenes/bunny.prt");
  const ObjectDescription& sphere = scene.objects[1];
  CHECK(sphere.name == "sphere");
  CHECK(sphere.mesh == "builtin:sphere");
  CHECK_FALSE(sphere.transform.fit);
  CHECK(sphere.transform.scale == glm::dvec3(0.5));
  CHECK(std::get<int>(sphere.spheres) == 1);
  REQUIRE(scene.receiver);
  CHECK(scene.receiver->center == glm::dvec3(1, 2, 3));
  CHECK(scene.receiver->size == glm::dvec2(4, 5));
  CHECK(scene.receiver->samples == glm::ivec2(64, 32));
  CHECK(scene.receiver->albedo == glm::dvec3(0.1, 0.2, 0.3));
  CHECK(scene.light.source == "/probes/grace.hdr");
  CHECK(scene.light.layout == "vcross");
  CHECK(scene.light.rotateDegrees == -90);
  CHECK(scene.light.scale == 0);
  REQUIRE(scene.light.samples.size() == 2);
  const LightSampleDescription& near = scene.light.samples[0];
  CHECK(near.position == glm::dvec3(1, 0, 2));
  CHECK(near.source == "scenes/near.hdr");
  CHECK(near.layout == "angular");
  CHECK(near.rotateDegrees == 30);
  CHECK(near.scale == 2);
  CHECK(scene.light.samples[1].source == "builtin:sky");
  CHECK(scene.camera.position == glm::dvec3(1, 2, 3));
  CHECK(scene.camera.target == glm::dvec3(4, 5, 7));
  CHECK(scene.camera.up == glm::dvec3(0, 0, 1));
  CHECK(scene.camera.verticalFieldOfViewDegrees == 45.5);
  CHECK(scene.image.width == 320);
  CHECK(scene.image.height == 200);
  CHECK(scene.image.samplesPerPixel == 16);
  CHECK(scene.image.exposure == -1.5);
  CHECK(scene.image.background == glm::dvec3(0, 0.5, 2));
  CHECK(scene.shading.method == ShadingMethod::PixelMesh);
  CHECK(scene.shading.terms == 6144);
  CHECK(scene.shading.levels == 1);
  CHECK(scene.shading.order == 6);
  CHECK(scene.shading.per == ShadedPer::pixel);
  CHECK(scene.shading.visibility == VisibilityKind::table);
  CHECK(scene.shading.engine == EngineChoice::Reference);
}

TEST_CASE("fields that are absent have the documented defaults") {
  const SceneDescription scene = parseScene(R"({"objects": [{"mesh": "a/knot.obj"}]})", "x.json");
  const ObjectDescription& object = scene.objects.at(0);
  CHECK(object.name == "knot");
  CHECK(object.mesh == "a/knot.obj");
  CHECK_FALSE(object.transform.fit);
  CHECK(object.transform.scale == glm::dvec3(1));
  CHECK(object.transform.rotateDegrees == glm::dvec3(0));
  CHECK(object.transform.rest == Rest::None);
  CHECK(object.transform.translate == glm::dvec3(0));
  CHECK(object.albedo == glm::dvec3(0.5));
  CHECK(std::get<int>(object.spheres) == 64);
  CHECK(object.castsShadow);
  CHECK_FALSE(object.transfer);
  CHECK_FALSE(scene.receiver);
  CHECK(scene.light.source == "builtin:lamps");
  CHECK(scene.light.layout == "auto");
  CHECK(scene.light.rotateDegrees == 0);
  CHECK(scene.light.scale == 1);
  CHECK(scene.light.samples.empty());
  CHECK(scene.camera.position == glm::dvec3(0, 4, 8));
  CHECK(scene.camera.target == glm::dvec3(0, 0.5, 0));
  CHECK(scene.camera.up == glm::dvec3(0, 1, 0));
  CHECK(scene.camera.verticalFieldOfViewDegrees == 40);
  CHECK(scene.image.width == 960);
  CHECK(scene.image.height == 540);
  CHECK(scene.image.samplesPerPixel == 4);
  CHECK_FALSE(scene.image.exposure);
  CHECK_FALSE(scene.image.background);
  CHECK(scene.shading.method == ShadingMethod::Haar);
  CHECK(scene.shading.terms == 200);
  CHECK(scene.shading.levels == 2);
  CHECK_FALSE(scene.shading.order);
  CHECK(scene.shading.per == ShadedPer::vertex);
  CHECK(scene.shading.visibility == VisibilityKind::exact);
  CHECK(scene.shading.engine == EngineChoice::Auto);
}

TEST_CASE("a receiver that says nothing has the documented defaults") {
  const SceneDescription scene = parseScene(smallScene, "x.json");
  REQUIRE(scene.receiver);
  CHECK(scene.receiver->center == glm::dvec3(0));
  CHECK(scene.receiver->size == glm::dvec2(8));
  CHECK(scene.receiver->samples == glm::ivec2(128));
  CHECK(scene.receiver->albedo == glm::dvec3(0.5));
}

TEST_CASE("a sky is read, written and read again") {
  const SceneDescription scene = parseScene(R"({"receiver": {}, "light": {
      "source": "builtin:cie-clear",
      "sky": {"sunAzimuthDegrees": -120, "sunElevationDegrees": 7.5, "zenithRadiance": 3,
              "sunDisc": 0.5, "groundAlbedo": [0.1, 0.2, 0.3]},
      "motion": {"keys": [{"seconds": 1, "sunAzimuthDegrees": 720}]}}})",
                                            "x.json");
  const SkySettings expected{-120, 7.5, 3.0, 0.5, {0.1, 0.2, 0.3}};
  CHECK(scene.light.source == "builtin:cie-clear");
  CHECK(scene.light.sky == expected);
  CHECK(scene.light.motion->keys[0].sunAzimuthDegrees == 720);
  CHECK_FALSE(scene.light.motion->keys[0].sunElevationDegrees);
  const SceneDescription again = parseScene(sceneToJson(scene), "x.json");
  CHECK(again.light.sky == expected);
  CHECK(sceneToJson(again) == sceneToJson(scene));
  CHECK_FALSE(parseScene(R"({"receiver": {}})", "x.json").light.sky);
}

TEST_CASE("a scene that is written and read again is the same") {
  const std::string once = sceneToJson(parseScene(fullScene, "full.json"));
  CHECK(sceneToJson(parseScene(once, "again.json")) == once);
}

TEST_CASE("relative paths start at the scene file's folder") {
  const auto meshIn = [](const char* mesh, const char* fileName) {
    const std::string text = std::string(R"({"objects": [{"mesh": ")") + mesh + "\"}]}";
    return parseScene(text, fileName).objects.at(0).mesh;
  };
  CHECK(meshIn("../meshes/a.obj", "/data/scenes/x.json") == "/data/meshes/a.obj");
  CHECK(meshIn("a.obj", "x.json") == "a.obj");
  CHECK(meshIn("./a.obj", "scenes/x.json") == "scenes/a.obj");
  CHECK(meshIn("/meshes/a.obj", "scenes/x.json") == "/meshes/a.obj");
  CHECK(meshIn("Häschen.obj", "s/x.json") == "s/Häschen.obj");
}

TEST_CASE("a scene file is read from disk") {
  const TemporaryFolder folder;
  writeFile(folder / "full.json", fullScene);
  const SceneDescription scene = readScene(folder / "full.json");
  CHECK(scene.objects.at(0).mesh == folder / "meshes/bunny.obj");
}

TEST_CASE("byte order mark, carriage returns and white space around the scene are accepted") {
  const std::string expected = sceneToJson(parseScene(smallScene, "x.json"));
  for (const char* text : {"\xEF\xBB\xBF{\"receiver\": {}}", "{\r\n\"receiver\":\r\n{}\r\n}\r\n",
                           " \t\n{\"receiver\" : { } }\n\n "})
    CHECK(sceneToJson(parseScene(text, "x.json")) == expected);
}

TEST_CASE("whole numbers may be written with a fraction or an exponent") {
  const SceneDescription scene =
      parseScene(R"({"receiver": {}, "image": {"width": 64.0, "height": 1e2}})", "x.json");
  CHECK(scene.image.width == 64);
  CHECK(scene.image.height == 100);
}

TEST_CASE("the scenes in assets are the built-in ones") {
  const std::filesystem::path assets = std::filesystem::path(HAARLIGHT_SOURCE_FOLDER) / "assets";
  for (const std::string name : {"default", "smooth", "twist", "lamp-knot", "cone-and-sphere"}) {
    CHECK(readFile(assets / (name + ".json")) == builtinSceneText("builtin:" + name));
    CHECK(sceneToJson(readScene(assets / (name + ".json"))) ==
          sceneToJson(readScene("builtin:" + name)));
  }
  CHECK(readScene("builtin:default").light.source == "builtin:lamps");
  CHECK(readScene("builtin:smooth").light.source == "builtin:sky");
}

TEST_CASE("the smooth scene is the default scene under another light") {
  SceneDescription scene = readScene("builtin:default");
  scene.light.source = "builtin:sky";
  CHECK(sceneToJson(scene) == sceneToJson(readScene("builtin:smooth")));
}

TEST_CASE("the examples in docs/scene.md are scenes, the first is the default one") {
  const std::vector<std::string> examples = examplesIn("scene.md");
  REQUIRE(examples.size() == 3);
  CHECK(examples[0] ==
        readFile(std::filesystem::path(HAARLIGHT_SOURCE_FOLDER) / "assets/default.json"));
  CHECK(parseScene(examples[1], "x.json").objects.size() == 2);
  CHECK(parseScene(examples[2], "x.json").objects.size() == 2);
}

TEST_CASE("the example in docs/skies.md is a scene under a sky") {
  const std::vector<std::string> examples = examplesIn("skies.md");
  REQUIRE(examples.size() == 1);
  const SceneDescription scene = parseScene(examples[0], "x.json");
  CHECK(scene.light.source == "builtin:iso-sky-12");
  CHECK(scene.light.motion->keys.size() == 3);
}
