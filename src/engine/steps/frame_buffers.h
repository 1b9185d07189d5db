#pragma once

#include <array>

#include "engine/receivers.h"
#include "engine/steps/kernel_queue.h"
#include "visibility/sphere.h"
#include "visibility/sphere_table.h"

namespace haarlight {

/// What every frame begins and ends with, on the device: the sphere table, the spheres, a batch of
/// receivers and their radiance. All kernels that merge read the first three.
class FrameBuffers {
 public:
  /// Uploads the table; null: visibility is exact.
  FrameBuffers(KernelQueue& queue, const SphereTable* table);

  /// As kernels read them: x, y, z, radius of all, one after the other, padded to a multiple of 32
  /// with the last sphere.
  void uploadSpheres(std::span<const Sphere> spheres);
  std::uint32_t sphereCount() const { return sphereCount_; }

  std::array<CommandSeconds, 2> uploadPlaces(ReceiverSpan receivers);
  CommandSeconds uploadLobes(std::span<const LobeBlend> blends);

  KernelArgument roomForRadiance(std::size_t samples);

  bool usesTable = false;
  GrowingBuffer tableEntries, tableGroups;
  GrowingBuffer spheres;
  GrowingBuffer positions, normals, lobes;
  GrowingBuffer radiance;  ///< of every kernel that ends a frame

 private:
  KernelQueue& queue_;
  std::uint32_t sphereCount_ = 0;
};

/// Lobes that kernels look at: receivers whose normals are all tabulated ones need one each, others
/// three.
std::uint32_t lobesPerReceiver(std::span<const LobeBlend> lobes);

}  // namespace haarlight
