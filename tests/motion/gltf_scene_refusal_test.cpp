#include <limits>

#include "gltf_refusals.h"

using namespace haarlight;
using namespace haarlight::test;
using Json = nlohmann::json;

namespace {

const float notANumber = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_CASE("a glTF hierarchy that is no forest is refused") {
  checkFaults(triangleGltf,
              {{"node 0: it is the child of two nodes",
                [](GltfBuilder& b, Json&) {
                  b.addNode({{"children", Json::array({0})}});
                  b.addNode({{"children", Json::array({0})}});
                }},
               {"their own ancestors",
                [](GltfBuilder& b, Json& d) {
                  d["nodes"][0]["children"] = Json::array({1});
                  b.addNode({{"children", Json::array({0})}});
                }},
               {"their own ancestors",
                [](auto&, Json& d) { d["nodes"][0]["children"] = Json::array({0}); }},
               {"node 0: there is no node 7",
                [](auto&, Json& d) { d["nodes"][0]["children"] = Json::array({7}); }},
               {"scene 0: there is no node 7",
                [](auto&, Json& d) { d["scenes"][0]["nodes"] = Json::array({7}); }},
               {"there is no scene 2", [](auto&, Json& d) { d["scene"] = 2; }},
               {"there is no mesh 3", [](auto&, Json& d) { d["nodes"][0]["mesh"] = 3; }},
               {"there is no skin 0", [](auto&, Json& d) { d["nodes"][0]["skin"] = 0; }},
               {"rotation has 3 numbers instead of 4",
                [](auto&, Json& d) {
                  d["nodes"][0]["rotation"] = {0, 0, 1};
                }},
               {"weights has 1 number instead of 0",
                [](auto&, Json& d) { d["nodes"][0]["weights"] = {1}; }}});
}

TEST_CASE("a glTF skin that does not fit is refused") {
  const auto weights = [](float first, float second) {
    return [=](GltfBuilder& b, Json& d) {
      std::vector<float> all(48, 0.25f);
      all[20] = first;
      all[21] = second;
      all[22] = all[23] = 0;
      primitive(d)["attributes"]["WEIGHTS_0"] = b.add("VEC4", all);
    };
  };
  checkFaults(skinnedBar, {{"vertex 5 has skin weights of the sum 0", weights(0, 0)},
                           {"vertex 5 has a negative skin weight", weights(-1, 2)},
                           {"element 5 is not a finite number", weights(1, notANumber)},
                           {"follows joint 1 of a skin of 1 joint",
                            [](auto&, Json& d) { d["skins"][0]["joints"] = Json::array({0}); }},
                           {"skin 0: there is no node 9",
                            [](auto&, Json& d) {
                              d["skins"][0]["joints"] = {0, 9};
                            }},
                           {"more joints than inverse bind matrices",
                            [](auto&, Json& d) {
                              d["skins"][0]["joints"] = {0, 1, 2};
                            }},
                           {"skin 0: accessor 0: element 1 is not a finite number",
                            [](GltfBuilder& b, Json&) {
                              for (int i = 0; i < 4; ++i) b.bytes[64 + i] = char(0xFF);
                            }},
                           {"other sets of JOINTS than of WEIGHTS",
                            [](auto&, Json& d) { primitive(d)["attributes"].erase("WEIGHTS_0"); }},
                           {"it has no JOINTS_0",
                            [](auto&, Json& d) {
                              primitive(d)["attributes"].erase("WEIGHTS_0");
                              primitive(d)["attributes"].erase("JOINTS_0");
                            }},
                           {"has 11 elements instead of 12",
                            [](auto&, Json& d) { accessor(d, "JOINTS_0")["count"] = 11; }}});
}

TEST_CASE("a glTF animation that does not fit is refused") {
  const auto keys = [](const std::vector<float>& seconds) {
    return [=](GltfBuilder& b, Json& d) { sampler(d)["input"] = b.add("SCALAR", seconds); };
  };
  checkFaults(
      skinnedBar,
      {{"the times of keys 0 and 1 do not increase", keys({1, 1})},
       {"the times of keys 0 and 1 do not increase", keys({1, 0.5f})},
       {"element 1 is not a finite number", keys({0, notANumber})},
       {"its first key lies before second 0", keys({-1, 1})},
       {"has 2 elements instead of 3", keys({0, 1, 2})},
       {"it has no keys",
        [](auto&, Json& d) { d["accessors"][sampler(d)["input"].get<int>()]["count"] = 0; }},
       {"has 2 elements instead of 6",
        [](auto&, Json& d) { sampler(d)["interpolation"] = "CUBICSPLINE"; }},
       {"unknown interpolation, SMOOTH",
        [](auto&, Json& d) { sampler(d)["interpolation"] = "SMOOTH"; }},
       {"elements of another type",
        [](auto&, Json& d) { d["animations"][0]["channels"][0]["target"]["path"] = "scale"; }},
       {"channel 0: there is no node 8",
        [](auto&, Json& d) { d["animations"][0]["channels"][0]["target"]["node"] = 8; }},
       {"channel 0: there is no sampler 1",
        [](auto&, Json& d) { d["animations"][0]["channels"][0]["sampler"] = 1; }},
       {"it moves node 1, which has a matrix", [](auto&, Json& d) {
          d["nodes"][1] = {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
        }}});
}

TEST_CASE("glTF sparse accessors and morph targets that do not fit are refused") {
  const auto sparse = [](const char* part, const char* field, const Json& value) {
    return [=](auto&, Json& d) {
      Json& entry = d["accessors"][primitive(d)["targets"][0]["POSITION"].get<int>()]["sparse"];
      (*part ? entry[part] : entry)[field] = value;
    };
  };
  checkFaults(everyFeature,
              {{"replaces more elements than it has", sparse("", "count", 13)},
               {"ends at byte 6 of buffer view", sparse("", "count", 3)},
               {"sparse indices of a wrong type", sparse("indices", "componentType", 5126)},
               {"there is no buffer view 99", sparse("values", "bufferView", 99)},
               {"replaces element 458753 of 12",
                [=](GltfBuilder& b, Json& d) {
                  sparse("indices", "componentType", 5125)(b, d);
                  sparse("", "count", 1)(b, d);
                }},
               {"different numbers of morph targets",
                [](auto&, Json& d) {
                  Json other = primitive(d);
                  other.erase("targets");
                  d["meshes"][0]["primitives"].push_back(other);
                }},
               {"weights has 2 numbers instead of 1", [](auto&, Json& d) {
                  d["meshes"][0]["weights"] = {0, 1};
                }}});
}

TEST_CASE("glTF positions that are no place are refused, also in the middle of a motion") {
  const auto triangle = [](float x) {
    GltfBuilder builder = triangleGltf();
    primitive(builder.document)["attributes"]["POSITION"] =
        builder.add<float>("VEC3", {0, 0, 0, x, 0, 0, 0, 1, 0});
    return refusal(builder.gltf());
  };
  CHECK(triangle(notANumber).find("element 1 is not a finite number") != std::string::npos);
  CHECK(triangle(2e9f).find("node 0: at second 0.000 vertex 1") != std::string::npos);
  GltfBuilder builder = triangleGltf();
  builder.addChannel("burst", 0, "scale", builder.add<float>("SCALAR", {0, 1}),
                     builder.add<float>("VEC3", {1, 1, 1, 1e10f, 1, 1}));
  const AnimatedMesh burst = load(builder);
  CHECK(burst.motion->positions(0.05)[1].x == doctest::Approx(5e8));
  CHECK_THROWS_WITH_AS(burst.motion->positions(0.5), doctest::Contains("at second 0.500 vertex 1"),
                       InputError);
}
