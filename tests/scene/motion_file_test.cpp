#include <string>

#include "base/error.h"
#include "scene/keyframes.h"
#include "scene/scene_file.h"
#include "test_support.h"

using namespace haarlight;

namespace {

const std::string movingScene = R"({
  "objects": [
    {
      "mesh": "walk.obj",
      "deformation": {
        "pointCache": "walk.pc2", "framesPerSecond": 30, "startSeconds": -1.5, "speed": 0.5,
        "repeat": "pingpong",
        "twist": { "axis": "x", "keys": [{ "seconds": 0, "degrees": -720, "ease": "hold" }] },
        "bend": { "axis": "z", "towards": "y", "keys": [{ "seconds": 0.5 }, { "seconds": 2 }] }
      },
      "motion": {
        "keys": [
          { "seconds": 0, "translate": [1, 2, 3], "rotation": [0, 0, 3, 4], "scale": 0.5,
            "ease": "smooth" },
          { "seconds": 1 }
        ],
        "repeat": "loop"
      }
    },
    { "mesh": "a.obj", "deformation": { "sequence": "../frames/a_%04d.obj" } },
    { "mesh": "fox.GLB", "deformation": { "animation": "Run" } }
  ],
  "light": {
    "motion": {
      "keys": [
        { "seconds": 0, "rotateDegrees": 36000, "scale": 0.25, "ease": "hold" },
        { "seconds": 3, "source": "sky.hdr", "layout": "angular" }
      ],
      "repeat": "pingpong"
    }
  },
  "camera": {
    "motion": { "keys": [{ "seconds": 0.25, "position": [1, 2, 3] },
                         { "seconds": 0.5, "target": [0, 1, 0], "ease": "smooth" }] }
  },
  "animation": { "firstFrame": 10, "lastFrame": 20, "framesPerSecond": 29.97 }
})";

/// What parseScene complains about; empty when it does not.
std::string complaint(const std::string& text) {
  try {
    parseScene(text, "scene.json");
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string complaintAboutObject(const std::string& fields, const std::string& mesh = "a.obj") {
  return complaint(R"({"objects": [{"mesh": ")" + mesh + "\", " + fields + "}]}");
}

std::string complaintAboutDeformation(const std::string& fields) {
  return complaintAboutObject(R"("deformation": {)" + fields + "}");
}

std::string complaintBesideReceiver(const std::string& fields) {
  return complaint(R"({"receiver": {}, )" + fields + "}");
}

}  // namespace

TEST_CASE("every field of a deformation reaches the description") {
  const SceneDescription scene = parseScene(movingScene, "scenes/moving.json");
  const DeformationDescription& walk = *scene.objects.at(0).deformation;
  CHECK(walk.pointCache == "scenes/walk.pc2");
  CHECK_FALSE(walk.sequence);
  CHECK_FALSE(walk.animation);
  CHECK(walk.framesPerSecond == 30);
  CHECK(walk.playback.startSeconds == -1.5);
  CHECK(walk.playback.speed == 0.5);
  CHECK(walk.playback.repeat == Repeat::pingpong);
  CHECK(walk.twist->axis == Axis::x);
  REQUIRE(walk.twist->keys.size() == 1);
  CHECK(walk.twist->keys[0].degrees == -720);
  CHECK(walk.twist->keys[0].ease == Ease::hold);
  CHECK(walk.bend->axis == Axis::z);
  CHECK(walk.bend->towards == Axis::y);
  REQUIRE(walk.bend->keys.size() == 2);
  CHECK(walk.bend->keys[1].seconds == 2);
  CHECK(walk.bend->keys[1].degrees == 0);
  CHECK(walk.bend->keys[1].ease == Ease::linear);
  CHECK(scene.objects.at(1).deformation->sequence == "frames/a_%04d.obj");
  CHECK(scene.objects.at(2).deformation->animation == "Run");
  CHECK_FALSE(scene.objects.at(2).deformation->framesPerSecond);
  CHECK_FALSE(scene.objects.at(2).motion);
}

