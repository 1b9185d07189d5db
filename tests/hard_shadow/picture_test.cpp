#include <doctest/doctest.h>

#include <numbers>

#include "hard_shadow/shadow_difference.h"
#include "hard_shadow/shadow_picture.h"
#include "shadow_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

TEST_CASE("radiance is Lambert's, of each light that is not in the way") {
  SurfaceView view;
  view.pixels.width = 4, view.pixels.height = 1;
  view.pixels.column = {1, 0, 0};
  view.points = {
      {0, {0, 0, 0}, {0, 1, 0}}, {0, {0, 0, 0}, {0, 1, 0}}, {1, {3, 0, 0}, {0, 1, 0}}, {}};
  view.depths = {1, 1, 1, 1};
  const std::vector<PunctualLight> lights{{PointLight{{0, 2, 0}}, {8, 4, 2}},
                                          {DirectionalLight{{0, 3, 3}}, {1, 1, 1}}};
  const std::vector<std::vector<std::uint8_t>> inShadow{{0, 1, 0, 0}, {1, 1, 0, 0}};
  ShadowPicture picture(4, 1, 1, {glm::dvec3(0.5), glm::dvec3(1)}, lights,
                        {glm::dvec3(-1, -1, -1), glm::dvec3(1, 1, 1)});
  picture.addRows(0, view, inShadow);
  const glm::vec3 lit = picture.image().at(0, 0), dark = picture.image().at(1, 0);
  const glm::vec3 both = picture.image().at(2, 0), nothing = picture.image().at(3, 0);
  const double pi = std::numbers::pi;
  for (int channel = 0; channel < 3; ++channel) {
    const double intensity = lights[0].strength[channel];
    CHECK(lit[channel] - dark[channel] == doctest::Approx(0.5 / pi * intensity / 4));
    const double cosine = 2 / std::sqrt(13);
    const double expected = (intensity / 13 * cosine + std::numbers::sqrt2 / 2) / pi;
    CHECK(both[channel] - 2 * dark[channel] == doctest::Approx(expected));
    CHECK(nothing[channel] == doctest::Approx(2 * dark[channel]));
    CHECK(dark[channel] > 0);
  }
}

TEST_CASE("shadows are as bright under a light in the scene's middle as under one next to it") {
  SurfaceView view;
  view.pixels.width = 1, view.pixels.height = 1;
  view.points = {{0, {0, -1, 0}, {0, 1, 0}}};
  view.depths = {1};
  const auto darkUnder = [&](const glm::dvec3& place) {
    ShadowPicture picture(1, 1, 1, {glm::dvec3(1)}, {{PointLight{place}, {3, 2, 1}}},
                          {glm::dvec3(-1), glm::dvec3(1)});
    picture.addRows(0, view, std::vector<std::vector<std::uint8_t>>{{1}});
    return picture.image().at(0, 0);
  };
  CHECK(darkUnder({0, 0, 0}).z > 0);
  CHECK(darkUnder({0, 0, 0}) == darkUnder({0.1, 0.4, 0}));
  CHECK(darkUnder({0, 4, 0}).x == doctest::Approx(darkUnder({2, 0, 0}).x / 4));
}

TEST_CASE("camera rays of a pixel are averaged") {
  SurfaceView view;
  view.pixels.width = 4, view.pixels.height = 2;
  view.points.assign(8, {0, {0, 0, 0}, {0, 1, 0}});
  view.depths.assign(8, 1);
  const std::vector<std::vector<std::uint8_t>> inShadow{{0, 1, 1, 1, 0, 1, 1, 1}};
  ShadowPicture picture(2, 2, 2, {glm::dvec3(1)}, {{DirectionalLight{{0, 1, 0}}, {1, 1, 1}}},
                        {glm::dvec3(-1), glm::dvec3(1)});
  picture.addRows(2, view, inShadow);
  const float pi = std::numbers::pi_v<float>;
  CHECK(picture.image().at(0, 0).x == 0);
  CHECK(picture.image().at(0, 1).x - picture.image().at(1, 1).x == doctest::Approx(0.5 / pi));
}

TEST_CASE("differences count where the surface faces the light") {
  SurfaceView view;
  const ReceiverPoint up{0, {0, 0, 0}, {0, 1, 0}}, down{0, {0, 0, 0}, {0, -1, 0}};
  view.points = {up, up, up, up, up, down, {}};
  const std::uint8_t answer[] = {1, 0, 1, 0, 1, 0, 1}, reference[] = {1, 1, 0, 0, 1, 1, 0};
  ShadowDifference difference;
  difference.add(view, DirectionalLight{{0, 1, 0}}, answer, reference);
  difference.add(view, DirectionalLight{{0, -1, 0}}, answer, reference);
  CHECK(difference.inShadow == 4);
  CHECK(difference.missing == 2);
  CHECK(difference.extra == 1);
  CHECK(difference.areaError() == -0.25);
  CHECK(difference.wrongPart() == 0.75);
  CHECK(ShadowDifference{}.wrongPart() == 0);
}
