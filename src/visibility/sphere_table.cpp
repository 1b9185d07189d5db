#include "visibility/sphere_table.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <optional>

#include "base/error.h"
#include "base/file.h"
#include "base/parallel.h"

namespace haarlight {

namespace {

using Words = std::vector<std::uint32_t>;

std::vector<glm::dvec3> texelDirections() {
  std::vector<glm::dvec3> directions(texelCount);
  for (int texel = 0; texel < texelCount; ++texel) directions[texel] = texelDirection(texel);
  return directions;
}

/// cos α of every radius bin: a texel is blocked iff dir·v ≥ cos α.
std::array<float, radiusBins> radiusBinCosines() {
  std::array<float, radiusBins> cosines;
  for (int bin = 0; bin < radiusBins; ++bin)
    cosines[bin] = float(std::sqrt(1.0 - radiusBinCenter(bin)));
  return cosines;
}

std::uint32_t rowMask(const float* cosines, float threshold) {
  std::uint32_t mask = 0;
  for (int column = 0; column < faceSize; ++column)
    mask |= std::uint32_t(cosines[column] >= threshold) << column;
  return mask;
}

/// The masks of one direction, by radius bin. Along the radii masks only grow, so a row is left as
/// soon as it is empty at the largest remaining radius.
std::vector<BitCube> masksOf(const std::vector<glm::dvec3>& directions, int direction) {
  static const auto thresholds = radiusBinCosines();
  std::vector<BitCube> masks(radiusBins);
  for (int row = 0; row < bitCubeRows; ++row) {
    float cosines[faceSize];
    for (int column = 0; column < faceSize; ++column)
      cosines[column] = float(glm::dot(directions[direction], directions[row * faceSize + column]));
    for (int bin = radiusBins - 1; bin >= 0; --bin) {
      const std::uint32_t mask = rowMask(cosines, thresholds[bin]);
      if (!mask) break;
      masks[bin].rows[row] = mask;
    }
  }
  return masks;
}

constexpr std::uint32_t groupsMask = (1u << SphereTable::groupCount) - 1;

/// Appends the occupied groups of a mask; returns which they are.
std::uint32_t appendGroups(const BitCube& mask, Words& groups) {
  std::uint32_t occupied = 0;
  for (int group = 0; group < SphereTable::groupCount; ++group) {
    const auto rows =
        std::span(mask.rows).subspan(group * SphereTable::groupRows).first(SphereTable::groupRows);
    if (std::ranges::all_of(rows, [](std::uint32_t row) { return row == 0; })) continue;
    occupied |= 1u << group;
    groups.insert(groups.end(), rows.begin(), rows.end());
  }
  return occupied;
}

/// Adds the numbers of their first groups to entries that say which groups they have. The empty
/// group is number 0. Returns the number of all groups.
std::uint32_t numberGroups(Words& entries) {
  std::uint32_t number = 1;
  for (std::uint32_t& entry : entries) {
    const auto own = std::uint32_t(std::popcount(entry & groupsMask));
    entry |= number << SphereTable::groupCount;
    number += own;
  }
  return number;
}

/// File: entries, groups, checksum of both.
std::vector<std::uint8_t> fileContent(std::span<const std::uint32_t> entries,
                                      std::span<const std::uint32_t> groups) {
  std::vector<std::uint8_t> bytes(entries.size_bytes() + groups.size_bytes());
  std::memcpy(bytes.data(), entries.data(), entries.size_bytes());
  std::memcpy(bytes.data() + entries.size_bytes(), groups.data(), groups.size_bytes());
  const std::uint64_t sum = checksum(bytes);
  const auto* sumBytes = reinterpret_cast<const std::uint8_t*>(&sum);
  bytes.insert(bytes.end(), sumBytes, sumBytes + sizeof sum);
  return bytes;
}

constexpr std::size_t entryBytes = sphereTableEntries * sizeof(std::uint32_t);

struct Content {
  Words entries = Words(sphereTableEntries);
  Words groups;
};

/// What a file holds; nothing when its size or checksum is wrong.
std::optional<Content> contentOf(std::span<const std::uint8_t> file) {
  constexpr std::size_t sumBytes = sizeof(std::uint64_t);
  if (file.size() < entryBytes + sumBytes || file.size() % sizeof(std::uint32_t))
    return std::nullopt;
  std::uint64_t stored = 0;
  std::memcpy(&stored, file.data() + file.size() - sumBytes, sumBytes);
  if (checksum(file.first(file.size() - sumBytes)) != stored) return std::nullopt;
  Content content;
  std::memcpy(content.entries.data(), file.data(), entryBytes);
  const auto groups = file.subspan(entryBytes, file.size() - entryBytes - sumBytes);
  content.groups.resize(groups.size() / sizeof(std::uint32_t));
  std::memcpy(content.groups.data(), groups.data(), groups.size());
  return content;
}

std::optional<Content> readCache(const std::filesystem::path& file) {
  constexpr std::uintmax_t largest = entryBytes + sphereTableEntries * sizeof(BitCube) + 128;
  std::error_code error;
  if (std::filesystem::file_size(file, error) > largest || error) return std::nullopt;
  return contentOf(readWholeFile(file, "sphere table"));
}

}  // namespace

std::filesystem::path sphereTableFile(const std::filesystem::path& folder) {
  return folder / "sphere-table-2.bin";
}

SphereTable SphereTable::build() {
  Words entries(sphereTableEntries);
  const auto directions = texelDirections();
  std::vector<Words> groupsOfDirection(texelCount);
  parallelFor(texelCount, 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t direction = begin; direction < end; ++direction) {
      std::uint32_t* entry = &entries[direction * radiusBins];
      for (const BitCube& mask : masksOf(directions, int(direction)))
        *entry++ = appendGroups(mask, groupsOfDirection[direction]);
    }
  });
  Words groups;
  groups.reserve(std::size_t(numberGroups(entries)) * groupRows);
  groups.resize(groupRows);
  for (Words& own : groupsOfDirection) {
    groups.insert(groups.end(), own.begin(), own.end());
    Words().swap(own);
  }
  return {std::move(entries), std::move(groups)};
}

BitCube SphereTable::mask(int entry) const {
  BitCube mask;
  const std::uint32_t* rows = &groups_[std::size_t(entries_[entry] >> groupCount) * groupRows];
  for (int group = 0; group < groupCount; ++group) {
    if (!(entries_[entry] >> group & 1)) continue;
    std::copy_n(rows, groupRows, &mask.rows[group * groupRows]);
    rows += groupRows;
  }
  return mask;
}

BitCube SphereTable::bitCube(std::span<const Sphere> spheres, const glm::vec3& samplePosition,
                             const glm::vec3& sampleNormal) const {
  BitCube cube;
  for (const Sphere& sphere : spheres)
    cube |= mask(sphereTableEntry(sphere, samplePosition, sampleNormal));
  return cube;
}

SphereTable SphereTable::load(const std::filesystem::path& folder) {
  if (folder.empty()) return build();
  const auto file = sphereTableFile(folder);
  try {
    if (auto content = readCache(file))
      return {std::move(content->entries), std::move(content->groups)};
  } catch (const InputError&) {  // unreadable is as good as missing
  }
  SphereTable table = build();
  try {
    std::filesystem::create_directories(folder);
    writeFileAtomically(file, fileContent(table.entries_, table.groups_));
  } catch (const std::exception&) {  // no cache: the next start builds again
  }
  return table;
}

}  // namespace haarlight
