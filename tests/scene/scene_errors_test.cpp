#include <string>

#include "error_text.h"
#include "scene/scene_file.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// What parseScene complains about; empty when it does not.
std::string complaint(const std::string& text) {
  return inputErrorOf([&] { parseScene(text, "scene.json"); });
}

std::string complaintAboutObject(const std::string& fields) {
  return complaint(R"({"objects": [{"mesh": "a.obj", )" + fields + "}]}");
}

std::string complaintBesideReceiver(const std::string& fields) {
  return complaint(R"({"receiver": {}, )" + fields + "}");
}

}  // namespace

TEST_CASE("numbers out of range name their field") {
  CHECK(complaint(R"({"objects": [{"mesh": "a"}, {"mesh": "b"},
                      {"mesh": "c", "transform": {"scale": -1}}]})") ==
        "scene.json: objects[2].transform.scale: must be >= 1e-06, is -1");
  CHECK(complaintAboutObject(R"("albedo": [0, 0, 1.5])") ==
        "scene.json: objects[0].albedo[2]: must be <= 1, is 1.5");
  CHECK(complaintAboutObject(R"("spheres": 0)") ==
        "scene.json: objects[0].spheres: must be >= 1, is 0");
  CHECK(complaintBesideReceiver(R"("shading": {"terms": 6145})") ==
        "scene.json: shading.terms: must be <= 6144, is 6145");
  CHECK(complaintBesideReceiver(R"("image": {"width": 99999999999999999999})") ==
        "scene.json: image.width: must be <= 65536, is 1e+20");
  CHECK(complaintBesideReceiver(R"("camera": {"position": [0, 1e300, 0]})") ==
        "scene.json: camera.position[1]: must be <= 1000000, is 1e+300");
  CHECK(complaintBesideReceiver(R"("version": 2)") == "scene.json: version: must be 1, is 2");
}

TEST_CASE("suns that stand nowhere are refused with their place") {
  const auto aboutSky = [](const std::string& fields) {
    return complaintBesideReceiver(R"("light": {"source": "builtin:iso-sky-7", "sky": {)" + fields +
                                   "}}");
  };
  CHECK(aboutSky(R"("sunElevationDegrees": 90, "sunDisc": 1, "zenithRadiance": "auto")") == "");
  CHECK(aboutSky(R"("sunElevationDegrees": -5)") ==
        "scene.json: light.sky.sunElevationDegrees: must be >= 0, is -5");
  CHECK(aboutSky(R"("sunElevationDegrees": 91)") ==
        "scene.json: light.sky.sunElevationDegrees: must be <= 90, is 91");
  CHECK(aboutSky(R"("sunAzimuthDegrees": 361)") ==
        "scene.json: light.sky.sunAzimuthDegrees: must be <= 360, is 361");
  CHECK(aboutSky(R"("sunAzimuthDegrees": "NaN")") ==
        "scene.json: light.sky.sunAzimuthDegrees: must be a number, is \"NaN\"");
  CHECK(aboutSky(R"("zenithRadiance": "bright")") ==
        "scene.json: light.sky.zenithRadiance: must be a number or \"auto\", is \"bright\"");
  CHECK(aboutSky(R"("groundAlbedo": [0.1, 0.1, 1.1])") ==
        "scene.json: light.sky.groundAlbedo[2]: must be <= 1, is 1.1");
  CHECK(aboutSky(R"("sunElevationDegree": 5)") ==
        "scene.json: light.sky: unknown field 'sunElevationDegree'; did you mean "
        "'sunElevationDegrees'?");
  CHECK(complaintBesideReceiver(R"("light": {"motion": {"keys": [
          {"seconds": 0, "sunElevationDegrees": -1}]}})") ==
        "scene.json: light.motion.keys[0].sunElevationDegrees: must be >= 0, is -1");
  CHECK(complaintBesideReceiver(R"("light": {"source": "builtin:iso-sky-16"})")
            .starts_with("scene.json: light.source: must be a path or one of builtin:lamps, "));
}

TEST_CASE("fractions are refused where whole numbers are asked for") {
  for (const char* order : {"0", "21"})
    CHECK(complaintBesideReceiver(std::string(R"("shading": {"order": )") + order + "}")
              .starts_with("scene.json: shading.order: must be "));
  CHECK(complaintBesideReceiver(R"("shading": {"terms": 10.5})") ==
        "scene.json: shading.terms: must be a whole number, is 10.5");
}

