#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "json_schema.h"
#include "scene/names.h"
#include "scene/scene_file.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

using Json = nlohmann::json;
using Place = Json::json_pointer;

ObjectDescription movingObject() {
  ObjectDescription object;
  object.name = "a";
  object.mesh = "a.obj";
  object.family = "letters";
  object.transform.scale = {1, 2, 3};
  object.transfer = "a.prt";
  object.deformation.emplace().pointCache = "a.pc2";
  object.deformation->framesPerSecond = 25;
  object.deformation->twist.emplace().keys.resize(1);
  object.deformation->bend.emplace().keys.resize(1);
  object.deformation->bend->towards = Axis::z;
  object.motion.emplace().keys.resize(1);
  return object;
}

/// One of each shape, with measures of which any one may be another.
std::vector<ObjectDescription> solidObjects() {
  std::vector<ObjectDescription> objects;
  for (const Shape& shape :
       {Shape(SphereShape{}), Shape(EllipsoidShape{}), Shape(BoxShape{}), Shape(CylinderShape{}),
        Shape(ConeShape{}), Shape(TorusShape{1e6, 1e-6})}) {
    ObjectDescription& object = objects.emplace_back();
    object.name = "b";
    object.solid = shape;
  }
  objects.front().motion.emplace().keys.resize(1);
  return objects;
}

/// Every field of solids and of lights with hard shadows.
Json documentOfSolids() {
  SceneDescription scene;
  scene.objects = solidObjects();
  PointLightDescription& point = scene.pointLights.emplace_back();
  point.motion = {{{0, glm::dvec3(1, 2, 3), Ease::linear}}, {}};
  DirectionalLightDescription& directional = scene.directionalLights.emplace_back();
  directional.towards = {1, 2, 3};
  directional.motion = {{{0, glm::dvec3(1, 2, 3), Ease::linear}}, {}};
  Json document{{"receiver", Json::object()}};
  for (const char* name : {"objects", "pointLights", "directionalLights"})
    document[name] = Json::parse(sceneToJson(scene))[name];
  return document;
}

/// Every field of meshes and of what surrounds them; the camera stays valid when one value changes.
/// The sources of a deformation, which exclude each other, are spread over three objects.
Json documentOfMeshes() {
  SceneDescription scene;
  scene.objects.push_back(movingObject());
  scene.receiver.emplace();
  scene.light.motion.emplace().keys.resize(1);
  scene.light.motion->keys[0].source = "sky.hdr";
  scene.light.motion->keys[0].sunAzimuthDegrees = 400;
  scene.light.motion->keys[0].sunElevationDegrees = 30;
  scene.light.sky.emplace().zenithRadiance = 2;
  scene.light.samples.emplace_back().source = "near.hdr";
  scene.shading.order = 4;
  scene.camera.position = {3, 2, 7};
  scene.camera.target = {-1, 0.5, 0.25};
  scene.camera.up = {0.2, 1, -0.1};
  scene.camera.motion = {{{0, glm::dvec3(4, 2, 6), glm::dvec3(-1, 0.75, 0.25), Ease::linear}}, {}};
  scene.animation.lastFrame = 1000000;
  Json document = Json::parse(sceneToJson(scene));
  document["objects"].push_back({{"mesh", "b.obj"}, {"deformation", {{"sequence", "b_%04d.obj"}}}});
  document["objects"].push_back({{"mesh", "c.glb"}, {"deformation", {{"animation", "run"}}}});
  return document;
}

/// Together they have every field that the parser knows.
std::vector<Json> documents() {
  return {documentOfMeshes(), documentOfSolids()};
}

/// The place with the first element of every array instead of another.
Place withFirstElements(const Place& place) {
  return Place(std::regex_replace(place.to_string(), std::regex("/[0-9]+"), "/0"));
}

