#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "cube/cube_image.h"

namespace haarlight {

/// Corners of a spherical quadrilateral of great-circle arcs, clockwise as seen from the centre.
using SphericalQuadrilateral = std::array<glm::dvec3, 4>;

/// Its solid angle in steradians; the corners need not be unit vectors.
double solidAngle(const SphericalQuadrilateral& corners);

/// A light integrated over the cube's texels, in double precision.
struct LightIntegrals {
  CubeImage<glm::dvec3> radiance;  ///< ∫ L dω over the texel
  CubeImage<double> solidAngle;    ///< ∫ dω, as the same quadrature measures it
  glm::dvec3 sourcePower{0.0};     ///< ∫ L dω over all directions, without the cube

  LightIntegrals& operator+=(const LightIntegrals& other);

  /// Adds a small quadrilateral (sides less than a right angle) of constant radiance to every
  /// texel it overlaps, with exactly the solid angle of the overlap: texels are clipped out on
  /// great circles.
  void addQuadrilateral(const SphericalQuadrilateral& corners, const glm::dvec3& value);
};

}  // namespace haarlight
