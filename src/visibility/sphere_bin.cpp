#include "visibility/sphere_bin.h"

#include <cmath>

namespace haarlight {

namespace {

struct FaceFloat {
  int face;
  float s, t, major;  // coordinates on the face times `major` > 0
};

FaceFloat faceOf(const glm::vec3& d) {
  const float x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  if (x >= y && x >= z) return {d.x > 0 ? 0 : 1, d.x > 0 ? -d.z : d.z, -d.y, x};
  if (y >= z) return {d.y > 0 ? 2 : 3, d.x, d.y > 0 ? d.z : -d.z, y};
  return {d.z > 0 ? 4 : 5, d.z > 0 ? d.x : -d.x, -d.y, z};
}

/// Largest column (or row) whose lower border (column − 16) · major/16 is not above `coordinate`.
int texelOf(float coordinate, float major) {
  const float sixteenth = 0.0625f * major;
  float place = -16;
  for (float step = 16; step >= 1; step *= 0.5f)
    if (coordinate >= (place + step) * sixteenth) place += step;
  return int(place) + 16;
}

}  // namespace

int directionBin(const glm::vec3& toCenter) {
  const FaceFloat f = faceOf(toCenter);
  return (f.face * faceSize + texelOf(f.t, f.major)) * faceSize + texelOf(f.s, f.major);
}

int radiusBin(const glm::vec3& d, float radius, const glm::vec3& normal) {
  const float distanceSquared = (d.x * d.x + d.y * d.y) + d.z * d.z;
  const float radiusSquared = radius * radius;
  const float height = (d.x * normal.x + d.y * normal.y) + d.z * normal.z;
  const float depth = std::fmin(height, 0.0f);  // below the tangent plane, or 0
  const float limit = horizonFactor * depth * depth;
  const float reach = std::fmin(radiusSquared, distanceSquared - limit);
  const float unit = 0x1p-15f * distanceSquared;
  float bin = 0;
  for (float step = 16; step >= 1; step *= 0.5f) {
    const float next = bin + step;
    if (next * next * next * unit <= reach) bin = next;
  }
  return int(bin);
}

int sphereTableEntry(const Sphere& sphere, const glm::vec3& samplePosition,
                     const glm::vec3& sampleNormal) {
  const glm::vec3 toCenter = sphere.center - samplePosition;
  return directionBin(toCenter) * radiusBins + radiusBin(toCenter, sphere.radius, sampleNormal);
}

}  // namespace haarlight
