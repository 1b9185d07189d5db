#pragma once

#include "engine/lobe_window.h"
#include "engine/steps/shading_buffers.h"

namespace haarlight {

/// The lobes whose weights are spread over texels, on the device, by their places in the window.
/// spreadWeights fills them; shadeByTable and shadeExactly read them.
class SpreadLobes {
 public:
  SpreadLobes(KernelQueue& queue, ShadingBuffers& shading) : queue_(queue), shading_(shading) {}

  /// To be called when the tables of `shading` are others: none of their lobes is there yet.
  void clear();
  /// How many lobes are there at a time.
  std::size_t capacity() const { return window_.capacity(); }

  /// Brings the lobes of ascending `slots` there, at most capacity() of them; spreads the weights
  /// of those that were not.
  CommandSeconds open(std::span<const std::uint32_t> slots);

  GrowingBuffer places;              ///< by lobe
  GrowingBuffer unshadowed, scales;  ///< by place
  GrowingBuffer texelWeights;        ///< by place, texelWeightCount each

 private:
  void uploadTables();
  CommandSeconds spread(LobeWindow::Change change);

  KernelQueue& queue_;
  ShadingBuffers& shading_;
  LobeWindow window_;
  GrowingBuffer newSlots_, newPlaces_;  ///< read by spreadWeights
};

}  // namespace haarlight
