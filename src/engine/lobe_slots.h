#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "material/cosine_lobe.h"

namespace haarlight {

/// The lobes that occur among the receivers (importance above 0), in the order of their slots.
inline std::vector<int> usedLobes(std::span<const double> importance) {
  std::vector<int> used;
  for (int lobe = 0; lobe < lobeCount; ++lobe)
    if (importance[lobe] > 0) used.push_back(lobe);
  return used;
}

/// Slot of every lobe: those that are used come one after the other, all others share the slot
/// behind the last, which is black.
inline std::vector<std::uint32_t> assignSlots(std::span<const int> lobes) {
  std::vector<std::uint32_t> slots(lobeCount, std::uint32_t(lobes.size()));
  for (std::size_t slot = 0; slot < lobes.size(); ++slot) slots[lobes[slot]] = std::uint32_t(slot);
  return slots;
}

}  // namespace haarlight
