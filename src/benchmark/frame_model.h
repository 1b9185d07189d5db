#pragma once

/// What a frame has to compute and to move, stage by stage: the arithmetic of the kernels in
/// opencl/ without what they spend on lists, loops and lanes that idle, and every byte once for
/// each time that it is needed where it is used.
///
/// An operation is one on a 32-bit lane: an addition, multiplication, comparison, selection,
/// conversion, shift, AND or OR. Constants and what all samples share are free.

#include <vector>

#include "benchmark/frame_counts.h"
#include "engine/shading_tables.h"
#include "engine/stage_times.h"
#include "haar/occlusion_transform.h"
#include "visibility/visibility_kind.h"

namespace haarlight::benchmark {

/// Bytes that are read or written.
struct Traffic {
  double bytes = 0;
  /// Bytes that a thread goes over before it comes back to the same place: tells the cache that
  /// they can come from. 0: they are in the nearest.
  double workingSet = 0;
};

struct StageWork {
  double StageTimes::*stage = nullptr;
  double operations = 0;
  std::vector<Traffic> traffic = {};

  double bytes() const {
    double sum = 0;
    for (const Traffic& part : traffic) sum += part.bytes;
    return sum;
  }
};

namespace frame_model {

/// Vector to a sphere's centre: 3; its height above the tangent plane: 5.
inline constexpr double seeSphere = 8;

/// opencl/sphere_bin.cl. Direction: 25 to find face, major axis, s and t; for each of s and t five
/// steps of 4 and 3 more; 4 for the index. Radius: 12 for both sides of the comparison, five steps
/// of 6, 1 to convert; 2 for the index.
inline constexpr double findMask = (25 + 2 * 23 + 4) + (12 + 30 + 1) + 2;

/// opencl/tile_reach.cl, once for a tile of 16 samples. Its enlarged cap: 20; which faces that may
/// reach: for each face both directions of 11, and 3; on each face the ranges of rows and of
/// columns, 60 each.
inline constexpr double findReach = (20 + 6 * (2 * 11 + 3 + 2 * 60)) / 16.0;
/// opencl/caps.cl. The cap: 12, and the root of its rim 13.
inline constexpr double findCap = findReach + 25;
/// A face: inverse of the quadratic's leading term 13, factors of its roots 3, whether they are
/// safe 13.
inline constexpr double enterFace = 29;
/// opencl/cap_rows.cl. A row: place 2, discriminant 3, its root 7, middle and ends 5, within the
/// face 4, nearest columns 2, both tested 18, bits 7, ahead or not 2, joined 2.
inline constexpr double findInterval = 52;

/// A group of a mask: 16 words of 32 texels.
inline constexpr double wordsOfGroup = SphereTable::groupRows;
inline constexpr double bytesOfGroup = 4 * wordsOfGroup;
/// A mask's number and groups.
inline constexpr double bytesOfEntry = sizeof(std::uint32_t);

/// Weights of a row's texels for one lobe: three channels, one addition each.
inline constexpr double weightsOfRow = 3 * faceSize;

/// opencl/transform_occlusion.cl. A block: 14 to collect its bits, 13 to count them, 2 for the
/// mean; a square of levels 0 … 2: 12 for three coefficients and the mean.
inline constexpr double transformSample = 29.0 * blockCount + 12.0 * coarseSquareCount;

/// Three channels of four multiplications and additions.
inline constexpr double weighSquare = 3 * 4 * 2;
inline constexpr double bytesOfSquare = sizeof(ChannelWeights<glm::uvec4>);

/// Position, normal, lobes; radiance.
inline constexpr double bytesIn = 2 * sizeof(glm::vec4) + sizeof(LobeBlend);
inline constexpr double bytesOut = sizeof(glm::vec4);
/// Samples of a batch of the staged path on a CPU: the stages go over all of it, one after the
/// other.
inline constexpr double batch = 2048;

/// Of `each` bytes a sample, in batches.
inline Traffic ofBatch(const FrameCounts& counts, double each) {
  return {counts.samples * each, std::min(counts.samples, batch) * each};
}

/// A copy: read and written.
inline StageWork copy(double StageTimes::*stage, double bytes) {
  return {stage, 0, {{2 * bytes, 2 * bytes}}};
}

/// Spheres to bit cubes. With the table masks are looked up for every sample and sphere, from the
/// nearest cache where the tile has read them before, else from where the frame's masks lie.
inline StageWork merge(const FrameCounts& counts, VisibilityKind visibility) {
  const double pairs = counts.samples * counts.spheres;
  const auto bytes = [](double masks, double groups) {
    return masks * bytesOfEntry + groups * bytesOfGroup;
  };
  if (visibility == VisibilityKind::exact)
    return {&StageTimes::merge,
            pairs * (seeSphere + findCap) + counts.reachedFaces * enterFace +
                counts.reachedRows * findInterval,
            {{2 * sizeof(glm::vec4) * counts.samples, 0}}};
  const double first = bytes(counts.masksOfTiles, counts.maskGroupsOfTiles);
  return {&StageTimes::merge,
          pairs * (seeSphere + findMask) + counts.maskGroups * wordsOfGroup,
          {{bytes(pairs, counts.maskGroups) - first, 0},
           {first, bytes(counts.masksOfFrame, counts.maskGroupsOfFrame)},
           {2 * sizeof(glm::vec4) * counts.samples, 0}}};
}

/// Bit cubes to weights of blocked texels, added; two samples that share a lobe read them once.
inline StageWork addWeights(const FrameCounts& counts) {
  const double bytes = 4 * weightsOfRow;
  return {
      &StageTimes::fused,
      counts.blockedRows * weightsOfRow,
      {{counts.weightRows * bytes, counts.differentBlockedRows * bytes * counts.differentLobes}}};
}

/// Merging without bit cubes that leave the processor, and the weights of what is blocked.
inline StageWork fused(const FrameCounts& counts, VisibilityKind visibility) {
  StageWork work = merge(counts, visibility);
  const StageWork weights = addWeights(counts);
  work.stage = &StageTimes::fused;
  work.operations += weights.operations;
  work.traffic.insert(work.traffic.end(), weights.traffic.begin(), weights.traffic.end());
  return work;
}

inline StageWork stagedMerge(const FrameCounts& counts, VisibilityKind visibility) {
  StageWork work = merge(counts, visibility);
  work.traffic.push_back(ofBatch(counts, sizeof(BitCube)));
  return work;
}

inline StageWork transform(const FrameCounts& counts) {
  return {&StageTimes::transform,
          counts.samples * transformSample,
          {ofBatch(counts, sizeof(BitCube)), ofBatch(counts, sizeof(OcclusionHaar))}};
}

inline StageWork tripleProduct(const FrameCounts& counts) {
  return {&StageTimes::tripleProduct,
          counts.lobes * counts.squares * weighSquare,
          {ofBatch(counts, sizeof(OcclusionHaar)),
           {counts.lobes * counts.squares * bytesOfSquare,
            counts.differentLobes * counts.squares * bytesOfSquare}}};
}

}  // namespace frame_model

/// The stages of a path, in the order of a frame.
inline std::vector<StageWork> frameWork(const FrameCounts& counts, VisibilityKind visibility,
                                        FramePath path) {
  using namespace frame_model;
  std::vector<StageWork> work{copy(&StageTimes::upload, counts.samples * bytesIn)};
  if (path == FramePath::fused) {
    work.push_back(fused(counts, visibility));
  } else {
    work.push_back(stagedMerge(counts, visibility));
    work.push_back(transform(counts));
    work.push_back(tripleProduct(counts));
  }
  work.push_back(copy(&StageTimes::readBack, counts.samples * bytesOut));
  return work;
}

}  // namespace haarlight::benchmark
