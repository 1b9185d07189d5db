#pragma once

#include "engine/stage_times.h"
#include "engine/steps/frame_buffers.h"
#include "engine/steps/spread_lobes.h"

namespace haarlight {

/// From spheres to radiance in one kernel, shadeByTable or shadeExactly, once the weights of the
/// lobes in use are spread over texels.
class FusedPath {
 public:
  FusedPath(KernelQueue& queue, FrameBuffers& frame, ShadingBuffers& shading)
      : queue_(queue), frame_(frame), shading_(shading), lobes_(queue, shading) {}

  /// To be called when the tables of `shading` are others.
  void shadingChanged() { lobes_.clear(); }

  /// Receivers to pass to shade() at a time; they leave nothing but their radiance.
  static constexpr std::size_t batchSize() { return 1 << 16; }
  /// Radiance of receivers among the spheres of `frame`; adds to `times`.
  void shade(ReceiverSpan receivers, std::span<glm::vec4> radiance, StageTimes& times);

 private:
  CommandSeconds launch(std::span<const LobeBlend> blends);

  KernelQueue& queue_;
  FrameBuffers& frame_;
  ShadingBuffers& shading_;
  SpreadLobes lobes_;
};

}  // namespace haarlight
