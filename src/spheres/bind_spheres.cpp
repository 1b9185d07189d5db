#include "spheres/bind_spheres.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <numeric>

#include "base/error.h"
#include "base/parallel.h"
#include "mesh/mesh_measures.h"

namespace haarlight {

namespace {

/// A vertex that a sphere follows.
struct Follower {
  double area = 0;              ///< a third of the sphere's triangles around it
  bool mustStayInside = false;  ///< a corner of a triangle that lies in the sphere
};
using Followers = std::map<std::uint32_t, Follower>;

double beyond(const Sphere& sphere, const glm::vec3& point) {
  return glm::length(glm::dvec3(point) - glm::dvec3(sphere.center)) - double(sphere.radius);
}

struct Owner {
  std::size_t sphere = 0;
  double beyond = 0;  ///< how far the farthest corner is outside, < 0 inside
};

Owner ownerOf(const TriangleMesh& mesh, const glm::uvec3& triangle,
              std::span<const Sphere> spheres) {
  Owner owner{0, INFINITY};
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    double farthest = -INFINITY;
    for (int corner = 0; corner < 3 && farthest < owner.beyond; ++corner)
      farthest = std::max(farthest, beyond(spheres[i], mesh.positions[triangle[corner]]));
    if (farthest < owner.beyond) owner = {i, farthest};
  }
  return owner;
}

std::vector<Followers> followersOf(const TriangleMesh& mesh, std::span<const Sphere> spheres) {
  std::vector<Owner> owners(mesh.triangles.size());
  parallelFor(owners.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) owners[t] = ownerOf(mesh, mesh.triangles[t], spheres);
  });
  std::vector<Followers> followers(spheres.size());
  for (std::size_t t = 0; t < owners.size(); ++t) {
    const glm::uvec3& triangle = mesh.triangles[t];
    const double area = triangleArea(mesh.positions[triangle.x], mesh.positions[triangle.y],
                                     mesh.positions[triangle.z]);
    for (int corner = 0; corner < 3; ++corner) {
      Follower& follower = followers[owners[t].sphere][triangle[corner]];
      follower.area += area / 3;
      follower.mustStayInside |= owners[t].beyond <= 0;
    }
  }
  return followers;
}

/// Mean and second moments of weighted points.
struct Spread {
  double weight = 0;
  glm::dvec3 mean{0};
  glm::dmat3 moments{0};
};

Spread spreadOf(const TriangleMesh& mesh, const Followers& followers) {
  Spread spread;
  for (const auto& [vertex, follower] : followers) {
    spread.weight += follower.area;
    spread.mean += follower.area * glm::dvec3(mesh.positions[vertex]);
  }
  if (spread.weight <= 0) return spread;
  spread.mean /= spread.weight;
  for (const auto& [vertex, follower] : followers) {
    const glm::dvec3 d = glm::dvec3(mesh.positions[vertex]) - spread.mean;
    spread.moments += follower.area / spread.weight * glm::outerProduct(d, d);
  }
  return spread;
}

/// Whether points say how all of space around them moves: they are no plane, no line and no point.
/// The determinant over the cube of the mean variance is 1 for equal variances.
bool spansSpace(const Spread& spread) {
  if (spread.weight <= 0) return false;
  const double variance = (spread.moments[0][0] + spread.moments[1][1] + spread.moments[2][2]) / 3;
  return variance > 0 && glm::determinant(spread.moments) > 0.02 * variance * variance * variance;
}

/// Adds the vertices nearest to the sphere, twice as many at a time, until all span space.
void addNearest(const TriangleMesh& mesh, std::span<const std::uint32_t> usedVertices,
                const Sphere& sphere, Followers& followers) {
  std::vector<std::pair<double, std::uint32_t>> nearest;
  for (const std::uint32_t vertex : usedVertices)
    nearest.emplace_back(beyond(sphere, mesh.positions[vertex]), vertex);
  std::ranges::sort(nearest);
  const Spread own = spreadOf(mesh, followers);
  const double area = own.weight > 0 ? own.weight / double(followers.size()) : 1.0;
  for (std::size_t count = 16; !spansSpace(spreadOf(mesh, followers)); count *= 2) {
    for (std::size_t i = count == 16 ? 0 : count / 2; i < std::min(count, nearest.size()); ++i)
      if (Follower& follower = followers[nearest[i].second]; follower.area == 0)
        follower.area = area;
    if (count >= nearest.size()) return;
  }
}

