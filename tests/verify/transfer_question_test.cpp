#include "verify/transfer_question.h"

#include <doctest/doctest.h>

#include "verify/cases/random_cases.h"

using namespace haarlight;
using namespace haarlight::verify;

namespace {

/// A receiver's radiance in double, before anything below zero is cut off.
double radianceOf(const TransferQuestion& question, std::size_t receiver, int channel) {
  const RowBlend& blend = question.receivers.blends[receiver];
  const std::size_t lights = question.lights.count();
  double sum = 0;
  for (std::size_t light = 0; light < lights; ++light)
    for (int i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < question.rows.coefficients(); ++k)
        sum += double(question.receivers.lightWeights[receiver * lights + light]) *
               blend.weights[i] * question.rows.row(blend.rows[i], channel)[k] *
               question.lights.light(light, channel)[k];
  return sum;
}

}  // namespace

TEST_CASE("questions of transfer ask for radiance above and below zero") {
  for (const TransferSetting& setting : allTransferSettings) {
    CAPTURE(nameOf(setting));
    std::size_t above = 0, below = 0;
    for (std::size_t index = 0; index < 20; ++index) {
      const TransferQuestion question(randomCase(1, index), setting);
      for (std::size_t i = 0; i < question.receivers.size(); ++i)
        for (int channel = 0; channel < 3; ++channel)
          (radianceOf(question, i, channel) < 0 ? below : above) += 1;
    }
    CHECK(above > below);
    CHECK(below > 0);
  }
}
