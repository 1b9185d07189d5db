#include <cstdint>
#include <limits>
#include <random>

#include "image/write_image.h"
#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;
namespace fs = std::filesystem;

namespace {

/// Files of one kind that cannot be used, by name.
using BadFiles = std::vector<std::pair<std::string, std::string>>;

std::string randomBytes() {
  std::mt19937 random(1);
  std::string bytes(3000, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

template <typename Value>
std::string bytesOf(const Value& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// Binary STL of one triangle that claims to have `count`.
std::string stl(std::uint32_t count, float coordinate) {
  std::string bytes(80, '\0');
  bytes += bytesOf(count);
  for (const float value : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, coordinate, 0.f, 0.f, 0.f, 1.f, 0.f})
    bytes += bytesOf(value);
  return bytes + std::string(2, '\0');
}

std::string ply(const std::string& vertices, const std::string& faces) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
         vertices + faces;
}

std::string hdr(const std::string& header, const std::string& size, std::size_t pixels) {
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + header + "\n" + size + "\n";
  for (std::size_t i = 0; i < pixels; ++i) bytes += "\x40\x50\x60\x80";
  return bytes;
}

std::string exr(float value, const TemporaryFolder& folder) {
  Image image(8, 4);
  for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(value);
  writeExr(folder / "made.exr", {{"", image}});
  return readFile(folder / "made.exr");
}

std::string sphereSet(const std::string& spheres) {
  return R"({"format": "haarlight-spheres", "version": 1,
             "mesh": {"name": "m", "hash": "0123456789abcdef"}, "method": "m", "seed": 0,
             "measures": {"coveredFraction": 1, "outsideVolumeRatio": null}, "spheres": )" +
         spheres + "}";
}

std::string oneSphere(const std::string& radius) {
  return sphereSet(R"([{"center": [0, 0, 0], "radius": )" + radius + "}]");
}

std::string scene(const std::string& object) {
  return R"({"version": 1, "objects": [)" + object + "]}";
}

/// Files that no format can be, for every extension.
BadFiles withGeneralFaults(const std::vector<std::string>& extensions, BadFiles files) {
  for (const std::string& extension : extensions) {
    files.emplace_back("empty" + extension, "");
    files.emplace_back("garbage" + extension, randomBytes());
  }
  return files;
}

/// Checks that each of the files, and also a missing one and a folder, is refused by name, by the
/// command that the function makes of its path.
template <typename Command>
void checkFilesRefused(const BadFiles& files, const std::vector<std::string>& extensions,
                       const Command& commandFor) {
  const TemporaryFolder folder, target;
  const auto check = [&](const std::string& name) {
    checkRefused(joined(commandFor(folder / name, folder), {"-o", target / "x.png", "--quiet"}),
                 (folder / name).string());
    CHECK(fs::is_empty(target.path()));
    checkRefused({"info", folder / name, "--quiet"}, (folder / name).string());
  };
  for (const auto& [name, bytes] : files) {
    writeFile(folder / name, bytes);
    check(name);
  }
  for (const std::string& extension : extensions) {
    check("missing" + extension);
    fs::create_directory(folder / ("folder" + extension));
    check("folder" + extension);
  }
}

Arguments renderMesh(const fs::path& path, const TemporaryFolder&) {
  return {"render", "--mesh", path};
}

Arguments renderLight(const fs::path& path, const TemporaryFolder& folder) {
  writeFile(folder / "plane.json", R"({"receiver": {}})");
  return {"render", folder / "plane.json", "--light", path};
}

Arguments renderScene(const fs::path& path, const TemporaryFolder&) {
  return {"render", path};
}

/// A scene that uses a sphere set.
Arguments renderSet(const fs::path& path, const TemporaryFolder& folder) {
  const std::string object = R"({"mesh": "builtin:sphere", "spheres": ")" + path.string() + "\"}";
  writeFile(folder / "scene.json", scene(object));
  return {"render", folder / "scene.json"};
}

}  // namespace

TEST_CASE("mesh files that cannot be used are refused") {
  const std::vector<std::string> extensions{".obj", ".ply", ".off", ".stl"};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::string corner = "v 0 0 0\nv 1 0 0\n", plyCorner = "0 0 0\n1 0 0\n";
  checkFilesRefused(
      withGeneralFaults(extensions, {{"cut.obj", corner + "v 0 1"},
                                     {"cut-vertices.obj", corner + "f 1 2 3\n"},
                                     {"nan.obj", corner + "v 0 nan 0\nf 1 2 3\n"},
                                     {"huge.obj", corner + "v 0 1e30 0\nf 1 2 3\n"},
                                     {"no-triangle.obj", corner},
                                     {"no-area.obj", corner + "v 2 0 0\nf 1 2 3\n"},
                                     {"cut.ply", ply(plyCorner, "")},
                                     {"nan.ply", ply(plyCorner + "0 nan 0\n", "3 0 1 2\n")},
                                     {"index.ply", ply(plyCorner + "0 1 0\n", "3 0 1 7\n")},
                                     {"cut.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n"},
                                     {"nan.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"},
                                     {"cut.stl", stl(2, 1)},
                                     {"count.stl", stl(0xffffffff, 1)},
                                     {"nan.stl", stl(1, nan)},
                                     {"mesh.gltf", "{}"}}),
      extensions, renderMesh);
}

