#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/ray_scene.h"
#include "mesh/triangle_mesh.h"
#include "spheres/enclosing_ball.h"

namespace haarlight {

/// A perspective picture of what a mesh blocks from one viewpoint, in which balls are rows of
/// pixels whose ends come from a formula.
///
/// The direction through a point of the image is (x, y, 1) in the view's own axes. A ball with the
/// centre c and the radius r blocks it where (d·c)² ≥ d² (c² − r²), which for a given y is an
/// interval of x, and for the whole an interval of y.
class SilhouetteView {
 public:
  /// `pixels`: along the longer side of the picture, which the mesh fills but for a margin.
  /// `scene` holds the mesh.
  SilhouetteView(const TriangleMesh& mesh, const RayScene& scene, const glm::dvec3& eye,
                 int pixels);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Whether the mesh is seen at all.
  bool empty() const { return empty_; }

  /// What blocking a pixel adds to the error of this view: the part that its solid angle has of the
  /// mesh's, negative where the mesh blocks it. Rows from the top, width() · height() values.
  const std::vector<float>& errors() const { return errors_; }

  /// A ball as this view sees it.
  struct Disc {
    float x, y, z;           ///< the centre in the view's axes
    float cosine2;           ///< c² − r²: c² times the squared cosine of the angular radius
    float side;              ///< y² + z² − r²
    float firstRow, endRow;  ///< where it begins and ends, in rows; may lie beyond the image
  };
  /// A ball behind the eye has no rows, one around the eye blocks all pixels.
  Disc discOf(const Ball& ball) const;

  struct Interval {
    float begin, end;  ///< in pixels from the left edge; empty when end <= begin
  };
  /// What the disc blocks of the line through the centres of a row's pixels.
  Interval columnsOf(const Disc& disc, int row) const;

 private:
  void render(const RayScene& scene);

  glm::dvec3 eye_;
  glm::dmat3 axes_;  ///< rows are the view's axes in the world
  float left_ = 0, top_ = 0, pixel_ = 1, leftInPixels_ = 0;
  int width_ = 0, height_ = 0;
  bool empty_ = false;
  std::vector<float> errors_;
};

/// The first pixel and the one past the last whose centres lie in the interval, within the width.
struct PixelRange {
  int begin, end;
};
PixelRange pixelsIn(const SilhouetteView::Interval& interval, int width);

// Both take most of the time of a fit, so they are inline.

inline SilhouetteView::Interval SilhouetteView::columnsOf(const Disc& disc, int row) const {
  if (disc.cosine2 <= 0) return {0, float(width_)};
  const float y = top_ + (float(row) + 0.5f) * pixel_;
  const float q = y * disc.y + disc.z;
  const float square = disc.cosine2 * (q * q - disc.side * (y * y + 1));
  if (square <= 0) return {0, 0};
  const float root = std::sqrt(square), scale = 1 / (disc.side * pixel_);
  const float middle = disc.x * q * scale - leftInPixels_;
  if (disc.side > 0) return {middle - root * scale, middle + root * scale};
  if (disc.x > 0) return {middle - root * scale, float(width_)};
  return {0, middle + root * scale};
}

inline PixelRange pixelsIn(const SilhouetteView::Interval& interval, int width) {
  const auto pixel = [&](float place) {
    const float inside = std::min(std::max(place - 0.5f, 0.0f), float(width));
    const auto before = static_cast<int>(inside);
    return before + (float(before) < inside);
  };
  return {pixel(interval.begin), pixel(interval.end)};
}

}  // namespace haarlight
