#include "motion/mesh_sequence.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <initializer_list>

#include "motion/point_cache_bytes.h"
#include "scene/numbered_files.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

const std::string tetrahedronFaces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string objText(const std::vector<glm::vec3>& points, const std::string& faces) {
  std::string text;
  for (const glm::vec3& p : points)
    text +=
        "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
  return text + faces;
}

/// A tetrahedron that is stretched along x; all its numbers are exact in decimals.
std::vector<glm::vec3> tetrahedron(float stretch) {
  return {{0, 0, 0}, {stretch, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

void writeTetrahedron(const std::filesystem::path& path, float stretch,
                      const std::string& faces = tetrahedronFaces) {
  writeFile(path, objText(tetrahedron(stretch), faces));
}

std::string openingRefusal(const std::filesystem::path& pattern, const LoadedMesh& mesh) {
  return inputErrorOf([&] { openMeshSequence(pattern, mesh, 24); });
}

std::string numbersOf(const std::filesystem::path& pattern) {
  std::string names;
  for (const auto& file : NumberedFiles(pattern).list()) names += file.filename().string() + " ";
  return names;
}

}  // namespace

TEST_CASE("a sequence shows its files in turn, from the lowest number on") {
  const TemporaryFolder folder;
  for (int i = 0; i < 4; ++i)
    writeTetrahedron(folder / ("walk_" + std::to_string(i + 98) + ".obj"), float(1 + i * i));
  const LoadedMesh mesh = loadMesh(folder / "walk_98.obj");
  const auto motion = openMeshSequence(folder / "walk_%d.obj", mesh, 8);
  CHECK(motion->vertexCount() == 4);
  CHECK(motion->duration() == 3.0 / 8);
  for (const int i : {2, 0, 3, 1, 3})
    CHECK(sameBits(motion->positions(i / 8.0), tetrahedron(float(1 + i * i))));
  CHECK(sameBits(motion->positions(1.5 / 8), tetrahedron(3.5f)));
  CHECK(sameBits(motion->positions(2.25 / 8), tetrahedron(6.25f)));
  CHECK(sameBits(motion->positions(99), tetrahedron(10)));
}

TEST_CASE("frames may have other normals, and so other repeated vertices, than the mesh") {
  const TemporaryFolder folder;
  const std::string normals = "vn 0 0 1\nvn 0 1 0\nvn 1 0 0\n";
  const std::string split =
      normals + "f 1//1 3//1 2//1\nf 1//2 2//2 4//2\nf 1//3 4//3 3//3\nf 2//1 3//1 4//1\n";
  writeTetrahedron(folder / "a_0.obj", 1, split);
  writeTetrahedron(folder / "a_1.obj", 2);
  const LoadedMesh mesh = loadMesh(folder / "a_0.obj");
  REQUIRE(mesh.mesh.positions.size() > 4);
  const std::vector<glm::vec3> end = openMeshSequence(folder / "a_%d.obj", mesh, 1)->positions(1);
  REQUIRE(end.size() == mesh.mesh.positions.size());
  for (std::size_t i = 0; i < end.size(); ++i)
    CHECK(end[i] == tetrahedron(2)[mesh.sourceVertices[i]]);
}

TEST_CASE("only files whose numbers are written as in the pattern belong to it") {
  const TemporaryFolder folder;
  for (const char* name : {"a007.obj", "a008.obj", "a009.obj", "a010.obj", "a1.obj", "a0011.obj",
                           "b001.obj", "a012.ply", "a.obj", "a-01.obj", "a01x.obj"})
    writeFile(folder / name, "");
  CHECK(numbersOf(folder / "a%03d.obj") == "a007.obj a008.obj a009.obj a010.obj ");
  CHECK(numbersOf(folder / "a%d.obj") == "a1.obj ");
  CHECK(numbersOf(folder / "a%04d.obj") == "a0011.obj ");
  CHECK(numbersOf(folder / "b%03d.obj") == "b001.obj ");
  CHECK(numbersOf(folder / "a0%d.obj") == "a010.obj ");
  CHECK(numbersOf(folder / "a00%d1.obj") == "a0011.obj ");
  CHECK_THROWS_AS(numbersOf(folder / "a0%d1.obj"), InputError);
}

TEST_CASE("patterns without one number are refused, and those without files") {
  const TemporaryFolder folder;
  const LoadedMesh mesh = meshWithVertices(3);
  for (const char* pattern :
       {"a.obj", "a%.obj", "a%s.obj", "a%4d.obj", "a%d_%d.obj", "a%00d.obj", "a%", "a%%d.obj", ""})
    CHECK(contains(openingRefusal(folder / pattern, mesh), "cannot use the name"));
  CHECK(contains(openingRefusal(folder / "a%d.obj", mesh),
                 "no file such as " + (folder / "a1.obj").string()));
  CHECK(contains(openingRefusal(folder / "none" / "a%d.obj", mesh), "No such file"));
}

TEST_CASE("a missing frame is refused by name") {
  const TemporaryFolder folder;
  for (const int i : {3, 4, 6, 9})
    writeTetrahedron(folder / ("a_000" + std::to_string(i) + ".obj"), float(i));
  const std::string message =
      openingRefusal(folder / "a_%04d.obj", loadMesh(folder / "a_0003.obj"));
  CHECK(contains(message, "missing frame: " + (folder / "a_0005.obj").string()));
}

TEST_CASE("frames with other vertices or triangles are refused by name") {
  const std::pair<std::string, std::string> cases[] = {
      {objText(tetrahedron(1), "v 0 0 0\n" + tetrahedronFaces), "5 vertices"},
      {objText(tetrahedron(1), "f 1 3 2\nf 1 2 4\nf 1 4 3\n"), "3 triangles"},
      {objText(tetrahedron(1), "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 4 3\n"), "its triangle 3 (from 0)"},
      {objText(tetrahedron(0), tetrahedronFaces), "2 triangles with an area"},
      {"v 0 0 nan\n", "line 1"},
      {"", "empty"}};
  for (const auto& [text, problem] : cases) {
    const TemporaryFolder folder;
    writeTetrahedron(folder / "a_0.obj", 1);
    writeFile(folder / "a_1.obj", text);
    const auto motion = openMeshSequence(folder / "a_%d.obj", loadMesh(folder / "a_0.obj"), 24);
    CHECK(sameBits(motion->positions(0), tetrahedron(1)));
    const std::string message = inputErrorOf([&] { motion->positions(0.5 / 24); });
    CHECK(contains(message, "a_1.obj"));
    CHECK(contains(message, problem));
  }
}

TEST_CASE("frames that change or vanish after opening are refused") {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i) writeTetrahedron(folder / ("a_" + std::to_string(i) + ".obj"), 1);
  const auto motion = openMeshSequence(folder / "a_%d.obj", loadMesh(folder / "a_0.obj"), 24);
  writeTetrahedron(folder / "a_1.obj", 1, tetrahedronFaces + "# longer\n");
  CHECK(contains(inputErrorOf([&] { motion->positions(1.0 / 24); }), "when it was opened and now"));
  fs::remove(folder / "a_2.obj");
  CHECK(contains(inputErrorOf([&] { motion->positions(2.0 / 24); }), "a_2.obj: No such file"));
}
