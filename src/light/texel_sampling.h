#pragma once

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/parallel.h"
#include "cube/cube_map.h"
#include "light/light_integrals.h"

namespace haarlight {

/// Integrals of a light given by formula, turned by `rotation`: every texel is sampled at
/// samplesPerSide² places weighted by solid angle. `radianceIn(c)` gives the radiance by unit
/// direction that holds in the texel whose centre is the unit direction c, both as the light is
/// before the rotation. sourcePower stays 0.
template <typename RadianceIn>
LightIntegrals sampleTexels(const glm::dmat3& rotation, int samplesPerSide,
                            const RadianceIn& radianceIn) {
  const glm::dmat3 toLight = glm::transpose(rotation);
  const double step = 2.0 / (faceSize * samplesPerSide);
  LightIntegrals integrals;
  const auto integrateTexel = [&](int texel) {
    const int face = texel / texelsPerFace, row = texel / faceSize % faceSize,
              column = texel % faceSize;
    const auto radiance = radianceIn(toLight * texelDirection(texel));
    for (int i = 0; i < samplesPerSide * samplesPerSide; ++i) {
      const double s = -1 + (column * samplesPerSide + i % samplesPerSide + 0.5) * step;
      const double t = -1 + (row * samplesPerSide + i / samplesPerSide + 0.5) * step;
      const glm::dvec3 place = cubeDirection({face, s, t});
      const double distance = glm::length(place);
      const double solidAngle = step * step / (distance * distance * distance);
      integrals.radiance[texel] += solidAngle * radiance(toLight * (place / distance));
      integrals.solidAngle[texel] += solidAngle;
    }
  };
  parallelFor(texelCount, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t texel = begin; texel < end; ++texel) integrateTexel(int(texel));
  });
  return integrals;
}

}  // namespace haarlight
