#include "scene/camera.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/scene_file.h"

using namespace haarlight;

namespace {

constexpr double rounding = 1e-15;

/// At the origin, looking along −z.
CameraDescription plainCamera(double verticalFieldOfViewDegrees) {
  CameraDescription camera;
  camera.position = {0, 0, 0};
  camera.target = {0, 0, -5};
  camera.verticalFieldOfViewDegrees = verticalFieldOfViewDegrees;
  return camera;
}

void checkDirection(const glm::dvec3& actual, const glm::dvec3& expected) {
  CHECK(glm::distance(actual, glm::normalize(expected)) < rounding);
}

/// Where a point appears in the image, by the textbook formula: x/z and y/z in the camera's axes.
glm::dvec2 project(const glm::dvec3& point, const CameraDescription& camera, int width,
                   int height) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
  const glm::dvec3 offset = point - camera.position;
  const double scale = height / 2.0 / std::tan(camera.verticalFieldOfViewDegrees * M_PI / 360);
  const double depth = glm::dot(offset, forward);
  return {width / 2.0 + scale * glm::dot(offset, right) / depth,
          height / 2.0 - scale * glm::dot(offset, glm::cross(right, forward)) / depth};
}

}  // namespace

TEST_CASE("the middle of the image looks at the target") {
  CameraDescription description;
  description.position = {1, 2, 3};
  description.target = {4, 0, -2};
  const Camera camera(description, 640, 480);
  CHECK(camera.position() == glm::dvec3(1, 2, 3));
  checkDirection(camera.direction(320, 240), {3, -2, -5});
}

TEST_CASE("corners of a square image of 90 degrees look along cube corners") {
  const Camera camera(plainCamera(90), 100, 100);
  checkDirection(camera.direction(0, 0), {-1, 1, -1});
  checkDirection(camera.direction(100, 0), {1, 1, -1});
  checkDirection(camera.direction(0, 100), {-1, -1, -1});
  checkDirection(camera.direction(100, 100), {1, -1, -1});
}

TEST_CASE("a wide image widens the horizontal angle and keeps the vertical one") {
  const Camera camera(plainCamera(60), 960, 540);
  const double halfHeight = 1 / std::sqrt(3.0);  // tan 30°
  checkDirection(camera.direction(480, 0), {0, halfHeight, -1});
  checkDirection(camera.direction(960, 270), {halfHeight * 16 / 9, 0, -1});
  checkDirection(camera.direction(0, 540), {-halfHeight * 16 / 9, -halfHeight, -1});
}

TEST_CASE("up decides which side of the image is above") {
  CameraDescription description = plainCamera(90);
  description.target = {0, -1, 0};  // straight down
  description.up = {0, 0, -2};      // any length
  const Camera camera(description, 200, 200);
  checkDirection(camera.direction(100, 0), {0, -1, -1});
  checkDirection(camera.direction(200, 100), {1, -1, 0});
}

TEST_CASE("rays are unit vectors that meet the projection of their points") {
  CameraDescription description;
  description.position = {3, 2, 7};
  description.target = {-1, 0.5, 0.25};
  description.up = {0.2, 1, -0.1};
  const Camera camera(description, 333, 217);
  for (const glm::dvec3 point : {glm::dvec3(0), glm::dvec3(-2, 1, 0.5), glm::dvec3(1, 1.5, -3)}) {
    const glm::dvec2 pixel = project(point, description, 333, 217);
    const glm::dvec3 direction = camera.direction(pixel.x, pixel.y);
    CHECK(std::abs(glm::length(direction) - 1) < rounding);
    CHECK(glm::distance(direction, glm::normalize(point - description.position)) < 1e-14);
  }
}

TEST_CASE("the built-in scenes show the object and the ground around it") {
  for (const char* name : {"builtin:default", "builtin:smooth", "builtin:twist"}) {
    const SceneDescription scene = readScene(name);
    REQUIRE(scene.receiver);
    const double size = *scene.objects.at(0).transform.fit;
    for (const int corner : {0, 1, 2, 3}) {
      const double x = corner & 1 ? 1 : -1, z = corner & 2 ? 1 : -1;
      const auto check = [&](const glm::dvec3& point) {
        const auto& image = scene.image;
        const glm::dvec2 pixel = project(point, scene.camera, image.width, image.height);
        CHECK(pixel.x > 0);
        CHECK(pixel.x < image.width);
        CHECK(pixel.y > 0);
        CHECK(pixel.y < image.height);
      };
      check({x * size / 2, 0, z * size / 2});
      check({x * size / 4, 0.8 * size, z * size / 4});
    }
  }
}
