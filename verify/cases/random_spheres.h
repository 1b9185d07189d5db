#pragma once

#include <glm/vec3.hpp>

#include "verify/cases/random_cases.h"

namespace haarlight::verify {

/// The receiver that a random sphere is made for.
struct Viewpoint {
  glm::vec3 position, normal;
};

/// A sphere of any kind that asks nothing of the viewpoint's position: ordinary; tiny; grazing (the
/// sample on the sphere, within 3 steps of float32); with its rim through the centre of a texel;
/// touching the tangent plane; just below the horizon; around the sample, or its centre there; huge
/// and far, up to 10¹⁵ and a few beyond, where squares overflow.
Sphere anySphere(PortableRandom& random, const Viewpoint& view);

/// A sphere whose centre lies exactly along an axis, an edge or a corner of the cube, or on the
/// border or centre of a texel, or whose radius is on the bound of a radius bin. Exact only where
/// the position's coordinates are multiples of 1/64 and at most 4.
Sphere alignedSphere(PortableRandom& random, const Viewpoint& view);

/// A small sphere for a viewpoint at the origin, with its rim through the centre of a texel or its
/// radius on the bound of a radius bin as nearly as float32 numbers can say: an operation that is
/// rounded otherwise often turns a bit.
Sphere smallSphereOnBound(PortableRandom& random, const glm::vec3& normal);

/// A sphere at a distance of 10⁻⁴⁰ … 10⁻¹⁸, or with such a radius, for a viewpoint at the origin.
Sphere denormalSphere(PortableRandom& random);

/// Of a size and at a distance that scenes have, mostly beside the sample.
Sphere ordinarySphere(PortableRandom& random, const Viewpoint& view);

/// A sphere that is huge or far: with squares of 2²⁶ … 2¹⁰⁰, that overflow or are about to.
Sphere farSphere(PortableRandom& random, const Viewpoint& view);

/// Any unit vector.
glm::vec3 randomDirection(PortableRandom& random);
/// ±X, ±Y or ±Z.
glm::vec3 randomAxis(PortableRandom& random);

}  // namespace haarlight::verify
