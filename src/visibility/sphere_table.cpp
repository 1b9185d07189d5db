#include "visibility/sphere_table.h"

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

/// All radii of one direction. Along the radii masks only grow, so a row is left as soon as it is
/// empty at the largest remaining radius.
void buildDirection(const std::vector<glm::dvec3>& directions, int direction, Words& words) {
  static const auto thresholds = radiusBinCosines();
  const std::size_t first = std::size_t(direction) * radiusBins * bitCubeRows;
  for (int row = 0; row < bitCubeRows; ++row) {
    float cosines[faceSize];
    for (int column = 0; column < faceSize; ++column)
      cosines[column] = float(glm::dot(directions[direction], directions[row * faceSize + column]));
    for (int bin = radiusBins - 1; bin >= 0; --bin) {
      const std::uint32_t mask = rowMask(cosines, thresholds[bin]);
      if (!mask) break;
      words[first + std::size_t(bin) * bitCubeRows + row] = mask;
    }
  }
}

std::vector<std::uint8_t> findOccupiedFaces(const Words& words) {
  std::vector<std::uint8_t> occupied(sphereTableEntries);
  parallelFor(sphereTableEntries, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t entry = begin; entry < end; ++entry)
      for (int row = 0; row < bitCubeRows; ++row)
        if (words[entry * bitCubeRows + row]) occupied[entry] |= 1u << (row / faceSize);
  });
  return occupied;
}

std::span<const std::uint8_t> asBytes(const Words& words) {
  return {reinterpret_cast<const std::uint8_t*>(words.data()), words.size() * sizeof words[0]};
}

/// File: words, then their checksum.
std::optional<Words> readCache(const std::filesystem::path& file) {
  std::error_code error;
  const std::uint64_t wordBytes = std::uint64_t(sphereTableEntries) * sizeof(BitCube);
  if (std::filesystem::file_size(file, error) != wordBytes + sizeof(std::uint64_t) || error)
    return std::nullopt;
  const auto bytes = readWholeFile(file, "sphere table");
  if (bytes.size() != wordBytes + sizeof(std::uint64_t)) return std::nullopt;
  std::uint64_t stored = 0;
  std::memcpy(&stored, bytes.data() + wordBytes, sizeof stored);
  if (checksum(std::span(bytes).first(wordBytes)) != stored) return std::nullopt;
  Words words(wordBytes / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), wordBytes);
  return words;
}

void writeCache(const std::filesystem::path& file, const Words& words) {
  std::filesystem::create_directories(file.parent_path());
  const auto wordBytes = asBytes(words);
  std::vector<std::uint8_t> bytes(wordBytes.begin(), wordBytes.end());
  const std::uint64_t sum = checksum(wordBytes);
  const auto* sumBytes = reinterpret_cast<const std::uint8_t*>(&sum);
  bytes.insert(bytes.end(), sumBytes, sumBytes + sizeof sum);
  writeFileAtomically(file, bytes);
}

}  // namespace

std::filesystem::path sphereTableFile(const std::filesystem::path& folder) {
  return folder / "sphere-table-1.bin";
}

SphereTable SphereTable::build() {
  SphereTable table;
  table.words_.resize(std::size_t(sphereTableEntries) * bitCubeRows);
  const auto directions = texelDirections();
  parallelFor(texelCount, 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t direction = begin; direction < end; ++direction)
      buildDirection(directions, int(direction), table.words_);
  });
  table.occupiedFaces_ = findOccupiedFaces(table.words_);
  return table;
}

BitCube SphereTable::bitCube(std::span<const Sphere> spheres, const glm::vec3& samplePosition,
                             const glm::vec3& sampleNormal) const {
  BitCube cube;
  for (const Sphere& sphere : spheres) {
    const auto rows = mask(sphereTableEntry(sphere, samplePosition, sampleNormal));
    for (int row = 0; row < bitCubeRows; ++row) cube.rows[row] |= rows[row];
  }
  return cube;
}

SphereTable SphereTable::load(const std::filesystem::path& folder) {
  if (folder.empty()) return build();
  const auto file = sphereTableFile(folder);
  try {
    if (auto words = readCache(file)) {
      SphereTable table;
      table.words_ = std::move(*words);
      table.occupiedFaces_ = findOccupiedFaces(table.words_);
      return table;
    }
  } catch (const InputError&) {  // unreadable is as good as missing
  }
  SphereTable table = build();
  try {
    writeCache(file, table.words_);
  } catch (const std::exception&) {  // no cache: the next start builds again
  }
  return table;
}

}  // namespace haarlight
