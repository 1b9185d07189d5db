#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "mesh/mesh_measures.h"
#include "spheres/fit_shapes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr auto cover = FitObjective::cover, shadow = FitObjective::shadow;

/// A sheet bent round a quarter of a cylinder.
TriangleMesh bentSheet() {
  TriangleMesh sheet = groundGrid(1, 12);
  sheet.normals.clear();
  for (glm::vec3& p : sheet.positions) {
    const float angle = p.x * float(std::numbers::pi) / 4;
    p = {std::sin(angle), std::cos(angle), p.z};
  }
  return sheet;
}

TriangleMesh withStrayTriangle(TriangleMesh mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const glm::vec3& corner : {glm::vec3(3, 0, 0), glm::vec3(3.1f, 0, 0), glm::vec3(3, 0.1f, 0)})
    mesh.positions.push_back(corner);
  mesh.triangles.emplace_back(first, first + 1, first + 2);
  return mesh;
}

TriangleMesh withDuplicates(TriangleMesh mesh) {
  const std::vector<glm::uvec3> triangles = mesh.triangles;
  mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.begin() + 100);
  for (std::size_t i = 100; i < 150; ++i)
    mesh.triangles.emplace_back(triangles[i].z, triangles[i].y, triangles[i].x);
  return mesh;
}

float distanceTo(const std::vector<glm::vec3>& points, const glm::vec3& place) {
  float least = std::numeric_limits<float>::max();
  for (const glm::vec3& point : points) least = std::min(least, glm::distance(point, place));
  return least;
}

/// On a surface that is open: spheres of a size that fits their number stay at it.
SphereSet fitOpen(FitObjective objective, const TriangleMesh& mesh, std::size_t count) {
  const std::vector<glm::vec3> surface = sampleSurface(mesh, 20000, 3);
  // Discs of this radius have together the area of the surface.
  const double size = std::sqrt(surfaceArea(mesh) / (double(count) * std::numbers::pi));
  const auto spacing = float(std::sqrt(surfaceArea(mesh) / double(surface.size())));
  const SphereSet set = fitFor(objective, mesh, count).set;
  CHECK(set.spheres.size() <= count);
  for (const Sphere& sphere : set.spheres) {
    CHECK(sphere.radius > 0);
    CHECK(sphere.radius < 2 * size);
    CHECK(distanceTo(surface, sphere.center) < sphere.radius + 2 * spacing);
  }
  return set;
}

}  // namespace

TEST_CASE("random bodies are covered, and more spheres do it better") {
  for (const TriangleMesh& mesh : {blob(11, 2), grapes(13, 4), grapes(14, 6)}) {
    double last = std::numeric_limits<double>::max();
    for (const std::size_t count : {1, 2, 8}) {
      const SphereFit fit = fitFor(cover, mesh, count);
      const double outside = *fit.set.measures.outsideVolumeRatio;
      CHECK(fit.set.spheres.size() <= count);
      CHECK(uncovered(mesh, fit.set.spheres) == 0);
      CHECK(*fit.set.measures.uncoveredVolumeRatio < 1e-3);
      CHECK((outside > 0 && outside < last));
      CHECK(fit.warnings.empty());
      last = outside;
    }
  }
}

TEST_CASE("random bodies throw nearly the right shadow, the more so with more spheres") {
  for (const TriangleMesh& mesh : {blob(12, 2), grapes(14, 6)}) {
    double last = 1;  // without spheres
    for (const std::size_t count : {1, 2}) {
      const double error = fitFor(shadow, mesh, count).set.measures.silhouette->mean;
      CHECK((error > 0 && error < last));
      CHECK(error < fitFor(cover, mesh, count).set.measures.silhouette->mean);
      last = error;
    }
  }
}

