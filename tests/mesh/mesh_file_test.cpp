#include "mesh/mesh_file.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>

#include "base/error.h"
#include "mesh/mesh_measures.h"
#include "test_support.h"

using namespace haarlight;
using haarlight::test::TemporaryFolder;
using haarlight::test::writeFile;

namespace {

LoadedMesh loadText(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  writeFile(folder / name, text);
  return loadMesh(folder / name);
}

/// The message of the InputError; empty when there is none.
std::string errorOf(const std::string& name, const std::string& text) {
  try {
    loadText(name, text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool hasWarning(const LoadedMesh& loaded, const std::string& part) {
  for (const auto& warning : loaded.warnings)
    if (contains(warning, part)) return true;
  return false;
}

const std::string cubeVertices =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
const std::string cubeQuads = "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";
const std::string tetrahedronObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string tetrahedronPlyHeader(const std::string& format, const std::string& more = "") {
  return "ply\nformat " + format + " 1.0\ncomment element face 9\nelement vertex 4\n" +
         "property float x\nproperty float y\nproperty float z\n" + more +
         "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
}
const std::string tetrahedronAscii =
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

template <typename Number>
void append(std::string& bytes, Number number, bool bigEndian = false) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  if (bigEndian) std::reverse(raw, raw + sizeof number);
  bytes.append(raw, sizeof number);
}

std::string binaryTetrahedron(bool bigEndian, float firstX = 0) {
  std::string bytes =
      tetrahedronPlyHeader(bigEndian ? "binary_big_endian" : "binary_little_endian");
  for (const float x : {firstX, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f})
    append(bytes, x, bigEndian);
  for (const auto& t : {glm::ivec3(0, 2, 1), {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    append(bytes, std::uint8_t(3));
    for (int i = 0; i < 3; ++i) append(bytes, std::int32_t(t[i]), bigEndian);
  }
  return bytes;
}

std::string binaryStl(const TriangleMesh& mesh) {
  std::string bytes = "solid that is binary";
  bytes.resize(80);
  append(bytes, std::uint32_t(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.f);
    for (const auto vertex : {t.x, t.y, t.z})
      for (int i = 0; i < 3; ++i) append(bytes, mesh.positions[vertex][i]);
    append(bytes, std::uint16_t(0));
  }
  return bytes;
}

void checkTetrahedron(const LoadedMesh& loaded) {
  CHECK(loaded.mesh.positions.size() == 4);
  CHECK(loaded.mesh.triangles.size() == 4);
  CHECK(loaded.topology.closed);
  CHECK(loaded.topology.components == 1);
  CHECK(signedVolume(loaded.mesh) == doctest::Approx(1.0 / 6).epsilon(1e-12));
}

}  // namespace

TEST_CASE("an OBJ cube of quads becomes twelve triangles of volume one") {
  const LoadedMesh cube = loadText("cube.obj", cubeVertices + cubeQuads);
  CHECK(cube.mesh.triangles.size() == 12);
  CHECK(cube.topology.vertices == 8);
  CHECK(cube.topology.edges == 18);
  CHECK(cube.topology.closed);
  CHECK(cube.warnings.empty());
  CHECK(signedVolume(cube.mesh) == doctest::Approx(1).epsilon(1e-12));
  CHECK(surfaceArea(cube.mesh) == doctest::Approx(6).epsilon(1e-12));
  // Angle weights make the corner normals those of the cube's diagonals, however quads are cut.
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::vec3 diagonal = glm::normalize(cube.mesh.positions[i] - glm::vec3(0.5f));
    CHECK(glm::distance(cube.mesh.normals[i], diagonal) < 1e-6f);
  }
}

TEST_CASE("OBJ variants: negative indices, CRLF, comments, texture coordinates, junk keywords") {
  checkTetrahedron(loadText("a.obj", tetrahedronObj));
  checkTetrahedron(loadText("b.OBJ",
                            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                            "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n"));
  std::string windows =
      "# comment\n\nmtllib no.mtl\nusemtl x\ng a b\no c\ns off\n" + tetrahedronObj;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2)
    windows.replace(at, 1, "\r\n");
  checkTetrahedron(loadText("c.obj", windows));
  checkTetrahedron(loadText("d.obj",
                            "v 0 0 0 1 0.5 0.5\nvt 0 0\n  v\t+1.0 0 0\nv 0 1e0 0\nv 0 0 1\n"
                            "f 1/1 3/1 2/1 # one\nf 1/ 2/ 4/\nf 1/1 4/1 3/1\nf 2 3 4"));
}

TEST_CASE("a vertex with several normals in an OBJ becomes several vertices") {
  const std::string faces =
      "f 4//1 3//1 2//1 1//1\nf 5//2 6//2 7//2 8//2\nf 1//3 2//3 6//3 5//3\n"
      "f 3//4 4//4 8//4 7//4\nf 2//5 3//5 7//5 6//5\nf 4//6 1//6 5//6 8//6\n";
  const std::string normals = "vn 0 0 -2\nvn 0 0 1\nvn 0 -1 0\nvn 0 1 0\nvn 1 0 0\nvn -1 0 0\n";
  const LoadedMesh cube = loadText("cube.obj", cubeVertices + normals + faces);
  CHECK(cube.mesh.positions.size() == 24);
  CHECK(cube.topology.vertices == 8);
  CHECK(cube.topology.closed);
  CHECK(cube.warnings.empty());
  for (std::size_t i = 0; i < 24; ++i) {
    if (i < 8) CHECK(cube.sourceVertices[i] == i);
    CHECK(cube.mesh.positions[i] == cube.mesh.positions[cube.sourceVertices[i]]);
  }
  for (const auto& t : cube.mesh.triangles) {
    const auto& p = cube.mesh.positions;
    const glm::vec3 flat = glm::normalize(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]));
    for (const auto vertex : {t.x, t.y, t.z})
      CHECK(glm::distance(cube.mesh.normals[vertex], flat) < 1e-6f);
  }
}

