#include "solids/scaled_shape.h"

namespace haarlight {

namespace {

struct Scaled {
  double factor;

  Shape operator()(const SphereShape& s) const { return SphereShape{factor * s.radius}; }
  Shape operator()(const EllipsoidShape& s) const { return EllipsoidShape{factor * s.radii}; }
  Shape operator()(const BoxShape& s) const { return BoxShape{factor * s.halfSizes}; }
  Shape operator()(const CylinderShape& s) const {
    return CylinderShape{factor * s.radius, factor * s.height};
  }
  Shape operator()(const ConeShape& s) const {
    return ConeShape{factor * s.radius, factor * s.height, factor * s.topRadius};
  }
  Shape operator()(const TorusShape& s) const {
    return TorusShape{factor * s.majorRadius, factor * s.minorRadius};
  }
};

}  // namespace

Shape scaled(const Shape& shape, double factor) {
  return std::visit(Scaled{factor}, shape);
}

}  // namespace haarlight
