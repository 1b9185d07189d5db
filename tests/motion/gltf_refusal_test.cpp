#include "gltf_refusals.h"

using namespace haarlight;
using namespace haarlight::test;
using Json = nlohmann::json;

TEST_CASE("a glTF file whose sizes do not fit is refused") {
  checkFaults(
      triangleGltf,
      {{"ends at byte 48 of buffer view 0, which has 36",
        [](auto&, Json& d) { d["accessors"][0]["count"] = 4; }},
       {"ends at byte 40", [](auto&, Json& d) { d["accessors"][0]["byteOffset"] = 4; }},
       {"more than the file has bytes",
        [](auto&, Json& d) { d["accessors"][0]["count"] = 2147483647; }},
       {"count is 4294967299, not a whole number",
        [](auto&, Json& d) { d["accessors"][0]["count"] = 4294967299; }},
       {"byteOffset is -4", [](auto&, Json& d) { d["accessors"][0]["byteOffset"] = -4; }},
       {"byteOffset is 0.5", [](auto&, Json& d) { d["accessors"][0]["byteOffset"] = 0.5; }},
       {"buffer view 0 ends at byte 37 of a buffer of 36",
        [](auto&, Json& d) { d["bufferViews"][0]["byteLength"] = 37; }},
       {"byteOffset is 18446744073709551615",
        [](auto&, Json& d) { d["bufferViews"][0]["byteOffset"] = 18446744073709551615u; }},
       {"stride shorter than an element",
        [](auto&, Json& d) { d["bufferViews"][0]["byteStride"] = 8; }},
       {"byteStride", [](auto&, Json& d) { d["bufferViews"][0]["byteStride"] = 13; }},
       {"there is no buffer 1", [](auto&, Json& d) { d["bufferViews"][0]["buffer"] = 1; }},
       {"there is no buffer view 5", [](auto&, Json& d) { d["accessors"][0]["bufferView"] = 5; }},
       {"there is no accessor 9, the file has 1 accessor",
        [](auto&, Json& d) { primitive(d)["attributes"]["POSITION"] = 9; }},
       {"attributes is \"0\"",
        [](auto&, Json& d) { primitive(d)["attributes"]["POSITION"] = "0"; }},
       {"elements of another type", [](auto&, Json& d) { d["accessors"][0]["type"] = "VEC2"; }},
       {"component type that glTF 2.0 does not know",
        [](auto&, Json& d) { d["accessors"][0]["componentType"] = 5130; }},
       {"componentType", [](auto&, Json& d) { d["accessors"][0]["componentType"] = 1; }},
       {"index 2 is vertex 3 of 3",
        [](GltfBuilder& b, Json& d) {
          primitive(d)["indices"] = b.add<std::uint16_t>("SCALAR", {0, 1, 3});
        }},
       {"does not have whole numbers",
        [](GltfBuilder& b, Json& d) {
          primitive(d)["indices"] = b.add<float>("SCALAR", {0, 1, 2});
        }},
       {"4 corners, not a multiple of 3",
        [](GltfBuilder& b, Json& d) {
          primitive(d)["indices"] = b.add<std::uint8_t>("SCALAR", {0, 1, 2, 0});
        }},
       {"NORMAL: accessor 1: has 2 elements instead of 3", [](GltfBuilder& b, Json& d) {
          primitive(d)["attributes"]["NORMAL"] = b.add<float>("VEC3", {0, 0, 1, 0, 0, 1});
        }}});
}

TEST_CASE("a glTF buffer that is not what it says is refused") {
  const auto buffer = [](const Json& fields) {
    return [fields](auto&, Json& document) { document["buffers"] = Json::array({fields}); };
  };
  const std::string zeros = "data:;base64," + std::string(48, 'A');
  CHECK(refusal([&] {
          GltfBuilder builder = triangleGltf();
          builder.document["buffers"] = Json::array({Json{{"uri", zeros}, {"byteLength", 36}}});
          return builder.gltf();
        }())
            .find("no triangle with an area") != std::string::npos);
  checkFaults(triangleGltf,
              {{"says it has 37 bytes, there are 36", buffer({{"uri", zeros}, {"byteLength", 37}})},
               {"there are 6", buffer({{"uri", "data:;base64,AAAAAAAA!AAA"}, {"byteLength", 36}})},
               {"but not as base64", buffer({{"uri", "data:,zero"}, {"byteLength", 36}})},
               {"has no byteLength", buffer({{"uri", zeros}})},
               {"which only buffer 0 of a .glb",
                [&](auto&, Json& d) {
                  d["buffers"] = Json::array(
                      {Json{{"uri", zeros}, {"byteLength", 1}}, Json{{"byteLength", 1}}});
                }},
               {"there are 0", buffer({{"byteLength", 36}})},
               {"no relative path", buffer({{"uri", "/etc/passwd"}, {"byteLength", 36}})},
               {"no relative path", buffer({{"uri", "http://host/a.bin"}, {"byteLength", 36}})},
               {"no relative path", buffer({{"uri", "a%00.bin"}, {"byteLength", 36}})},
               {"no relative path", buffer({{"uri", ""}, {"byteLength", 36}})},
               {"which is no plain file", buffer({{"uri", "."}, {"byteLength", 36}})}});
  CHECK_THROWS_WITH_AS(loadGltfText(triangleGltf().json("missing.bin")),
                       doctest::Contains("missing.bin: No such file"), InputError);
}

