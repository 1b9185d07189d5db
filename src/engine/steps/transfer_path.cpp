#include "engine/steps/transfer_path.h"

#include "base/canonical_order.h"

namespace haarlight {

void TransferPath::setRows(const TransferRows& rows) {
  rows_ = {rows.order, rows.channels, {}};
  rowCount_ = rows.rowCount();
  queue_.upload(rowValues_, rows.values);
}

void TransferPath::setLights(const TransferLights& lights) {
  lights_ = lights;
  queue_.upload(lightValues_, lights.values);
  warmUp();
}

/// Some drivers (PoCL) compile a kernel when it is first launched, which is no part of a frame.
void TransferPath::warmUp() {
  bool& isWarm = isWarm_[rows_.order == 2 ? 0 : 1];
  if (isWarm || rowCount_ == 0 || lights_.order != rows_.order || lights_.count() == 0) return;
  isWarm = true;
  StageTimes ignored;
  shade({{RowBlend{}}, std::vector<float>(lights_.count())}, ignored);
}

CommandSeconds TransferPath::launch(std::span<const RowBlend> blends) {
  const auto count = std::uint32_t(blends.size()), lightCount = std::uint32_t(lights_.count()),
             channels = std::uint32_t(rows_.channels);
  if (rows_.order == 2)
    return queue_.launch(
        "shadeByFourCoefficients", roundedUp(count, partialSums) / partialSums,
        {blends_, count, rowsPerReceiver(blends), rowValues_, channels, lightValues_, lightCount,
         lightWeights_, queue_.room(radiance_, count * sizeof(glm::vec4))});
  return queue_.launch("shadeByTransfer", count,
                       {blends_, count, rowsPerReceiver(blends), rowValues_, channels,
                        std::uint32_t(rows_.coefficients()), lightValues_, lightCount,
                        lightWeights_, queue_.roomForSamples(radiance_, count, sizeof(glm::vec4))});
}

std::vector<glm::vec4> TransferPath::shade(const TransferReceivers& receivers, StageTimes& times) {
  requireTransfer(rows_.order, rowCount_, lights_, receivers);
  std::vector<glm::vec4> radiance(receivers.size());
  if (radiance.empty()) return radiance;
  const CommandSeconds blends = queue_.upload(blends_, receivers.blends);
  const CommandSeconds weights = queue_.upload(lightWeights_, receivers.lightWeights);
  const CommandSeconds shading = launch(receivers.blends);
  times.readBack += queue_.download(radiance_, radiance)();
  times.upload += blends() + weights();
  times.fused += shading();
  return radiance;
}

}  // namespace haarlight