TEST_CASE("stray, doubled and turned triangles change no sphere") {
  const TriangleMesh clean = blob(5, 2);
  const TriangleMesh damaged[] = {withStrayTriangle(clean), withDuplicates(clean),
                                  turnedOver(clean), turnedOver(clean, 7)};
  for (const FitObjective objective : {cover, shadow}) {
    const std::size_t count = objective == cover ? 3 : 1;
    const SphereSet set = fitFor(objective, clean, count).set;
    for (const TriangleMesh& mesh : damaged) {
      const SphereFit fit = fitFor(objective, mesh, count);
      checkSame(fit.set.spheres, set.spheres);
      CHECK(fit.set.measures.silhouette->mean == set.measures.silhouette->mean);
      CHECK(fit.set.measures.outsideVolumeRatio == set.measures.outsideVolumeRatio);
      CHECK(fit.set.meshHash == meshHash(mesh));
      CHECK(fit.warnings.size() == 1);
    }
  }
}

TEST_CASE("an open bowl and a bent sheet keep their spheres at the surface") {
  for (const TriangleMesh& mesh : {bowl(32), bentSheet()}) {
    const SphereSet covering = fitOpen(cover, mesh, 4), shading = fitOpen(shadow, mesh, 4);
    CHECK(uncovered(mesh, covering.spheres) == 0);
    CHECK(shading.measures.silhouette->mean < 0.7);
    CHECK(shading.measures.silhouette->mean < covering.measures.silhouette->mean);
  }
}

TEST_CASE("every part of a mesh gets a sphere") {
  const glm::vec3 places[] = {{-3, 0, 0}, {0, 2, 0}, {3, 0, 1}};
  const float sizes[] = {1, 0.6f, 0.8f};
  TriangleMesh mesh;
  for (int i = 0; i < 3; ++i) mesh = combined(mesh, sphereAt(places[i], sizes[i], 2));
  for (const FitObjective objective : {cover, shadow}) {
    const SphereSet set = fitFor(objective, mesh, 3).set;
    REQUIRE(set.spheres.size() == 3);
    for (int i = 0; i < 3; ++i)
      CHECK(std::ranges::count_if(set.spheres, [&](const Sphere& sphere) {
              return glm::distance(sphere.center, places[i]) < 0.1f * sizes[i] &&
                     std::abs(sphere.radius - sizes[i]) < 0.1f * sizes[i];
            }) == 1);
  }
}

TEST_CASE("a closed box that is hardly thick is covered as a square would be") {
  const TriangleMesh thin = box({0, 0, 0}, {1, 1, 1e-3f});
  const SphereSet set = fitFor(cover, thin, 16).set;
  CHECK(uncovered(thin, set.spheres) == 0);
  // 16 balls can cover the square in a pattern of 4 × 4 with the radius √2 / 8 each.
  double volume = 0;
  for (const Sphere& sphere : set.spheres) volume += ballVolume(sphere.radius);
  CHECK(volume < 1.25 * 16 * ballVolume(std::sqrt(2.0) / 8));
  CHECK(fitFor(shadow, thin, 16).set.measures.silhouette->mean < set.measures.silhouette->mean);
}

TEST_CASE("tiny, huge and distant meshes are fitted as well as others") {
  const TriangleMesh mesh = blob(6, 2);
  const SphereSet covering = fitFor(cover, mesh, 3).set, shading = fitFor(shadow, mesh, 1).set;
  const struct {
    float factor;
    glm::vec3 offset;
  } moves[] = {{1e-6f, {0, 0, 0}}, {1e6f, {3e6f, -2e6f, 1e6f}}, {1, {1000, -2000, 500}}};
  for (const auto& move : moves) {
    const TriangleMesh other = scaled(mesh, move.factor, move.offset);
    const SphereSet otherCovering = fitFor(cover, other, 3).set;
    CHECK(uncovered(other, otherCovering.spheres) == 0);
    CHECK(*otherCovering.measures.outsideVolumeRatio ==
          doctest::Approx(*covering.measures.outsideVolumeRatio).epsilon(0.1));
    CHECK(fitFor(shadow, other, 1).set.measures.silhouette->mean ==
          doctest::Approx(shading.measures.silhouette->mean).epsilon(0.05));
  }
}
