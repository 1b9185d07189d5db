#include "visibility/exact_visibility.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace haarlight {

namespace {

/// A spherical cap: unit axis and the cosine of its angular radius (≥ 0).
struct Cap {
  glm::dvec3 axis;
  double cosine;
};

Cap capOf(const glm::dvec3& toCenter, double radius) {
  const double distance = glm::length(toCenter);
  if (distance == 0) return {{0, 1, 0}, 1};
  const double ratio = radius / distance, r = std::min(ratio, 1 / ratio);
  return {toCenter / distance, std::sqrt(1 - r * r)};
}

/// The directions of a face and their bounding cone, so that a cap can pass over it.
struct FaceDirections {
  double x[texelsPerFace], y[texelsPerFace], z[texelsPerFace];
};

const std::array<FaceDirections, faceCount>& faceDirections() {
  static const auto table = [] {
    std::array<FaceDirections, faceCount> faces;
    for (int texel = 0; texel < texelCount; ++texel) {
      const glm::dvec3 d = texelDirection(texel);
      FaceDirections& face = faces[texel / texelsPerFace];
      face.x[texel % texelsPerFace] = d.x;
      face.y[texel % texelsPerFace] = d.y;
      face.z[texel % texelsPerFace] = d.z;
    }
    return faces;
  }();
  return table;
}

/// Whether the cap may reach the face: their axes are closer than the sum of the cap's angle and
/// the face's half diagonal (cosine √⅓).
bool mayTouch(const Cap& cap, int face) {
  const double axisCosine = glm::dot(cap.axis, cubeDirection({face, 0, 0}));
  const double angle = std::acos(std::clamp(axisCosine, -1.0, 1.0));
  return angle <= std::acos(cap.cosine) + std::acos(std::sqrt(1.0 / 3));
}

std::uint32_t rowMask(const FaceDirections& face, int row, const Cap& cap) {
  std::uint32_t mask = 0;
  for (int column = 0; column < faceSize; ++column) {
    const int texel = row * faceSize + column;
    const double cosine =
        cap.axis.x * face.x[texel] + cap.axis.y * face.y[texel] + cap.axis.z * face.z[texel];
    mask |= std::uint32_t(cosine >= cap.cosine) << column;
  }
  return mask;
}

}  // namespace

void addSphereExactly(BitCube& cube, const glm::dvec3& toCenter, double radius) {
  const Cap cap = capOf(toCenter, radius);
  for (int face = 0; face < faceCount; ++face) {
    if (!mayTouch(cap, face)) continue;
    for (int row = 0; row < faceSize; ++row)
      cube.rows[face * faceSize + row] |= rowMask(faceDirections()[face], row, cap);
  }
}

BitCube exactBitCube(std::span<const Sphere> spheres, const glm::vec3& samplePosition) {
  BitCube cube;
  for (const Sphere& sphere : spheres)
    addSphereExactly(cube, glm::dvec3(sphere.center) - glm::dvec3(samplePosition), sphere.radius);
  return cube;
}

}  // namespace haarlight