TEST_CASE("normals that are zero or no numbers are computed, with a warning") {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn nan 0 0\nvn 0 0 5\nf 1//1 2//2 3//3\n";
  const LoadedMesh loaded = loadText("a.obj", text);
  CHECK(hasWarning(loaded, "2 normals"));
  for (const auto& normal : loaded.mesh.normals) CHECK(normal == glm::vec3(0, 0, 1));
}

TEST_CASE("PLY: ascii, both byte orders, normals, unused properties") {
  checkTetrahedron(loadText("a.ply", tetrahedronPlyHeader("ascii") + tetrahedronAscii));
  checkTetrahedron(loadText("b.ply", binaryTetrahedron(false)));
  checkTetrahedron(loadText("c.ply", binaryTetrahedron(true)));

  const std::string colors =
      "property float nx\nproperty float ny\nproperty float nz\n"
      "property uchar red\nproperty double confidence\n";
  const LoadedMesh loaded =
      loadText("d.ply", tetrahedronPlyHeader("ascii", colors) +
                            "0 0 0 1 0 0 7 0.5\n1 0 0 0 2 0 7 0.5\n0 1 0 0 0 1 7 0.5\n"
                            "0 0 1 0 0 -1 7 0.5\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  checkTetrahedron(loaded);
  CHECK(loaded.mesh.normals[1] == glm::vec3(0, 1, 0));
  CHECK(loaded.mesh.normals[3] == glm::vec3(0, 0, -1));
}

TEST_CASE("OFF: plain, comments, colours, normals, counts on the first line") {
  const std::string faces = "3 0 2 1 255 0 0\n3 0 1 3\n3 0 3 2 0.5 0.5 0.5\n3 1 2 3\n";
  checkTetrahedron(loadText("a.off", "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + faces));
  checkTetrahedron(loadText("b.off",
                            "# x\nCOFF 4 4 0\n\n0 0 0 1 2 3\n# y\n1 0 0 1 2 3\n0 1 0 1 2 3 # z\n"
                            "0 0 1 1 2 3\n" +
                                faces));
  const LoadedMesh loaded = loadText(
      "c.off", "NOFF\n4 4 0\n0 0 0 1 0 0\n1 0 0 0 3 0\n0 1 0 0 0 1\n0 0 1 0 0 1\n" + faces);
  checkTetrahedron(loaded);
  CHECK(loaded.mesh.normals[1] == glm::vec3(0, 1, 0));
}

TEST_CASE("STL: binary and ascii vertices are joined") {
  const TriangleMesh tetrahedron = loadText("a.obj", tetrahedronObj).mesh;
  checkTetrahedron(loadText("a.stl", binaryStl(tetrahedron)));
  std::ostringstream text;
  text << "solid x\n";
  for (const auto& t : tetrahedron.triangles) {
    text << "facet normal 0 0 0\n outer loop\n";
    for (const auto vertex : {t.x, t.y, t.z}) {
      const glm::vec3& p = tetrahedron.positions[vertex];
      text << "  vertex " << p.x << ' ' << p.y << ' ' << p.z << "\n";
    }
    text << " endloop\nendfacet\n";
  }
  checkTetrahedron(loadText("b.stl", text.str() + "endsolid x\n"));
  CHECK(contains(errorOf("c.stl", text.str()), "endsolid"));
  CHECK(contains(errorOf("d.stl", "solid\nouter loop\nvertex 0 0 0\nvertex 1 0 nan\n"), "line 4"));
  const std::string binary = binaryStl(tetrahedron);
  CHECK(contains(errorOf("e.stl", binary.substr(0, binary.size() - 1)), "cut off"));
  std::string notFinite = binary;
  const float infinite = std::numeric_limits<float>::infinity();
  std::memcpy(notFinite.data() + 84 + 50 + 12 + 24, &infinite, 4);
  CHECK(contains(errorOf("f.stl", notFinite), "vertex 2 of triangle 1"));
}

TEST_CASE("concave polygons are cut inside their outline") {
  // An arrow head: the fan from its first vertex would leave it.
  const LoadedMesh arrow =
      loadText("arrow.obj", "v 2 0 0\nv 0 2 0\nv -2 0 0\nv 0 1 0\nf 1 2 3 4\n");
  CHECK(arrow.mesh.triangles.size() == 2);
  CHECK(surfaceArea(arrow.mesh) == doctest::Approx(2).epsilon(1e-12));
  for (const auto& t : arrow.mesh.triangles) {
    const auto& p = arrow.mesh.positions;
    CHECK(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]).z > 0);
  }
}

TEST_CASE("no triangle is lost where a surface is open, not manifold or doubled") {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\n";
  const LoadedMesh fan = loadText("fan.obj", points + "f 1 2 3\nf 1 2 4\nf 1 2 5\n");
  CHECK(fan.mesh.triangles.size() == 3);
  CHECK(fan.topology.nonManifoldEdges == 1);
  CHECK(fan.topology.boundaryEdges == 6);
  CHECK_FALSE(fan.topology.closed);
  CHECK(hasWarning(fan, "1 edges of more than two triangles"));
  CHECK(hasWarning(fan, "6 boundary edges"));

  const LoadedMesh doubled = loadText("double.obj", tetrahedronObj + "f 2 3 4\nf 4 3 2\n");
  CHECK(doubled.mesh.triangles.size() == 6);
  CHECK(doubled.topology.duplicateTriangles == 2);
  CHECK(hasWarning(doubled, "2 triangles are there more than once"));

  const LoadedMesh turned = loadText("turned.obj", points + "f 1 2 3\nf 1 2 4\n");
  CHECK(turned.topology.misorientedEdges == 1);
}

TEST_CASE("triangles without area are left out with a warning") {
  const LoadedMesh loaded =
      loadText("a.obj", tetrahedronObj + "v 0.5 0 0\nf 1 2 2\nf 1 2 5\nf 3 3 3\n");
  CHECK(loaded.mesh.triangles.size() == 4);
  CHECK(hasWarning(loaded, "3 triangles without area"));
  CHECK(hasWarning(loaded, "1 vertices belong to no triangle"));
  CHECK(loaded.mesh.positions.size() == 5);
  CHECK(loaded.mesh.normals.size() == 5);
}

TEST_CASE("bad OBJ files are refused with the line") {
  CHECK(contains(errorOf("a.obj", "v 0 0 0\nv 1 nan 0\n"), "line 2: vertex 2"));
  CHECK(contains(errorOf("a.obj", "v 0 0 inf\n"), "line 1"));
  CHECK(contains(errorOf("a.obj", "v 0 0 1e39\n"), "line 1"));
  CHECK(contains(errorOf("a.obj", "v 0 0\n"), "line 1"));
  CHECK(contains(errorOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"), "line 4"));
  CHECK(contains(errorOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"),
                 "vertex 4, but there are 3"));
  CHECK(contains(errorOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n"), "vertex -4"));
  CHECK(contains(errorOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n"), "vertex 0"));
  CHECK(contains(errorOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//9\n"), "normal 9"));
  CHECK(contains(errorOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n"), "'x' is no corner"));
  CHECK(contains(errorOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "no triangle"));
  CHECK(contains(errorOf("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "no triangle"));
  CHECK(contains(errorOf("a.obj", ""), "empty"));
  CHECK(contains(errorOf("a.obj", std::string("\x7f\0ELF\n\n\1\2", 9)), "no triangle"));
  CHECK(contains(errorOf("a.xyz", tetrahedronObj), "extension"));
}

TEST_CASE("bad PLY files are refused") {
  const std::string header = tetrahedronPlyHeader("ascii");
  const auto error = [](const std::string& text) { return errorOf("a.ply", text); };
  CHECK(contains(error("ply\nformat ascii 1.0\nelement vertex 4\n"), "no end"));
  CHECK(contains(error("plx\n"), "ply"));
  CHECK(contains(error("ply\nformat ascii 1.0\nproperty float x\nend_header\n"), "line 3"));
  CHECK(
      contains(error("ply\nformat ascii 1.0\nelement vertex 4000000000\nend_header\n"), "line 3"));
  CHECK(contains(error("ply\nformat ascii 1.0\nelement vertex -1\nend_header\n"), "line 3"));
  CHECK(contains(error(tetrahedronPlyHeader("ascii", "property float x\n")), "twice"));
  CHECK(contains(error(tetrahedronPlyHeader("ascii", "property thing q\n")), "'thing' is no type"));
  CHECK(contains(error(tetrahedronPlyHeader("ascii", "property list uchar int q\n")), "'q'"));
  CHECK(contains(error(header + "0 0 0\n1 0 0\n0 nan 0\n"), "3 vertices"));
  CHECK(contains(error(header + tetrahedronAscii.substr(0, 40)), "cut off"));
  CHECK(contains(error(header + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 9\n3 0 3 2\n3 1 2 3\n"),
                 "face 1 (from 0) refers to vertex 9"));
  CHECK(
      contains(error(header + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 -1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"),
               "face 0 (from 0) refers to vertex -1"));
  CHECK(contains(error(header + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n4000000000 0 2 1\n"), "cut off"));
  CHECK(contains(error(binaryTetrahedron(false, std::nanf(""))), "vertex 0"));
  const std::string binary = binaryTetrahedron(false);
  for (std::size_t size = 0; size < binary.size(); size += 3)
    CHECK_FALSE(error(binary.substr(0, size)).empty());
}

TEST_CASE("bad OFF files are refused with the line") {
  const auto error = [](const std::string& text) { return errorOf("a.off", text); };
  CHECK(contains(error("OOF\n"), "'OOF'"));
  CHECK(contains(error("OFF BINARY\n4 4 0\n"), "binary"));
  CHECK(contains(error("OFF\n4000000000 4 0\n0 0 0\n"), "line 2"));
  CHECK(contains(error("OFF\n3 x 0\n0 0 0\n"), "line 2"));
  CHECK(contains(error("OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"), "line 4: vertex 1"));
  CHECK(contains(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "line 6: face 0"));
  CHECK(contains(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n"), "line 6: face 0"));
  CHECK(contains(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"), "cut off"));
}

TEST_CASE("damaged bytes give an error or a mesh, never anything else") {
  const std::string sources[][2] = {
      {"a.obj", tetrahedronObj},
      {"a.ply", tetrahedronPlyHeader("ascii") + tetrahedronAscii},
      {"b.ply", binaryTetrahedron(false)},
      {"a.off", "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"},
      {"a.stl", binaryStl(loadText("t.obj", tetrahedronObj).mesh)}};
  std::uint32_t state = 1;
  for (const auto& [name, text] : sources)
    for (int round = 0; round < 400; ++round) {
      std::string damaged = text;
      for (int i = 0; i < 3; ++i) {
        state = state * 1664525 + 1013904223;
        damaged[(state >> 8) % damaged.size()] = static_cast<char>(state >> 24);
      }
      try {
        const LoadedMesh loaded = loadText(name, damaged);
        for (const auto& t : loaded.mesh.triangles)
          REQUIRE(std::max({t.x, t.y, t.z}) < loaded.mesh.positions.size());
      } catch (const InputError&) {
      }
    }
}

TEST_CASE("missing files, folders and unknown built-in meshes are refused") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(loadMesh(folder / "none.obj"), InputError);
  CHECK_THROWS_AS(loadMesh(folder.path()), InputError);
  try {
    loadMeshOrBuiltin("builtin:teapot");
    FAIL("no error");
  } catch (const InputError& error) {
    CHECK(contains(error.what(), "builtin:torusknot"));
    CHECK(contains(error.what(), "builtin:sphere"));
  }
}

TEST_CASE("the real meshes are what their description says") {
  if (const auto path = test::testData("meshes/bunny.obj")) {
    const LoadedMesh bunny = loadMesh(*path);
    CHECK(bunny.mesh.positions.size() == 35947);
    CHECK(bunny.mesh.triangles.size() == 69451);
    CHECK(bunny.topology.boundaryEdges == 223);
    CHECK_FALSE(bunny.topology.closed);
  }
  if (const auto path = test::testData("meshes/armadillo.obj")) {
    const auto start = std::chrono::steady_clock::now();
    const LoadedMesh armadillo = loadMesh(*path);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(2));
    CHECK(armadillo.mesh.triangles.size() == 86482);
    CHECK(armadillo.topology.closed);
    CHECK(armadillo.warnings.empty());
  }
}
