#pragma once

#include <optional>

#include "engine/exponentiation_tables.h"
#include "engine/stage_times.h"
#include "engine/steps/frame_buffers.h"

namespace haarlight {

/// From spheres to radiance by spherical-harmonic exponentiation, in one kernel:
/// shadeByExponentiation, which alone reads its tables.
class ExponentiationPath {
 public:
  ExponentiationPath(KernelQueue& queue, FrameBuffers& frame) : queue_(queue), frame_(frame) {}

  /// Whether there have been tables.
  bool isSet() const { return visibility_.has_value(); }
  void set(const ExponentiationTables& tables);

  /// Receivers to pass to shade() at a time; they leave nothing but their radiance.
  static constexpr std::size_t batchSize() { return 1 << 16; }
  /// Radiance of receivers among the spheres of `frame`; adds to `times`.
  void shade(ReceiverSpan receivers, std::span<glm::vec4> radiance, StageTimes& times);

 private:
  CommandSeconds launch(std::span<const LobeBlend> blends);

  KernelQueue& queue_;
  FrameBuffers& frame_;
  std::optional<ShexpTables> visibility_;
  GrowingBuffer logarithms_, linear_, constants_, squareStarts_, squareTerms_;  ///< of visibility_
  GrowingBuffer lobeSlots_, lightLobes_;
};

}  // namespace haarlight
