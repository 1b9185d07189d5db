#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace haarlight {

/// Where a solid stands: its own coordinates are turned, then moved. A rigid motion, so that
/// lengths stay what they are.
class Placement {
 public:
  Placement() = default;

  /// Throws InputError when a number is not finite, or when `rotation` differs from a rotation by
  /// more than 10⁻⁶ (as one that scales or mirrors does); a smaller difference is mended.
  explicit Placement(const glm::dvec3& translation, const glm::dmat3& rotation = glm::dmat3(1));

  const glm::dmat3& rotation() const { return rotation_; }
  const glm::dvec3& translation() const { return translation_; }

  glm::dvec3 toWorldPoint(const glm::dvec3& point) const {
    return rotation_ * point + translation_;
  }
  glm::dvec3 toWorldDirection(const glm::dvec3& direction) const { return rotation_ * direction; }

  // A vector times a matrix is its transpose times the vector.
  glm::dvec3 toOwnPoint(const glm::dvec3& point) const {
    return (point - translation_) * rotation_;
  }
  glm::dvec3 toOwnDirection(const glm::dvec3& direction) const { return direction * rotation_; }

 private:
  glm::dmat3 rotation_{1};
  glm::dvec3 translation_{0};
};

}  // namespace haarlight