TEST_CASE("lights that cannot be used are refused") {
  const TemporaryFolder folder;
  const std::vector<std::string> extensions{".hdr", ".exr"};
  const std::string whole = exr(1, folder);
  checkFilesRefused(
      withGeneralFaults(extensions, {{"cut.hdr", hdr("", "-Y 16 +X 32", 5)},
                                     {"cut-header.hdr", "#?RADIANCE\nFORM"},
                                     {"nan.hdr", hdr("EXPOSURE=nan\n", "-Y 2 +X 4", 8)},
                                     {"huge.hdr", hdr("", "-Y 60000 +X 60000", 5)},
                                     {"cut.exr", whole.substr(0, whole.size() / 2)},
                                     {"cut-pixels.exr", whole.substr(0, whole.size() - 10)},
                                     {"nan.exr", exr(NAN, folder)},
                                     {"infinite.exr", exr(INFINITY, folder)}}),
      extensions, renderLight);
}

TEST_CASE("a light in no known layout is refused as a light, but it is an image") {
  const TemporaryFolder folder;
  writeFile(folder / "strip.hdr", hdr("", "-Y 2 +X 5", 10));
  checkRefused(joined(renderLight(folder / "strip.hdr", folder), {"-o", folder / "x.png"}),
               "strip.hdr");
  CHECK(contains(resultsOf({"info", folder / "strip.hdr"}).at("as_light"), "no"));
}

TEST_CASE("scene files that cannot be used are refused") {
  const std::string whole = scene(R"({"mesh": "builtin:sphere", "spheres": 1})");
  checkFilesRefused(
      withGeneralFaults({".json"},
                        {{"cut.json", whole.substr(0, whole.size() / 2)},
                         {"nan.json", R"({"receiver": {"center": [NaN, 0, 0]}})"},
                         {"array.json", "[]"},
                         {"nothing.json", "{}"},
                         {"field.json", scene(R"({"mesh": "builtin:sphere", "albdo": 1})")},
                         {"type.json", scene(R"({"mesh": 7})")},
                         {"range.json", scene(R"({"mesh": "builtin:sphere", "spheres": 0})")},
                         {"deep.json", std::string(100000, '[')}}),
      {".json"}, renderScene);
}

TEST_CASE("a wrong field of a scene is named") {
  const TemporaryFolder folder;
  writeFile(folder / "scene.json", scene(R"({"mesh": "builtin:sphere", "albdo": 1})"));
  checkRefused({"render", folder / "scene.json", "-o", folder / "x.png"},
               "objects[0]: unknown field 'albdo'; did you mean 'albedo'?");
  writeFile(folder / "scene.json", scene(R"({"mesh": "missing.obj"})"));
  checkRefused({"render", folder / "scene.json", "-o", folder / "x.png"}, folder / "missing.obj");
}

TEST_CASE("sphere sets that cannot be used are refused") {
  const std::string whole = oneSphere("1");
  checkFilesRefused(
      withGeneralFaults({".set.json"}, {{"cut.set.json", whole.substr(0, whole.size() / 2)},
                                        {"nan.set.json", oneSphere("NaN")},
                                        {"infinite.set.json", oneSphere("1e999")},
                                        {"huge.set.json", oneSphere("1e39")},
                                        {"negative.set.json", oneSphere("-1")},
                                        {"zero.set.json", oneSphere("0")},
                                        {"text.set.json", oneSphere("\"1\"")},
                                        {"none.set.json", sphereSet("[]")}}),
      {".set.json"}, renderSet);
}

TEST_CASE("names that no file system takes are refused") {
  const std::string name(300, 'a');
  checkRefused({"info", name}, name);
  for (const char* extension : {".obj", ".hdr", ".json", ".unknown"})
    checkRefused({"info", name + extension}, name);
}

TEST_CASE("a cache folder that cannot be used does no harm") {
  const TemporaryFolder folder;
  for (const std::string cache : {"/proc/none", "/dev/null"}) {
    CAPTURE(cache);
    Surroundings surroundings;
    surroundings.environment["HAARLIGHT_CACHE_DIR"] = cache;
    const Outcome outcome =
        runHaarlight({"render", "--mesh", "builtin:sphere", "--spheres", "1", "--size", "4x4",
                      "--samples", "1", "--engine", "reference", "-o", folder / "x.png"},
                     surroundings);
    CHECK(outcome.exitCode == 0);
  }
}
