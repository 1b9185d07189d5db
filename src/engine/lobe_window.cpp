#include "engine/lobe_window.h"

#include <algorithm>

namespace haarlight {

std::vector<std::uint32_t> slotsOf(std::span<const LobeBlend> lobes, const ShadingTables& tables) {
  std::vector<bool> used(tables.slotCount());
  for (const LobeBlend& blend : lobes)
    for (int i = 0; i < 3; ++i)
      if (blend.weights[i] != 0) used[tables.lobeSlots[blend.lobes[i]]] = true;
  std::vector<std::uint32_t> slots;
  for (std::uint32_t slot = 0; slot < used.size(); ++slot)
    if (used[slot]) slots.push_back(slot);
  return slots;
}

LobeWindow::Change LobeWindow::open(std::span<const std::uint32_t> slots) {
  Change change;
  if (!slots.empty() && slots.back() >= places_.size()) places_.resize(slots.back() + 1, none);
  for (const std::uint32_t slot : slots) {
    if (places_[slot] != none) continue;
    const std::uint32_t place = nextPlace(slots);
    slots_[place] = slot;
    places_[slot] = place;
    change.slots.push_back(slot);
    change.places.push_back(place);
  }
  return change;
}

/// A free place, or one whose slot is not wanted; that slot loses it.
std::uint32_t LobeWindow::nextPlace(std::span<const std::uint32_t> wanted) {
  if (slots_.size() < capacity_) {
    slots_.push_back(none);
    return std::uint32_t(slots_.size() - 1);
  }
  while (std::ranges::binary_search(wanted, slots_[hand_])) hand_ = (hand_ + 1) % capacity_;
  const std::size_t place = hand_;
  hand_ = (hand_ + 1) % capacity_;
  places_[slots_[place]] = none;
  return std::uint32_t(place);
}

}  // namespace haarlight