TEST_CASE("wrong types name what is asked for and what is there") {
  CHECK(complaint("[1, 2]") == "scene.json: must be an object {...}, is an array of 2");
  CHECK(complaint("null") == "scene.json: must be an object {...}, is null");
  CHECK(complaint(R"({"objects": {}})") ==
        "scene.json: objects: must be an array [...], is an object");
  CHECK(complaint(R"({"objects": [7]})") ==
        "scene.json: objects[0]: must be an object {...}, is 7");
  CHECK(complaint(R"({"objects": [{"mesh": 5}]})") ==
        "scene.json: objects[0].mesh: must be text in quotes, is 5");
  CHECK(complaintAboutObject(R"("castsShadow": 1)") ==
        "scene.json: objects[0].castsShadow: must be true or false, is 1");
  CHECK(complaintAboutObject(R"("spheres": [])") ==
        "scene.json: objects[0].spheres: must be a number or the path of a file, is an array of 0");
  CHECK(complaintBesideReceiver(R"("light": {"scale": "NaN"})") ==
        "scene.json: light.scale: must be a number, is \"NaN\"");
  CHECK(complaintBesideReceiver(R"("image": {"exposure": "dark"})") ==
        "scene.json: image.exposure: must be a number or \"auto\", is \"dark\"");
  CHECK(complaintBesideReceiver(R"("image": {"background": 0.5})") ==
        "scene.json: image.background: must be an array of 3 numbers or \"light\", is 0.5");
}

TEST_CASE("arrays of the wrong length are refused") {
  CHECK(complaintAboutObject(R"("albedo": [0, 0])") ==
        "scene.json: objects[0].albedo: must be an array of 3 numbers, is an array of 2");
  CHECK(complaint(R"({"receiver": {"samples": [1, 2, 3]}})") ==
        "scene.json: receiver.samples: must be an array of 2 numbers, is an array of 3");
  std::string objects = R"({"mesh": "a"})";
  for (int i = 0; i < 1024; ++i) objects += R"(, {"mesh": "a"})";
  CHECK(complaint(R"({"objects": [)" + objects + "]}") ==
        "scene.json: objects: must be an array of at most 1024, is an array of 1025");
}

TEST_CASE("words that are no choice are answered with the choices") {
  CHECK(
      complaintBesideReceiver(R"("shading": {"method": "harr"})") ==
      "scene.json: shading.method: must be one of haar, pixel, pixel-mesh, shexp, sh, is \"harr\"");
  CHECK(complaintBesideReceiver(R"("light": {"layout": 3})") ==
        "scene.json: light.layout: must be one of auto, latlong, vcross, hcross, angular, is 3");
  CHECK(complaint(R"({"objects": [{"mesh": "builtin:cube"}]})") ==
        "scene.json: objects[0].mesh: must be a path or one of builtin:sphere, builtin:torusknot, "
        "is \"builtin:cube\"");
  CHECK(complaintAboutObject(R"("spheres": "builtin:cube")") ==
        "scene.json: objects[0].spheres: must be the path of a file, is \"builtin:cube\"");
}

TEST_CASE("unknown fields are answered with the nearest known one") {
  CHECK(complaintAboutObject(R"("albdo": [1, 1, 1])") ==
        "scene.json: objects[0]: unknown field 'albdo'; did you mean 'albedo'?");
  CHECK(complaintAboutObject(R"("transform": {"rotate": [0, 0, 0]})") ==
        "scene.json: objects[0].transform: unknown field 'rotate'; known are fit, scale, "
        "rotateDegrees, rest, translate");
  CHECK(complaintBesideReceiver(R"("Camera": {})") ==
        "scene.json: unknown field 'Camera'; did you mean 'camera'?");
  CHECK(complaintBesideReceiver(R"("image": {"heigth": 5})") ==
        "scene.json: image: unknown field 'heigth'; did you mean 'height'?");
  CHECK(complaintBesideReceiver("\"a\\nb\": 1").find("unknown field 'a\\nb'; known are") !=
        std::string::npos);
}

TEST_CASE("fields that must be there are missed") {
  CHECK(complaint(R"({"objects": [{"albedo": [1, 1, 1]}]})") ==
        "scene.json: objects[0]: give a mesh or a solid");
  CHECK(complaintBesideReceiver(R"("pointLights": [{"position": [0, 1, 0]}])") ==
        "scene.json: pointLights[0]: field 'intensity' is missing");
  CHECK(complaintBesideReceiver(R"("directionalLights": [{"irradiance": [1, 1, 1]}])") ==
        "scene.json: directionalLights[0]: field 'towards' is missing");
  CHECK(complaint("{}") == "scene.json: there is nothing to see; give objects or a receiver");
  CHECK(complaint(R"({"objects": []})") ==
        "scene.json: there is nothing to see; give objects or a receiver");
}

TEST_CASE("texts are short, printable and not empty") {
  CHECK(complaint(R"({"objects": [{"mesh": ""}]})") ==
        "scene.json: objects[0].mesh: must not be empty");
  CHECK(complaint(R"({"objects": [{"mesh": "a\u0000b"}]})") ==
        R"(scene.json: objects[0].mesh: must not hold control characters, is "a\u0000b")");
  CHECK(complaintAboutObject(R"("name": "two\nlines")") ==
        R"(scene.json: objects[0].name: must not hold control characters, is "two\nlines")");
  CHECK(complaintAboutObject(R"("name": ")" + std::string(1025, 'x') + '"') ==
        "scene.json: objects[0].name: must be at most 1024 characters");
}

