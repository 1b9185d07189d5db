#include "render/light_coefficients.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "sh/cube_basis.h"
#include "sh/rotation.h"

namespace haarlight {

const ShVector<glm::vec3>& LightCoefficients::projected(std::size_t place,
                                                        const Source& environment) {
  if (place == projected_.size()) projected_.emplace_back(nullptr, ShVector<glm::vec3>(order_));
  auto& [known, coefficients] = projected_[place];
  if (known != environment) {
    coefficients = projectToSh(order_, projectToCube(*environment).cube);
    known = environment;
  }
  return coefficients;
}

TransferLights LightCoefficients::of(const SceneLight& light) {
  TransferLights lights{order_, {}};
  const auto add = [&](const auto& source) {
    const ShVector<glm::vec3>& still = projected(lights.count(), source.environment);
    const auto turned = source.scale * ShRotation(glm::dmat3(source.rotation), order_)(still);
    for (int channel = 0; channel < 3; ++channel)
      for (int k = 0; k < turned.size(); ++k) lights.values.push_back(turned[k][channel]);
  };
  if (light.samples.empty()) add(light);
  for (const SceneLightSample& sample : light.samples) add(sample);
  return lights;
}

void weighLights(const SceneLight& light, const glm::vec3& position, std::span<float> weights) {
  if (light.samples.empty()) {
    weights[0] = 1;
    return;
  }
  std::vector<double> shares;
  double sum = 0;
  for (const SceneLightSample& sample : light.samples) {
    const glm::dvec3 offset = glm::dvec3(position) - glm::dvec3(sample.position);
    const double squared = glm::dot(offset, offset);
    if (squared == 0) {
      std::ranges::fill(weights, 0.0f);
      weights[shares.size()] = 1;
      return;
    }
    shares.push_back(1 / squared);
    sum += shares.back();
  }
  for (std::size_t i = 0; i < shares.size(); ++i) weights[i] = float(shares[i] / sum);
}

}  // namespace haarlight
