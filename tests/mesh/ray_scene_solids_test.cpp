#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <vector>

#include "mesh/builtin_meshes.h"
#include "mesh/random.h"
#include "mesh/ray_scene.h"

using namespace haarlight;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

glm::vec3 randomVector(Random& random) {
  const auto number = [&] { return float(2 * random.uniform() - 1); };
  const float x = number(), y = number();
  return {x, y, number()};
}

Placement randomPlacement(Random& random) {
  const glm::vec3 axis = randomVector(random);
  const glm::dquat turn = glm::normalize(glm::dquat(random.uniform(), glm::dvec3(axis)));
  return Placement(2.0 * glm::dvec3(randomVector(random)), glm::mat3_cast(turn));
}

/// Two of each shape, somewhere.
std::vector<Solid> randomSolids(Random& random) {
  std::vector<Solid> solids;
  for (int i = 0; i < 2; ++i)
    for (const Shape& shape : {Shape(SphereShape{0.4}), Shape(EllipsoidShape{{0.5, 0.1, 0.3}}),
                               Shape(BoxShape{{0.3, 0.2, 0.4}}), Shape(CylinderShape{0.2, 1}),
                               Shape(ConeShape{0.4, 0.8, 0}), Shape(TorusShape{0.4, 0.15})})
      solids.emplace_back(shape, randomPlacement(random));
  return solids;
}

std::vector<Occluder> occludersOf(const std::vector<Solid>& solids) {
  std::vector<Occluder> occluders;
  for (const Solid& solid : solids) occluders.push_back(&solid);
  return occluders;
}

struct FirstHit {
  std::size_t object = 0;
  SolidHit hit{infinity, {}};
};

FirstHit firstHit(const std::vector<Solid>& solids, const Ray& ray) {
  FirstHit first;
  for (std::size_t i = 0; i < solids.size(); ++i)
    if (const auto hit = solids[i].intersect(ray); hit && hit->t < first.hit.t) first = {i, *hit};
  return first;
}

/// Sixteen random rays; single queries are made along them, too.
struct Packet {
  explicit Packet(Random& random) {
    origins.fill(2.0f * randomVector(random));
    for (glm::vec3& direction : directions) direction = 2.0f * randomVector(random);
    valid = static_cast<std::uint16_t>(random.next());
  }

  Ray ray(std::size_t i, double near, double far) const {
    return {origins[i], directions[i], near, far};
  }

  std::array<glm::vec3, 16> origins, directions;
  std::uint16_t valid;
};

}  // namespace

TEST_CASE("rays meet solids where their formulas say") {
  Random random(3);
  const std::vector<Solid> solids = randomSolids(random);
  const RayScene scene(occludersOf(solids));
  int hits = 0, misses = 0;
  for (int i = 0; i < 2000; ++i) {
    const Packet packet(random);
    const FirstHit expected = firstHit(solids, packet.ray(0, 0.05f, infinity));
    const auto hit = scene.closestHit(packet.origins[0], packet.directions[0], 0.05f);
    REQUIRE(hit.has_value() == (expected.hit.t < infinity));
    ++(hit ? hits : misses);
    if (!hit) continue;
    CHECK(hit->object == expected.object);
    CHECK(hit->distance == float(expected.hit.t));
    CHECK(hit->triangle == 0);
    CHECK(hit->barycentric == glm::vec2(0));
    CHECK(glm::distance(hit->geometricNormal, glm::vec3(expected.hit.normal)) < 1e-6f);
    CHECK(hit->shadingNormal == hit->geometricNormal);
    CHECK(glm::distance(glm::dvec3(hit->position), packet.ray(0, 0, 1).at(expected.hit.t)) < 2e-6);
  }
  CHECK(hits > 200);
  CHECK(misses > 300);
}

