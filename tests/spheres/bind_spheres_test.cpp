#include "spheres/bind_spheres.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <random>

#include "base/error.h"
#include "mesh/builtin_meshes.h"

using namespace haarlight;

namespace {

std::vector<glm::vec4> padded(const std::vector<glm::vec3>& positions) {
  std::vector<glm::vec4> result;
  for (const glm::vec3& position : positions) result.emplace_back(position, 0);
  return result;
}

template <typename Motion>
std::vector<glm::vec4> moved(const TriangleMesh& mesh, const Motion& motion) {
  std::vector<glm::vec4> result;
  for (const glm::vec3& position : mesh.positions)
    result.emplace_back(glm::vec3(motion(glm::dvec3(position))), 0);
  return result;
}

/// Balls of one size around points spread over a mesh.
std::vector<Sphere> ballsOn(const TriangleMesh& mesh, std::size_t count, float radius) {
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < count; ++i)
    spheres.push_back({0.9f * mesh.positions[i * mesh.positions.size() / count], radius});
  return spheres;
}

bool contains(const Sphere& sphere, const glm::vec3& point) {
  return glm::length(glm::dvec3(point) - glm::dvec3(sphere.center)) <=
         double(sphere.radius) * (1 + 1e-5);
}

bool someContains(const std::vector<Sphere>& spheres, const glm::vec3& a, const glm::vec3& b,
                  const glm::vec3& c) {
  return std::ranges::any_of(spheres, [&](const Sphere& sphere) {
    return contains(sphere, a) && contains(sphere, b) && contains(sphere, c);
  });
}

constexpr FitObjective objectives[] = {FitObjective::cover, FitObjective::shadow};

}  // namespace

TEST_CASE("spheres bound to a mesh at rest stay where they are") {
  const TriangleMesh knot = torusKnot();
  const auto spheres = ballsOn(knot, 40, 0.2f);
  for (const FitObjective objective : objectives) {
    const auto same = moveSpheres(bindSpheres(knot, spheres, objective), padded(knot.positions));
    REQUIRE(same.size() == spheres.size());
    for (std::size_t i = 0; i < same.size(); ++i) {
      CHECK(glm::length(same[i].center - spheres[i].center) < 2e-6f);
      CHECK(std::abs(same[i].radius - spheres[i].radius) < 1e-6f);
    }
  }
}

TEST_CASE("centres follow every affine motion, radii every similarity") {
  const TriangleMesh knot = torusKnot();
  const auto spheres = ballsOn(knot, 40, 0.2f);
  const glm::dmat3 shear(1.2, 0.3, -0.4, 0.1, 0.8, 0.5, -0.2, 0.6, 1.1);
  const glm::dmat3 turn(0, 3, 0, 0, 0, 3, 3, 0,
                        0);  // by 120° about (1, 1, 1), three times as large
  const glm::dvec3 shift(3, -2, 1);
  for (const FitObjective objective : objectives) {
    const SphereBinding binding = bindSpheres(knot, spheres, objective);
    const auto sheared =
        moveSpheres(binding, moved(knot, [&](const glm::dvec3& p) { return shear * p + shift; }));
    const auto turned =
        moveSpheres(binding, moved(knot, [&](const glm::dvec3& p) { return turn * p + shift; }));
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      const glm::dvec3 center(spheres[i].center);
      CHECK(glm::length(glm::dvec3(sheared[i].center) - (shear * center + shift)) < 5e-6);
      CHECK(glm::length(glm::dvec3(turned[i].center) - (turn * center + shift)) < 1e-5);
      CHECK(std::abs(turned[i].radius - 3 * spheres[i].radius) < 5e-6f);
    }
  }
}

TEST_CASE("a ball stretched by s along one axis keeps its mean square or its farthest corner") {
  const TriangleMesh ball = icosphere(4);
  const std::vector<Sphere> spheres{{{0, 0, 0}, 1.01f}};
  constexpr double s = 2;
  const auto stretched = moved(ball, [](glm::dvec3 p) {
    p.y *= s;
    return p;
  });
  const auto mean = moveSpheres(bindSpheres(ball, spheres, FitObjective::shadow), stretched);
  CHECK(std::abs(mean[0].radius - 1.01 * std::sqrt((2 + s * s) / 3)) < 2e-4);  // E y² = 1/3
  const auto reach = moveSpheres(bindSpheres(ball, spheres, FitObjective::cover), stretched);
  CHECK(std::abs(reach[0].radius - 1.01 * s) < 1e-5);  // the ball has vertices on the y axis
}

TEST_CASE("a triangle that a cover's sphere holds is held however the vertices move") {
  const TriangleMesh knot = torusKnot();
  const auto spheres = ballsOn(knot, 60, 0.17f);
  const SphereBinding binding = bindSpheres(knot, spheres, FitObjective::cover);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> jitter(-0.3f, 0.3f);
  for (int trial = 0; trial < 20; ++trial) {
    auto positions = padded(knot.positions);
    for (glm::vec4& position : positions)
      position += glm::vec4(jitter(random), jitter(random), jitter(random), 0);
    const auto movedSpheres = moveSpheres(binding, positions);
    std::size_t held = 0;
    for (const glm::uvec3& t : knot.triangles) {
      if (!someContains(spheres, knot.positions[t.x], knot.positions[t.y], knot.positions[t.z]))
        continue;
      ++held;
      REQUIRE(someContains(movedSpheres, positions[t.x], positions[t.y], positions[t.z]));
    }
    CHECK(held > knot.triangles.size() / 4);
  }
}

TEST_CASE("a sphere whose triangles lie in a plane turns with the mesh all the same") {
  // A flat box: the sphere in the middle of its upper face owns triangles of that face only.
  TriangleMesh box = groundGrid(1, 10);
  const std::size_t upper = box.positions.size();
  for (std::size_t i = 0; i < upper; ++i)
    box.positions.push_back(box.positions[i] - glm::vec3(0, 1, 0));
  const std::size_t faces = box.triangles.size();
  for (std::size_t i = 0; i < faces; ++i) {
    const glm::uvec3 t = box.triangles[i] + glm::uvec3(upper);
    box.triangles.emplace_back(t.x, t.z, t.y);
  }
  const std::vector<Sphere> spheres{{{0, -0.1f, 0}, 0.3f}, {{0, -1, 0}, 3}};
  const auto turned =
      moveSpheres(bindSpheres(box, spheres, FitObjective::shadow),
                  moved(box, [](const glm::dvec3& p) { return glm::dvec3(-p.y, p.x, p.z); }));
  CHECK(glm::length(turned[0].center - glm::vec3(0.1f, 0, 0)) < 1e-5f);
  CHECK(std::abs(turned[0].radius - 0.3f) < 1e-5f);
}

TEST_CASE("spheres that no triangle prefers follow their neighbourhood") {
  const TriangleMesh knot = torusKnot();
  auto spheres = ballsOn(knot, 30, 0.25f);
  spheres.push_back({spheres[3].center, 0.01f});  // within another one
  const auto shifted = moveSpheres(bindSpheres(knot, spheres, FitObjective::cover),
                                   moved(knot, [](const glm::dvec3& p) { return 2.0 * p; }));
  CHECK(glm::length(shifted.back().center - 2.0f * spheres.back().center) < 1e-5f);
  CHECK(std::abs(shifted.back().radius - 0.02f) < 1e-6f);
}

TEST_CASE("nothing can be bound to nothing") {
  CHECK_THROWS_AS(bindSpheres(TriangleMesh{}, {}, FitObjective::cover), InputError);
}
