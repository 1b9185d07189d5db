#include "cube/cube_map.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace haarlight {

namespace {

/// Face coordinate of the centre of column or row `index`: (2·index + 1)/32 − 1, exact.
double centerCoordinate(int index) {
  return (2 * index + 1 - faceSize) / double(faceSize);
}

int texelIndex(double coordinate) {
  return std::clamp(int(std::floor((coordinate + 1) * (faceSize / 2))), 0, faceSize - 1);
}

struct TexelBorders {
  int face;
  double s0, s1, t0, t1;
};

TexelBorders bordersOf(int texel) {
  constexpr double half = 1.0 / faceSize;
  const double s = centerCoordinate(texel % faceSize);
  const double t = centerCoordinate(texel / faceSize % faceSize);
  return {texel / texelsPerFace, s - half, s + half, t - half, t + half};
}

/// Antiderivative of the solid angle over a rectangle with one corner at the face's centre.
double cornerSolidAngle(double s, double t) {
  return std::atan2(s * t, std::sqrt(s * s + t * t + 1));
}

}  // namespace

glm::dvec3 cubeDirection(const FacePoint& point) {
  const double s = point.s, t = point.t;
  switch (point.face) {
    case 0:
      return {1, -t, -s};
    case 1:
      return {-1, -t, s};
    case 2:
      return {s, 1, t};
    case 3:
      return {s, -1, -t};
    case 4:
      return {s, -t, 1};
    default:
      return {-s, -t, -1};
  }
}

glm::dvec3 texelDirection(int texel) {
  const int face = texel / texelsPerFace, row = texel / faceSize % faceSize,
            column = texel % faceSize;
  return glm::normalize(cubeDirection({face, centerCoordinate(column), centerCoordinate(row)}));
}

FacePoint projectToCube(const glm::dvec3& d) {
  const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  if (x >= y && x >= z)
    return d.x > 0 ? FacePoint{0, -d.z / x, -d.y / x} : FacePoint{1, d.z / x, -d.y / x};
  if (y >= z) return d.y > 0 ? FacePoint{2, d.x / y, d.z / y} : FacePoint{3, d.x / y, -d.z / y};
  return d.z > 0 ? FacePoint{4, d.x / z, -d.y / z} : FacePoint{5, -d.x / z, -d.y / z};
}

int texelAt(const glm::dvec3& direction) {
  const FacePoint point = projectToCube(direction);
  return (point.face * faceSize + texelIndex(point.t)) * faceSize + texelIndex(point.s);
}

double faceRectangleSolidAngle(double s0, double s1, double t0, double t1) {
  return cornerSolidAngle(s1, t1) - cornerSolidAngle(s0, t1) - cornerSolidAngle(s1, t0) +
         cornerSolidAngle(s0, t0);
}

double texelSolidAngle(int texel) {
  const TexelBorders b = bordersOf(texel);
  return faceRectangleSolidAngle(b.s0, b.s1, b.t0, b.t1);
}

glm::dvec3 texelMoment(int texel) {
  const TexelBorders b = bordersOf(texel);
  const FacePoint corners[] = {
      {b.face, b.s0, b.t0}, {b.face, b.s0, b.t1}, {b.face, b.s1, b.t1}, {b.face, b.s1, b.t0}};
  glm::dvec3 moment(0);
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3 from = glm::normalize(cubeDirection(corners[i]));
    const glm::dvec3 to = glm::normalize(cubeDirection(corners[(i + 1) % 4]));
    const glm::dvec3 axis = glm::cross(from, to);
    const double sine = glm::length(axis);
    moment += axis * (0.5 * std::atan2(sine, glm::dot(from, to)) / sine);
  }
  return moment;
}

}  // namespace haarlight
