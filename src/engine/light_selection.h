#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/shading_settings.h"
#include "haar/transform.h"

namespace haarlight {

/// A light in the Haar basis, RGB in double.
using LightHaar = HaarCube<glm::dvec3>;

/// A lobe that occurs among the receivers, and how often.
struct UsedLobe {
  int lobe;
  double importance;
  HaarCube<float> haar;
};

/// A coefficient of the light: 0 is the Φ of the face.
struct LightTerm {
  int face;
  int coefficient;
};

/// The light terms to keep (paper §4.1): the Φ of every face, and the wavelets that matter most
/// among all faces, in order of face and coefficient.
std::vector<LightTerm> selectLightTerms(const LightHaar& light, const ShadingSettings& settings,
                                        std::span<const UsedLobe> lobes);

}  // namespace haarlight
