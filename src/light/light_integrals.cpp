#include "light/light_integrals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace haarlight {

namespace {

/// A convex spherical polygon of great-circle arcs; the corners need not be unit vectors. A
/// triangle clipped by a face's and a texel's four sides has at most 3 + 8 corners.
struct Polygon {
  std::array<glm::dvec3, 12> corners;
  int count = 0;

  void add(const glm::dvec3& corner) { corners[count++] = corner; }
};

/// Signed solid angle of a triangle (Van Oosterom and Strackee 1983).
double triangleSolidAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const double volume = glm::dot(a, glm::cross(b - a, c - a));
  return 2 * std::atan2(volume, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la +
                                    glm::dot(c, a) * lb);
}

double polygonSolidAngle(const Polygon& polygon) {
  double sum = 0;
  for (int i = 2; i < polygon.count; ++i)
    sum += triangleSolidAngle(polygon.corners[0], polygon.corners[i - 1], polygon.corners[i]);
  return sum;
}

/// The part of the polygon where dot(normal, direction) >= 0 (Sutherland and Hodgman 1974).
Polygon clipped(const Polygon& polygon, const glm::dvec3& normal) {
  Polygon result;
  for (int i = 0; i < polygon.count; ++i) {
    const glm::dvec3& from = polygon.corners[i];
    const glm::dvec3& to = polygon.corners[(i + 1) % polygon.count];
    const double heightFrom = glm::dot(normal, from), heightTo = glm::dot(normal, to);
    if (heightFrom >= 0) result.add(from);
    if ((heightFrom < 0) != (heightTo < 0))
      result.add(from + (to - from) * (heightFrom / (heightFrom - heightTo)));
  }
  return result;
}

/// A face's axes: a direction's face coordinates are its components along s and t over that along
/// center.
struct FaceAxes {
  glm::dvec3 center, s, t;

  explicit FaceAxes(int face)
      : center(cubeDirection({face, 0, 0})),
        s(cubeDirection({face, 1, 0}) - center),
        t(cubeDirection({face, 0, 1}) - center) {}
};

/// The part of the polygon where low <= coordinate along `axis` <= high.
Polygon clippedToSlab(const Polygon& polygon, const FaceAxes& face, const glm::dvec3& axis,
                      double low, double high) {
  return clipped(clipped(polygon, axis - low * face.center), high * face.center - axis);
}

double borderCoordinate(int index) {
  return 2.0 * index / faceSize - 1;
}

/// First and last column (or row) that the polygon, which lies in the face, touches.
std::array<int, 2> touchedRange(const Polygon& polygon, const FaceAxes& face,
                                const glm::dvec3& axis) {
  std::array<int, 2> range{faceSize - 1, 0};
  for (int i = 0; i < polygon.count; ++i) {
    const glm::dvec3& corner = polygon.corners[i];
    const double coordinate = glm::dot(axis, corner) / glm::dot(face.center, corner);
    const int index =
        std::clamp(int(std::floor((coordinate + 1) * (faceSize / 2))), 0, faceSize - 1);
    range = {std::min(range[0], index), std::max(range[1], index)};
  }
  return range;
}

void addTriangleInFace(LightIntegrals& integrals, const Polygon& triangle, int faceIndex,
                       const glm::dvec3& value) {
  const FaceAxes face(faceIndex);
  const Polygon inColumns = clippedToSlab(triangle, face, face.s, -1, 1);
  const Polygon inFace = clippedToSlab(inColumns, face, face.t, -1, 1);
  if (inFace.count < 3) return;
  const auto [firstColumn, lastColumn] = touchedRange(inFace, face, face.s);
  for (int column = firstColumn; column <= lastColumn; ++column) {
    const Polygon strip =
        clippedToSlab(inFace, face, face.s, borderCoordinate(column), borderCoordinate(column + 1));
    if (strip.count < 3) continue;
    const auto [firstRow, lastRow] = touchedRange(strip, face, face.t);
    for (int row = firstRow; row <= lastRow; ++row) {
      const double overlap = polygonSolidAngle(
          clippedToSlab(strip, face, face.t, borderCoordinate(row), borderCoordinate(row + 1)));
      const int texel = (faceIndex * faceSize + row) * faceSize + column;
      integrals.radiance[texel] += overlap * value;
      integrals.solidAngle[texel] += overlap;
    }
  }
}

}  // namespace

double solidAngle(const SphericalQuadrilateral& corners) {
  return triangleSolidAngle(corners[0], corners[1], corners[2]) +
         triangleSolidAngle(corners[0], corners[2], corners[3]);
}

LightIntegrals& LightIntegrals::operator+=(const LightIntegrals& other) {
  for (int texel = 0; texel < texelCount; ++texel) {
    radiance[texel] += other.radiance[texel];
    solidAngle[texel] += other.solidAngle[texel];
  }
  sourcePower += other.sourcePower;
  return *this;
}

void LightIntegrals::addQuadrilateral(const SphericalQuadrilateral& corners,
                                      const glm::dvec3& value) {
  const int texel = texelAt(corners[0]);
  if (std::all_of(corners.begin() + 1, corners.end(),
                  [&](const glm::dvec3& corner) { return texelAt(corner) == texel; })) {
    const double overlap = haarlight::solidAngle(corners);
    radiance[texel] += overlap * value;
    solidAngle[texel] += overlap;
    return;
  }
  for (int half = 0; half < 2; ++half) {
    const Polygon triangle{{corners[0], corners[1 + half], corners[2 + half]}, 3};
    for (int face = 0; face < faceCount; ++face) addTriangleInFace(*this, triangle, face, value);
  }
}

}  // namespace haarlight
