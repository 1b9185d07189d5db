#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/shading_tables.h"

namespace haarlight {

/// Slots that the receivers' lobes have weight in, ascending.
std::vector<std::uint32_t> slotsOf(std::span<const LobeBlend> lobes, const ShadingTables& tables);

/// Which lobes have a place in memory that does not hold all of them at once. Batches of receivers
/// that lie near each other share most of their lobes, and those stay where they are.
class LobeWindow {
 public:
  explicit LobeWindow(std::size_t capacity = 0) : capacity_(capacity) {}

  std::size_t capacity() const { return capacity_; }

  /// Slots that got a place, and the places.
  struct Change {
    std::vector<std::uint32_t> slots, places;
  };

  /// Makes place for ascending `slots`, at most capacity() of them: for those that have none, first
  /// places not yet used, then those of slots that are not among them.
  Change open(std::span<const std::uint32_t> slots);

  /// Slots by place.
  std::span<const std::uint32_t> slots() const { return slots_; }
  /// Place of a slot; 0 for one without.
  std::uint32_t placeOf(std::uint32_t slot) const {
    return slot < places_.size() && places_[slot] != none ? places_[slot] : 0;
  }

 private:
  static constexpr std::uint32_t none = ~0u;

  std::uint32_t nextPlace(std::span<const std::uint32_t> wanted);

  std::size_t capacity_;
  std::vector<std::uint32_t> slots_;
  std::vector<std::uint32_t> places_;  ///< by slot
  std::size_t hand_ = 0;               ///< where the search for a place to reuse goes on
};

}  // namespace haarlight
