#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hard_shadow/level_of_detail.h"
#include "hard_shadow/shadow_participant.h"
#include "mesh_shadow/embree_occlusion.h"
#include "shadow/octree_refinement.h"

namespace haarlight {

/// What it took to bring a scene's octrees up to date.
struct SceneOctreeWork {
  std::size_t preparedObjects = 0;  ///< silhouettes, Embree's trees
  std::size_t builtOctrees = 0;     ///< the others were kept
  ShadowPairs pairs;
  OctreeCounts counts;  ///< of the octrees that were built
  double prepareSeconds = 0, pairSeconds = 0, octreeSeconds = 0;

  double seconds() const { return prepareSeconds + pairSeconds + octreeSeconds; }
};

/// The shadows of one light in a whole scene: an octree for every participant, by the coarse step
/// (shadow/shadow_pairs.h) and the fine one (shadow/octree_refinement.h). When the scene moves only
/// those octrees are built anew that can differ.
class SceneOctrees {
 public:
  /// Throws InputError for a detail that checkDetail refuses.
  explicit SceneOctrees(const LevelOfDetail& detail);

  /// Brings the octrees to a scene. `moved[i]`: participant i is not what it was at the call
  /// before; without it, or where light or number of participants have changed, all are. Shapes
  /// must stay until the next call. Throws InputError for lights that checkLight refuses, and for
  /// what makeShadowObject and BoxTree refuse.
  void show(std::span<const ShadowParticipant> participants, const ShadowLight& light,
            const std::vector<bool>& moved = {});

  /// Of the last call of show.
  const SceneOctreeWork& work() const { return work_; }

  const std::vector<ShadowOctree>& octrees() const { return octrees_; }

  /// Sets inShadow[i] to 1 where the light does not reach points[i], and to 0 elsewhere, also where
  /// there is no object. Points may lie off their surface by single precision's rounding. Uses all
  /// threads.
  void answer(std::span<const ReceiverPoint> points, std::span<std::uint8_t> inShadow) const;

  /// The largest edge that the smallest cells of any participant may have: more than was asked for
  /// where even the deepest cells are larger.
  double cellEdge() const;

  /// Bytes of all leaves.
  std::size_t memory() const;

 private:
  void prepare(std::span<const ShadowParticipant> participants, const std::vector<bool>& moved);

  LevelOfDetail detail_;
  std::optional<ShadowLight> light_;
  std::vector<std::unique_ptr<ShadowObject>> objects_;
  std::vector<AxisBox> boxes_;
  std::optional<EmbreeOcclusion> rays_;
  std::vector<std::vector<std::uint32_t>> casters_;  ///< of each receiver
  std::vector<ShadowOctree> octrees_;
  SceneOctreeWork work_;
};

}  // namespace haarlight
