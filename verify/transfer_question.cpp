#include "verify/transfer_question.h"

#include <cmath>
#include <glm/mat3x3.hpp>
#include <numbers>

#include "sh/cube_basis.h"
#include "sh/rotation.h"
#include "sh/zonal.h"
#include "verify/cases/random_cases.h"

namespace haarlight::verify {

namespace {

/// One row in so many has half the mean that it should have. Where the light comes from behind, its
/// radiance is below zero then, as ringing makes it.
constexpr std::size_t ringingRows = 3;

TransferRows rowsOf(const Case& value, int order, int channels) {
  constexpr std::array albedo{0.8, 0.5, 0.3};
  const auto zonal = clampedCosineZonal(order);
  TransferRows rows{order, channels, {}};
  for (std::size_t row = 0; row < value.receivers.size(); ++row) {
    ShVector<double> cosine = rotateZonal(zonal, glm::dvec3(value.receivers.normals[row]));
    if (row % ringingRows == 0) cosine[0] *= 0.5;
    for (int channel = 0; channel < channels; ++channel)
      for (const double coefficient : cosine.coefficients())
        rows.values.push_back(float(albedo[std::size_t(channel)] * coefficient / std::numbers::pi));
  }
  return rows;
}

TransferLights lightsOf(const Case& value, int order, int count) {
  const ShVector<glm::vec3> still = projectToSh(order, value.light);
  TransferLights lights{order, {}};
  for (int light = 0; light < count; ++light) {
    const double c = std::cos(light), s = std::sin(light);
    const auto turned = ShRotation(glm::dmat3(c, 0, -s, 0, 1, 0, s, 0, c), order)(still);
    for (int channel = 0; channel < 3; ++channel)
      for (const glm::vec3& coefficient : turned.coefficients())
        lights.values.push_back(coefficient[channel]);
  }
  return lights;
}

TransferReceivers receiversOf(std::size_t count, const TransferSetting& setting) {
  PortableRandom random(std::uint64_t(setting.order));
  TransferReceivers receivers;
  for (std::size_t i = 0; i < count; ++i) {
    RowBlend blend{{i, (i + 1) % count, (i + 2) % count, 0}, {1, 0, 0, 0}};
    if (setting.blendsRows) {
      const float second = random.uniform(0, 0.5f), third = random.uniform(0, 0.5f);
      blend.weights = {1 - second - third, second, third, 0};
    }
    receivers.blends.push_back(blend);
    for (int light = 0; light < setting.lights; ++light)
      receivers.lightWeights.push_back(setting.lights == 1 ? 1 : random.uniform(0, 1));
  }
  return receivers;
}

}  // namespace

std::string nameOf(const TransferSetting& setting) {
  return "order " + std::to_string(setting.order) +
         (setting.channels == 1 ? ", grey, " : ", coloured, ") + std::to_string(setting.lights) +
         (setting.lights == 1 ? " light" : " lights") +
         (setting.blendsRows ? ", blended rows" : "");
}

TransferQuestion::TransferQuestion(const Case& value, const TransferSetting& transferSetting)
    : setting(transferSetting),
      rows(rowsOf(value, setting.order, setting.channels)),
      lights(lightsOf(value, setting.order, setting.lights)),
      receivers(receiversOf(value.receivers.size(), setting)) {}

}  // namespace haarlight::verify
