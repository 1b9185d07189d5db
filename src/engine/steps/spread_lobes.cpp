#include "engine/steps/spread_lobes.h"

#include <algorithm>

namespace haarlight {

namespace {

/// Lobes to have room for at least, so that small frames need not grow theirs.
constexpr std::size_t smallestRoom = 16;

}  // namespace

void SpreadLobes::clear() {
  window_ = LobeWindow(std::min(queue_.device().lobeWindow(), shading_.host().slotCount()));
}

CommandSeconds SpreadLobes::open(std::span<const std::uint32_t> slots) {
  LobeWindow::Change change = window_.open(slots);
  if (change.slots.empty()) return [] { return 0.0; };
  uploadTables();
  return spread(std::move(change));
}

void SpreadLobes::uploadTables() {
  const ShadingTables& tables = shading_.host();
  std::vector<std::uint32_t> placesOfLobes;
  for (const std::uint32_t slot : tables.lobeSlots) placesOfLobes.push_back(window_.placeOf(slot));
  std::vector<glm::uvec4> unshadowedAt;
  std::vector<glm::vec4> scalesAt;
  for (const std::uint32_t slot : window_.slots()) {
    unshadowedAt.push_back(tables.unshadowed[slot]);
    scalesAt.push_back(tables.scales[slot]);
  }
  queue_.upload(places, placesOfLobes);
  queue_.upload(unshadowed, unshadowedAt);
  queue_.upload(scales, scalesAt);
}

CommandSeconds SpreadLobes::spread(LobeWindow::Change change) {
  // Work-groups are full; the last lobe fills them up.
  const std::size_t count = change.slots.size();
  const std::size_t full = roundedUp(count, queue_.samplesPerGroup());
  change.slots.resize(full, change.slots.back());
  change.places.resize(full, change.places.back());
  queue_.upload(newSlots_, change.slots);
  queue_.upload(newPlaces_, change.places);
  const std::size_t lobes = std::max(window_.capacity(), smallestRoom);
  return queue_.launch(
      "spreadWeights", count,
      {newSlots_, newPlaces_, std::uint32_t(shading_.host().squareCount()), shading_.weights,
       shading_.squaresOfBlocks,
       queue_.room(texelWeights, lobes * texelWeightCount * sizeof(std::uint32_t))});
}

}  // namespace haarlight
