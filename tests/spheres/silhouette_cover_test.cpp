#include "spheres/silhouette_cover.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

#include "mesh/builtin_meshes.h"
#include "mesh/mesh_measures.h"
#include "mesh/test_meshes.h"
#include "spheres/random_spheres.h"
#include "spheres/view_pixels.h"
#include "spheres/viewpoints.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

using Views = SilhouetteCover::Views;

std::shared_ptr<const Views> viewsFrom(const TriangleMesh& mesh,
                                       const std::vector<glm::dvec3>& eyes, int pixels) {
  const RayScene scene(mesh);
  auto views = std::make_shared<Views>();
  for (const glm::dvec3& eye : eyes) views->emplace_back(mesh, scene, eye, pixels);
  return views;
}

std::shared_ptr<const Views> viewsAround(const TriangleMesh& mesh, std::size_t count, int pixels) {
  return viewsFrom(mesh, viewpointsAround(boundingBox(mesh), count, 1), pixels);
}

/// The error of balls by a look at each pixel of each view.
double errorOf(const Views& views, const std::vector<Ball>& balls) {
  double sum = 0;
  for (const SilhouetteView& view : views)
    for (int row = 0; row < view.height(); ++row)
      for (int column = 0; column < view.width(); ++column) {
        const float whenBlocked = view.errors()[std::size_t(row) * view.width() + column];
        const bool blocked = std::ranges::any_of(balls, [&](const Ball& ball) {
          return ball.radius >= 0 && blocks(view, view.discOf(ball), column, row);
        });
        if (blocked != (whenBlocked < 0)) sum += std::abs(whenBlocked);
      }
  return sum / double(views.size());
}

Ball randomBall(Random& random) {
  return {randomDirection(random) * random.uniform(), 0.05 + 0.5 * random.uniform()};
}

/// As a fit uses it: proposals that help are taken.
void refine(SilhouetteCover& cover, std::size_t index, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    const Ball old = cover.balls()[index];
    const double before = cover.error();
    cover.replace(index, cover.refined(index));
    if (cover.error() > before) cover.replace(index, old);
  }
}

}  // namespace

TEST_CASE("balls around and within a sphere err by the ratio of solid angles") {
  const TriangleMesh sphere = icosphere(5);
  for (const double distance : {1.8, 4.0}) {
    std::vector<glm::dvec3> eyes;
    for (const glm::dvec3& direction : directionsInCap({0, 0, 1}, -1, 6, 0))
      eyes.push_back(distance * direction);
    const auto views = viewsFrom(sphere, eyes, 160);
    const auto solidAngle = [&](double radius) {
      return 1 - std::sqrt(1 - radius * radius / (distance * distance));
    };
    CHECK(SilhouetteCover(views).error() == 1);
    for (const double size : {0.3, 0.7, 0.95, 1.05, 1.1}) {
      SilhouetteCover cover(views);
      cover.add({glm::dvec3(0), size});
      const double expected = std::abs(solidAngle(size) / solidAngle(1) - 1);
      CHECK(std::abs(cover.error() - expected) < 0.006);
    }
    SilhouetteCover exact(views);
    exact.add({glm::dvec3(0), 1});
    CHECK(exact.error() < 0.01);
  }
}

TEST_CASE("the error of a silhouette cover is that of all its pixels") {
  const auto views = viewsAround(torusKnot(), 5, 50);
  SilhouetteCover cover(views);
  std::vector<Ball> balls;
  Random random(5);
  for (int i = 0; i < 60; ++i) {
    const Ball ball = i % 7 == 6 ? Ball{glm::dvec3(0), -1} : randomBall(random);
    const std::size_t index = random.next() % (balls.size() + 1);
    const double before = cover.error();
    if (index == balls.size()) {
      const double gain = cover.gainOf(ball);
      cover.add(ball);
      balls.push_back(ball);
      CHECK(std::abs(before - cover.error() - gain) < 1e-5);
    } else {
      cover.replace(index, ball);
      balls[index] = ball;
    }
    CHECK(std::abs(cover.error() - errorOf(*views, balls)) < 1e-5);
    REQUIRE(cover.balls().size() == balls.size());
    CHECK(cover.balls()[std::min(index, balls.size() - 1)].radius == ball.radius);
  }
}