TEST_CASE("sixteen rays meet solids as single ones do, and only those that count") {
  Random random(4);
  const std::vector<Solid> solids = randomSolids(random);
  const RayScene scene(occludersOf(solids));
  int hits = 0, differences = 0;
  for (int i = 0; i < 500; ++i) {
    const Packet packet(random);
    std::array<TriangleHit, 16> met{};
    const auto mask = scene.closestHits16(packet.origins[0], packet.directions, met, packet.valid);
    for (std::size_t ray = 0; ray < 16; ++ray) {
      const FirstHit expected = firstHit(solids, packet.ray(ray, 0, infinity));
      const bool hit = (packet.valid >> ray & 1) && expected.hit.t < infinity;
      differences += bool(mask >> ray & 1) != hit;
      if (!hit) continue;
      ++hits;
      differences += met[ray].object != expected.object || met[ray].triangle != 0 ||
                     met[ray].distance != float(expected.hit.t);
    }
  }
  CHECK(differences == 0);
  CHECK(hits > 400);
}

TEST_CASE("solids stand in the way of light as their formulas say, one ray or sixteen") {
  Random random(5);
  const std::vector<Solid> solids = randomSolids(random);
  const RayScene scene(occludersOf(solids));
  int blockedRays = 0, clear = 0, differences = 0;
  for (int i = 0; i < 500; ++i) {
    const Packet packet(random);
    const float far = i % 2 ? 1 : std::numeric_limits<float>::infinity();
    const auto mask = scene.occluded16(packet.origins, packet.directions, packet.valid, 0.1f, far);
    for (std::size_t ray = 0; ray < 16; ++ray) {
      const auto blocks = [&](double end) {
        return std::ranges::any_of(
            solids, [&](const Solid& solid) { return solid.blocks(packet.ray(ray, 0.1f, end)); });
      };
      const bool blocked = blocks(far);
      ++(blocked ? blockedRays : clear);
      differences += bool(mask >> ray & 1) != (blocked && (packet.valid >> ray & 1));
      differences +=
          scene.occluded(packet.origins[ray], packet.directions[ray], 0.1f) != blocks(infinity);
    }
  }
  CHECK(differences == 0);
  CHECK(blockedRays > 500);
  CHECK(clear > 1000);
}

TEST_CASE("a ray wholly inside a solid is blocked and meets nothing") {
  const Solid ball(SphereShape{4});
  const RayScene scene(std::vector<Occluder>{&ball});
  std::array<glm::vec3, 16> origins{}, directions;
  directions.fill({0, 1, 0});
  CHECK(scene.occluded16(origins, directions, 0x0f0f, 0, 1) == 0x0f0f);
  const auto hit = scene.closestHit({0, 0, 0}, {0, 1, 0});
  REQUIRE(hit);
  CHECK(hit->distance == 4);
  CHECK(hit->geometricNormal == glm::vec3(0, 1, 0));
}

TEST_CASE("meshes and solids meet rays side by side") {
  const TriangleMesh ground = groundGrid(2, 4), nothing;
  const Solid ball(SphereShape{0.5}, Placement({0, 1, 0}));
  const RayScene scene(std::vector<Occluder>{&nothing, &ground, &ball});
  const auto through = scene.closestHit({0, 5, 0}, {0, -1, 0});
  REQUIRE(through);
  CHECK(through->object == 2);
  CHECK(through->distance == 3.5f);
  const auto beside = scene.closestHit({0.6f, 5, 0.1f}, {0, -1, 0});
  REQUIRE(beside);
  CHECK(beside->object == 1);
  CHECK(beside->distance == 5);
  CHECK(beside->barycentric != glm::vec2(0));
  CHECK(beside->shadingNormal == glm::vec3(0, 1, 0));
  CHECK_FALSE(scene.closestHit({3, 5, 0}, {0, -1, 0}));
}

TEST_CASE("no occluders block nothing, and solids far out are met") {
  CHECK_FALSE(RayScene(std::span<const Occluder>{}).occluded({0, 0, 0}, {0, 1, 0}));
  const Solid far(SphereShape{1}, Placement({1e6, 0, 0}));
  const RayScene scene(std::vector<Occluder>{&far});
  int differences = 0;
  for (int i = -60; i <= 60; ++i) {
    const glm::vec3 origin(1e6f, float(i) / 50, -3);
    differences +=
        scene.occluded(origin, {0, 0, 1}) != far.blocks({origin, {0, 0, 1}, 0, infinity});
  }
  CHECK(differences == 0);
}
