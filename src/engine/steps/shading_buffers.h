#pragma once

#include "engine/shading_tables.h"
#include "engine/steps/kernel_queue.h"

namespace haarlight {

/// The tables of one light (engine/shading_tables.h), on the device.
class ShadingBuffers {
 public:
  explicit ShadingBuffers(KernelQueue& queue) : queue_(queue) {}

  void set(const ShadingTables& tables);

  /// The tables without weights and block squares, which are needed on the device only.
  const ShadingTables& host() const { return host_; }

  /// Of all squares, by slot. Read by tripleProduct and spreadWeights.
  GrowingBuffer weights;
  /// Read by spreadWeights.
  GrowingBuffer squaresOfBlocks;

  /// What tripleProduct reads besides.
  struct OfLobes {
    glm::uvec4 squareListEnds{0};
    GrowingBuffer slots, squarePlaces, unshadowed, scales;
  };
  /// Uploaded when they are first asked for: the fused path never does.
  const OfLobes& ofLobes();

 private:
  KernelQueue& queue_;
  ShadingTables host_;
  OfLobes ofLobes_;
  bool hasOfLobes_ = false;
};

}  // namespace haarlight