TEST_CASE("every field of the other motions reaches the description") {
  const SceneDescription scene = parseScene(movingScene, "scenes/moving.json");
  const MotionDescription& motion = *scene.objects.at(0).motion;
  REQUIRE(motion.keys.size() == 2);
  CHECK(motion.keys[0].translate == glm::dvec3(1, 2, 3));
  CHECK(motion.keys[0].rotation == glm::dvec4(0, 0, 3, 4));
  CHECK(motion.keys[0].scale == 0.5);
  CHECK(motion.keys[0].ease == Ease::smooth);
  CHECK(motion.keys[1].seconds == 1);
  CHECK(motion.keys[1].rotation == glm::dvec4(0, 0, 0, 1));
  CHECK(motion.repeat == Repeat::loop);
  const LightMotionDescription& light = *scene.light.motion;
  REQUIRE(light.keys.size() == 2);
  CHECK(light.keys[0].rotateDegrees == 36000);
  CHECK(light.keys[0].scale == 0.25);
  CHECK(light.keys[0].ease == Ease::hold);
  CHECK_FALSE(light.keys[0].source);
  CHECK(light.keys[1].source == "scenes/sky.hdr");
  CHECK(light.keys[1].layout == "angular");
  CHECK(light.repeat == Repeat::pingpong);
  const CameraMotionDescription& camera = *scene.camera.motion;
  REQUIRE(camera.keys.size() == 2);
  CHECK(camera.keys[0].position == glm::dvec3(1, 2, 3));
  CHECK_FALSE(camera.keys[0].target);
  CHECK(camera.keys[1].target == glm::dvec3(0, 1, 0));
  CHECK(camera.keys[1].ease == Ease::smooth);
  CHECK(scene.animation.firstFrame == 10);
  CHECK(scene.animation.lastFrame == 20);
  CHECK(scene.animation.framesPerSecond == 29.97);
}

TEST_CASE("a scene without motion stands still") {
  const SceneDescription scene = parseScene(R"({"objects": [{"mesh": "a.obj"}]})", "x.json");
  CHECK_FALSE(scene.objects.at(0).deformation);
  CHECK_FALSE(scene.objects.at(0).motion);
  CHECK_FALSE(scene.light.motion);
  CHECK_FALSE(scene.camera.motion);
  CHECK(scene.animation.firstFrame == 0);
  CHECK(scene.animation.lastFrame == 0);
  CHECK(scene.animation.framesPerSecond == 24);
}

TEST_CASE("a moving scene that is written and read again is the same") {
  const std::string once = sceneToJson(parseScene(movingScene, "moving.json"));
  CHECK(sceneToJson(parseScene(once, "again.json")) == once);
}

TEST_CASE("a bend curves towards the next axis unless it says another") {
  CHECK(bendDirection({Axis::x, {}, {}}) == Axis::y);
  CHECK(bendDirection({Axis::y, {}, {}}) == Axis::z);
  CHECK(bendDirection({Axis::z, {}, {}}) == Axis::x);
  CHECK(bendDirection({Axis::z, Axis::y, {}}) == Axis::y);
}

TEST_CASE("keys must be there, be few enough, and come one after the other") {
  const std::string place = "scene.json: objects[0].motion";
  CHECK(complaintAboutObject(R"("motion": {})") == place + ": field 'keys' is missing");
  CHECK(complaintAboutObject(R"("motion": {"keys": []})") == place + ".keys: must not be empty");
  CHECK(complaintAboutObject(R"("motion": {"keys": [{"scale": 2}]})") ==
        place + ".keys[0]: field 'seconds' is missing");
  CHECK(complaintAboutObject(R"("motion": {"keys": [{"seconds": -1}]})") ==
        place + ".keys[0].seconds: must be >= 0, is -1");
  for (const std::string seconds : {"0.5", "2"})
    CHECK(complaintAboutObject(R"("motion": {"keys": [{"seconds": 0}, {"seconds": 2},
                                                      {"seconds": )" +
                               seconds + "}]}") ==
          place + ".keys[2].seconds: must be > 2, those of the key before, is " +
              (seconds == "2" ? "2" : "0.5"));
  CHECK(complaintAboutDeformation(R"("twist": {"keys": [{"seconds": 1}, {"seconds": 1}]})") ==
        "scene.json: objects[0].deformation.twist.keys[1].seconds: must be > 1, those of the key "
        "before, is 1");
  std::string keys = R"({"seconds": 0})";
  for (int i = 1; i <= 65536; ++i) keys += R"(,{"seconds":)" + std::to_string(i) + "}";
  CHECK(complaintBesideReceiver(R"("camera": {"motion": {"keys": [)" + keys + "]}}") ==
        "scene.json: camera.motion.keys: must be an array of at most 65536, is an array of 65537");
}

TEST_CASE("a mesh has one source of deformation") {
  const std::string expected =
      "scene.json: objects[0].deformation: give at most one of pointCache, sequence and animation";
  CHECK(complaintAboutDeformation(R"("pointCache": "a.pc2", "sequence": "a%d.obj")") == expected);
  CHECK(complaintAboutObject(R"("deformation": {"pointCache": "a.pc2", "animation": "none"})",
                             "a.glb") == expected);
  CHECK(complaintAboutObject(R"("deformation": {"sequence": "a%d.obj", "animation": "0"})",
                             "a.glb") == expected);
}

