#pragma once

#include <span>

#include "engine/receivers.h"
#include "visibility/sphere_table.h"

namespace haarlight::benchmark {

/// How much of a frame there is to do, counted on the frame itself. Groups are 16 rows of a bit
/// cube, tiles 16 samples one after the other.
struct FrameCounts {
  double samples = 0, spheres = 0;
  /// Lobes that samples blend, over all samples, and different ones among them.
  double lobes = 0, differentLobes = 0;
  /// Of the triple product's list, with fillers.
  double squares = 0;
  /// Rows that hold a blocked texel, once for each of the sample's lobes, over all samples.
  double blockedRows = 0;
  /// The same with each row once for two samples that follow each other, where they share a lobe:
  /// kernels read its weights once.
  double weightRows = 0;
  /// Rows in which any sample has a blocked texel: at most 192.
  double differentBlockedRows = 0;

  /// With the table, over all samples and spheres: groups of the masks.
  double maskGroups = 0;
  /// The same with each mask once a tile, and the masks themselves.
  double maskGroupsOfTiles = 0, masksOfTiles = 0;
  /// The same with each mask once a frame.
  double maskGroupsOfFrame = 0, masksOfFrame = 0;

  /// With exact visibility, over all samples and spheres: faces and rows where the sphere blocks a
  /// texel.
  double reachedFaces = 0, reachedRows = 0;
};

/// Looks each sphere up from each sample on the host; without a table visibility is exact.
/// `squares` is that of the shading tables.
FrameCounts countFrame(std::span<const Sphere> spheres, ReceiverSpan receivers,
                       const SphereTable* table, std::size_t squares);

}  // namespace haarlight::benchmark
