#include "spheres/silhouette_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>

#include "mesh/mesh_measures.h"
#include "spheres/viewpoints.h"

namespace haarlight {

namespace {

struct Rectangle {
  glm::dvec2 lower{std::numeric_limits<double>::infinity()};
  glm::dvec2 upper{-std::numeric_limits<double>::infinity()};
};

}  // namespace

SilhouetteView::SilhouetteView(const TriangleMesh& mesh, const RayScene& scene,
                               const glm::dvec3& eye, int pixels)
    : eye_(eye) {
  const BoundingBox box = boundingBox(mesh);
  const glm::dvec3 center = (glm::dvec3(box.lower) + glm::dvec3(box.upper)) / 2.0;
  axes_ = glm::transpose(basisAround(glm::normalize(center - eye)));
  Rectangle bounds;
  for (const glm::uvec3& t : mesh.triangles)
    for (const std::uint32_t vertex : {t.x, t.y, t.z}) {
      const glm::dvec3 at = axes_ * (glm::dvec3(mesh.positions[vertex]) - eye);
      bounds.lower = glm::min(bounds.lower, glm::dvec2(at.x, at.y) / at.z);
      bounds.upper = glm::max(bounds.upper, glm::dvec2(at.x, at.y) / at.z);
    }
  constexpr double margin = 0.1;
  glm::dvec2 size = bounds.upper - bounds.lower;
  const double longest = std::max(size.x, size.y);
  bounds.lower -= margin * longest;
  size += 2 * margin * longest;
  left_ = static_cast<float>(bounds.lower.x);
  top_ = static_cast<float>(bounds.lower.y);
  pixel_ = static_cast<float>(longest * (1 + 2 * margin) / pixels);
  leftInPixels_ = left_ / pixel_;
  width_ = std::clamp(static_cast<int>(std::ceil(size.x / pixel_)), 1, pixels);
  height_ = std::clamp(static_cast<int>(std::ceil(size.y / pixel_)), 1, pixels);
  render(scene);
}

void SilhouetteView::render(const RayScene& scene) {
  constexpr int packet = 16;
  errors_.resize(std::size_t(width_) * height_);
  const glm::dmat3 toWorld = glm::transpose(axes_);
  std::array<glm::vec3, packet> origins, rays{};
  origins.fill(glm::vec3(eye_));
  double meshAngle = 0;
  for (int row = 0; row < height_; ++row)
    for (int first = 0; first < width_; first += packet) {
      const int count = std::min(packet, width_ - first);
      const auto imagePoint = [&](int i) {
        return glm::dvec3(left_ + (first + i + 0.5) * pixel_, top_ + (row + 0.5) * pixel_, 1);
      };
      for (int i = 0; i < count; ++i) rays[i] = glm::vec3(toWorld * imagePoint(i));
      const unsigned hits =
          scene.occluded16(origins, rays, static_cast<std::uint16_t>((1u << count) - 1));
      for (int i = 0; i < count; ++i) {
        // Solid angle of a pixel, but for the same factor everywhere.
        const double angle = std::pow(glm::dot(imagePoint(i), imagePoint(i)), -1.5);
        const bool blocked = hits >> i & 1;
        if (blocked) meshAngle += angle;
        errors_[std::size_t(row) * width_ + first + i] = float(blocked ? -angle : angle);
      }
    }
  empty_ = !(meshAngle > 0);
  if (!empty_)
    for (float& error : errors_) error /= float(meshAngle);
}

SilhouetteView::Disc SilhouetteView::discOf(const Ball& ball) const {
  const glm::dvec3 c = axes_ * (ball.center - eye_);
  const double square = ball.radius * ball.radius;
  const double side = c.y * c.y + c.z * c.z - square, front = c.z * c.z - square;
  const auto row = [&](double y) { return float((y - top_) / pixel_); };
  Disc disc{float(c.x),  float(c.y), float(c.z),    float(side + c.x * c.x),
            float(side), 0,          float(height_)};
  if (disc.cosine2 <= 0) return disc;  // the eye lies in the ball
  if (front >= 0 && c.z < 0) {
    disc.endRow = 0;
    return disc;
  }
  if (side <= 0) {
    disc.side = float(std::min(side, -1e-6 * square));  // which columnsOf divides by
    return disc;
  }
  if (front == 0) return disc;
  const double middle = c.y * c.z / front, half = ball.radius * std::sqrt(side) / std::abs(front);
  if (front > 0) {
    disc.firstRow = row(middle - half);
    disc.endRow = row(middle + half);
  } else if (c.y > 0) {  // beside the eye, only one of the two tangents is ahead of it
    disc.firstRow = row(middle + half);
  } else {
    disc.endRow = row(middle - half);
  }
  return disc;
}

}  // namespace haarlight
