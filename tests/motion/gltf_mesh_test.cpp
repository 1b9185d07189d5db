#include "motion/gltf_mesh.h"

#include <cmath>

#include "gltf_support.h"

using namespace haarlight;
using namespace haarlight::test;
using Json = nlohmann::json;

namespace {

const std::vector<glm::vec3> trianglePositions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/// Five points of the plane z = 0, as a primitive of that mode.
TriangleMesh fivePoints(int mode) {
  GltfBuilder builder;
  const int positions = builder.add<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
  builder.addMeshNode({{"attributes", {{"POSITION", positions}}}, {"mode", mode}});
  return load(builder).mesh.mesh;
}

}  // namespace

TEST_CASE("a glTF triangle is the same embedded, beside the file and in a GLB") {
  const GltfBuilder builder = triangleGltf();
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "parts");
  writeFile(folder / "parts" / "a b.bin", builder.bytes + "more");
  writeFile(folder / "external.gltf", builder.json("parts/a%20b.bin"));
  writeFile(folder / "embedded.gltf", builder.gltf());
  writeFile(folder / "binary.glb", builder.glb());
  for (const char* name : {"external.gltf", "embedded.gltf", "binary.glb"}) {
    CAPTURE(name);
    const AnimatedMesh loaded = loadGltf(folder / name, "");
    CHECK(loaded.mesh.mesh.positions == trianglePositions);
    CHECK(loaded.mesh.mesh.triangles == std::vector{glm::uvec3(0, 1, 2)});
    CHECK(loaded.mesh.mesh.normals == std::vector(3, glm::vec3(0, 0, 1)));
    CHECK(loaded.mesh.sourceVertices == std::vector<std::uint32_t>{0, 1, 2});
    CHECK_FALSE(loaded.motion);
  }
}

TEST_CASE("glTF strips turn every second triangle and fans share their first vertex") {
  CHECK(fivePoints(5).triangles ==
        std::vector{glm::uvec3(0, 1, 2), glm::uvec3(1, 3, 2), glm::uvec3(2, 3, 4)});
  // The fan's third triangle, 3 4 0, has an area too.
  CHECK(fivePoints(6).triangles ==
        std::vector{glm::uvec3(1, 2, 0), glm::uvec3(2, 3, 0), glm::uvec3(3, 4, 0)});
}

