#pragma once

/// Shapes to fit spheres to, and what a fit of them must hold, for tests.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <span>
#include <vector>

#include "mesh/test_meshes.h"
#include "spheres/fit_spheres.h"
#include "spheres/random_spheres.h"

namespace haarlight::test {

inline double ballVolume(double radius) {
  return 4.0 / 3 * std::numbers::pi * radius * radius * radius;
}

inline SphereFit fitFor(FitObjective objective, const TriangleMesh& mesh, std::size_t count,
                        std::uint64_t seed = 0) {
  SphereFitOptions options;
  options.objective = objective;
  options.seed = seed;
  return fitSpheres(mesh, count, options);
}

inline bool isCovered(const glm::vec3& point, std::span<const Sphere> spheres) {
  return std::ranges::any_of(spheres, [&](const Sphere& sphere) {
    return glm::distance(point, sphere.center) <= sphere.radius;
  });
}

/// Number of used vertices and triangle centres outside all spheres, in float.
inline int uncovered(const TriangleMesh& mesh, std::span<const Sphere> spheres) {
  int count = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
    for (const glm::vec3& point : {a, b, c, (a + b + c) / 3.0f})
      count += !isCovered(point, spheres);
  }
  return count;
}

/// Σ V(S_i − T) for a solid T that `inside(point)` tells, on a lattice of points in each ball
/// (Roberts' sequence) rather than at random.
template <typename Inside>
double summedOutsideVolume(std::span<const Sphere> spheres, const Inside& inside) {
  constexpr int points = 20000;
  constexpr double base = 1.2207440846057596;  // the real root of x⁴ = x + 1
  double sum = 0;
  for (const Sphere& sphere : spheres) {
    int outside = 0;
    for (int i = 0; i < points; ++i) {
      const auto place = [&](double step) { return std::fmod(0.5 + (i + 1) / step, 1.0); };
      const double z = 2 * place(base) - 1, flat = std::sqrt(1 - z * z);
      const double angle = 2 * std::numbers::pi * place(base * base);
      const double radius = sphere.radius * std::cbrt(place(base * base * base));
      const glm::dvec3 offset(flat * std::cos(angle), flat * std::sin(angle), z);
      outside += !inside(glm::dvec3(sphere.center) + radius * offset);
    }
    sum += ballVolume(sphere.radius) * outside / points;
  }
  return sum;
}

inline void checkSame(std::span<const Sphere> a, std::span<const Sphere> b) {
  REQUIRE(a.size() == b.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    different += a[i].center != b[i].center || a[i].radius != b[i].radius;
  CHECK(different == 0);
}

inline TriangleMesh scaled(const TriangleMesh& mesh, float factor, const glm::vec3& offset = {}) {
  return transformed(mesh, glm::scale(glm::translate(glm::mat4(1), offset), glm::vec3(factor)));
}

/// A small mesh of a torus knot.
inline TriangleMesh smallKnot() {
  return torusKnot({.lengthSegments = 64, .tubeSegments = 8});
}

/// A star-shaped body around the origin whose radius is a sum of smooth waves over the directions.
inline TriangleMesh blob(std::uint64_t seed, int subdivisions = 3) {
  struct Wave {
    glm::dvec3 direction;
    double height, frequency, phase;
  };
  Random random(seed);
  std::array<Wave, 6> waves;
  for (Wave& wave : waves) {
    wave.direction = randomDirection(random);
    wave.frequency = 1 + 4 * random.uniform();
    wave.height = 0.35 * (0.5 + random.uniform()) / wave.frequency;
    wave.phase = 2 * std::numbers::pi * random.uniform();
  }
  TriangleMesh mesh = sphereAt({0, 0, 0}, 1, subdivisions);
  for (glm::vec3& position : mesh.positions) {
    double radius = 1;
    for (const Wave& wave : waves)
      radius +=
          wave.height *
          std::sin(wave.frequency * glm::dot(wave.direction, glm::dvec3(position)) + wave.phase);
    position *= static_cast<float>(std::max(radius, 0.2));
  }
  return mesh;
}

/// Spheres through each other, each a closed part of its own.
inline TriangleMesh grapes(std::uint64_t seed, std::size_t count) {
  TriangleMesh mesh;
  for (const Sphere& sphere : randomSpheres(count, seed))
    mesh = combined(mesh, sphereAt(sphere.center, sphere.radius, 2));
  return mesh;
}

/// A cylinder of radius 1 along x from -half to half, closed by half spheres.
inline TriangleMesh capsule(float half, int subdivisions = 4) {
  TriangleMesh mesh = sphereAt({0, 0, 0}, 1, subdivisions);
  for (glm::vec3& position : mesh.positions)
    position.x += std::abs(position.x) < 1e-6f ? 0 : std::copysign(half, position.x);
  return mesh;
}

}  // namespace haarlight::test
