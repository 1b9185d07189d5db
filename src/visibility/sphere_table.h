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
/// all sizes, 6144 directions × 32 radii × 768 bytes = 144 MiB. Most of a mask is empty (§3.3), so
/// only its groups of 16 rows that hold a set bit are kept, 3.3 of 12 on average: 40 MiB.
class SphereTable {
 public:
  /// Rows of a group, and groups of a mask; group g holds rows 16 g … 16 g + 15 of a bit cube.
  static constexpr int groupRows = 16;
  static constexpr int groupCount = bitCubeRows / groupRows;

  /// Computes all masks, on all threads.
  static SphereTable build();

  /// Reads the table from `folder`, or builds it and writes it there when the file is missing or
  /// its checksum is wrong. An empty or unwritable folder only means that it is built.
  static SphereTable load(const std::filesystem::path& folder);

  /// Per entry: number of its first group << 12 | which groups it has, bit g for group g.
  std::span<const std::uint32_t> entries() const { return entries_; }
  /// An empty group, then those of all entries, one entry after the other: 16 words each.
  std::span<const std::uint32_t> groups() const { return groups_; }

  /// The mask of one entry.
  BitCube mask(int entry) const;

  /// Union of the masks of all spheres, seen from a sample.
  BitCube bitCube(std::span<const Sphere> spheres, const glm::vec3& samplePosition,
                  const glm::vec3& sampleNormal) const;

 private:
  SphereTable(std::vector<std::uint32_t> entries, std::vector<std::uint32_t> groups)
      : entries_(std::move(entries)), groups_(std::move(groups)) {}

  std::vector<std::uint32_t> entries_;
  std::vector<std::uint32_t> groups_;
};

/// The file in `folder` that load() reads and writes.
std::filesystem::path sphereTableFile(const std::filesystem::path& folder);

}  // namespace haarlight