/// The same without the numbers in arrays, which have no description or default of their own.
std::vector<Place> fieldsOf(const Json& document) {
  std::vector<Place> places = placesOf(document);
  std::erase_if(places, [&](const Place& place) {
    return !place.empty() && document[place.parent_pointer()].is_array() &&
           document[place].is_number();
  });
  return places;
}

/// Every limit and choice a schema names, with the values just inside and just outside.
void collectProbes(const Json& schema, std::vector<Json>& probes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (schema.is_structured())
    for (const Json& part : schema) collectProbes(part, probes);
  if (!schema.is_object()) return;
  for (const char* keyword : {"minimum", "maximum"})
    if (schema.contains(keyword) && schema[keyword].is_number()) {
      const double limit = schema[keyword];
      for (const double number :
           {limit, limit - 1, limit + 1, limit + 0.5, std::nextafter(limit, -infinity),
            std::nextafter(limit, infinity)})
        probes.push_back(number);
    }
  if (schema.contains("const")) probes.push_back(schema["const"]);
  if (schema.contains("enum") && schema["enum"].is_array())
    probes.insert(probes.end(), schema["enum"].begin(), schema["enum"].end());
}

/// Values of every type, and texts and arrays at the limits of their sizes.
std::vector<Json> typeProbes() {
  std::vector<Json> probes{nullptr,
                           true,
                           1,
                           2.5,
                           "",
                           "x",
                           "häschen.obj",
                           "builtin:",
                           "builtin:nothing",
                           std::string("a\0b", 3),
                           "tab\t",
                           "\x7F",
                           "a%d.obj",
                           "a_%04d.obj",
                           "10%/a%d.obj",
                           "a%0d.obj",
                           "a%d%d.obj",
                           "%d/a.obj",
                           "builtin:%d",
                           "tab\t%d",
                           "a.GLB",
                           std::string(1024, 'x'),
                           std::string(1025, 'x'),
                           Json::object(),
                           Json{{"x", 1}},
                           Json{{"mesh", "builtin:sphere"}},
                           Json{{"solid", {{"cone", {{"height", 2}}}}}},
                           Json{{"sphere", {{"radius", 2}}}},
                           Json{{"sphere", Json::object()}, {"box", Json::object()}},
                           Json{{"fit", 2}, {"scale", {1, 2, 3}}},
                           Json{{"fit", "none"}, {"scale", 2}},
                           Json{{"seconds", 1}},
                           Json{{"keys", Json::array({{{"seconds", 1}}})}},
                           Json{{"pointCache", "a.mdd"}},
                           Json{{"axis", "z"}, {"keys", Json::array({{{"seconds", 1}}})}},
                           Json::array({{{"seconds", 0}}, {{"seconds", 0.5}}}),
                           std::vector<double>(4, 0.0),
                           Json::array(),
                           Json{"a", "b", "c"},
                           Json{1, true},
                           std::vector<Json>(1024, Json{{"mesh", "a"}}),
                           std::vector<Json>(1025, Json{{"mesh", "a"}})};
  std::string umlauts;
  for (int i = 0; i < 1024; ++i) umlauts += "ä";
  probes.push_back(umlauts);
  for (const double component : {1.0, 0.5})
    for (const std::size_t size : {1, 2, 3, 4})
      probes.push_back(std::vector<double>(size, component));
  return probes;
}