/// The weights a_k of least Σ a_k² / area that sum to 1 and give the centre.
glm::dvec4 barycentricPlane(const Spread& spread, const glm::dvec3& center) {
  // A little of a ball's moments keeps the inverse finite where the whole mesh is a plane.
  const double variance = (spread.moments[0][0] + spread.moments[1][1] + spread.moments[2][2]) / 3;
  const glm::dmat3 moments = spread.moments + glm::dmat3(1e-9 * std::max(variance, 1e-30));
  const glm::dvec3 gradient = glm::inverse(moments) * (center - spread.mean);
  return {gradient, 1 - glm::dot(gradient, spread.mean)};
}

class SphereBinder {
 public:
  SphereBinder(const TriangleMesh& mesh, const Sphere& sphere, const Followers& followers)
      : mesh_(mesh), sphere_(sphere), followers_(followers), spread_(spreadOf(mesh, followers)) {}

  void addTo(SphereBinding& binding, FitObjective objective) const {
    const glm::dvec4 plane = barycentricPlane(spread_, glm::dvec3(sphere_.center));
    std::vector<std::uint32_t> vertices;
    std::vector<glm::vec4> weights;
    for (const auto& [vertex, follower] : followers_) {
      const double part = follower.area / spread_.weight;
      const glm::dvec4 position(glm::dvec3(mesh_.positions[vertex]), 1);
      vertices.push_back(vertex);
      weights.emplace_back(part * glm::dot(plane, position), part,
                           follower.mustStayInside ? 1.0 : 0.0, 0.0);
    }
    binding.add(vertices, weights, glm::vec2(radiusFactors(objective)));
  }

 private:
  /// Factors that give the radius as it is now, from the distances as they are now.
  glm::dvec2 radiusFactors(FitObjective objective) const {
    double meanSquare = 0, farthestSquare = 0;
    for (const auto& [vertex, follower] : followers_) {
      const glm::dvec3 d = glm::dvec3(mesh_.positions[vertex]) - glm::dvec3(sphere_.center);
      meanSquare += follower.area / spread_.weight * glm::dot(d, d);
      if (follower.mustStayInside) farthestSquare = std::max(farthestSquare, glm::dot(d, d));
    }
    const double square = double(sphere_.radius) * double(sphere_.radius);
    if (objective == FitObjective::cover && farthestSquare > 0) return {0, square / farthestSquare};
    return {square / meanSquare, 0};
  }

  const TriangleMesh& mesh_;
  const Sphere& sphere_;
  const Followers& followers_;
  Spread spread_;
};

std::vector<std::uint32_t> usedVerticesOf(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int corner = 0; corner < 3; ++corner) used[triangle[corner]] = true;
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t v = 0; v < used.size(); ++v)
    if (used[v]) vertices.push_back(v);
  return vertices;
}

}  // namespace

SphereBinding bindSpheres(const TriangleMesh& mesh, std::span<const Sphere> spheres,
                          FitObjective objective) {
  if (mesh.triangles.empty()) throw InputError("spheres cannot follow a mesh without triangles");
  auto followers = followersOf(mesh, spheres);
  const auto usedVertices = usedVerticesOf(mesh);
  SphereBinding binding;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    if (!spansSpace(spreadOf(mesh, followers[i])))
      addNearest(mesh, usedVertices, spheres[i], followers[i]);
    SphereBinder(mesh, spheres[i], followers[i]).addTo(binding, objective);
  }
  return binding;
}

}  // namespace haarlight
