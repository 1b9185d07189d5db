#include "light/image_environment.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "base/parallel.h"
#include "cube/cube_map.h"
#include "image/read_image.h"
#include "light/light_projection.h"
#include "light_test_support.h"

namespace haarlight::test {

namespace {

constexpr double pi = std::numbers::pi;

struct Sized {
  std::string name;
  glm::ivec2 size;
};

const std::vector<Sized> everyLayout{
    {"latlong", {64, 32}}, {"vcross", {63, 84}}, {"hcross", {84, 63}}, {"angular", {61, 61}}};

Image filled(glm::ivec2 size, const glm::vec3& value) {
  Image image(size.x, size.y);
  std::fill(image.pixels.begin(), image.pixels.end(), value);
  return image;
}

LightProjection projected(const Image& image, const std::string& layout,
                          const glm::mat3& rotation = glm::mat3(1.0f), float scale = 1) {
  return projectToCube(ImageEnvironment(image, layout, "test"), rotation, scale);
}

/// The pixel of a picture that shows a direction, by the documented layout alone.
glm::ivec2 pixelShowing(const Sized& layout, const glm::dvec3& direction) {
  const Layout& chosen = chooseLayout(layout.name, layout.size);
  const PatchPoint place = chosen.locate(direction);
  return chosen.patchOrigin(place.patch, layout.size) +
         glm::ivec2(place.position * glm::dvec2(chosen.patchSize(layout.size)));
}

int brightestTexel(const RadianceCube& cube) {
  const auto less = [](const glm::vec3& a, const glm::vec3& b) { return a.g < b.g; };
  return int(std::max_element(cube.texels.begin(), cube.texels.end(), less) - cube.texels.begin());
}

glm::dvec3 brightestDirection(const Image& image, const std::string& layout,
                              const glm::mat3& rotation = glm::mat3(1.0f)) {
  return texelDirection(brightestTexel(projected(image, layout, rotation).cube));
}

Image withBrightPixel(glm::ivec2 size, int x, int y) {
  Image image(size.x, size.y);
  image.at(x, y) = {1, 100, 1};
  return image;
}

}  // namespace

TEST_CASE("a constant picture gives exactly constant texels in every layout") {
  const glm::vec3 value(0.3f, 1.7f, 1234.5f);
  std::mt19937 random(1);
  for (const Sized& layout : everyLayout) {
    CAPTURE(layout.name);
    const LightProjection projection =
        projected(filled(layout.size, value), layout.name, randomRotation(random));
    for (int texel = 0; texel < texelCount; ++texel) REQUIRE(projection.cube[texel] == value);
    CHECK(projection.cubePower.g == doctest::Approx(4 * pi * value.g).epsilon(1e-6));
    CHECK(projection.sourcePower.g == doctest::Approx(4 * pi * value.g).epsilon(1e-5));
  }
}

TEST_CASE("the weights of every texel add up to its solid angle") {
  std::mt19937 random(2);
  for (const Sized& layout : everyLayout) {
    CAPTURE(layout.name);
    const ImageEnvironment environment(filled(layout.size, glm::vec3(1.0f)), layout.name, "test");
    const LightIntegrals integrals = environment.integrate(glm::dmat3(randomRotation(random)));
    double worst = 0;
    for (int texel = 0; texel < texelCount; ++texel)
      worst = std::max(worst, std::abs(integrals.solidAngle[texel] / texelSolidAngle(texel) - 1));
    CHECK(worst < 1e-6);
  }
}

TEST_CASE("pictures of a few pixels reach every texel") {
  for (const Sized& layout : std::vector<Sized>{
           {"latlong", {2, 1}}, {"vcross", {3, 4}}, {"hcross", {4, 3}}, {"angular", {1, 1}}}) {
    const LightProjection projection = projected(filled(layout.size, glm::vec3(2.0f)), layout.name);
    for (int texel = 0; texel < texelCount; ++texel)
      REQUIRE(projection.cube[texel] == glm::vec3(2.0f));
    CHECK(projection.powerRatio == doctest::Approx(1).epsilon(1e-3));
  }
}

TEST_CASE("a single bright pixel keeps its power anywhere and in any rotation") {
  std::mt19937 random(3);
  for (const Sized& layout : everyLayout)
    for (int round = 0; round < 4; ++round) {
      const glm::mat3 rotation = randomRotation(random);
      const glm::dvec3 direction = glm::dmat3(randomRotation(random))[0];
      const glm::ivec2 pixel = pixelShowing(layout, direction);
      const Image image = withBrightPixel(layout.size, pixel.x, pixel.y);
      CAPTURE(layout.name);
      CAPTURE(pixel.x);
      CAPTURE(pixel.y);
      const LightProjection projection = projected(image, layout.name, rotation);
      REQUIRE(projection.sourcePower.g > 0);
      CHECK(projection.powerRatio == doctest::Approx(1).epsilon(1e-3));
      CHECK(projection.cubePower.g / projection.sourcePower.g == doctest::Approx(1).epsilon(1e-3));
    }
}

TEST_CASE("the pixels at the poles and on the rim keep their power") {
  for (const auto& [layout, x, y] : {std::tuple("latlong", 5, 0), std::tuple("latlong", 40, 31)}) {
    const LightProjection projection = projected(withBrightPixel({64, 32}, x, y), layout);
    CHECK(projection.powerRatio == doctest::Approx(1).epsilon(1e-3));
  }
}

TEST_CASE("a bright pixel comes out in the direction its layout documents") {
  const auto near = [](const glm::dvec3& found, const glm::dvec3& expected) {
    return glm::dot(found, glm::normalize(expected)) > std::cos(0.06);
  };
  // Latlong 64×32: the centre is +Z, a quarter from the left +X, the top +Y.
  CHECK(near(brightestDirection(withBrightPixel({64, 32}, 32, 16), "latlong"), {0, 0, 1}));
  CHECK(near(brightestDirection(withBrightPixel({64, 32}, 16, 16), "latlong"), {1, 0, 0}));
  CHECK(near(brightestDirection(withBrightPixel({64, 32}, 48, 16), "latlong"), {-1, 0, 0}));
  CHECK(near(brightestDirection(withBrightPixel({64, 32}, 0, 16), "latlong"), {0, 0, -1}));
  CHECK(near(brightestDirection(withBrightPixel({64, 32}, 7, 0), "latlong"), {0, 1, 0}));
  CHECK(near(brightestDirection(withBrightPixel({64, 32}, 7, 31), "latlong"), {0, -1, 0}));
  // Vertical cross of 31-pixel faces: middle pixels of the faces, and one of the back.
  CHECK(near(brightestDirection(withBrightPixel({93, 124}, 46, 46), "vcross"), {0, 0, -1}));
  CHECK(near(brightestDirection(withBrightPixel({93, 124}, 15, 46), "vcross"), {-1, 0, 0}));
  CHECK(near(brightestDirection(withBrightPixel({93, 124}, 77, 46), "vcross"), {1, 0, 0}));
  CHECK(near(brightestDirection(withBrightPixel({93, 124}, 46, 15), "vcross"), {0, 1, 0}));
  CHECK(near(brightestDirection(withBrightPixel({93, 124}, 46, 77), "vcross"), {0, -1, 0}));
  CHECK(near(brightestDirection(withBrightPixel({93, 124}, 46, 93), "vcross"), {0, -1, 1}));
  CHECK(near(brightestDirection(withBrightPixel({93, 124}, 61, 123), "vcross"), {1, 1, 1}));
  // Horizontal cross: the back is upright at the right.
  CHECK(near(brightestDirection(withBrightPixel({124, 93}, 77, 46), "hcross"), {1, 0, 0}));
  CHECK(near(brightestDirection(withBrightPixel({124, 93}, 108, 46), "hcross"), {0, 0, 1}));
  CHECK(near(brightestDirection(withBrightPixel({124, 93}, 123, 31), "hcross"), {-1, 1, 1}));
  // Angular 81×81: half the radius is a right angle from −Z, the rim +Z.
  CHECK(near(brightestDirection(withBrightPixel({81, 81}, 40, 40), "angular"), {0, 0, -1}));
  CHECK(near(brightestDirection(withBrightPixel({81, 81}, 60, 40), "angular"), {1, 0, 0}));
  CHECK(near(brightestDirection(withBrightPixel({81, 81}, 40, 20), "angular"), {0, 1, 0}));
  CHECK(near(brightestDirection(withBrightPixel({81, 81}, 40, 80), "angular"), {0, 0, 1}));
}

TEST_CASE("yaw turns the light from +Z towards +X") {
  const Image front = withBrightPixel({64, 32}, 32, 16);
  CHECK(brightestDirection(front, "latlong", yawRotation(90)).x > 0.99);
  CHECK(brightestDirection(front, "latlong", yawRotation(180)).z < -0.99);
  const glm::dvec3 diagonal = brightestDirection(front, "latlong", yawRotation(45));
  CHECK(diagonal.x == doctest::Approx(std::sqrt(0.5)).epsilon(0.05));
  CHECK(diagonal.z == doctest::Approx(std::sqrt(0.5)).epsilon(0.05));
}

TEST_CASE("a yaw of 90 degrees permutes the cube's side faces") {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> value(0, 5);
  Image image(64, 32);
  for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(value(random), value(random), 1);
  const RadianceCube still = projected(image, "latlong").cube;
  const RadianceCube turned = projected(image, "latlong", yawRotation(90)).cube;
  // +Z goes to +X, +X to −Z, −Z to −X and −X to +Z, with rows and columns unchanged.
  for (const auto& [from, to] :
       {std::pair(4, 0), std::pair(0, 5), std::pair(5, 1), std::pair(1, 4)})
    for (int i = 0; i < texelsPerFace; ++i) {
      const glm::vec3 expected = still[from * texelsPerFace + i];
      REQUIRE(turned[to * texelsPerFace + i].r == doctest::Approx(expected.r).epsilon(1e-4));
    }
}

TEST_CASE("the projection does not depend on the number of threads") {
  std::mt19937 random(5);
  const glm::mat3 rotation = randomRotation(random);
  const Image image = withBrightPixel({64, 32}, 20, 9);
  setThreadCount(1);
  const LightProjection one = projected(image, "latlong", rotation);
  setThreadCount(5);
  const LightProjection five = projected(image, "latlong", rotation);
  setThreadCount(0);
  CHECK(one.cube.texels == five.cube.texels);
  CHECK(one.sourcePower == five.sourcePower);
}

TEST_CASE("scale multiplies texels and power") {
  const Image image = withBrightPixel({64, 32}, 20, 9);
  const LightProjection plain = projected(image, "latlong"),
                        scaled = projected(image, "latlong", glm::mat3(1.0f), 4);
  for (int texel = 0; texel < texelCount; ++texel)
    REQUIRE(scaled.cube[texel] == 4.0f * plain.cube[texel]);
  CHECK(scaled.sourcePower == 4.0 * plain.sourcePower);
  CHECK(projected(Image(64, 32), "latlong").powerRatio == 1);
}

TEST_CASE("real probes keep their power on the cube") {
  std::mt19937 random(6);
  for (const std::string name : {"probes/grace.hdr", "probes/uffizi.hdr"}) {
    const auto path = testData(name);
    if (!path) return;
    const Image image = readImage(*path).image;
    for (const glm::mat3& rotation : {glm::mat3(1.0f), randomRotation(random)}) {
      const LightProjection projection = projected(image, "latlong", rotation);
      MESSAGE(name << ": cube power / source power = " << projection.powerRatio);
      for (int c = 0; c < 3; ++c)
        CHECK(projection.cubePower[c] / projection.sourcePower[c] ==
              doctest::Approx(1).epsilon(1e-3));
    }
  }
}

TEST_CASE("background look-up gives pixel values at pixel centres and the mean between them") {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> value(0, 5);
  for (const Sized& layout : everyLayout) {
    CAPTURE(layout.name);
    Image image(layout.size.x, layout.size.y);
    for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(value(random));
    const ImageEnvironment environment(image, layout.name, "test");
    const Layout& chosen = chooseLayout(layout.name, layout.size);
    const glm::ivec2 patch = chosen.patchSize(layout.size);
    const glm::ivec2 origin = chosen.patchOrigin(0, layout.size);
    const glm::ivec2 middle = patch / 2;
    const auto at = [&](double x, double y) {
      const glm::dvec2 place = (glm::dvec2(middle) + glm::dvec2(x, y)) / glm::dvec2(patch);
      return environment.radiance(glm::vec3(chosen.direction({0, place}))).r;
    };
    const glm::ivec2 pixel = origin + middle;
    CHECK(at(0.5, 0.5) == doctest::Approx(image.at(pixel.x, pixel.y).r).epsilon(1e-4));
    CHECK(at(1, 0.5) ==
          doctest::Approx((image.at(pixel.x, pixel.y).r + image.at(pixel.x + 1, pixel.y).r) / 2)
              .epsilon(1e-4));
  }
}

TEST_CASE("background look-up of a constant picture is constant everywhere") {
  std::mt19937 random(8);
  for (const Sized& layout : everyLayout) {
    Image image = filled(layout.size, glm::vec3(3.0f));
    const ImageEnvironment environment(image, layout.name, "test");
    for (int i = 0; i < 2000; ++i)
      REQUIRE(environment.radiance(randomRotation(random)[0]).r == doctest::Approx(3));
    for (const glm::vec3 axis : {glm::vec3(0, 1, 0), {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})
      CHECK(environment.radiance(axis).r == doctest::Approx(3));
  }
}

TEST_CASE("unused parts of a picture do not reach the light or the background") {
  for (const Sized& layout : everyLayout) {
    if (layout.name == "latlong") continue;
    CAPTURE(layout.name);
    const Layout& chosen = chooseLayout(layout.name, layout.size);
    Image image(layout.size.x, layout.size.y);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        bool used = false;
        for (int patch = 0; patch < chosen.patchCount(); ++patch) {
          const glm::ivec2 origin = chosen.patchOrigin(patch, layout.size);
          used |= chosen.covers((glm::dvec2(glm::ivec2(x, y) - origin) + 0.5) /
                                glm::dvec2(chosen.patchSize(layout.size)));
        }
        image.at(x, y) = glm::vec3(used ? 1.0f : 1000.0f);
      }
    const ImageEnvironment environment(image, layout.name, "test");
    std::mt19937 random(9);
    for (int i = 0; i < 2000; ++i)
      REQUIRE(environment.radiance(randomRotation(random)[0]).r == doctest::Approx(1));
    if (layout.name == "angular") continue;  // the rim cuts through pixels
    CHECK(projectToCube(environment).cubePower.r == doctest::Approx(4 * pi));
  }
}

TEST_CASE("the description names file, size and layout") {
  CHECK(ImageEnvironment(Image(64, 32), "", "probe.hdr").description() ==
        "probe.hdr (64×32, latlong)");
}

}  // namespace haarlight::test
