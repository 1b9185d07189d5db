#include "spheres/sphere_cover.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

#include "mesh/mesh_measures.h"
#include "mesh/test_meshes.h"
#include "spheres/fit_shapes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// Three small spheres in a row, in a box of size 1.
constexpr float size = 0.1f;
const std::vector<glm::vec3> places = {{-0.4f, 0, 0}, {0, 0, 0}, {0.4f, 0, 0}};

TriangleMesh threeSpheres() {
  TriangleMesh mesh;
  for (const glm::vec3& place : places) mesh = combined(mesh, sphereAt(place, size));
  return mesh;
}

/// Points on the surface, in the order of PointBlocks.
std::shared_ptr<const PointBlocks> pointsOn(const TriangleMesh& mesh, std::size_t count) {
  return std::make_shared<const PointBlocks>(sampleSurface(mesh, count, 1));
}

/// Groups by function(point).
template <typename Function>
std::vector<std::uint32_t> groupsBy(const PointBlocks& points, const Function& function) {
  std::vector<std::uint32_t> groups;
  for (const glm::vec3& point : points.points())
    groups.push_back(static_cast<std::uint32_t>(function(point)));
  return groups;
}

int missed(const SphereCover& cover) {
  return static_cast<int>(std::ranges::count_if(cover.points()->points(), [&](const auto& point) {
    return std::ranges::none_of(cover.balls(),
                                [&](const Ball& ball) { return covers(ball, point); });
  }));
}

std::size_t used(const SphereCover& cover) {
  return std::size_t(
      std::ranges::count_if(cover.balls(), [](const Ball& ball) { return ball.radius >= 0; }));
}

bool holdsBallAt(const SphereCover& cover, const glm::dvec3& center, double radius) {
  return std::ranges::any_of(cover.balls(), [&](const Ball& ball) {
    return glm::distance(ball.center, center) < 0.1 * radius &&
           std::abs(ball.radius - radius) < 0.1 * radius;
  });
}

}  // namespace

TEST_CASE("each group of points gets the ball around it that bulges out least") {
  const TriangleMesh mesh = threeSpheres();
  const SolidGrid solid(mesh, 128);
  const auto points = pointsOn(mesh, 900);
  const auto place = [](const glm::vec3& p) { return p.x < -0.2f ? 0 : p.x < 0.2f ? 2 : 3; };
  const SphereCover cover(points, groupsBy(*points, place), 5, solid);
  REQUIRE(cover.balls().size() == 3);  // groups 1 and 4 are empty
  CHECK(missed(cover) == 0);
  for (const glm::vec3& center : places) CHECK(holdsBallAt(cover, center, size));
  CHECK(cover.cost() == cover.cost(0) + cover.cost(1) + cover.cost(2));
  CHECK(cover.cost() < 0.05 * solid.volume());
}

TEST_CASE("a ball around a cap of a sphere leans into the solid") {
  // A larger ball around a cap may bulge out less than the smallest: where it reaches further into
  // the sphere, that costs nothing.
  const TriangleMesh sphere = sphereAt({0, 0, 0}, 0.5f, 4);
  const SolidGrid solid(sphere, 64);
  std::vector<glm::vec3> cap = sampleSurface(sphere, 3000, 1);
  std::erase_if(cap, [](const glm::vec3& p) { return p.x < 0.25f; });
  const auto points = std::make_shared<const PointBlocks>(cap);
  const SphereCover cover(points, std::vector<std::uint32_t>(cap.size()), 1, solid);
  REQUIRE(cover.balls().size() == 1);
  const Ball smallest = minimumEnclosingBall(cap);
  CHECK(smallest.radius < 0.45);
  CHECK(cover.balls()[0].radius > smallest.radius);
  CHECK(cover.balls()[0].center.x < smallest.center.x);
  CHECK(cover.cost() < 0.7 * solid.outsideVolume(smallest));
}

TEST_CASE("a refit lets go of what another ball holds, and misses no point") {
  const TriangleMesh mesh = threeSpheres();
  const SolidGrid solid(mesh, 128);
  const auto points = pointsOn(mesh, 900);
  // A few points of the second sphere are with the first.
  int turn = 0;
  const auto group = [&](const glm::vec3& p) {
    return p.x < -0.2f ? 0 : p.x > 0.2f ? 2 : ++turn % 10 == 0 ? 0 : 1;
  };
  SphereCover cover(points, groupsBy(*points, group), 3, solid);
  CHECK(cover.balls()[0].radius > 0.2);
  const double before = cover.cost();
  cover.refit();
  CHECK(cover.cost() < 0.1 * before);
  CHECK(missed(cover) == 0);
  for (const glm::vec3& center : places) CHECK(holdsBallAt(cover, center, size));
}

TEST_CASE("a refit never raises the cost") {
  const TriangleMesh knot = torusKnot();
  const SolidGrid solid(knot, 64);
  const auto points = pointsOn(knot, 3000);
  Random random(1);
  const auto group = [&](const glm::vec3&) { return random.next() % 20; };
  SphereCover cover(points, groupsBy(*points, group), 20, solid);
  for (int round = 0; round < 3; ++round) {
    const double before = cover.cost();
    cover.refit();
    CHECK(cover.cost() <= before);
    CHECK(missed(cover) == 0);
    CHECK(used(cover) == cover.balls().size());
  }
}

