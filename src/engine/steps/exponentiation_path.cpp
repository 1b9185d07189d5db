#include "engine/steps/exponentiation_path.h"

namespace haarlight {

void ExponentiationPath::set(const ExponentiationTables& tables) {
  const ShexpTables& visibility = visibility_.emplace(tables.visibility);
  queue_.upload(logarithms_, visibility.logarithms);
  queue_.upload(linear_, visibility.linear);
  queue_.upload(constants_, std::span(&visibility.constants, 1));
  queue_.upload(squareStarts_, visibility.squareStarts);
  queue_.upload(squareTerms_, visibility.squareTerms);
  queue_.upload(lobeSlots_, tables.lobeSlots);
  queue_.upload(lightLobes_, tables.lightLobes);
}

CommandSeconds ExponentiationPath::launch(std::span<const LobeBlend> blends) {
  const ShexpTables& visibility = visibility_.value();
  return queue_.launchTiles(
      "shadeByExponentiation", blends.size(),
      {frame_.positions, frame_.normals, frame_.lobes, frame_.spheres, frame_.sphereCount(),
       std::uint32_t(visibility.order),
       std::uint32_t(visibility.mostHalvings(frame_.sphereCount())), logarithms_, linear_,
       constants_, squareStarts_, squareTerms_, lobesPerReceiver(blends), lobeSlots_, lightLobes_,
       frame_.roomForRadiance(blends.size())});
}

void ExponentiationPath::shade(ReceiverSpan receivers, std::span<glm::vec4> radiance,
                               StageTimes& times) {
  const auto places = frame_.uploadPlaces(receivers);
  const CommandSeconds blends = frame_.uploadLobes(receivers.lobes);
  const CommandSeconds fused = launch(receivers.lobes);
  times.readBack += queue_.download(frame_.radiance, radiance)();
  times.upload += places[0]() + places[1]() + blends();
  times.fused += fused();
}

}  // namespace haarlight