TEST_CASE("images of too many pixels are refused") {
  CHECK(complaintBesideReceiver(R"("image": {"width": 40000, "height": 25000})") ==
        "scene.json: image: width x height must be <= 268435456 pixels, is 1000000000");
  CHECK(complaintBesideReceiver(R"("image": {"width": 16384, "height": 16384})").empty());
}

TEST_CASE("cameras that see nothing are refused") {
  CHECK(complaintBesideReceiver(R"("camera": {"position": [1, 2, 3], "target": [1, 2, 3]})") ==
        "scene.json: camera.target: must differ from the position");
  const std::string parallel =
      "scene.json: camera.up: must not be zero or parallel to the line from position to target";
  CHECK(complaintBesideReceiver(R"("camera": {"position": [0, 9, 0], "target": [0, 0, 0]})") ==
        parallel);
  CHECK(complaintBesideReceiver(R"("camera": {"up": [0, 0, 0]})") == parallel);
}

TEST_CASE("wrong syntax is answered with line and column") {
  CHECK(complaint("") ==
        "scene.json: line 1, column 1: unexpected end of input; expected '[', '{', or a literal");
  CHECK(complaint("{\"receiver\": {}\n") ==
        "scene.json: line 2, column 1: unexpected end of input; expected '}'");
  CHECK(complaint("{\"receiver\": {},\r\n \"version\": 1,\r\n}") ==
        "scene.json: line 3, column 1: unexpected '}'; expected string literal");
  CHECK(complaint("{\"receiver\": {}}\n}") ==
        "scene.json: line 2, column 1: unexpected '}'; expected end of input");
  CHECK(complaint("{\n  \"version\": 01\n}") ==
        "scene.json: line 2, column 15: unexpected number literal; expected '}'");
  CHECK(complaint("{\"light\": {\"scale\": NaN}}") ==
        "scene.json: line 1, column 21: invalid literal");
  CHECK(complaint("\xEF\xBB\xBF{]") ==
        "scene.json: line 1, column 2: unexpected ']'; expected string literal");
  CHECK(complaint("{\"version\":\n 1e999}") ==
        "scene.json: line 2, column 2: the number is too large");
  CHECK(complaint("{\"name\": \"\xFF\"}") ==
        "scene.json: line 1, column 11: invalid string: ill-formed UTF-8 byte");
}

TEST_CASE("comments are refused with words") {
  CHECK(complaint("{\n  // a plane\n  \"receiver\": {}}") ==
        "scene.json: line 2, column 3: JSON has no comments; remove it");
  CHECK(complaint("{\"receiver\": {}} # a plane") ==
        "scene.json: line 1, column 18: JSON has no comments; remove it");
}

TEST_CASE("a field that is given twice is refused") {
  CHECK(complaint(R"({"receiver": {}, "version": 1, "receiver": {}})") ==
        "scene.json: field \"receiver\" is given twice in one object");
}

TEST_CASE("deep nesting is refused before it is built") {
  const std::string expected = "scene.json: arrays and objects are nested more than 16 deep";
  CHECK(complaint(std::string(1000000, '[')) == expected);
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  CHECK(complaint(objects) == expected);
}

TEST_CASE("the time to read a file grows no faster than the file") {
  std::string objects = R"({"objects": [{})";
  for (int i = 0; i < 1'000'000; ++i) objects += ",{}";
  CHECK(complaint(objects + "]}") ==
        "scene.json: objects: must be an array of at most 1024, is an array of 1000001");
}

TEST_CASE("every cut and every changed byte of a scene ends in a scene or one line") {
  const std::string whole(builtinSceneText("builtin:default"));
  for (std::size_t length = 0; length < whole.rfind('}'); ++length)
    CHECK_FALSE(complaint(whole.substr(0, length)).empty());
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const char byte : {'\0', '"', '{', ']', '9', '-', '\x80', '\xFF'}) {
      std::string changed = whole;
      changed[at] = byte;
      const std::string message = complaint(changed);
      CHECK(message.find('\n') == std::string::npos);
      if (!message.empty()) CHECK(message.starts_with("scene.json: "));
    }
}

TEST_CASE("files that cannot be scenes are refused") {
  const TemporaryFolder folder;
  const auto failure = [](const std::filesystem::path& path) -> std::string {
    try {
      readScene(path);
      return {};
    } catch (const InputError& error) {
      return error.what();
    }
  };
  CHECK(failure(folder / "none.json") ==
        "cannot read scene " + (folder / "none.json").string() + ": No such file or directory");
  CHECK(failure(folder.path()) ==
        "cannot read scene " + folder.path().string() + ": it is a folder");
  const std::filesystem::path large = folder / "large.json";
  writeFile(large, "");
  std::filesystem::resize_file(large, 100'000'000);
  CHECK(failure(large) ==
        "cannot read scene " + large.string() + ": it is larger than 4194304 bytes");
  CHECK(failure("builtin:bunny") ==
        "unknown scene 'builtin:bunny'; built in are builtin:default, builtin:smooth, "
        "builtin:twist, builtin:lamp-knot, builtin:cone-and-sphere");
  CHECK(failure("/dev/zero") == "cannot read scene /dev/zero: it is a device");
}
