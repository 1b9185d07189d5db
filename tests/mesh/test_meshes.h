#pragma once

/// Meshes for tests and what befalls them.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <utility>

#include "mesh/builtin_meshes.h"
#include "mesh/mesh_transform.h"
#include "mesh/triangle_mesh.h"

namespace haarlight::test {

/// Both meshes as one, without normals.
inline TriangleMesh combined(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.positions.size());
  a.normals.clear();
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const glm::uvec3& t : b.triangles) a.triangles.push_back(t + offset);
  return a;
}

/// With every `step`-th triangle turned over.
inline TriangleMesh turnedOver(TriangleMesh mesh, std::size_t step = 1) {
  for (std::size_t i = 0; i < mesh.triangles.size(); i += step)
    std::swap(mesh.triangles[i].y, mesh.triangles[i].z);
  return mesh;
}

/// A sphere without normals.
inline TriangleMesh sphereAt(const glm::vec3& center, float radius, int subdivisions = 3) {
  TriangleMesh sphere = icosphere(subdivisions);
  sphere.normals.clear();
  for (glm::vec3& p : sphere.positions) p = center + radius * p;
  return sphere;
}

/// A closed box of twelve triangles that face outwards; `otherDiagonals` cuts its sides the other
/// way.
inline TriangleMesh box(const glm::vec3& lower, const glm::vec3& upper,
                        bool otherDiagonals = false) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back(i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y,
                                i & 4 ? upper.z : lower.z);
  constexpr std::uint32_t sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& s : sides) {
    const int from = otherDiagonals ? 1 : 0;
    mesh.triangles.emplace_back(s[from], s[from + 1], s[from + 2]);
    mesh.triangles.emplace_back(s[from], s[from + 2], s[(from + 3) % 4]);
  }
  return mesh;
}

/// Unit cubes side by side, each a mesh of its own.
inline TriangleMesh cubeStack(int size, bool mixedDiagonals = false) {
  TriangleMesh stack;
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        stack = combined(stack, box(glm::vec3(x, y, z), glm::vec3(x + 1, y + 1, z + 1),
                                    mixedDiagonals && (x + y + z) % 2 != 0));
  return stack;
}

/// The half of the unit sphere below y = 0, in rings of `segments` points, which faces outwards.
inline TriangleMesh bowl(std::uint32_t segments) {
  TriangleMesh mesh;
  const std::uint32_t rings = segments / 4;
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    for (std::uint32_t i = 0; i < segments; ++i) {
      const double down = std::numbers::pi / 2 * ring / rings;
      const double around = 2 * std::numbers::pi * i / segments;
      mesh.positions.emplace_back(std::cos(down) * std::cos(around), -std::sin(down),
                                  std::cos(down) * std::sin(around));
    }
  mesh.positions.emplace_back(0, -1, 0);
  const std::uint32_t pole = rings * segments;
  for (std::uint32_t i = 0; i < pole; ++i) {
    const std::uint32_t beside = i / segments * segments + (i + 1) % segments;
    const std::uint32_t below = std::min(i + segments, pole);
    mesh.triangles.emplace_back(i, beside, below);
    if (below < pole) mesh.triangles.emplace_back(beside, beside + segments, below);
  }
  return mesh;
}

}  // namespace haarlight::test