bool parserAllows(const Json& document) {
  try {
    parseScene(document.dump(), "scene.json");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::string normalForm(const Json& document) {
  return sceneToJson(parseScene(document.dump(), "scene.json"));
}

std::set<std::string> namesIn(const Json& object) {
  std::set<std::string> names;
  for (const auto& [name, value] : object.items()) names.insert(name);
  return names;
}

Json without(Json document, const Place& place) {
  Json& parent = document[place.parent_pointer()];
  if (parent.is_array())
    parent.erase(std::stoul(place.back()));
  else
    parent.erase(place.back());
  return document;
}

Json with(Json document, const Place& place, const Json& value) {
  document[place] = value;
  return document;
}

JsonSchema schema() {
  return JsonSchema(Json::parse(sceneSchema()));
}

bool isRequired(const Place& place) {
  const Json required = schema().at(place.parent_pointer()).value("required", Json::array());
  return std::count(required.begin(), required.end(), place.back()) > 0;
}

}  // namespace

TEST_CASE("the schema in docs is the built-in one") {
  const auto path = std::filesystem::path(HAARLIGHT_SOURCE_FOLDER) / "docs/scene.schema.json";
  CHECK(readFile(path) == sceneSchema());
}

TEST_CASE("the built-in scenes satisfy the schema") {
  for (const std::string_view name : builtinScenes)
    CHECK(schema().allows(Json::parse(builtinSceneText(std::string(name)))));
}

TEST_CASE("schema and parser know the same fields, and each has a description") {
  std::map<std::string, std::set<std::string>> known;
  for (const Json& document : documents())
    for (const Place& place : fieldsOf(document)) {
      CAPTURE(place.to_string());
      CHECK(schema().at(place).contains("description"));
      if (document[place].is_object())
        known[withFirstElements(place).to_string()].merge(namesIn(document[place]));
    }
  for (const auto& [place, names] : known) {
    CAPTURE(place);
    std::set<std::string> expected = namesIn(schema().at(Place(place)).at("properties"));
    expected.erase("$schema");
    CHECK(names == expected);
  }
}

TEST_CASE("defaults in the schema are the parser's") {
  for (const Json& document : documents())
    for (const Place& place : fieldsOf(document)) {
      CAPTURE(place.to_string());
      const Json subschema = schema().at(place);
      if (!subschema.contains("default")) {
        CHECK((document[place].is_object() || isRequired(place) ||
               std::string(subschema["description"]).find("Default: ") != std::string::npos));
      } else {
        CHECK(normalForm(with(document, place, subschema["default"])) ==
              normalForm(without(document, place)));
      }
    }
}

TEST_CASE("schema and parser agree on every limit, choice and type at every place") {
  const JsonSchema sceneFileSchema = schema();
  std::vector<Json> probes = typeProbes();
  collectProbes(Json::parse(sceneSchema()), probes);
  std::ranges::sort(probes);
  probes.erase(std::unique(probes.begin(), probes.end()), probes.end());
  for (const Json& document : documents()) {
    int allowed = 0, refused = 0;
    for (const Place& place : placesOf(document))
      for (const Json& probe : probes) {
        const Json changed = with(document, place, probe);
        const bool expected = sceneFileSchema.allows(changed);
        if (parserAllows(changed) != expected) {
          CAPTURE(place.to_string());
          CAPTURE(probe.dump().substr(0, 80));
          CHECK(parserAllows(changed) == expected);
        }
        ++(expected ? allowed : refused);
      }
    CHECK(allowed > 500);
    CHECK(refused > 500);
  }
}

TEST_CASE("schema and parser agree on fields that are missing or unknown") {
  const JsonSchema sceneFileSchema = schema();
  for (const Json& document : documents())
    for (const Place& place : placesOf(document)) {
      CAPTURE(place.to_string());
      if (!place.empty()) {
        const Json changed = without(document, place);
        CHECK(parserAllows(changed) == sceneFileSchema.allows(changed));
      }
      if (document[place].is_object()) {
        const Json changed = with(document, place / "unknown", 1);
        CHECK_FALSE(parserAllows(changed));
        CHECK_FALSE(sceneFileSchema.allows(changed));
      }
    }
  for (const char* text :
       {"{}", R"({"objects": []})", R"({"receiver": {}})", R"({"objects": [], "receiver": {}})",
        R"({"$schema": "x"})", R"({"$schema": "x", "receiver": {}})"})
    CHECK(parserAllows(Json::parse(text)) == sceneFileSchema.allows(Json::parse(text)));
}
