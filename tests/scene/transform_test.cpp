#include "scene/transform.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "base/error.h"

using namespace haarlight;

namespace {

/// Corners of the box [1, 5] × [2, 4] × [0, 1].
const std::vector<glm::vec3> box{{1, 2, 0}, {5, 2, 0}, {1, 4, 0}, {5, 4, 0},
                                 {1, 2, 1}, {5, 2, 1}, {1, 4, 1}, {5, 4, 1}};

void checkPoint(const glm::dmat4& matrix, const glm::dvec3& point, const glm::dvec3& expected) {
  CHECK(glm::distance(glm::dvec3(matrix * glm::dvec4(point, 1)), expected) < 1e-14);
}

}  // namespace

TEST_CASE("a transform without fields leaves points alone") {
  checkPoint(objectToWorld({}, box, 3), {1, 2, 3}, {1, 2, 3});
}

TEST_CASE("scale comes before rotation and translation") {
  TransformDescription transform;
  transform.scale = {2, 3, 4};
  transform.rotateDegrees = {0, 90, 0};  // +z to +x, +x to −z
  transform.translate = {10, 20, 30};
  checkPoint(objectToWorld(transform, box, 0), {1, 1, 1}, {10 + 4, 20 + 3, 30 - 2});
}

TEST_CASE("rotation is about x, then y, then z, each by the right-hand rule") {
  TransformDescription transform;
  transform.rotateDegrees = {90, 0, 0};
  checkPoint(objectToWorld(transform, box, 0), {0, 1, 0}, {0, 0, 1});
  transform.rotateDegrees = {0, 0, 90};
  checkPoint(objectToWorld(transform, box, 0), {1, 0, 0}, {0, 1, 0});
  transform.rotateDegrees = {90, 90, 0};  // +y to +z by x, then +z to +x by y
  checkPoint(objectToWorld(transform, box, 0), {0, 1, 0}, {1, 0, 0});
  transform.rotateDegrees = {0, 90, 90};  // +z to +x by y, then +x to +y by z
  checkPoint(objectToWorld(transform, box, 0), {0, 0, 1}, {0, 1, 0});
}

TEST_CASE("fit centres the bounding box and scales its longest side") {
  TransformDescription transform;
  transform.fit = 2;  // the longest side is 4
  const glm::dmat4 matrix = objectToWorld(transform, box, 0);
  checkPoint(matrix, {3, 3, 0.5}, {0, 0, 0});
  checkPoint(matrix, {5, 4, 1}, {1, 0.5, 0.25});
}

TEST_CASE("rest puts the lowest point on the ground, after rotation and before translation") {
  TransformDescription transform;
  transform.rest = Rest::Ground;
  checkPoint(objectToWorld(transform, box, -1), {1, 2, 0}, {1, -1, 0});
  transform.rotateDegrees = {0, 0, 90};  // x becomes y
  transform.translate = {0, 0.5, 7};
  checkPoint(objectToWorld(transform, box, -1), {1, 2, 0}, {-2, -0.5, 7});
}

TEST_CASE("the pivot is where the origin is placed, with fit the middle of the box") {
  TransformDescription transform;
  transform.scale = {2, 3, 4};
  transform.rotateDegrees = {30, -50, 70};
  transform.translate = {1, 2, 3};
  CHECK(objectPivot(transform, box, 0) == glm::dvec3(1, 2, 3));
  checkPoint(objectToWorld(transform, box, 0), {0, 0, 0}, objectPivot(transform, box, 0));
  transform.fit = 2;
  transform.rest = Rest::Ground;
  checkPoint(objectToWorld(transform, box, 7), {3, 3, 0.5}, objectPivot(transform, box, 7));
  transform = {};
  transform.rest = Rest::Ground;  // the box starts at y = 2
  CHECK(objectPivot(transform, box, 7) == glm::dvec3(0, 5, 0));
}

TEST_CASE("the ground is the receiver's plane") {
  SceneDescription scene;
  CHECK(groundHeight(scene) == 0);
  scene.receiver.emplace().center = {1, -2, 3};
  CHECK(groundHeight(scene) == -2);
}

TEST_CASE("fit refuses a mesh of one point or none") {
  TransformDescription transform;
  transform.fit = 2;
  const std::vector<glm::vec3> point{{1, 2, 3}, {1, 2, 3}};
  const char* message = "transform.fit: the mesh has no extent that could be scaled";
  CHECK_THROWS_WITH_AS(objectToWorld(transform, point, 0), message, InputError);
  CHECK_THROWS_WITH_AS(objectToWorld(transform, {}, 0), message, InputError);
}

TEST_CASE("a solid rests on its own lowest point, which no vertex need know") {
  TransformDescription transform;
  transform.scale = glm::dvec3(2);
  transform.rotateDegrees = {0, 0, 90};  // +y to −x
  transform.rest = Rest::Ground;
  transform.translate = {1, 2, 3};
  // Lying on its side: a rim of radius 2 is lowest.
  const Shape shape = ConeShape{1, 4, 0};
  checkPoint(solidToWorld(transform, shape, 0.5), {0, 0, 0}, {1, 0.5 + 2 + 2, 3});
  checkPoint(solidToWorld(transform, shape, 0.5), {0, 2, 0}, {1 - 4, 4.5, 3});
  CHECK(glm::distance(solidPivot(transform, shape, 0.5), glm::dvec3(1, 4.5, 3)) < 1e-14);
  transform.rotateDegrees = {0, 0, 33};
  transform.scale = glm::dvec3(1);
  // The furthest point of an ellipsoid down the world's y, seen from its own axes.
  const double angle = glm::radians(33.0), x = 3 * std::sin(angle), y = std::cos(angle);
  CHECK(solidPivot(transform, Shape(EllipsoidShape{{3, 1, 5}}), 0).y ==
        doctest::Approx(2 + std::hypot(x, y)).epsilon(1e-14));
}
