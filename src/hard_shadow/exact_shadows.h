#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hard_shadow/shadow_participant.h"

namespace haarlight {

/// The reference: one ray from every point to the light, against all that may be in its way, which
/// the coarse step tells.
class ExactShadows {
 public:
  /// Shapes must stay. Throws InputError as SceneOctrees::show does.
  ExactShadows(std::span<const ShadowParticipant> participants, const ShadowLight& light);

  /// Sets inShadow[i] to 1 where light does not reach points[i]: it faces away, or something stands
  /// in the way; elsewhere, and where there is no object, to 0. Returns the number of rays. Uses
  /// all threads.
  std::uint64_t answer(std::span<const ReceiverPoint> points,
                       std::span<std::uint8_t> inShadow) const;

 private:
  OcclusionRay rayFrom(const ReceiverPoint& point, std::uint32_t caster) const;

  std::vector<ShadowParticipant> participants_;
  ShadowLight light_;
  EmbreeOcclusion rays_;
  std::vector<AxisBox> boxes_;                       ///< of the participants
  std::vector<std::vector<std::uint32_t>> casters_;  ///< of each receiver
  /// Of each receiver: the light lies on a mesh that casts a shadow on it.
  std::vector<bool> isAllDark_;
};

}  // namespace haarlight
