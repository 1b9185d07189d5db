#include "solids/solid_checks.h"

#include <string>

#include "base/error.h"
#include "base/text_format.h"

namespace haarlight {

namespace {

void checkMeasure(const char* name, const char* measure, double value) {
  if (value >= smallestMeasure && value <= largestMeasure) return;
  throw InputError(std::string(name) + ": its " + measure + " is " + numberText(value) +
                   "; a solid with an inside has measures from 1e-30 to 1e30");
}

void checkMeasures(const char* name, const char* measure, const glm::dvec3& values) {
  for (int axis = 0; axis < 3; ++axis) checkMeasure(name, measure, values[axis]);
}

struct MeasureCheck {
  const char* name;

  void operator()(const SphereShape& s) const { checkMeasure(name, "radius", s.radius); }
  void operator()(const EllipsoidShape& s) const { checkMeasures(name, "radius", s.radii); }
  void operator()(const BoxShape& s) const { checkMeasures(name, "half size", s.halfSizes); }

  void operator()(const CylinderShape& s) const {
    checkMeasure(name, "radius", s.radius);
    checkMeasure(name, "height", s.height);
  }

  void operator()(const ConeShape& s) const {
    checkMeasure(name, "radius", s.radius);
    checkMeasure(name, "height", s.height);
    if (s.topRadius != 0) checkMeasure(name, "top radius", s.topRadius);
  }

  void operator()(const TorusShape& s) const {
    checkMeasure(name, "major radius", s.majorRadius);
    checkMeasure(name, "minor radius", s.minorRadius);
    if (s.minorRadius <= s.majorRadius) return;
    throw InputError(std::string(name) + ": its minor radius " + numberText(s.minorRadius) +
                     " exceeds its major radius " + numberText(s.majorRadius) +
                     ", so that its surface would pass through itself");
  }
};

struct NameOf {
  const char* operator()(const SphereShape&) const { return "sphere"; }
  const char* operator()(const EllipsoidShape&) const { return "ellipsoid"; }
  const char* operator()(const BoxShape&) const { return "box"; }
  const char* operator()(const CylinderShape&) const { return "cylinder"; }
  const char* operator()(const ConeShape&) const { return "cone"; }
  const char* operator()(const TorusShape&) const { return "torus"; }
};

}  // namespace

void checkShape(const Shape& shape) {
  std::visit(MeasureCheck{shapeName(shape)}, shape);
}

const char* shapeName(const Shape& shape) {
  return std::visit(NameOf{}, shape);
}

}  // namespace haarlight
