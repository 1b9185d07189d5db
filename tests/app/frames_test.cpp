#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <glm/vec3.hpp>

#include "image/frame_files.h"
#include "run_haarlight.h"
#include "scene/frame_pattern.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// A ball that moves over a plane while the light turns, in frames of 32×18 pixels.
const char* const movingBall = R"({
  "objects": [{
    "mesh": "builtin:sphere", "spheres": 1,
    "transform": {"scale": 0.5, "rest": "ground"},
    "motion": {"keys": [{"seconds": 0}, {"seconds": 1, "translate": [2, 1, 0]}]}
  }],
  "receiver": {},
  "light": {"motion": {"keys": [{"seconds": 0}, {"seconds": 1, "rotateDegrees": 90}]}},
  "image": {"width": 32, "height": 18, "samplesPerPixel": 1},
  "shading": {"engine": "reference"},
  "animation": {"lastFrame": 5, "framesPerSecond": 8}
})";

struct Animation {
  TemporaryFolder folder;
  std::string scene = folder / "scene.json";

  explicit Animation(const std::string& text = movingBall) { writeFile(scene, text); }

  Arguments render(const Arguments& more) const {
    return joined({"render", scene, "--quiet"}, more);
  }
  std::string frame(const std::string& name, int number) const {
    return readFile(FramePattern(folder / name).path(number));
  }
};

/// A .pc2 cache of `frames` times the same positions; the frame `damaged` has a NaN.
std::string pointCache(const std::vector<glm::vec3>& positions, int frames, int damaged) {
  std::string bytes("POINTCACHE2\0", 12);
  const auto append = [&](auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(std::int32_t(1));
  append(std::int32_t(positions.size()));
  append(0.0f);
  append(1.0f);
  append(std::int32_t(frames));
  for (int frame = 0; frame < frames; ++frame)
    for (std::size_t i = 0; i < positions.size(); ++i)
      append(frame == damaged && i == 2 ? glm::vec3(NAN) : positions[i]);
  return bytes;
}

const char* const tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const std::vector<glm::vec3> tetrahedronPositions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

const char* const cachedTetrahedron = R"({
  "objects": [{"mesh": "t.obj", "spheres": 1, "deformation": {"pointCache": "t.pc2"}}],
  "receiver": {}, "image": {"width": 16, "height": 9, "samplesPerPixel": 1},
  "shading": {"engine": "reference"}, "animation": {"lastFrame": 3}
})";

}  // namespace

TEST_CASE("sequences, single, resumed and reordered frames have the same bits") {
  const Animation animation;
  const auto all = resultsOf(animation.render(
      {"-o", animation.folder / "all_%02d.exr", "-o", animation.folder / "all_%02d.png"}));
  CHECK(all.at("frames_rendered") == 6);
  CHECK(all.at("frames").size() == 6);
  CHECK(all.at("frames")[3].at("seconds").at("total") > 0);

  for (const int frame : {5, 2})
    resultsOf(animation.render({"--frames", std::to_string(frame), "-o",
                                animation.folder / "one_%02d.exr", "-o",
                                animation.folder / "one_%02d.png"}));
  const auto rest = resultsOf(animation.render({"--resume", "-o", animation.folder / "one_%02d.exr",
                                                "-o", animation.folder / "one_%02d.png"}));
  CHECK(rest.at("frames_rendered") == 4);
  CHECK(rest.at("frames_skipped") == 2);
  for (int frame = 0; frame < 6; ++frame) {
    CHECK(animation.frame("one_%02d.exr", frame) == animation.frame("all_%02d.exr", frame));
    CHECK(animation.frame("one_%02d.png", frame) == animation.frame("all_%02d.png", frame));
  }
  CHECK(animation.frame("all_%02d.exr", 0) != animation.frame("all_%02d.exr", 1));
}

TEST_CASE("frames show seconds: half as many a second are every other frame") {
  const Animation animation;
  resultsOf(animation.render({"-o", animation.folder / "a_%d.png"}));
  resultsOf(
      animation.render({"--frames", "0:2", "--fps", "4", "-o", animation.folder / "b_%d.png"}));
  for (int frame = 0; frame < 3; ++frame)
    CHECK(animation.frame("b_%d.png", frame) == animation.frame("a_%d.png", 2 * frame));
}

TEST_CASE("a still shows second 0, through the camera of that second") {
  std::string moving = movingBall;
  moving.insert(moving.find("\"image\""),
                R"("camera": {"motion": {"keys": [{"seconds": 0, "position": [4, 3, 4]}]}}, )");
  const Animation animation(moving);
  resultsOf(animation.render({"--exposure", "0", "-o", animation.folder / "still.png"}));
  resultsOf(
      animation.render({"--exposure", "0", "--frames", "0", "-o", animation.folder / "frame.png"}));
  CHECK(readFile(animation.folder / "still.png") == readFile(animation.folder / "frame.png"));
}

