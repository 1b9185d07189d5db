#include "scene/keyframes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "base/error.h"

using namespace haarlight;

namespace {

constexpr double rounding = 1e-14;

std::vector<AngleKey> threeKeys() {
  return {{1, 10, Ease::linear}, {2, 30, Ease::linear}, {4, -50, Ease::linear}};
}

void checkPlace(const KeyPlace& place, const KeyPlace& expected) {
  CHECK(place.from == expected.from);
  CHECK(place.to == expected.to);
  CHECK(place.fraction == expected.fraction);
}

glm::dvec3 moved(const MotionDescription& motion, const glm::dvec3& pivot, double seconds,
                 const glm::dvec3& point) {
  return glm::dvec3(motionMatrix(motion, pivot, seconds) * glm::dvec4(point, 1));
}

void checkNear(const glm::dvec3& point, const glm::dvec3& expected) {
  CHECK(glm::distance(point, expected) < rounding);
}

/// From no turn at second 0 to `rotation` at second 1.
MotionDescription turnTo(const glm::dvec4& rotation) {
  MotionDescription motion;
  motion.keys.resize(2);
  motion.keys[1].seconds = 1;
  motion.keys[1].rotation = rotation;
  return motion;
}

const double halfRoot = std::sqrt(0.5);
const glm::dvec4 quarterTurnAboutZ{0, 0, halfRoot, halfRoot};

}  // namespace

TEST_CASE("easing goes by its formula") {
  CHECK(easedFraction(Ease::linear, 0.25) == 0.25);
  CHECK(easedFraction(Ease::smooth, 0) == 0);
  CHECK(easedFraction(Ease::smooth, 0.25) == 0.15625);
  CHECK(easedFraction(Ease::smooth, 0.5) == 0.5);
  CHECK(easedFraction(Ease::smooth, 0.75) == 0.84375);
  CHECK(easedFraction(Ease::smooth, 1) == 1);
  CHECK(easedFraction(Ease::hold, 0.999) == 0);
}

TEST_CASE("a time lies between the two keys around it") {
  const auto keys = threeKeys();
  checkPlace(keyPlace(keys, Repeat::hold, -5), {0, 1, 0});
  checkPlace(keyPlace(keys, Repeat::hold, 1), {0, 1, 0});
  checkPlace(keyPlace(keys, Repeat::hold, 1.25), {0, 1, 0.25});
  checkPlace(keyPlace(keys, Repeat::hold, 2), {1, 2, 0});
  checkPlace(keyPlace(keys, Repeat::hold, 3.5), {1, 2, 0.75});
  checkPlace(keyPlace(keys, Repeat::hold, 4), {2, 2, 0});
  checkPlace(keyPlace(keys, Repeat::hold, 1e9), {2, 2, 0});
}

TEST_CASE("the key before decides how its time eases") {
  std::vector<AngleKey> keys = threeKeys();
  keys[0].ease = Ease::smooth;
  keys[1].ease = Ease::hold;
  CHECK(keyPlace(keys, Repeat::hold, 1.25).fraction == 0.15625);
  CHECK(degreesAt(keys, {}, 1.25) == 10 + 0.15625 * 20);
  CHECK(degreesAt(keys, {}, std::nextafter(4, 0)) == 30);
  CHECK(degreesAt(keys, {}, 4) == -50);
}

TEST_CASE("the time from the first key to the last repeats") {
  const auto keys = threeKeys();
  checkPlace(keyPlace(keys, Repeat::loop, 0), {0, 1, 0});
  checkPlace(keyPlace(keys, Repeat::loop, 3), {1, 2, 0.5});
  checkPlace(keyPlace(keys, Repeat::loop, 4), {0, 1, 0});
  checkPlace(keyPlace(keys, Repeat::loop, 6), {1, 2, 0.5});
  checkPlace(keyPlace(keys, Repeat::loop, 301), {0, 1, 0});
  checkPlace(keyPlace(keys, Repeat::pingpong, 0), {0, 1, 0});
  checkPlace(keyPlace(keys, Repeat::pingpong, 4), {2, 2, 0});
  checkPlace(keyPlace(keys, Repeat::pingpong, 5), {1, 2, 0.5});
  checkPlace(keyPlace(keys, Repeat::pingpong, 6.5), {0, 1, 0.5});
  checkPlace(keyPlace(keys, Repeat::pingpong, 7), {0, 1, 0});
  checkPlace(keyPlace(keys, Repeat::pingpong, 8), {1, 2, 0});
}

