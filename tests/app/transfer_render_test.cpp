#include "image/compare.h"
#include "image/read_image.h"
#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// A ball over a plane of few samples.
std::string ballScene(const std::string& more = "", const std::string& ofLight = "") {
  return R"({"objects": [{"name": "ball", "mesh": "builtin:sphere", "spheres": 1,
      "transform": {"fit": 2, "rest": "ground"})" +
         more + R"(}], "receiver": {"size": [6, 6], "samples": [16, 16]},
      "light": {"source": "builtin:sky")" +
         ofLight + R"(}, "image": {"width": 48, "height": 27, "samplesPerPixel": 1}})";
}

struct Ball {
  explicit Ball(const std::string& more = "", const std::string& ofLight = "") {
    writeFile(scene, ballScene(more, ofLight));
  }
  Arguments render(const Arguments& more = {}) const {
    return joined({"render", scene, "--method", "sh", "-o", picture}, more);
  }
  std::vector<glm::vec3> pixels(const Arguments& more = {}) const {
    resultsOf(render(more));
    return readImage(picture).image.pixels;
  }
  Arguments prt(const Arguments& arguments) const {
    return joined(joined({"prt"}, arguments), {"-o", transfer, "--rays", "64"});
  }

  TemporaryFolder folder;
  std::filesystem::path scene = folder / "scene.json", picture = folder / "picture.exr",
                        transfer = folder / "ball.prt";
};

const Arguments onReference{"--engine", "reference"};

}  // namespace

TEST_CASE("sh renders a scene without more ado, the same on every engine") {
  const Ball ball;
  const auto results =
      resultsOf(ball.render({"--engine", "reference", "--compare-to", "pixel-mesh"}));
  CHECK(results.at("method") == "sh");
  CHECK(results.at("order") == 5);
  CHECK(results.at("per") == "vertex");
  CHECK(results.at("transfer_channels") == 1);
  CHECK(results.at("comparison").at(0).at("rmse_relative_to_mean_percent") < 2);
  for (const Arguments& more : {Arguments{}, {"--per", "pixel"}, {"--order", "2"}}) {
    const auto expected = ball.pixels(joined(onReference, more));
    for (const char* engine : {"auto", "cuda-host"})
      CHECK(ball.pixels(joined({"--engine", engine}, more)) == expected);
  }
}

TEST_CASE("a picture per pixel is one per vertex where nothing is below zero") {
  const Ball ball;
  const auto results = resultsOf(ball.render({"--engine", "reference", "--per", "pixel"}));
  CHECK(results.at("per") == "pixel");
  Image vertex(48, 27), pixel(48, 27);
  pixel.pixels = readImage(ball.picture).image.pixels;
  vertex.pixels = ball.pixels(onReference);
  CHECK(compareImages(pixel, vertex).relativeRootMeanSquare < 1e-5);
}

TEST_CASE("transfer by prt serves render: a mesh's by option and by field, and a scene's") {
  const Ball ball;
  const auto computed = ball.pixels(joined(onReference, {"--order", "3"}));
  resultsOf(ball.prt({"builtin:sphere", "--order", "3", "--bounces", "0"}));
  const auto results =
      resultsOf(ball.render({"--engine", "reference", "--transfer", ball.transfer}));
  CHECK(results.at("order") == 3);
  const auto stored = readImage(ball.picture).image.pixels;
  Image first(48, 27), second(48, 27);
  first.pixels = stored;
  second.pixels = computed;
  CHECK(compareImages(first, second).relativeRootMeanSquare <
        0.002);  // the plane's rays are others
  const Ball field(R"(, "transfer": ")" + ball.transfer.string() + "\"");
  CHECK(field.pixels(onReference) == stored);

  const auto prt = resultsOf(ball.prt({ball.scene, "--order", "3"}));
  CHECK(prt.at("transfer_kind") == "shadowed");
  CHECK(prt.at("channels") == 1);
  CHECK(prt.at("vertices") == results.at("vertices"));
  first.pixels = ball.pixels(joined(onReference, {"--transfer", ball.transfer}));
  CHECK(compareImages(first, second).relativeRootMeanSquare < 0.01);  // fewer rays
}

TEST_CASE("files of transfer that cannot be used are refused in one line") {
  const Ball ball;
  const auto refused = [&](const Arguments& more, const std::string& named) {
    checkRefused(joined(ball.render({"--quiet"}), more), named);
  };
  refused({"--transfer", ball.folder / "none.prt"}, "none.prt");
  resultsOf(ball.prt({"builtin:torusknot", "--order", "2"}));
  refused({"--transfer", ball.transfer}, "was computed for no mesh of this scene");
  const Ball field(R"(, "transfer": ")" + ball.transfer.string() + "\"");
  checkRefused(field.render({"--quiet"}), "was computed for another mesh than builtin:sphere");
  const std::string whole = readFile(ball.transfer);
  writeFile(ball.transfer, whole.substr(0, whole.size() / 2));
  refused({"--transfer", ball.transfer}, "it is cut off");
  std::string newer = whole;
  newer[8] = 2;
  writeFile(ball.transfer, newer);
  refused({"--transfer", ball.transfer}, "it is of version 2");
  checkRefused(ball.prt({ball.scene, "--bounces", "1"}), "shadows alone");
  checkRefused(ball.prt({ball.scene, "--albedo", "1"}), "shadows alone");
  CHECK_FALSE(std::filesystem::exists(ball.picture));
}

TEST_CASE("frames may turn the light, but no frame may move an object") {
  const std::string turning =
      R"(, "motion": {"keys": [{"seconds": 0}, {"seconds": 1, "rotateDegrees": 90}]})";
  const Ball ball("", turning);
  const auto frames = ball.folder / "frame_%02d.exr";
  const Arguments render{"render", ball.scene, "--method", "sh",  "--engine", "reference",
                         "-o",     frames,     "--frames", "0:1", "--fps",    "1"};
  resultsOf(render);
  const auto last = readImage(ball.folder / "frame_01.exr").image.pixels;
  CHECK(readImage(ball.folder / "frame_00.exr").image.pixels != last);
  const Ball turned("", R"(, "rotateDegrees": 90)");
  CHECK(turned.pixels(onReference) == last);

  const Ball moving(
      R"(, "motion": {"keys": [{"seconds": 0}, {"seconds": 1, "translate": [1, 0, 0]}]})");
  checkRefused({"render", moving.scene, "--method", "sh", "--frames", "0:1", "--quiet", "-o",
                moving.folder / "frame_%02d.exr"},
               "object 'ball' moves, and transfer is for one pose");
  CHECK(moving.pixels(onReference).size() == 48 * 27);  // as it is at second 0
  checkRefused({"track", moving.scene, "--method", "sh", "--compare-to", "pixel-mesh"}, "sh");
}

TEST_CASE("near light is for sh alone, as the others say") {
  const Ball ball("", R"(, "samples": [{"position": [2, 1, 0], "source": "builtin:constant"}])");
  const Outcome haar =
      runHaarlight({"render", ball.scene, "--engine", "reference", "-o", ball.picture, "--quiet"});
  CHECK(haar.exitCode == 0);
  CHECK(contains(haar.errors, "only the method sh knows light.samples"));
  const Outcome sh = runHaarlight(ball.render({"--engine", "reference", "--quiet"}));
  CHECK(sh.exitCode == 0);
  CHECK(sh.errors == "");
}
