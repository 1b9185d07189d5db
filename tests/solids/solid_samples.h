#pragma once

/// Solids at random, points of their surfaces, and their implicit functions: written apart from the
/// library, so that it can be checked against them.

#include <glm/vec3.hpp>
#include <random>

#include "solids/solid.h"

namespace haarlight::test {

using RandomNumbers = std::mt19937_64;

double uniform(RandomNumbers& random, double low, double high);
glm::dvec3 randomDirection(RandomNumbers& random);
glm::dvec3 randomPoint(RandomNumbers& random, double reach);
glm::dmat3 randomRotation(RandomNumbers& random);

inline constexpr int shapeKinds = 6;

/// A shape of kind 0 to 5, in the order of the variant, with measures from 0.2 to 1.
Shape randomShape(int kind, RandomNumbers& random);

/// Turned at will and moved by at most `reach` along each axis.
Solid randomSolid(int kind, double reach, RandomNumbers& random);

struct SurfaceSample {
  glm::dvec3 position;
  glm::dvec3 normal;  ///< unit, outwards
};

/// How many parts, each with parameters u and v in [0, 1], the surface has.
int surfaceParts(const Shape& shape);

/// In world coordinates.
SurfaceSample surfaceSample(const Solid& solid, int part, double u, double v);
SurfaceSample randomSurfaceSample(const Solid& solid, RandomNumbers& random);

/// Negative inside, 0 on the surface, positive outside.
double implicitFunction(const Solid& solid, const glm::dvec3& point);

double volume(const Shape& shape);

}  // namespace haarlight::test