TEST_CASE("a single key holds at all times") {
  for (const Repeat repeat : {Repeat::hold, Repeat::loop, Repeat::pingpong})
    for (const double seconds : {0.0, 0.3, 7.0})
      CHECK(degreesAt({{0.3, 12, Ease::smooth}}, {0, 1, repeat}, seconds) == 12);
}

TEST_CASE("at a key's own second its value comes out to the bit") {
  const std::vector<AngleKey> keys{{0.1, 0.7, Ease::linear},
                                   {0.3, 1 / 3.0, Ease::smooth},
                                   {0.7, -1e-9, Ease::hold},
                                   {1.9, 123.456, Ease::linear}};
  for (const Repeat repeat : {Repeat::hold, Repeat::pingpong})
    for (const AngleKey& key : keys)
      CHECK(degreesAt(keys, {0, 1, repeat}, key.seconds) == key.degrees);
  for (const std::size_t i : {0, 1, 2})
    CHECK(degreesAt(keys, {0, 1, Repeat::loop}, keys[i].seconds) == keys[i].degrees);
  CHECK(degreesAt(keys, {0, 1, Repeat::loop}, keys[3].seconds) == keys[0].degrees);
}

TEST_CASE("angles run on the clock of their deformation") {
  const std::vector<AngleKey> keys{{0, 0, Ease::linear}, {2, 100, Ease::linear}};
  CHECK(degreesAt(keys, {10, 2, Repeat::hold}, 9) == 0);
  CHECK(degreesAt(keys, {10, 2, Repeat::hold}, 10.25) == 25);
  CHECK(degreesAt(keys, {10, 2, Repeat::hold}, 11) == 100);
  CHECK(degreesAt(keys, {10, 2, Repeat::loop}, 11.25) == 25);
  CHECK(degreesAt(keys, {10, 2, Repeat::pingpong}, 11.25) == 75);
}

TEST_CASE("rotations take the way between two keys at constant speed") {
  const MotionDescription motion = turnTo(quarterTurnAboutZ);
  checkNear(moved(motion, {}, 0, {1, 0, 0}), {1, 0, 0});
  checkNear(moved(motion, {}, 1.0 / 3, {1, 0, 0}), {std::sqrt(0.75), 0.5, 0});
  checkNear(moved(motion, {}, 0.5, {1, 0, 0}), {halfRoot, halfRoot, 0});
  checkNear(moved(motion, {}, 1, {1, 0, 0}), {0, 1, 0});
}

TEST_CASE("rotations take the shorter way, whatever the quaternion's sign and length") {
  for (const double factor : {1.0, -1.0, 1e6, 1e-200, -5e-324})
    checkNear(moved(turnTo(factor * glm::dvec4(0, 0, 1, 1)), {}, 0.5, {1, 0, 0}),
              {halfRoot, halfRoot, 0});
  const glm::dvec4 threeQuarters{0, 0, halfRoot, -halfRoot};
  checkNear(moved(turnTo(threeQuarters), {}, 0.5, {1, 0, 0}), {halfRoot, -halfRoot, 0});
}

TEST_CASE("an object turns and grows about its pivot and is then moved") {
  MotionDescription motion;
  motion.keys.push_back({0, {10, 20, 30}, quarterTurnAboutZ, 2, Ease::linear});
  const glm::dvec3 pivot(1, 2, 3);
  checkNear(moved(motion, pivot, 0, pivot), {11, 22, 33});
  checkNear(moved(motion, pivot, 0, {2, 2, 3}), {11, 24, 33});
  checkNear(moved(motion, pivot, 0, {1, 2, 4}), {11, 22, 35});
}

TEST_CASE("translation and scale change linearly, and a turn stays a turn") {
  MotionDescription motion = turnTo(quarterTurnAboutZ);
  motion.keys[1].translate = {4, 0, -8};
  motion.keys[1].scale = 3;
  const glm::dmat4 matrix = motionMatrix(motion, {}, 0.25);
  checkNear(glm::dvec3(matrix[3]), {1, 0, -2});
  const glm::dmat3 turning(matrix), square = glm::transpose(turning) * turning;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      CHECK(std::abs(square[column][row] - (row == column ? 1.5 * 1.5 : 0)) < rounding);
}

TEST_CASE("a key without fields leaves the object alone to the bit, a moved one is only moved") {
  const glm::dvec3 pivot(0.1, 0.7, -3.3);
  MotionDescription motion;
  motion.keys.resize(2);
  motion.keys[1].seconds = 1;
  CHECK(motionMatrix(motion, pivot, 0) == glm::dmat4(1));
  CHECK(motionMatrix(motion, pivot, 0.3) == glm::dmat4(1));
  motion.keys[1].translate = {0.1, 0.2, 0.3};
  CHECK(motionMatrix(motion, pivot, 1)[3] == glm::dvec4(0.1, 0.2, 0.3, 1));
}