TEST_CASE("a glTF file of another kind is refused by name") {
  checkFaults(
      triangleGltf,
      {{"requires the extension KHR_draco_mesh_compression",
        [](auto&, Json& d) { d["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }},
       {"requires the extension EXT_meshopt_compression",
        [](auto&, Json& d) { d["extensionsRequired"] = {"EXT_meshopt_compression"}; }},
       {"it is glTF version 1.0", [](auto&, Json& d) { d["asset"]["version"] = "1.0"; }},
       {"asset.version is missing", [](auto&, Json& d) { d["asset"] = Json::array({1}); }},
       {"nodes is no array", [](auto&, Json& d) { d["nodes"] = Json::object(); }},
       {"`meshes'", [](auto&, Json& d) { d["meshes"] = Json::array({5}); }},
       {"'attributes'", [](auto&, Json& d) { d["meshes"][0]["primitives"] = Json::array({5}); }},
       {"it has no POSITION", [](auto&, Json& d) { primitive(d)["attributes"].erase("POSITION"); }},
       {"its mode 7 does not exist", [](auto&, Json& d) { primitive(d)["mode"] = 7; }},
       {"there is no triangle", [](auto&, Json& d) { primitive(d)["mode"] = 1; }},
       {"there is no triangle", [](auto&, Json& d) { d["scenes"][0]["nodes"] = Json::array(); }},
       {"nested more than", [](auto&, Json& d) {
          Json deep = 1;
          for (int i = 0; i < 100; ++i) deep = Json::array({deep});
          d["extras"] = deep;
        }}});
  CHECK(refusal("").find("it is empty") != std::string::npos);
  CHECK(refusal("{").find("line 1, column 2") != std::string::npos);
  CHECK(refusal("[1]").find("no object") != std::string::npos);
}

TEST_CASE("a GLB whose chunks do not fit is refused") {
  const std::string whole = triangleGltf().glb();
  const auto changed = [&](std::size_t at, char byte) {
    std::string glb = whole;
    glb[at] = byte;
    return refusal(glb);
  };
  CHECK(changed(4, 1).find("GLB version 1") != std::string::npos);
  CHECK(changed(10, 1).find("the GLB header says") != std::string::npos);
  CHECK(changed(15, 1).find("GLB chunk 0 says it has") != std::string::npos);
  CHECK(changed(16, 'X').find("GLB chunk 0 is not JSON") != std::string::npos);
  CHECK(refusal("glTF").find("header is cut off") != std::string::npos);
  CHECK(refusal(glbOf(triangleGltf().json(""), "")).find("there are 0") != std::string::npos);
}

TEST_CASE("a small glTF file cannot ask for any amount of memory") {
  const auto bomb = [](std::size_t vertices, std::size_t targets, int nodes) {
    GltfBuilder builder;
    const int positions = builder.add("VEC3", std::vector<float>(3 * vertices, 0.0f));
    Json primitive{{"attributes", {{"POSITION", positions}}}};
    for (std::size_t i = 0; i < targets; ++i)
      primitive["targets"].push_back({{"POSITION", positions}});
    for (int i = 0; i < nodes; ++i) builder.addMeshNode(primitive);
    return refusal(builder.gltf());
  };
  CHECK(bomb(30000, 5000, 1).find("more than 268,435,456") != std::string::npos);
  CHECK(bomb(300000, 0, 1000).find("more than 268,435,456") != std::string::npos);
  GltfBuilder keys = triangleGltf();
  keys.addChannel("long", 0, "scale", keys.add("SCALAR", std::vector<float>(60000, 0.0f)),
                  keys.add("VEC3", std::vector<float>(180000, 0.0f)));
  Json& channels = keys.document["animations"][0]["channels"];
  for (int i = 0; i < 5000; ++i) channels.push_back(Json(channels[0]));
  CHECK(refusal(keys.gltf()).find("more than 268,435,456") != std::string::npos);
}
