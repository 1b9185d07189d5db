#include <cmath>
#include <numbers>

#include "base/error.h"
#include "gltf_support.h"

using namespace haarlight;
using namespace haarlight::test;
using Json = nlohmann::json;

namespace {

const glm::vec3 y(0, 1, 0);

/// The vertices of the skinned bar, its top turned about z at (0, 1, 0) by that angle.
void checkBent(const std::vector<glm::vec3>& bent, const std::vector<glm::vec3>& rest,
               double angle) {
  REQUIRE(bent.size() == 12);
  const auto turned = [&](const glm::vec3& p) {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return glm::vec3(cosine * p.x - sine * (p.y - 1), 1 + sine * p.x + cosine * (p.y - 1), p.z);
  };
  for (int i = 0; i < 4; ++i) {
    checkNear(bent[i], rest[i]);
    checkNear(bent[4 + i], (rest[4 + i] + turned(rest[4 + i])) / 2.0f);
    checkNear(bent[8 + i], turned(rest[8 + i]));
  }
}

/// Where the first corner of a triangle is when `path` of its node follows these keys.
class MovedTriangle {
 public:
  MovedTriangle(const std::string& path, const std::vector<float>& seconds, const std::string& type,
                const std::vector<float>& values, const std::string& interpolation)
      : builder_(triangleGltf()) {
    builder_.addChannel("move", 0, path, builder_.add("SCALAR", seconds),
                        builder_.add(type, values), interpolation);
  }

  glm::vec3 corner(int index, double seconds) const {
    return positionsAt(builder_, seconds)[index];
  }

 private:
  GltfBuilder builder_;
};

}  // namespace

TEST_CASE("a skinned glTF bar bends about its joint") {
  const AnimatedMesh bar = load(skinnedBar());
  const std::vector<glm::vec3>& rest = bar.mesh.mesh.positions;
  REQUIRE(bar.motion);
  CHECK(bar.motion->vertexCount() == 12);
  CHECK(bar.motion->duration() == 1);
  checkNear(rest[8], {0.1f, 2, 0.1f});
  checkBent(bar.motion->positions(1), rest, std::numbers::pi / 2);
  checkNear(bar.motion->positions(1)[8], {-1, 1.1f, 0.1f});
  checkNear(bar.motion->positions(1)[4], {0.05f, 1.05f, 0.1f});
  // Spherical interpolation: half the angle at half the time.
  checkBent(bar.motion->positions(0.5), rest, std::numbers::pi / 4);
  checkBent(bar.motion->positions(0.25), rest, std::numbers::pi / 8);
}

TEST_CASE("a glTF motion stands still before its start and after its end") {
  const AnimatedMesh bar = load(skinnedBar());
  CHECK(bar.motion->positions(0) == bar.mesh.mesh.positions);
  CHECK(bar.motion->positions(-3) == bar.motion->positions(0));
  CHECK(bar.motion->positions(9) == bar.motion->positions(1));
  const auto half = bar.motion->positions(0.5);
  bar.motion->positions(0.1);
  CHECK(bar.motion->positions(0.5) == half);
}

TEST_CASE("the node of a skinned glTF mesh is without effect") {
  GltfBuilder builder = skinnedBar();
  builder.document["nodes"][2]["translation"] = {5, 6, 7};
  CHECK(load(builder).mesh.mesh.positions == load(skinnedBar()).mesh.mesh.positions);
}

TEST_CASE("a skin without inverse bind matrices has the identity") {
  GltfBuilder builder = skinnedBar();
  builder.document["skins"][0].erase("inverseBindMatrices");
  const AnimatedMesh bar = load(builder, "none");
  CHECK_FALSE(bar.motion);
  const auto with = load(skinnedBar()).mesh.mesh.positions;
  checkNear(bar.mesh.mesh.positions[9], with[9] + y);
  checkNear(bar.mesh.mesh.positions[5], with[5] + 0.5f * y);
}