TEST_CASE("a light without motion is the same at all times") {
  const LightDescription light{"probe.hdr", "angular", 30, 2, {}, {}};
  const LightState state = lightAt(light, 17);
  CHECK(state.from == LightSource{"probe.hdr", "angular"});
  CHECK(state.to == state.from);
  CHECK(state.rotateDegrees == 30);
  CHECK(state.scale == 2);
}

TEST_CASE("the sun goes from key to key, and stands where the sky says without one") {
  LightDescription light;
  light.source = "builtin:cie-clear";
  CHECK(lightAt(light, 1).sky == SkySettings{});
  light.sky = SkySettings{-30, 20, 2.5, 1, glm::dvec3(0.3)};
  CHECK(lightAt(light, 1).sky == *light.sky);
  LightKey rise, noon, set;
  rise.sunAzimuthDegrees = 350;
  rise.sunElevationDegrees = 0;
  noon.seconds = 2;
  noon.sunAzimuthDegrees = 450;
  noon.sunElevationDegrees = 60;
  set.seconds = 4;
  light.motion = LightMotionDescription{{rise, noon, set}, Repeat::hold};
  CHECK(lightAt(light, 0.5).sky == SkySettings{375, 15, 2.5, 1, glm::dvec3(0.3)});
  CHECK(lightAt(light, 2).sky == SkySettings{450, 60, 2.5, 1, glm::dvec3(0.3)});
  CHECK(lightAt(light, 3).sky == SkySettings{210, 40, 2.5, 1, glm::dvec3(0.3)});
  CHECK(lightAt(light, 9).sky == *light.sky);
}

TEST_CASE("lights turn, change their scale and cross-fade") {
  LightDescription light{"probe.hdr", "angular", 30, 2, LightMotionDescription{}, {}};
  light.motion->keys = {{0, 0, 1, {}, "auto", Ease::linear, {}, {}},
                        {2, 360, 0.5, "builtin:sky", "auto", Ease::smooth, {}, {}},
                        {4, -90, 0, "cross.exr", "vcross", Ease::linear, {}, {}}};
  const LightSource own{"probe.hdr", "angular"}, sky{"builtin:sky", "auto"},
      cross{"cross.exr", "vcross"};
  const LightState first = lightAt(light, 0.5), second = lightAt(light, 2.5);
  CHECK(first.from == own);
  CHECK(first.to == sky);
  CHECK(first.fraction == 0.25);
  CHECK(first.rotateDegrees == 30 + 90);
  CHECK(first.scale == 2 * 0.875);
  CHECK(second.from == sky);
  CHECK(second.to == cross);
  CHECK(second.fraction == 0.15625);
  CHECK(second.rotateDegrees == 30 + 360 - 0.15625 * 450);
  CHECK(lightAt(light, 2).fraction == 0);
  CHECK(lightAt(light, 2).from == sky);
  CHECK(lightAt(light, 9).from == cross);
  CHECK(lightAt(light, 9).to == cross);
  CHECK(lightAt(light, 9).scale == 0);
}

TEST_CASE("a point light goes straight from key to key") {
  PointLightDescription light{{1, 2, 3}, {5, 6, 7}, {}};
  CHECK(pointLightAt(light, 2).position == glm::dvec3(1, 2, 3));
  light.motion = PointLightMotionDescription{
      {{1, glm::dvec3(0, 4, 0), Ease::linear}, {3, {}, Ease::smooth}}, Repeat::pingpong};
  CHECK(pointLightAt(light, 0).position == glm::dvec3(0, 4, 0));
  CHECK(pointLightAt(light, 1.5).position == glm::dvec3(0.25, 3.5, 0.75));
  CHECK(pointLightAt(light, 3).position == glm::dvec3(1, 2, 3));
  CHECK(pointLightAt(light, 4.5).position == glm::dvec3(0.25, 3.5, 0.75));
  CHECK(pointLightAt(light, 1.5).intensity == glm::dvec3(5, 6, 7));
  CHECK_FALSE(pointLightAt(light, 1.5).motion);
}