TEST_CASE("a refit drops balls without a task") {
  const TriangleMesh sphere = sphereAt({0, 0, 0}, 0.5f, 4);
  const SolidGrid solid(sphere, 64);
  std::vector<glm::vec3> all = sampleSurface(sphere, 1000, 1);
  const std::vector<glm::vec3> inner = sampleSurface(sphereAt({0.1f, 0, 0}, 0.2f), 200, 2);
  all.insert(all.end(), inner.begin(), inner.end());
  const auto points = std::make_shared<const PointBlocks>(all);
  const auto isOuter = [](const glm::vec3& p) { return glm::length(p) > 0.4f; };
  SphereCover cover(points, groupsBy(*points, isOuter), 2, solid);
  CHECK(cover.balls().size() == 2);
  cover.refit();
  REQUIRE(cover.balls().size() == 1);
  CHECK(missed(cover) == 0);
  CHECK(holdsBallAt(cover, glm::dvec3(0), 0.5));
}

TEST_CASE("splitting finds parts far from each other and stops where it gains nothing") {
  const TriangleMesh mesh = combined(sphereAt(places[0], size), sphereAt(places[2], size));
  const SolidGrid solid(mesh, 128);
  const auto points = pointsOn(mesh, 900);
  const auto together = [](const glm::vec3&) { return 0; };
  SphereCover cover(points, groupsBy(*points, together), 1, solid);
  CHECK(holdsBallAt(cover, glm::dvec3(0), 0.5));
  cover.splitUpTo(1);
  CHECK(cover.balls().size() == 1);
  cover.splitUpTo(2);
  REQUIRE(cover.balls().size() == 2);
  CHECK(missed(cover) == 0);
  for (const glm::vec3& center : {places[0], places[2]}) CHECK(holdsBallAt(cover, center, size));

  // A ball that does not bulge out costs nothing.
  const TriangleMesh sphere = sphereAt({0, 0, 0}, 0.5f, 4);
  const auto inner = pointsOn(sphereAt({0, 0, 0}, 0.3f), 300);
  const SolidGrid solidSphere(sphere, 64);
  SphereCover single(inner, groupsBy(*inner, together), 1, solidSphere);
  CHECK(single.cost() < 1e-6 * ballVolume(0.3));
  single.splitUpTo(10);
  CHECK(single.balls().size() == 1);
}

TEST_CASE("teleportation takes a needless ball to where one is missing") {
  const TriangleMesh mesh = threeSpheres();
  const SolidGrid solid(mesh, 128);
  const auto points = pointsOn(mesh, 900);
  // Two balls share the first sphere, one spans the second and third.
  const auto place = [](const glm::vec3& p) { return p.x > -0.2f ? 2 : p.y > 0 ? 1 : 0; };
  const SphereCover before(points, groupsBy(*points, place), 3, solid);
  REQUIRE(before.balls().size() == 3);
  SphereCover cover = before;
  cover.teleport(0, 2);
  CHECK(missed(cover) == 0);
  CHECK(cover.cost() < 0.1 * before.cost());
  for (const glm::vec3& center : places) CHECK(holdsBallAt(cover, center, size));
  // The original is as it was.
  CHECK(before.balls()[2].radius > 0.25);
  CHECK(missed(before) == 0);
}

TEST_CASE("no teleportation leaves a point out") {
  const TriangleMesh knot = torusKnot();
  const SolidGrid solid(knot, 64);
  const auto points = pointsOn(knot, 2000);
  Random random(5);
  const auto slice = [](const glm::vec3& p) { return (std::atan2(p.z, p.x) + 3.15f) * 1.9f; };
  SphereCover cover(points, groupsBy(*points, slice), 12, solid);
  for (int i = 0; i < 40; ++i) {
    const std::size_t count = cover.balls().size();
    const std::size_t from = random.next() % count;
    const std::size_t divided = (from + 1 + random.next() % (count - 1)) % count;
    cover.teleport(from, divided);
    REQUIRE(missed(cover) == 0);
    CHECK(cover.balls().size() == count);
    CHECK(std::isfinite(cover.cost()));
  }
}

TEST_CASE("further points are taken up by the ball that grows least, and only that grows") {
  const TriangleMesh mesh = threeSpheres();
  const SolidGrid solid(mesh, 128);
  const auto points = pointsOn(mesh, 900);
  const auto place = [](const glm::vec3& p) { return p.x < -0.2f ? 0 : p.x < 0.2f ? 1 : 2; };
  SphereCover cover(points, groupsBy(*points, place), 3, solid);
  const std::vector<Ball> before = cover.balls();
  const glm::vec3 further(0.25f, 0.05f, 0);  // between the second and the third, nearer to that
  const std::vector<glm::vec3> added = {further, {0, 0.05f, 0}};
  cover.addPoints(added);
  CHECK(cover.points()->points().size() == points->points().size() + added.size());
  CHECK(missed(cover) == 0);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(cover.balls()[i].center == before[i].center);
    if (before[i].center.x < 0.2)
      CHECK(cover.balls()[i].radius == before[i].radius);
    else
      CHECK(cover.balls()[i].radius ==
            doctest::Approx(glm::distance(before[i].center, glm::dvec3(further))));
  }
  CHECK(cover.cost() > 0);
}

TEST_CASE("the exclusive share of a ball is the part of its points that no other holds") {
  const TriangleMesh sphere = sphereAt({0, 0, 0}, 0.5f, 4);
  const SolidGrid solid(sphere, 64);
  const auto points = pointsOn(sphere, 2000);
  const auto half = [](const glm::vec3& p) { return p.x < 0 ? 0 : 1; };
  const SphereCover cover(points, groupsBy(*points, half), 2, solid);
  for (std::size_t b = 0; b < 2; ++b) {
    int held = 0, alone = 0;
    for (const glm::vec3& point : points->points()) {
      if (!covers(cover.balls()[b], point)) continue;
      ++held;
      alone += !covers(cover.balls()[1 - b], point);
    }
    CHECK(cover.exclusiveShare(b) == double(alone) / held);
  }
}
