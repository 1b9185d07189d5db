#pragma once

/// Cube-map geometry: faces, texels, directions, solid angles (method.md §3).
///
/// Faces in the OpenGL order +X −X +Y −Y +Z −Z, each 32×32 texels, with the s,t of the OpenGL
/// specification; row 0 is t = 0, column 0 is s = 0. A texel's index is (face·32 + row)·32 +
/// column.

#include <array>
#include <glm/vec3.hpp>

namespace haarlight {

inline constexpr int faceCount = 6;
inline constexpr int faceSize = 32;
inline constexpr int texelsPerFace = faceSize * faceSize;
inline constexpr int texelCount = faceCount * texelsPerFace;

/// A place on the cube: face and face coordinates s, t in [−1, 1] (2s − 1 and 2t − 1 of OpenGL).
struct FacePoint {
  int face;
  double s, t;
};

/// Direction (not normalised, largest component ±1) of a place on the cube.
glm::dvec3 cubeDirection(const FacePoint& point);

/// Unit direction of a texel's centre.
glm::dvec3 texelDirection(int texel);

/// The place where a direction (any length > 0) meets the cube. Where components tie for the
/// largest, x wins over y and y over z.
FacePoint projectToCube(const glm::dvec3& direction);

/// The texel a direction (any length > 0) falls into; points on a texel's border belong to the
/// texel with the larger row or column.
int texelAt(const glm::dvec3& direction);

/// Solid angle in steradians of the rectangle [s0, s1] × [t0, t1] of a face, in closed form.
double faceRectangleSolidAngle(double s0, double s1, double t0, double t1);

/// Solid angle in steradians of a texel. The sum over all texels is 4π.
double texelSolidAngle(int texel);

/// First moment ∫ ω dω of a texel, in closed form (Lambert's formula for the irradiance of a
/// polygon). Its dot product with a normal is the texel's cosine-weighted solid angle where the
/// texel lies wholly above the horizon.
glm::dvec3 texelMoment(int texel);

}  // namespace haarlight