TEST_CASE("a direction to a light turns at constant speed, whatever its length") {
  DirectionalLightDescription light{{0, 3, 0}, {5, 6, 7}, {}};
  CHECK(directionalLightAt(light, 2).towards == glm::dvec3(0, 3, 0));
  light.motion = DirectionalLightMotionDescription{
      {{0, {}, Ease::linear}, {3, glm::dvec3(1e-300, 0, 0), Ease::linear}}, Repeat::hold};
  CHECK(directionalLightAt(light, 0).towards == glm::dvec3(0, 3, 0));
  checkNear(directionalLightAt(light, 1).towards, {0.5, std::sqrt(0.75), 0});
  checkNear(directionalLightAt(light, 1.5).towards, {halfRoot, halfRoot, 0});
  CHECK(directionalLightAt(light, 3).towards == glm::dvec3(1e-300, 0, 0));
  CHECK(directionalLightAt(light, 1).irradiance == glm::dvec3(5, 6, 7));
  CHECK_FALSE(directionalLightAt(light, 1).motion);
}

TEST_CASE("a direction takes the shorter way, and between equal ones stays") {
  DirectionalLightDescription light{{0, 1, 0}, {1, 1, 1}, DirectionalLightMotionDescription{}};
  const double angle = 3;  // of a half turn, π
  light.motion->keys = {
      {0, {}, Ease::linear},
      {1, glm::dvec3(0, std::cos(angle), -std::sin(angle)), Ease::linear},
      {2, glm::dvec3(0, 2 * std::cos(angle), -2 * std::sin(angle)), Ease::linear}};
  checkNear(directionalLightAt(light, 0.25).towards,
            {0, std::cos(angle / 4), -std::sin(angle / 4)});
  checkNear(directionalLightAt(light, 1.25).towards, {0, std::cos(angle), -std::sin(angle)});
}

TEST_CASE("between opposite directions there is no shorter way") {
  CHECK(areOpposite({1e-300, 2e-300, 0}, {-1e6, -2e6, 0}));
  CHECK_FALSE(areOpposite({1, 0, 0}, {-1, 1e-9, 0}));
  DirectionalLightDescription light{{0, 1, 0}, {1, 1, 1}, DirectionalLightMotionDescription{}};
  light.motion->keys = {{0, {}, Ease::linear}, {2, glm::dvec3(0, -1, 0), Ease::linear}};
  CHECK(directionalLightAt(light, 0).towards == glm::dvec3(0, 1, 0));
  CHECK_THROWS_WITH_AS(directionalLightAt(light, 1),
                       "a directional light at second 1: the directions of two keys are opposite",
                       InputError);
  light.motion->keys[0].ease = Ease::hold;
  CHECK(directionalLightAt(light, 1).towards == glm::dvec3(0, 1, 0));
  CHECK(directionalLightAt(light, 2).towards == glm::dvec3(0, -1, 0));
}

TEST_CASE("a camera moves between its keys") {
  CameraDescription camera;
  camera.position = {1, 2, 3};
  camera.target = {0, 0, 0};
  camera.verticalFieldOfViewDegrees = 25;
  CHECK(cameraAt(camera, 3).position == camera.position);
  camera.motion = CameraMotionDescription{{{0, {}, {}, Ease::linear},
                                           {2, glm::dvec3(5, 2, -1), {}, Ease::linear},
                                           {3, {}, glm::dvec3(0, 1, 0), Ease::linear}},
                                          Repeat::pingpong};
  const CameraDescription early = cameraAt(camera, 0.5), late = cameraAt(camera, 2.5);
  CHECK(early.position == glm::dvec3(2, 2, 2));
  CHECK(early.target == glm::dvec3(0));
  CHECK(early.verticalFieldOfViewDegrees == 25);
  CHECK_FALSE(early.motion);
  CHECK(late.position == glm::dvec3(3, 2, 1));
  CHECK(late.target == glm::dvec3(0, 0.5, 0));
  CHECK(cameraAt(camera, 3.5).position == late.position);
}

TEST_CASE("a camera that sees nothing on its way is refused") {
  CameraDescription camera;
  camera.target = {0, 0, 0};
  camera.motion = CameraMotionDescription{
      {{0, glm::dvec3(0, 0, 2), {}, Ease::linear}, {1, glm::dvec3(0, 0, -2), {}, Ease::linear}},
      Repeat::hold};
  CHECK(cameraAt(camera, 0.25).position == glm::dvec3(0, 0, 1));
  CHECK_THROWS_WITH_AS(cameraAt(camera, 0.5),
                       "camera at second 0.5: target must differ from the position", InputError);
}

TEST_CASE("a frame shows its number over the rate") {
  CHECK(frameSeconds({0, 95, 24}, 36) == 1.5);
  CHECK(frameSeconds({0, 0, 0.5}, 3) == 6);
}
