#pragma once

#include "engine/engine.h"
#include "verify/cases/case.h"

namespace haarlight::verify {

/// The size of the paper's frames (method.md §6): a plane of 128 × 128 receivers, `spheres` spheres
/// along a torus knot above it, and a light of a dim sky and a few lamps.
Case paperFrame(int spheres);

/// What one engine needs for that frame, against what a GeForce 8800 has (method.md §9).
struct Budget {
  std::uint64_t memoryBytes = 0;
  std::uint64_t largestLocalBytes = 0;
  int itemsPerGroup = 0;

  static constexpr std::uint64_t memoryLimit = 768'000'000, localLimit = 16 << 10;
  static constexpr int itemsLimit = 256;

  bool isKept() const {
    return memoryBytes <= memoryLimit && largestLocalBytes <= localLimit &&
           itemsPerGroup <= itemsLimit;
  }
};

/// Renders the frame with 128 spheres, 200 terms and two levels, and asks what it took. An engine
/// on the host without a device takes nothing.
Budget budgetOf(Engine& engine);

}  // namespace haarlight::verify
