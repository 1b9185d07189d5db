#include "benchmark/frame_counts.h"

#include <algorithm>
#include <bit>
#include <bitset>
#include <mutex>
#include <set>

#include "base/parallel.h"
#include "engine/kernel_device.h"
#include "visibility/exact_visibility.h"

namespace haarlight::benchmark {

namespace {

constexpr std::uint32_t allGroups = (1u << SphereTable::groupCount) - 1;

double bitCount(std::uint32_t bits) {
  return std::popcount(bits);
}

/// Bit r: row r holds a blocked texel.
using RowSet = std::bitset<bitCubeRows>;

RowSet rowsOf(const BitCube& cube) {
  RowSet rows;
  for (int row = 0; row < bitCubeRows; ++row) rows[row] = cube.rows[row] != 0;
  return rows;
}

double lobesOf(const LobeBlend& blend) {
  return double(std::ranges::count_if(blend.weights, [](float weight) { return weight != 0; }));
}

/// Rows of weights that two samples read, which have these rows blocked.
double weightRowsOf(const LobeBlend& one, const RowSet& rows, const LobeBlend& other,
                    const RowSet& otherRows) {
  double count = 0;
  for (int i = 0; i < 3; ++i) {
    const RowSet own = one.weights[i] != 0 ? rows : RowSet(),
                 others = other.weights[i] != 0 ? otherRows : RowSet();
    const bool isShared = one.lobes[i] == other.lobes[i];
    count += double(isShared ? (own | others).count() : own.count() + others.count());
  }
  return count;
}

/// Counts tiles, from several threads.
class FrameCounter {
 public:
  FrameCounter(std::span<const Sphere> spheres, ReceiverSpan receivers, const SphereTable* table)
      : spheres_(spheres),
        receivers_(receivers),
        table_(table),
        maskIsUsed_(table ? sphereTableEntries : 0) {}

  void countTile(std::size_t first, std::size_t end);
  FrameCounts result() const;

 private:
  struct Tile {
    FrameCounts counts;
    RowSet rows;
    std::vector<int> masks;
  };

  BitCube cubeOf(std::size_t sample, Tile& tile) const {
    return table_ ? lookUp(sample, tile) : testExactly(sample, tile);
  }

  BitCube lookUp(std::size_t sample, Tile& tile) const;
  BitCube testExactly(std::size_t sample, Tile& tile) const;
  void add(const Tile& tile);

  std::span<const Sphere> spheres_;
  ReceiverSpan receivers_;
  const SphereTable* table_;
  std::mutex mutex_;
  FrameCounts counts_;
  RowSet rows_;
  std::vector<bool> maskIsUsed_;
};

BitCube FrameCounter::lookUp(std::size_t sample, Tile& tile) const {
  const glm::vec3 position = receivers_.positions[sample], normal = receivers_.normals[sample];
  for (const Sphere& sphere : spheres_) {
    tile.masks.push_back(sphereTableEntry(sphere, position, normal));
    tile.counts.maskGroups += bitCount(table_->entries()[tile.masks.back()] & allGroups);
  }
  return table_->bitCube(spheres_, position, normal);
}

BitCube FrameCounter::testExactly(std::size_t sample, Tile& tile) const {
  BitCube all;
  for (const Sphere& sphere : spheres_) {
    BitCube own;
    addSphereExactly(own, sphere, receivers_.positions[sample], receivers_.normals[sample]);
    for (int face = 0; face < faceCount; ++face) {
      const auto rows = std::span(own.rows).subspan(face * faceSize, faceSize);
      const auto reached = faceSize - std::ranges::count(rows, 0u);
      tile.counts.reachedFaces += reached > 0;
      tile.counts.reachedRows += double(reached);
    }
    all |= own;
  }
  return all;
}

void FrameCounter::countTile(std::size_t first, std::size_t end) {
  Tile tile;
  RowSet before;  // of the sample before
  for (std::size_t sample = first; sample < end; ++sample) {
    const LobeBlend& blend = receivers_.lobes[sample];
    const RowSet rows = rowsOf(cubeOf(sample, tile));
    tile.rows |= rows;
    tile.counts.blockedRows += double(rows.count()) * lobesOf(blend);
    if ((sample - first) % 2 == 1)
      tile.counts.weightRows += weightRowsOf(receivers_.lobes[sample - 1], before, blend, rows);
    else if (sample + 1 == end)  // without another
      tile.counts.weightRows += double(rows.count()) * lobesOf(blend);
    before = rows;
  }
  std::ranges::sort(tile.masks);
  const auto repeated = std::ranges::unique(tile.masks);
  tile.masks.erase(repeated.begin(), repeated.end());
  add(tile);
}

void FrameCounter::add(const Tile& tile) {
  const std::lock_guard lock(mutex_);
  rows_ |= tile.rows;
  counts_.blockedRows += tile.counts.blockedRows;
  counts_.weightRows += tile.counts.weightRows;
  counts_.maskGroups += tile.counts.maskGroups;
  counts_.reachedFaces += tile.counts.reachedFaces;
  counts_.reachedRows += tile.counts.reachedRows;
  for (const int mask : tile.masks) {
    const double groups = bitCount(table_->entries()[mask] & allGroups);
    ++counts_.masksOfTiles;
    counts_.maskGroupsOfTiles += groups;
    if (maskIsUsed_[mask]) continue;
    maskIsUsed_[mask] = true;
    ++counts_.masksOfFrame;
    counts_.maskGroupsOfFrame += groups;
  }
}

FrameCounts FrameCounter::result() const {
  FrameCounts counts = counts_;
  counts.samples = double(receivers_.size());
  counts.spheres = double(spheres_.size());
  counts.differentBlockedRows = double(rows_.count());
  std::set<std::uint32_t> lobes;
  for (const LobeBlend& blend : receivers_.lobes) {
    counts.lobes += lobesOf(blend);
    for (int i = 0; i < 3; ++i)
      if (blend.weights[i] != 0) lobes.insert(blend.lobes[i]);
  }
  counts.differentLobes = double(lobes.size());
  return counts;
}

}  // namespace

FrameCounts countFrame(std::span<const Sphere> spheres, ReceiverSpan receivers,
                       const SphereTable* table, std::size_t squares) {
  FrameCounter counter(spheres, receivers, table);
  parallelFor(receivers.size(), tileSamples,
              [&](std::size_t first, std::size_t end) { counter.countTile(first, end); });
  FrameCounts counts = counter.result();
  counts.squares = double(squares);
  return counts;
}

}  // namespace haarlight::benchmark
