#pragma once

#include <array>

#include "engine/stage_times.h"
#include "engine/steps/kernel_queue.h"
#include "engine/transfer_tables.h"

namespace haarlight {

/// Shading by precomputed transfer, on the device: shadeByTransfer, or for four coefficients
/// shadeByFourCoefficients, reads and writes all of it.
class TransferPath {
 public:
  explicit TransferPath(KernelQueue& queue) : queue_(queue) {}

  void setRows(const TransferRows& rows);
  void setLights(const TransferLights& lights);

  /// Adds to `times`. The receivers are all shaded at once.
  std::vector<glm::vec4> shade(const TransferReceivers& receivers, StageTimes& times);

 private:
  CommandSeconds launch(std::span<const RowBlend> blends);
  void warmUp();

  KernelQueue& queue_;
  TransferRows rows_;  ///< without their values, which are on the device only
  std::size_t rowCount_ = 0;
  TransferLights lights_;
  std::array<bool, 2> isWarm_{};  ///< the kernel for four coefficients, the other one
  GrowingBuffer rowValues_, lightValues_, blends_, lightWeights_, radiance_;
};

}  // namespace haarlight
