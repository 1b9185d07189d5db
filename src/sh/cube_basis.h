#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "cube/cube_image.h"
#include "sh/vector.h"

namespace haarlight {

/// ∫ y_i dω over every texel of a cube map: projects maps whose texels are constant, without
/// sampling error. Faces, s and t are those of cube/cube_map.h, with side² texels a face;
/// texel (face · side + row) · side + column.
class CubeBasis {
 public:
  /// Gauss–Legendre points in s and t, as many as leave rounding errors only (some 1e-15). Takes
  /// 48 side² order² bytes: 20 MB and a third of a second for order 20. Throws
  /// std::invalid_argument for a wrong order or a face without texels.
  explicit CubeBasis(int order, int side = faceSize);

  /// The table of an order and size, made at the first call and kept; any thread may call.
  static const CubeBasis& shared(int order, int side = faceSize);

  int order() const { return order_; }

  /// ∫ y_i dω over a texel for all order² functions.
  std::span<const double> integrals(int texel) const;

  /// Coefficients of the map. `Value` is float, double, glm::vec3 or glm::dvec3; sums are in
  /// double. Throws std::invalid_argument unless there are 6 side² texels.
  template <typename Value>
  ShVector<Value> project(std::span<const Value> texels) const;

 private:
  void integrateTexel(int texel);

  int order_, side_;
  std::vector<double> integrals_;
};

/// Coefficients of a light or another image on the house's cube.
template <typename Value>
ShVector<Value> projectToSh(int order, const CubeImage<Value>& cube) {
  return CubeBasis::shared(order).project(std::span<const Value>(cube.texels));
}

}  // namespace haarlight
