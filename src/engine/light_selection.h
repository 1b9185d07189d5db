#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/shading_settings.h"
#include "haar/transform.h"

namespace haarlight {

/// A light in the Haar basis, RGB in double.
using LightHaar = HaarCube<glm::dvec3>;

/// Mean over the receivers of the lobe over every square, psum(p): face · 341 + mean index.
class MeanLobe {
 public:
  MeanLobe() : squares_(faceCount * meansPerFace) {}
  /// A lobe, and how often it occurs.
  void add(const HaarCube<float>& lobe, double importance);
  std::span<const double> squares() const { return squares_; }

 private:
  std::vector<double> squares_;
};

/// A coefficient of the light: 0 is the Φ of the face.
struct LightTerm {
  int face;
  int coefficient;
};

/// The light terms to keep (paper §4.1): the Φ of every face, and the wavelets that matter most
/// among all faces, in order of face and coefficient.
std::vector<LightTerm> selectLightTerms(const LightHaar& light, const ShadingSettings& settings,
                                        const MeanLobe& lobe);

}  // namespace haarlight
