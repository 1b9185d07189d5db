#include "mesh/ray_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_transform.h"
#include "mesh/random.h"

using namespace haarlight;

namespace {

glm::vec3 randomVector(Random& random) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return glm::vec3(2 * x - 1, 2 * y - 1, 2 * z - 1);
}

/// Distance to where a ray enters, or leaves, the sphere of this radius around the origin in
/// lengths of `direction`, or -1.
double sphereDistance(const glm::dvec3& origin, const glm::dvec3& direction, double radius,
                      bool leaving = false) {
  const double a = glm::dot(direction, direction), b = glm::dot(origin, direction);
  const double discriminant = b * b - a * (glm::dot(origin, origin) - radius * radius);
  const double root = std::sqrt(std::max(discriminant, 0.0));
  return discriminant < 0 ? -1 : (leaving ? -b + root : -b - root) / a;
}

}  // namespace

TEST_CASE("rays meet a fine sphere where they meet the true one") {
  const TriangleMesh sphere = icosphere(6);
  const RayScene scene(sphere);
  // Every triangle lies between the spheres of radius 1 and of the centres' distance.
  double inner = 1;
  for (const auto& t : sphere.triangles)
    inner = std::min(inner, double(glm::length(sphere.positions[t.x] + sphere.positions[t.y] +
                                               sphere.positions[t.z])) /
                                3);
  inner -= 1e-6;
  Random random(3);
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const glm::vec3 origin = 3.0f * glm::normalize(randomVector(random));
    const glm::vec3 direction = randomVector(random) - origin;
    const double outer = sphereDistance(origin, direction, 1 + 1e-6);
    const auto hit = scene.closestHit(origin, direction);
    CHECK(scene.occluded(origin, direction) == hit.has_value());
    if (outer < 0) CHECK_FALSE(hit);
    const double nearest = sphereDistance(origin, direction, inner);
    if (nearest < 0) continue;
    ++hits;
    REQUIRE(hit);
    CHECK(hit->distance >= outer - 1e-6);
    CHECK(hit->distance <= nearest + 1e-6);
    const glm::vec3 normal = glm::normalize(hit->position);
    CHECK(glm::distance(hit->shadingNormal, normal) < 1e-3f);
    CHECK(glm::dot(hit->geometricNormal, normal) > 0.999f);
    const glm::uvec3& t = sphere.triangles[hit->triangle];
    const glm::vec2 w = hit->barycentric;
    const glm::vec3 combined = (1 - w.x - w.y) * sphere.positions[t.x] +
                               w.x * sphere.positions[t.y] + w.y * sphere.positions[t.z];
    CHECK(glm::distance(combined, hit->position) < 1e-5f);
  }
  CHECK(hits > 1000);
}

TEST_CASE("the geometric normal is the winding's, also from behind") {
  TriangleMesh triangle{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {{0, 1, 2}}};
  const RayScene scene(triangle);
  for (const float side : {1.0f, -1.0f}) {
    const auto hit = scene.closestHit({0.2f, 0.3f, 4 * side}, {0, 0, -2 * side});
    REQUIRE(hit);
    CHECK(hit->geometricNormal == glm::vec3(0, 0, 1));
    CHECK(hit->distance == doctest::Approx(2));
    CHECK(hit->barycentric.x == doctest::Approx(0.2));
    CHECK(hit->barycentric.y == doctest::Approx(0.3));
  }
  CHECK_FALSE(scene.closestHit({0.2f, 0.3f, 4}, {0, 0, -2}, 2.01f));
  CHECK_FALSE(scene.occluded({0.2f, 0.3f, 4}, {0, 0, -2}, 2.01f));
  CHECK(scene.occluded({0.2f, 0.3f, 4}, {0, 0, -2}, 1.99f));
}

TEST_CASE("hits name their object, and empty objects keep their number") {
  const TriangleMesh sphere = icosphere(2), empty;
  const TriangleMesh right = transformed(sphere, glm::translate(glm::mat4(1), glm::vec3(5, 0, 0)));
  const RayScene scene(std::array{&sphere, &empty, &right});
  CHECK(scene.closestHit({0, 0, 3}, {0, 0, -1})->object == 0);
  CHECK(scene.closestHit({5, 0, 3}, {0, 0, -1})->object == 2);
  CHECK_FALSE(RayScene(empty).occluded({0, 0, 3}, {0, 0, -1}));
}

TEST_CASE("sixteen rays at once see what single rays see, on all threads") {
  const TriangleMesh knot = torusKnot();
  const RayScene scene(knot);
  std::atomic<int> differences = 0, hits = 0;
  parallelFor(500, 10, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Random random(i);
      std::array<glm::vec3, 16> origins, directions;
      for (int ray = 0; ray < 16; ++ray) {
        origins[ray] = randomVector(random);
        directions[ray] = randomVector(random);
      }
      const auto valid = static_cast<std::uint16_t>(random.next());
      const std::uint16_t mask = scene.occluded16(origins, directions, valid, 0.01f);
      for (int ray = 0; ray < 16; ++ray) {
        const bool expected =
            (valid >> ray & 1) && scene.occluded(origins[ray], directions[ray], 0.01f);
        differences += (mask >> ray & 1) != expected;
        hits += expected;
      }
    }
  });
  CHECK(differences.load() == 0);
  CHECK(hits.load() > 500);
}

