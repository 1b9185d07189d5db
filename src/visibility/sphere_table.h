#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "cube/bit_cube.h"
#include "visibility/sphere_bin.h"

namespace haarlight {

inline constexpr int sphereTableEntries = texelCount * radiusBins;

/// The visibility cube of one sphere for every (v, r) (method.md §3): one table for all spheres of
/// all sizes, 6144 directions × 32 radii × 768 bytes = 144 MiB.
class SphereTable {
 public:
  /// Computes all masks, on all threads.
  static SphereTable build();

  /// Reads the table from `folder`, or builds it and writes it there when the file is missing or
  /// its checksum is wrong. An empty or unwritable folder only means that it is built.
  static SphereTable load(const std::filesystem::path& folder);

  /// Masks: entry · 192 + face · 32 + row.
  std::span<const std::uint32_t> words() const { return words_; }

  /// Per entry: bit f is set when face f of the mask holds a set bit. Most of a mask is empty
  /// (§3.3), so merging reads only these faces.
  std::span<const std::uint8_t> occupiedFaces() const { return occupiedFaces_; }

  std::span<const std::uint32_t> mask(int entry) const {
    return words().subspan(std::size_t(entry) * bitCubeRows, bitCubeRows);
  }

  /// Union of the masks of all spheres, seen from a sample.
  BitCube bitCube(std::span<const Sphere> spheres, const glm::vec3& samplePosition,
                  const glm::vec3& sampleNormal) const;

 private:
  std::vector<std::uint32_t> words_;
  std::vector<std::uint8_t> occupiedFaces_;
};

/// The file in `folder` that load() reads and writes.
std::filesystem::path sphereTableFile(const std::filesystem::path& folder);

}  // namespace haarlight