TEST_CASE("a damaged frame, or one of another size, is rendered again") {
  const Animation animation;
  const Arguments render = animation.render({"--resume", "-o", animation.folder / "f_%d.png"});
  resultsOf(render);
  const std::string whole = animation.frame("f_%d.png", 3);
  writeFile(animation.folder / "f_3.png", whole.substr(0, whole.size() / 2));
  const auto again = resultsOf(render);
  CHECK(again.at("frames_rendered") == 1);
  CHECK(animation.frame("f_%d.png", 3) == whole);
  CHECK(resultsOf(joined(render, {"--size", "16x9"})).at("frames_rendered") == 6);
}

TEST_CASE("Ctrl-C ends after the current frame, and what is there is whole") {
  const Animation animation;
  Surroundings interrupted;
  interrupted.interruptAfter = animation.folder / "f_2.png";
  const auto results = resultsOf(
      animation.render({"--frames", "0:5000", "-o", animation.folder / "f_%d.png"}), interrupted);
  CHECK(results.at("interrupted") == true);
  const int rendered = results.at("frames_rendered");
  CHECK(rendered >= 3);
  CHECK(rendered < 5001);
  for (int frame = 0; frame < rendered; ++frame)
    CHECK(isCompleteFrame(animation.folder / fmt::format("f_{}.png", frame), 32, 18));
  CHECK_FALSE(std::filesystem::exists(animation.folder / fmt::format("f_{}.png", rendered)));
}

TEST_CASE("a cache that is damaged in the middle stops there and leaves the frames before it") {
  const Animation animation(cachedTetrahedron);
  writeFile(animation.folder / "t.obj", tetrahedron);
  writeFile(animation.folder / "t.pc2", pointCache(tetrahedronPositions, 4, 2));
  checkRefused(animation.render({"-o", animation.folder / "f_%d.png"}), "t.pc2");
  for (const int frame : {0, 1})
    CHECK(isCompleteFrame(animation.folder / fmt::format("f_{}.png", frame), 16, 9));
  CHECK_FALSE(std::filesystem::exists(animation.folder / "f_2.png"));
}

TEST_CASE("caches and sequences that do not fit the mesh are refused") {
  const Animation animation(cachedTetrahedron);
  writeFile(animation.folder / "t.obj", tetrahedron);
  const Arguments render = animation.render({"-o", animation.folder / "f_%d.png"});
  checkRefused(render, "t.pc2");  // missing
  const std::string bytes = pointCache(tetrahedronPositions, 4, -1);
  writeFile(animation.folder / "t.pc2", bytes.substr(0, bytes.size() - 5));
  checkRefused(render, "t.pc2");
  writeFile(animation.folder / "t.pc2", pointCache({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 4, -1));
  checkRefused(render, "t.pc2");

  std::string sequence = cachedTetrahedron;
  sequence.replace(sequence.find("\"pointCache\": \"t.pc2\""), 21, "\"sequence\": \"t_%d.obj\"");
  writeFile(animation.scene, sequence);
  writeFile(animation.folder / "t_0.obj", tetrahedron);
  writeFile(animation.folder / "t_2.obj", tetrahedron);
  checkRefused(render, "t_1.obj");
}

TEST_CASE("names that do not suit frames are refused before any work") {
  const Animation animation;
  checkRefused(animation.render({"--frames", "0:3", "-o", animation.folder / "f.png"}),
               "frame_%04d.png");
  checkRefused(animation.render({"-o", animation.folder / "f_%s.png"}), "%");
  checkRefused(animation.render({"--frames", "3:1", "-o", animation.folder / "f_%d.png"}), "3:1");
  checkRefused(animation.render({"--frames", "-1:1", "-o", animation.folder / "f_%d.png"}),
               "--frames");
  checkRefused(animation.render({"-o", animation.folder / "no/f_%d.png"}), "no");
  checkRefused(animation.render({"--compare-to", "pixel", "-o", animation.folder / "f_%d.png"}),
               "--compare-to");
  checkRefused(animation.render({"--resume", "-o", animation.folder / "clip.mp4"}), "clip.mp4");
  checkRefused(animation.render({"-o", animation.folder / "clip.mp4"}), "ffmpeg",
               {{{"PATH", "/nowhere"}}, {}, false, {}, {}});
  CHECK_FALSE(std::filesystem::exists(animation.folder / "f_0.png"));
}

TEST_CASE("memory does not grow with the number of frames") {
  std::string still = movingBall;  // its light, whose tables would take most of the time
  still.replace(still.find("\"rotateDegrees\": 90"), 19, "\"rotateDegrees\": 0");
  const Animation animation(still);
  const auto peak = [&](const std::string& frames) {
    return resultsOf(animation.render({"--size", "8x4", "--frames", frames, "-o",
                                       animation.folder / "f_%d.png"}))
        .at("peak_memory_mib")
        .get<double>();
  };
  const double few = peak("0:20"), many = peak("0:999");
  MESSAGE("peak memory after 21 and 1,000 frames, MiB: ", few, ", ", many);
  CHECK(many < few + 8);
}