TEST_CASE("what a ball gains or loses is what the error changes by without it") {
  const auto views = viewsAround(torusKnot(), 5, 50);
  SilhouetteCover cover(views);
  Random random(6);
  for (int i = 0; i < 12; ++i) cover.add(randomBall(random));
  for (std::size_t i = 0; i < 12; ++i) {
    SilhouetteCover without = cover;
    without.replace(i, {glm::dvec3(0), -1});
    CHECK(std::abs(cover.lossOf(i) - (without.error() - cover.error())) < 1e-5);
    CHECK(std::abs(without.gainOf(cover.balls()[i]) - cover.lossOf(i)) < 1e-5);
    CHECK(without.lossOf(i) == 0);
    CHECK(std::abs(errorOf(*views, without.balls()) - without.error()) < 1e-5);
  }
  cover.add(cover.balls()[0]);  // a second one of the same changes nothing, and neither is missed
  CHECK(cover.lossOf(0) == 0);
  CHECK(cover.lossOf(12) == 0);
  CHECK(cover.gainOf(cover.balls()[0]) == 0);
}

TEST_CASE("balls behind the eye change no error, a ball around it blocks the whole view") {
  const glm::dvec3 eye(0, 0, 2.5);
  const auto views = viewsFrom(icosphere(4), {eye}, 64);
  SilhouetteCover cover(views);
  CHECK(cover.gainOf({{0.2, 0.3, 5}, 1}) == 0);
  CHECK(cover.gainOf({{0, 0, 3}, 0.4}) == 0);
  double free = 0;
  for (const float error : (*views)[0].errors()) free += std::max(error, 0.0f);
  for (const double z : {2.4, 2.5, 2.6}) {
    CHECK(std::abs(cover.gainOf({{0, 0, z}, 0.3}) - (1 - free)) < 1e-5);
    cover.add({{0, 0, z}, 0.3});
    CHECK(std::abs(cover.error() - free) < 1e-5);
    const Ball refined = cover.refined(cover.balls().size() - 1);
    CHECK(std::isfinite(refined.radius + glm::length(refined.center)));
    cover.replace(cover.balls().size() - 1, {glm::dvec3(0), -1});
    CHECK(std::abs(cover.error() - 1) < 1e-5);
  }
}

TEST_CASE("refining moves a displaced ball to where the sphere is") {
  const auto views = viewsAround(icosphere(4), 16, 96);
  Random random(7);
  for (int i = 0; i < 6; ++i) {
    SilhouetteCover cover(views);
    cover.add({randomDirection(random) * 0.4, 0.6 + 0.6 * random.uniform()});
    const double before = cover.error();
    refine(cover, 0, 1);
    CHECK(cover.error() < before / 2);
    refine(cover, 0, 4);
    CHECK(glm::length(cover.balls()[0].center) < 0.02);
    CHECK(std::abs(cover.balls()[0].radius - 1) < 0.02);
    CHECK(cover.error() < 0.02);
  }
}

TEST_CASE("refining heeds what the other balls block") {
  // Two spheres that run into each other, one of which is covered already.
  const TriangleMesh pair =
      combined(sphereAt({-0.6f, 0, 0}, 1, 4), sphereAt({0.7f, 0, 0}, 0.8f, 4));
  SilhouetteCover cover(viewsAround(pair, 16, 96));
  cover.add({{-0.6, 0, 0}, 1});
  cover.add({{0.5, 0.2, -0.2}, 0.6});
  refine(cover, 1, 5);
  CHECK(glm::distance(cover.balls()[1].center, glm::dvec3(0.7, 0, 0)) < 0.05);
  CHECK(std::abs(cover.balls()[1].radius - 0.8) < 0.05);
  CHECK(cover.error() < 0.02);

  cover.replace(1, {glm::dvec3(0), -1});
  CHECK(cover.refined(1).radius == -1);
}
