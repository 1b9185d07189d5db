#pragma once

#include "engine/engine.h"
#include "engine/steps/frame_buffers.h"
#include "engine/steps/shading_buffers.h"

namespace haarlight {

/// The paper's three steps, each with its own kernel: mergeBitCubes or mergeBitCubesExactly,
/// transformOcclusion, tripleProduct. Every step can be taken alone, too.
class StagedPath {
 public:
  StagedPath(KernelQueue& queue, FrameBuffers& frame, ShadingBuffers& shading)
      : queue_(queue), frame_(frame), shading_(shading) {}

  /// Receivers to pass to shade() at a time.
  std::size_t batchSize() const { return queue_.device().batchSize(); }
  /// Radiance of receivers among the spheres of `frame`; adds to `times`.
  void shade(ReceiverSpan receivers, std::span<glm::vec4> radiance, StageTimes& times);

  /// The entries of the sphere table that merging looks up, by a kernel of their own.
  std::vector<std::uint32_t> sphereTableEntries(ReceiverSpan receivers);
  std::vector<BitCube> mergeBitCubes(ReceiverSpan receivers);
  std::vector<OcclusionHaar> transformOcclusion(std::span<const BitCube> cubes);
  std::vector<glm::vec4> tripleProduct(std::span<const OcclusionHaar> occlusion,
                                       std::span<const LobeBlend> lobes);

 private:
  CommandSeconds launchMerge(std::size_t samples);
  CommandSeconds launchTransform(std::size_t samples);
  CommandSeconds launchTripleProduct(std::span<const LobeBlend> lobes);

  KernelQueue& queue_;
  FrameBuffers& frame_;
  ShadingBuffers& shading_;
  GrowingBuffer tableEntries_;                   ///< of sphereTableEntries
  GrowingBuffer bitCubes_;                       ///< from merging to the transform
  GrowingBuffer coefficients_, means_, blocks_;  ///< from the transform to the triple product
};

}  // namespace haarlight