TEST_CASE("glTF skin weights are floats or normalized integers, in any number of sets") {
  GltfBuilder builder = skinnedBar();
  Json& attributes = builder.document["meshes"][0]["primitives"][0]["attributes"];
  const auto expected = positionsAt(builder, 1);
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint16_t> words, joints, none;
  for (int vertex = 0; vertex < 12; ++vertex) {
    const int second = vertex / 4;  // of 2
    bytes.insert(bytes.end(), {std::uint8_t(80 - 40 * second), std::uint8_t(40 * second), 0, 0});
    words.insert(words.end(), {0, std::uint16_t(30000 * second), 0, 0});
    none.insert(none.end(), {0, 0, 0, std::uint16_t(60000 - 30000 * second)});
    joints.insert(joints.end(), {9, 1, 0, 0});
  }
  // The weights of bytes have the sum 80 / 255.
  attributes["WEIGHTS_0"] = builder.add("VEC4", bytes, true);
  const auto ofBytes = positionsAt(builder, 1);
  attributes["JOINTS_0"] = builder.add("VEC4", joints);
  attributes["WEIGHTS_0"] = builder.add("VEC4", words, true);
  attributes["JOINTS_1"] = builder.add("VEC4", std::vector<std::uint8_t>(48, 0));
  attributes["WEIGHTS_1"] = builder.add("VEC4", none, true);
  const auto ofTwoSets = positionsAt(builder, 1);
  for (int vertex = 0; vertex < 12; ++vertex) {
    checkNear(ofBytes[vertex], expected[vertex]);
    checkNear(ofTwoSets[vertex], expected[vertex]);
  }
}

TEST_CASE("glTF morph targets are added by their weights") {
  GltfBuilder builder = triangleGltf();
  Json& mesh = builder.document["meshes"][0];
  mesh["primitives"][0]["targets"] =
      Json::array({Json{{"POSITION", builder.add<float>("VEC3", {0, 0, 2, 0, 0, 0, 0, 0, 0})}},
                   Json{{"POSITION", builder.add<float>("VEC3", {4, 0, 0, 0, 0, 0, 0, 0, 8})}}});
  CHECK(load(builder).mesh.mesh.positions[0] == glm::vec3(0));
  mesh["weights"] = {0.5, 0.25};
  CHECK(load(builder).mesh.mesh.positions ==
        std::vector<glm::vec3>{{1, 0, 1}, {1, 0, 0}, {0, 1, 2}});
  builder.document["nodes"][0]["weights"] = {0, 1};
  CHECK(load(builder).mesh.mesh.positions[0] == glm::vec3(4, 0, 0));
  builder.addChannel("morph", 0, "weights", builder.add<float>("SCALAR", {0, 2}),
                     builder.add<float>("SCALAR", {1, 0, 0, 1}));
  CHECK(load(builder).mesh.mesh.positions[0] == glm::vec3(0, 0, 2));
  CHECK(positionsAt(builder, 0.5)[0] == glm::vec3(1, 0, 1.5f));
}

TEST_CASE("glTF morph targets change the normals at rest") {
  GltfBuilder builder = triangleGltf();
  Json& mesh = builder.document["meshes"][0];
  mesh["primitives"][0]["attributes"]["NORMAL"] =
      builder.add<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
  mesh["primitives"][0]["targets"] =
      Json::array({Json{{"NORMAL", builder.add<float>("VEC3", {0, 1, 0, 0, 0, 0, 0, 0, 0})}}});
  mesh["weights"] = {0.5};
  const TriangleMesh loaded = load(builder).mesh.mesh;
  checkNear(loaded.normals[0], glm::normalize(glm::vec3(0, 0.5f, 1)));
  CHECK(loaded.normals[1] == glm::vec3(0, 0, 1));
}

TEST_CASE("glTF steps hold a value until the next key") {
  const MovedTriangle moved("translation", {1, 2, 4}, "VEC3", {1, 0, 0, 2, 0, 0, 3, 0, 0}, "STEP");
  CHECK(moved.corner(0, 0).x == 1);
  CHECK(moved.corner(0, 1.999).x == 1);
  CHECK(moved.corner(0, 2).x == 2);
  CHECK(moved.corner(0, 3.999).x == 2);
  CHECK(moved.corner(0, 4).x == 3);
}

TEST_CASE("linear glTF keys lie on a line") {
  const MovedTriangle moved("scale", {1, 2, 4}, "VEC3", {1, 1, 1, 2, 1, 1, 4, 3, 1}, "LINEAR");
  CHECK(moved.corner(1, 0.5).x == 1);
  CHECK(moved.corner(1, 1.5).x == 1.5f);
  CHECK(moved.corner(1, 3.5).x == 3.5f);
  CHECK(moved.corner(2, 3.5).y == 2.5f);
}

