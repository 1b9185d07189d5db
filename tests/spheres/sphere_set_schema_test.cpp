#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/json_schema.h"
#include "spheres/sphere_set.h"
#include "test_support.h"

using namespace haarlight;
using haarlight::test::JsonSchema;
using haarlight::test::placesOf;
using haarlight::test::TemporaryFolder;

namespace {

using Json = nlohmann::json;
using Place = Json::json_pointer;

Json schemaText() {
  return Json::parse(
      test::readFile(std::filesystem::path(HAARLIGHT_SOURCE_FOLDER) / "docs/spheres.schema.json"));
}

/// A written file. `whole`: with every measure, else with none that can be absent.
Json writtenFile(bool whole) {
  const TemporaryFolder folder;
  SphereSet set;
  set.spheres = {{{1, -2, 0.5f}, 3}};
  if (whole) set.measures = {0.9, 0.5, 0.4, 0.01, SilhouetteError{0.1, 0.2, 0.07, 0.03}};
  writeSphereSet(folder / "set.json", set);
  return Json::parse(test::readFile(folder / "set.json"));
}

bool readerAllows(const Json& document) {
  const TemporaryFolder folder;
  test::writeFile(folder / "set.json", document.dump());
  try {
    readSphereSet(folder / "set.json");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::set<std::string> namesIn(const Json& object) {
  std::set<std::string> names;
  for (const auto& [name, value] : object.items()) names.insert(name);
  return names;
}

/// The schema's part for a place, below "anyOf" that of the object.
Json partFor(const Place& place) {
  const Json root = schemaText();
  if (place.to_string() == "/measures/silhouette") return root["$defs"]["silhouette"];
  return JsonSchema(root).at(place);
}

}  // namespace

TEST_CASE("written sphere sets satisfy the schema") {
  const JsonSchema schema(schemaText());
  CHECK(schema.allows(writtenFile(true)));
  CHECK(schema.allows(writtenFile(false)));
}

TEST_CASE("schema and sphere set have the same fields, all of them required") {
  const Json document = writtenFile(true);
  for (const Place& place : placesOf(document)) {
    if (!document[place].is_object()) continue;
    CAPTURE(place.to_string());
    const Json part = partFor(place);
    const Json& required = part.at("required");
    CHECK(namesIn(document[place]) == namesIn(part.at("properties")));
    CHECK(namesIn(document[place]) == std::set<std::string>(required.begin(), required.end()));
    for (const auto& [name, property] : part.at("properties").items())
      CHECK(property.contains("description"));
  }
}

TEST_CASE("schema and reader of sphere sets agree on every type, limit and choice") {
  const JsonSchema schema(schemaText());
  const std::vector<Json> probes{nullptr,
                                 true,
                                 -1,
                                 -1e-9,
                                 0,
                                 1e-9,
                                 0.5,
                                 1,
                                 1.5,
                                 "",
                                 "cover",
                                 "shadow",
                                 Json::array(),
                                 Json{1, 2, 3},
                                 3,
                                 "x",
                                 {1, 2},
                                 {true},
                                 {{"x", 1}},
                                 "00000000000000fF",
                                 "00000000000000fg",
                                 "000",
                                 2,
                                 Json{1, 2, 3, 4},
                                 Json::object()};
  const Json document = writtenFile(true);
  int allowed = 0, refused = 0;
  for (const Place& place : placesOf(document))
    for (const Json& probe : probes) {
      if (place.to_string() == "/version" && probe == 1) continue;  // read, but not written
      Json changed = document;
      changed[place] = probe;
      CAPTURE(place.to_string());
      CAPTURE(probe.dump());
      const bool expected = schema.allows(changed);
      CHECK(readerAllows(changed) == expected);
      ++(expected ? allowed : refused);
    }
  CHECK(allowed > 50);
  CHECK(refused > 200);
}

TEST_CASE("schema and reader of sphere sets agree on missing and further fields") {
  const JsonSchema schema(schemaText());
  const Json document = writtenFile(true);
  for (const Place& place : placesOf(document)) {
    if (!document[place].is_object()) continue;
    CAPTURE(place.to_string());
    Json further = document;
    further[place]["unknown"] = 1;
    CHECK(readerAllows(further));
    CHECK(schema.allows(further));
    for (const std::string& name : namesIn(document[place])) {
      Json missing = document;
      missing[place].erase(name);
      CAPTURE(name);
      CHECK_FALSE(readerAllows(missing));
      CHECK_FALSE(schema.allows(missing));
    }
  }
}