TEST_CASE("sixteen rays from a point meet what single rays meet") {
  const TriangleMesh knot = torusKnot(), ball = icosphere(2);
  const RayScene scene(std::array{&knot, &ball});
  Random random(9);
  int met = 0;
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 origin = randomVector(random);
    std::array<glm::vec3, 16> directions;
    for (glm::vec3& direction : directions) direction = randomVector(random);
    const auto valid = static_cast<std::uint16_t>(random.next());
    std::array<TriangleHit, 16> hits{};
    const std::uint16_t mask = scene.closestHits16(origin, directions, hits, valid, 0.01f);
    CHECK((mask & ~valid) == 0);
    for (int ray = 0; ray < 16; ++ray) {
      if (!(valid >> ray & 1)) continue;
      const auto single = scene.closestHit(origin, directions[ray], 0.01f);
      REQUIRE(bool(mask >> ray & 1) == single.has_value());
      if (!single) continue;
      ++met;
      CHECK(hits[ray].object == single->object);
      CHECK(hits[ray].distance == doctest::Approx(single->distance).epsilon(1e-5));
      if (hits[ray].triangle == single->triangle)  // else they meet in an edge
        CHECK(glm::distance(hits[ray].barycentric, single->barycentric) < 1e-3f);
    }
  }
  CHECK(met > 500);
}

TEST_CASE("rays meet spheres where they meet the true ones") {
  Random random(5);
  std::vector<Sphere> spheres;
  for (int i = 0; i < 40; ++i)
    spheres.push_back({randomVector(random), static_cast<float>(0.02 + 0.2 * random.uniform())});
  const RayScene scene(spheres);
  int hits = 0, misses = 0, differences = 0;
  for (int i = 0; i < 500; ++i) {
    std::array<glm::vec3, 16> origins, directions;
    unsigned expected = 0, undecided = 0;
    for (int ray = 0; ray < 16; ++ray) {
      origins[ray] = 1.5f * randomVector(random);
      directions[ray] = randomVector(random);
      for (const Sphere& sphere : spheres) {
        const glm::dvec3 origin = origins[ray] - sphere.center;
        // A ray that starts in a sphere meets it from within.
        const auto meets = [&](double radius) {
          return sphereDistance(origin, directions[ray], radius, true) > 0;
        };
        if (meets(sphere.radius * 0.9999))
          expected |= 1u << ray;
        else if (meets(sphere.radius * 1.0001))
          undecided |= 1u << ray;
      }
    }
    const auto valid = static_cast<std::uint16_t>(random.next());
    const unsigned mask = scene.occluded16(origins, directions, valid);
    for (int ray = 0; ray < 16; ++ray) {
      const bool hit = expected >> ray & 1;
      if (!hit && (undecided >> ray & 1)) continue;
      ++(hit ? hits : misses);
      differences += scene.occluded(origins[ray], directions[ray]) != hit;
      differences += (mask >> ray & 1) != (hit && (valid >> ray & 1));
    }
  }
  CHECK(differences == 0);
  CHECK(hits > 500);
  CHECK(misses > 500);
}

TEST_CASE("rays to spheres begin where they are told, and no spheres block nothing") {
  const RayScene scene(std::vector<Sphere>{{{0, 0, -4}, 1}});
  CHECK(scene.occluded({0, 0, 0}, {0, 0, -2}));
  CHECK_FALSE(scene.occluded({0, 0, 0}, {0, 0, 2}));
  CHECK_FALSE(scene.occluded({1.01f, 0, 0}, {0, 0, -2}));
  CHECK(scene.occluded({0.99f, 0, 0}, {0, 0, -2}));
  CHECK(scene.occluded({0, 0, 0}, {0, 0, -2}, 1.49f));
  CHECK_FALSE(scene.occluded({0, 0, 0}, {0, 0, -2}, 2.51f));
  CHECK_FALSE(RayScene(std::span<const Sphere>{}).occluded({0, 0, 0}, {0, 0, -2}));
}

TEST_CASE("of sixteen rays, those that end before the mesh meet nothing") {
  const RayScene scene(groundGrid(1, 1));
  std::array<glm::vec3, 16> origins, directions;
  for (int i = 0; i < 16; ++i)
    origins[i] = {0.1f, 0.5f + 0.25f * float(i), 0.2f}, directions[i] = {0, -2, 0};
  // From heights 0.5, 0.75 … 4.25, with ends 2 further down.
  CHECK(scene.occluded16(origins, directions, 0xffff, 0, 1) == 0b1111111);
  CHECK(scene.occluded16(origins, directions) == 0xffff);
}