TEST_CASE("glTF points and lines are passed over with a warning") {
  GltfBuilder builder = triangleGltf();
  builder.addMeshNode({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
  builder.addMeshNode({{"attributes", {{"POSITION", 0}}}, {"mode", 3}});
  const LoadedMesh loaded = load(builder).mesh;
  CHECK(loaded.mesh.triangles.size() == 1);
  CHECK(loaded.warnings.front() == "2 primitives are points or lines: passed over");
}

TEST_CASE("glTF nodes place meshes one below the other") {
  GltfBuilder builder = triangleGltf();
  const double half = std::sqrt(0.5);
  // 90° about z, then 90° about x below it: x becomes y, y becomes −x; then in the parent.
  builder.document["nodes"][0]["rotation"] = {half, 0, 0, half};
  const int parent = builder.addNode({{"children", Json::array({0})},
                                      {"rotation", {0, 0, half, half}},
                                      {"translation", {10, 0, 0}},
                                      {"scale", {2, 2, 2}}});
  builder.document["scenes"][0]["nodes"] = Json::array({parent});
  const TriangleMesh mesh = load(builder).mesh.mesh;
  checkNear(mesh.positions[0], {10, 0, 0});
  checkNear(mesh.positions[1], {10, 2, 0});  // x → x → 2 y
  checkNear(mesh.positions[2], {10, 0, 2});  // y → z → 2 z
  builder.document["nodes"][parent] = {
      {"children", Json::array({0})},
      {"matrix", {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 10, 0, 0, 1}}};
  const TriangleMesh same = load(builder).mesh.mesh;
  for (int i = 0; i < 3; ++i) checkNear(same.positions[i], mesh.positions[i]);
}

TEST_CASE("a glTF mesh in a mirrored node keeps its outside outside") {
  GltfBuilder builder = triangleGltf();
  builder.document["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
      builder.add<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
  builder.document["nodes"][0]["scale"] = {-1, 1, 1};
  const TriangleMesh mesh = load(builder).mesh.mesh;
  CHECK(mesh.triangles == std::vector{glm::uvec3(0, 2, 1)});
  CHECK(mesh.normals[0] == glm::vec3(0, 0, 1));
}

TEST_CASE("glTF normals go by the inverse transpose of the node") {
  GltfBuilder builder = triangleGltf();
  const float part = std::sqrt(0.5f);
  builder.document["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
      builder.add<float>("VEC3", {part, part, 0, part, part, 0, part, part, 0});
  builder.document["nodes"][0]["scale"] = {2, 1, 1};
  // (1/2, 1), of length 1.
  checkNear(load(builder).mesh.mesh.normals[1], glm::normalize(glm::vec3(0.5f, 1, 0)));
}

TEST_CASE("a glTF accessor of zeros has the elements that it replaces") {
  GltfBuilder builder;
  builder.addView(std::string("\1\2", 2));
  const std::vector<float> values{1, 0, 0, 0, 1, 0};
  builder.addView(std::string(reinterpret_cast<const char*>(values.data()), 24));
  builder.document["accessors"] =
      Json::array({Json{{"type", "VEC3"},
                        {"componentType", 5126},
                        {"count", 3},
                        {"sparse",
                         {{"count", 2},
                          {"indices", {{"bufferView", 0}, {"componentType", 5121}}},
                          {"values", {{"bufferView", 1}}}}}}});
  builder.addMeshNode({{"attributes", {{"POSITION", 0}}}});
  CHECK(load(builder).mesh.mesh.positions == trianglePositions);
}

TEST_CASE("glTF attributes may lie among one another") {
  GltfBuilder builder;
  const std::vector<float> vertices{0, 0, 0, 0, 0, 1,  //
                                    1, 0, 0, 0, 1, 1,  //
                                    0, 1, 0, 0, 0, 1};
  const int view = builder.addView(std::string(reinterpret_cast<const char*>(vertices.data()), 72));
  builder.document["bufferViews"][view]["byteStride"] = 24;
  const int positions = builder.addAccessor(view, "VEC3", 5126, 9, false);
  const int normals = builder.addAccessor(view, "VEC3", 5126, 9, false);
  builder.document["accessors"][normals]["byteOffset"] = 12;
  builder.addMeshNode({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
  const TriangleMesh mesh = load(builder).mesh.mesh;
  CHECK(mesh.positions == trianglePositions);
  CHECK(mesh.normals[0] == glm::vec3(0, 0, 1));
  checkNear(mesh.normals[1], glm::normalize(glm::vec3(0, 1, 1)));
}

TEST_CASE("quantized glTF positions are numbers as they are or parts of the largest one") {
  GltfBuilder builder;
  builder.document["extensionsRequired"] = {"KHR_mesh_quantization"};
  const int whole = builder.add<std::int16_t>("VEC3", {0, 0, 0, 7, 0, 0, 0, -3, 0});
  const int part = builder.add<std::int8_t>("VEC3", {-128, -127, 0, 127, 0, 0, 0, 127, 0}, true);
  builder.addMeshNode({{"attributes", {{"POSITION", whole}}}});
  builder.addMeshNode({{"attributes", {{"POSITION", part}}}});
  const std::vector<glm::vec3> expected{{0, 0, 0},   {7, 0, 0}, {0, -3, 0},
                                        {-1, -1, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(load(builder).mesh.mesh.positions == expected);
}

TEST_CASE("glTF primitives that share vertices have them once") {
  GltfBuilder builder;
  const int positions = builder.add<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  const int first = builder.add<std::uint8_t>("SCALAR", {0, 1, 2});
  const int second = builder.add<std::uint32_t>("SCALAR", {1, 3, 2});
  const Json attributes{{"POSITION", positions}};
  builder.addMeshNode({{"attributes", attributes}, {"indices", first}});
  builder.document["meshes"][0]["primitives"].push_back(
      {{"attributes", attributes}, {"indices", second}});
  const LoadedMesh loaded = load(builder).mesh;
  CHECK(loaded.mesh.positions.size() == 4);
  CHECK(loaded.mesh.triangles == std::vector{glm::uvec3(0, 1, 2), glm::uvec3(1, 3, 2)});
}

TEST_CASE("only the default scene of a glTF file is loaded") {
  GltfBuilder builder = triangleGltf();
  builder.addMeshNode({{"attributes", {{"POSITION", 0}}}}, {{"translation", {0, 0, 5}}});
  builder.document["scenes"] =
      Json::array({Json{{"nodes", Json::array({0})}}, Json{{"nodes", Json::array({1})}}});
  CHECK(load(builder).mesh.mesh.positions[0] == glm::vec3(0, 0, 0));
  builder.document["scene"] = 1;
  CHECK(load(builder).mesh.mesh.positions[0] == glm::vec3(0, 0, 5));
  builder.document.erase("scenes");
  CHECK(load(builder).mesh.mesh.positions.size() == 6);
}

TEST_CASE("what a glTF file says about images, materials and extras is passed over") {
  GltfBuilder builder = triangleGltf();
  builder.document["images"] = Json::array({Json{{"uri", "missing.png"}}, Json{{"bufferView", 77}},
                                            Json{{"uri", "data:image/png;base64,"}}});
  builder.document["materials"] = Json::array({Json{{"name", 5}}});
  builder.document["meshes"][0]["primitives"][0]["material"] = 0;
  builder.document["nodes"][0]["extras"] = {{"mesh", "none"}, {"count", -1}};
  builder.document["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_transform"};
  CHECK(load(builder).mesh.mesh.positions == trianglePositions);
}
