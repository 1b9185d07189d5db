#include "image/rec709.h"

namespace haarlight {

namespace {

/// Imath multiplies row vectors, GLM column vectors: row i of the one is column i of the other.
glm::dmat3 toGlm(const Imath::M44f& m) {
  glm::dmat3 result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result[i][j] = m[i][j];
  return result;
}

}  // namespace

glm::dmat3 rec709FromXyz() {
  return toGlm(Imf::XYZtoRGB(Imf::Chromaticities(), 1));
}

glm::dmat3 rec709From(const Imf::Chromaticities& chromaticities) {
  return rec709FromXyz() * toGlm(Imf::RGBtoXYZ(chromaticities, 1));
}

}  // namespace haarlight
