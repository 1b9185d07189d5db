#include "engine/steps/fused_path.h"

namespace haarlight {

CommandSeconds FusedPath::launch(std::span<const LobeBlend> blends) {
  const KernelArgument radiance = frame_.roomForRadiance(blends.size());
  if (frame_.usesTable)
    return queue_.launchTiles(
        "shadeByTable", blends.size(),
        {frame_.positions, frame_.normals, frame_.lobes, frame_.spheres, frame_.sphereCount(),
         frame_.tableEntries, frame_.tableGroups, lobesPerReceiver(blends), lobes_.places,
         lobes_.texelWeights, lobes_.unshadowed, lobes_.scales, radiance});
  return queue_.launchTiles("shadeExactly", blends.size(),
                            {frame_.positions, frame_.normals, frame_.lobes, frame_.spheres,
                             frame_.sphereCount(), lobesPerReceiver(blends), lobes_.places,
                             lobes_.texelWeights, lobes_.unshadowed, lobes_.scales, radiance});
}

/// Halves batches whose lobes do not fit into the window.
void FusedPath::shade(ReceiverSpan receivers, std::span<glm::vec4> radiance, StageTimes& times) {
  const auto slots = slotsOf(receivers.lobes, shading_.host());
  if (slots.size() > lobes_.capacity()) {
    const std::size_t half = receivers.size() / 2;
    shade(receivers.part(0, half), radiance.first(half), times);
    shade(receivers.part(half, receivers.size() - half), radiance.subspan(half), times);
    return;
  }
  const CommandSeconds spread = lobes_.open(slots);
  const auto places = frame_.uploadPlaces(receivers);
  const CommandSeconds blends = frame_.uploadLobes(receivers.lobes);
  const CommandSeconds fused = launch(receivers.lobes);
  times.readBack += queue_.download(frame_.radiance, radiance)();
  times.upload += places[0]() + places[1]() + blends();
  times.fused += spread() + fused();
}

}  // namespace haarlight
