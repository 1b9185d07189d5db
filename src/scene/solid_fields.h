#pragma once

/// The fields of a scene file that describe solids: the counterpart of scene/scene_fields.h.

#include "scene/field_ranges.h"
#include "solids/shapes.h"
#include "solids/solid_checks.h"

namespace haarlight {

template <typename Fields>
void visitFields(Fields& fields, SphereShape& sphere) {
  fields.number("radius", sphere.radius, lengthRange);
}

template <typename Fields>
void visitFields(Fields& fields, EllipsoidShape& ellipsoid) {
  fields.vector("radii", ellipsoid.radii, lengthRange);
}

template <typename Fields>
void visitFields(Fields& fields, BoxShape& box) {
  fields.vector("halfSizes", box.halfSizes, lengthRange);
}

template <typename Fields>
void visitFields(Fields& fields, CylinderShape& cylinder) {
  fields.number("radius", cylinder.radius, lengthRange);
  fields.number("height", cylinder.height, lengthRange);
}

template <typename Fields>
void visitFields(Fields& fields, ConeShape& cone) {
  fields.number("radius", cone.radius, lengthRange);
  fields.number("height", cone.height, lengthRange);
  fields.number("topRadius", cone.topRadius, lengthOrZeroRange);
}

template <typename Fields>
void visitFields(Fields& fields, TorusShape& torus) {
  fields.number("majorRadius", torus.majorRadius, lengthRange);
  fields.number("minorRadius", torus.minorRadius, lengthRange);
}

template <typename Fields>
void visitFields(Fields& fields, Shape& shape) {
  fields.oneOf(shape, shapeName);
}

}  // namespace haarlight