TEST_CASE("only glTF files have animations") {
  const std::string animation = R"("deformation": {"animation": "0"})";
  const std::string expected =
      "scene.json: objects[0].deformation.animation: only meshes from .gltf and .glb files have "
      "animations";
  for (const char* mesh : {"a.obj", "builtin:sphere", "gltf", "a.glb.ply"})
    CHECK(complaintAboutObject(animation, mesh) == expected);
  for (const char* mesh : {"a.gltf", "b/a.glb", "A.GLTF", "a.Glb"})
    CHECK(complaintAboutObject(animation, mesh).empty());
}

TEST_CASE("a sequence has one number in its files' name") {
  const auto sequence = [](const std::string& pattern) {
    return complaintAboutDeformation(R"("sequence": ")" + pattern + '"');
  };
  for (const std::string pattern : {"a.obj", "a%.obj", "a%s.obj", "a%0d.obj", "a%010d.obj",
                                    "a%4d.obj", "a%d%d.obj", "a%%d.obj", "%d/a.obj", "a%d.obj/"})
    CHECK(sequence(pattern) ==
          "scene.json: objects[0].deformation.sequence: must be a file's name with one %d or "
          "%0Nd, such as walk_%04d.obj, is \"" +
              pattern + '"');
  for (const std::string pattern : {"a%d.obj", "%09d.ply", "100%/a_%04d.obj"})
    CHECK(sequence(pattern).empty());
}

TEST_CASE("bends towards their own axis are refused") {
  const auto bend = [](const std::string& axes) {
    return complaintAboutDeformation(R"("bend": {"keys": [{"seconds": 0}], )" + axes + "}");
  };
  const std::string place = "scene.json: objects[0].deformation.bend.towards: ";
  CHECK(bend(R"("axis": "x", "towards": "x")") == place + "must not be the bend's axis, is \"x\"");
  CHECK(bend(R"("towards": "y")") == place + "must not be the bend's axis, is \"y\"");
  CHECK(bend(R"("towards": "w")") == place + "must be one of x, y, z, is \"w\"");
  CHECK(bend(R"("axis": "x", "towards": "z")").empty());
}

TEST_CASE("rotations of length zero are refused") {
  const auto rotation = [](const std::string& numbers) {
    return complaintAboutObject(R"("motion": {"keys": [{"seconds": 0, "rotation": [)" + numbers +
                                "]}]}");
  };
  CHECK(rotation("0, 0, 0, 0") ==
        "scene.json: objects[0].motion.keys[0].rotation: must not be zero");
  CHECK(rotation("0, 0, 1") ==
        "scene.json: objects[0].motion.keys[0].rotation: must be an array of 4 numbers, is an "
        "array of 3");
  CHECK(rotation("0, 0, 1e-300, 0").empty());
}

TEST_CASE("a layout of a light's key needs a source") {
  CHECK(complaintBesideReceiver(
            R"("light": {"motion": {"keys": [{"seconds": 0, "layout": "angular"}]}})") ==
        "scene.json: light.motion.keys[0].layout: needs a source beside it");
}

TEST_CASE("cameras that see nothing at a key are refused") {
  CHECK(complaintBesideReceiver(R"("camera": {"target": [1, 2, 3], "motion": {"keys": [
            {"seconds": 0}, {"seconds": 1, "position": [1, 2, 3]}]}})") ==
        "scene.json: camera.motion.keys[1]: target must differ from the position");
  CHECK(complaintBesideReceiver(R"("camera": {"motion": {"keys": [
            {"seconds": 0, "position": [0, 9, 0], "target": [0, 0, 0]}]}})") ==
        "scene.json: camera.motion.keys[0]: up must not be zero or parallel to the line from "
        "position to target");
}

TEST_CASE("frames run forwards") {
  CHECK(complaintBesideReceiver(R"("animation": {"firstFrame": 5, "lastFrame": 4})") ==
        "scene.json: animation.lastFrame: must be >= firstFrame (5), is 4");
  CHECK(complaintBesideReceiver(R"("animation": {"firstFrame": 5, "lastFrame": 5})").empty());
  CHECK(complaintBesideReceiver(R"("animation": {"framesPerSecond": 0})") ==
        "scene.json: animation.framesPerSecond: must be >= 0.001, is 0");
}

TEST_CASE("the built-in animation twists and returns, and the light turns once") {
  const SceneDescription scene = readScene("builtin:twist");
  const DeformationDescription& knot = *scene.objects.at(0).deformation;
  const auto degrees = [&](int frame) {
    return degreesAt(knot.twist->keys, knot.playback, frameSeconds(scene.animation, frame));
  };
  CHECK(degrees(0) == 0);
  CHECK(degrees(48) == 90);
  CHECK(degrees(96) == 0);
  CHECK(degrees(24) == 45);
  CHECK(degrees(72) == 45);
  CHECK(lightAt(scene.light, frameSeconds(scene.animation, 24)).rotateDegrees ==
        scene.light.rotateDegrees + 90);
  CHECK(scene.animation.lastFrame == 95);
}
