#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "scene/scene_description.h"

namespace haarlight {

/// What is wrong with one field of a description.
struct FieldProblem {
  const char* field;
  const char* problem;
};

/// Why a camera sees nothing; nothing when it does.
std::optional<FieldProblem> sightProblem(const CameraDescription& camera);

/// A pinhole camera for an image of width × height square pixels, right-handed: looking along −z
/// with y up, +x is on the right.
class Camera {
 public:
  /// sightProblem() has nothing to say about the description; width and height are > 0.
  Camera(const CameraDescription& description, int width, int height);

  /// Where all rays start.
  const glm::dvec3& position() const { return position_; }

  /// Unit direction of the ray through (x, y), in pixels from the image's top left corner: the
  /// image is [0, width] × [0, height], pixel (column, row) has its centre at (column + ½, row +
  /// ½).
  glm::dvec3 direction(double x, double y) const;

  // That ray passes through topLeft() + x · columnStep() + y · rowStep(), from the position.
  const glm::dvec3& topLeft() const { return topLeft_; }
  const glm::dvec3& columnStep() const { return columnStep_; }
  const glm::dvec3& rowStep() const { return rowStep_; }

 private:
  glm::dvec3 position_;
  glm::dvec3 topLeft_;     // from the position to the image's corner, at distance 1
  glm::dvec3 columnStep_;  // from a pixel to the one on its right
  glm::dvec3 rowStep_;     // from a pixel to the one below
};

}  // namespace haarlight
