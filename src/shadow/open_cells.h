#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "shadow/cell_code.h"
#include "shadow/shadow_object.h"

namespace haarlight {

/// Items that follow each other in a list.
struct Run {
  std::uint32_t first = 0, count = 0;

  template <typename Item>
  std::span<const Item> of(const std::vector<Item>& items) const {
    return std::span(items).subspan(first, count);
  }
  template <typename Item>
  std::span<Item> of(std::vector<Item>& items) const {
    return std::span(items).subspan(first, count);
  }
};

/// The items that a list has got since there were `first` of them.
template <typename Item>
Run runSince(std::size_t first, const std::vector<Item>& items) {
  return {std::uint32_t(first), std::uint32_t(items.size() - first)};
}

/// A caster that may shadow a part of a cell, but not all of it, as far as is known.
struct Suspect {
  std::uint32_t caster;
  Run parts;
  CellShadow shadow = CellShadow::unknown;
  std::uint32_t rays = 0;  ///< how many of the cell's rays ask about it
};

/// A cell that the surface reaches, and what it hands down to its children.
struct OpenCell {
  CellCode code;
  std::uint32_t store = 0;  ///< which store of its level has its runs
  Run surface, suspects;
  std::optional<bool> inShadow;  ///< once it is known
  bool byRay = false;            ///< it is known for one point only
};

/// Cells of one level with all that they refer to.
struct CellStore {
  Parts surface, parts;  ///< of cells, and of suspects
  std::vector<Suspect> suspects;
  std::vector<OpenCell> cells;

  void clear() { surface.clear(), parts.clear(), suspects.clear(), cells.clear(); }
};

}  // namespace haarlight
