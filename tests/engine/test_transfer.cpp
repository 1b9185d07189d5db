#include "test_transfer.h"

#include <random>

namespace haarlight::test {

TestTransfer randomTransfer(unsigned seed, int order, int channels, std::size_t receivers,
                            std::size_t lights, bool blends) {
  constexpr std::uint32_t rowCount = 17;
  std::mt19937 random(seed);
  const auto uniform = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  TestTransfer transfer;
  transfer.rows = {order, channels, {}};
  transfer.rows.values.resize(rowCount * transfer.rows.rowLength());
  for (float& value : transfer.rows.values) value = uniform(-0.3f, 0.5f);
  transfer.lights = {order, {}};
  transfer.lights.values.resize(lights * 3 * transfer.lights.coefficients());
  for (float& value : transfer.lights.values) value = uniform(-1, 3);
  for (std::size_t i = 0; i < receivers; ++i) {
    const auto row = [&] { return std::uint32_t(random() % rowCount); };
    const float second = uniform(0, 0.5f), third = uniform(0, 0.5f);
    transfer.receivers.blends.push_back(
        blends ? RowBlend{{row(), row(), row(), 0}, {1 - second - third, second, third, 0}}
               : RowBlend{{row(), 0, 0, 0}, {1, 0, 0, 0}});
    for (std::size_t light = 0; light < lights; ++light)
      transfer.receivers.lightWeights.push_back(uniform(0, 1));
  }
  return transfer;
}

}  // namespace haarlight::test
