#include "engine/steps/frame_buffers.h"

#include <algorithm>

#include "base/canonical_order.h"

namespace haarlight {

FrameBuffers::FrameBuffers(KernelQueue& queue, const SphereTable* table)
    : usesTable(table != nullptr), queue_(queue) {
  if (!table) return;
  queue_.upload(tableEntries, table->entries());
  queue_.upload(tableGroups, table->groups());
}

void FrameBuffers::uploadSpheres(std::span<const Sphere> all) {
  sphereCount_ = std::uint32_t(all.size());
  const std::size_t stride = roundedUp(all.size(), partialSums);
  std::vector<float> numbers(4 * stride);
  for (std::size_t i = 0; i < stride; ++i) {
    const Sphere& sphere = all[std::min(i, all.size() - 1)];
    for (int axis = 0; axis < 3; ++axis) numbers[axis * stride + i] = sphere.center[axis];
    numbers[3 * stride + i] = sphere.radius;
  }
  queue_.upload(spheres, numbers);
}

std::array<CommandSeconds, 2> FrameBuffers::uploadPlaces(ReceiverSpan receivers) {
  return {queue_.uploadSamples(positions, receivers.positions),
          queue_.uploadSamples(normals, receivers.normals)};
}

CommandSeconds FrameBuffers::uploadLobes(std::span<const LobeBlend> blends) {
  return queue_.uploadSamples(lobes, blends);
}

KernelArgument FrameBuffers::roomForRadiance(std::size_t samples) {
  return queue_.roomForSamples(radiance, samples, sizeof(glm::vec4));
}

std::uint32_t lobesPerReceiver(std::span<const LobeBlend> lobes) {
  const bool single =
      std::ranges::all_of(lobes, [](const LobeBlend& b) { return b.weights[1] == 0; });
  return single ? 1 : 3;
}

}  // namespace haarlight