TEST_CASE("cubic glTF keys follow Hermite's formula") {
  // Between second 1 and 3: value 1, outgoing tangent 2; incoming tangent −1, value 5.
  const MovedTriangle moved("translation", {1, 3}, "VEC3",
                            {9, 0, 0, 1, 0, 0, 2, 0, 0, -1, 0, 0, 5, 0, 0, 9, 0, 0}, "CUBICSPLINE");
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double expected = (2 * t * t * t - 3 * t * t + 1) * 1 +
                            2 * (t * t * t - 2 * t * t + t) * 2 + (-2 * t * t * t + 3 * t * t) * 5 +
                            2 * (t * t * t - t * t) * -1;
    CHECK(moved.corner(0, 1 + 2 * t).x == doctest::Approx(expected).epsilon(1e-6));
  }
  CHECK(moved.corner(0, 2).x == 3.75f);
  CHECK(moved.corner(0, 0).x == 1);
  CHECK(moved.corner(0, 7).x == 5);
}

TEST_CASE("glTF rotations take the shorter arc") {
  const float half = std::sqrt(0.5f);
  // −q is the same rotation: 90° about z.
  const MovedTriangle moved("rotation", {0, 1}, "VEC4", {0, 0, 0, 1, 0, 0, -half, -half}, "LINEAR");
  checkNear(moved.corner(1, 1), y);
  checkNear(moved.corner(1, 1.0 / 3), {std::cos(std::numbers::pi / 6), 0.5f, 0});
}

TEST_CASE("animated glTF parents carry their children") {
  GltfBuilder builder = triangleGltf();
  const float half = std::sqrt(0.5f);
  const int parent = builder.addNode({{"children", Json::array({0})}});
  builder.document["nodes"][0]["translation"] = {1, 0, 0};
  builder.document["scenes"][0]["nodes"] = Json::array({parent});
  const int keys = builder.add<float>("SCALAR", {0, 1});
  const int turn = builder.add<float>("VEC4", {0, 0, 0, 1, 0, 0, half, half});
  builder.addChannel("turn", parent, "rotation", keys, turn);
  builder.addChannel("turn", 0, "rotation", keys, turn);
  // The child turns x to y, the parent its place to y and y to −x.
  checkNear(positionsAt(builder, 1)[0], {0, 1, 0});
  checkNear(positionsAt(builder, 1)[1], {-1, 1, 0});
}

TEST_CASE("a glTF animation is chosen by name or number") {
  GltfBuilder builder = triangleGltf();
  const int keys = builder.add<float>("SCALAR", {0, 1});
  builder.addChannel("left", 0, "translation", keys,
                     builder.add<float>("VEC3", {-1, 0, 0, -2, 0, 0}));
  builder.addChannel("up", 0, "translation", keys, builder.add<float>("VEC3", {0, 1, 0, 0, 2, 0}));
  CHECK(load(builder).motion->positions(1)[0] == glm::vec3(-2, 0, 0));
  CHECK(load(builder, "up").motion->positions(1)[0] == glm::vec3(0, 2, 0));
  CHECK(load(builder, "1").mesh.mesh.positions[0] == glm::vec3(0, 1, 0));
  CHECK(load(builder, "none").mesh.mesh.positions[0] == glm::vec3(0, 0, 0));
  CHECK_FALSE(load(builder, "none").motion);
  CHECK_THROWS_WITH_AS(load(builder, "2"),
                       doctest::Contains("choose one of 0 'left', 1 'up', or none"), InputError);
  CHECK_THROWS_WITH_AS(load(triangleGltf(), "walk"), doctest::Contains("choose none"), InputError);
}

TEST_CASE("a glTF animation that moves no vertex is no motion") {
  GltfBuilder builder = triangleGltf();
  const int camera = builder.addNode({});
  const int keys = builder.add<float>("SCALAR", {0, 1});
  const int values = builder.add<float>("VEC3", {0, 0, 0, 1, 0, 0});
  builder.addChannel("fly", camera, "translation", keys, values);
  CHECK_FALSE(load(builder).motion);
  builder.document["nodes"][camera]["children"] = Json::array({0});
  CHECK(load(builder).motion);
}
