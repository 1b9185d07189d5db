#pragma once

#include <variant>

#include "shadow/octree_refinement.h"

namespace haarlight {

/// How fine the shadows of a whole scene are.
struct LevelOfDetail {
  /// The depth of every receiver's smallest cells (int), or their largest edge in world units
  /// (double), from which each receiver's depth follows, at most the deepest.
  std::variant<int, double> boundary = 8;
  /// As in OctreeDepths; at most the boundary's.
  int interior = 0;
};

/// Throws InputError for depths and lengths that make no sense.
void checkDetail(const LevelOfDetail& detail);

OctreeDepths depthsFor(const LevelOfDetail& detail, const AxisBox& receiver);

}  // namespace haarlight
