#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "mesh_shadow/embree_occlusion.h"
#include "shadow/shadow_light.h"
#include "shadow/shadow_pairs.h"

namespace haarlight {

/// An object of a scene that receives shadows and may cast some.
struct ShadowParticipant {
  Occluder shape;  ///< in the world; must stay while it takes part
  bool castsShadow = true;
  std::string family;  ///< objects of one family are near each other; empty: of none
};

/// A point of a participant's surface.
struct ReceiverPoint {
  static constexpr std::uint32_t nothing = ~std::uint32_t(0);

  std::uint32_t object = nothing;
  glm::dvec3 position{0};
  glm::dvec3 normal{0};     ///< unit, of the surface itself, on the side that is seen
  bool fromWithin = false;  ///< seen from within a solid, where all is dark
};

/// Whether the surface lies in light unless something stands in the way.
inline bool facesLight(const ReceiverPoint& point, const ShadowLight& light) {
  return !point.fromWithin && !facesAway(point.normal, point.position, light);
}

/// Whether light leaves a point of a participant's surface by the participant itself: never of a
/// convex solid, which its normal tells.
bool mayShadowItself(const ShadowParticipant& participant);

std::vector<Occluder> shapesOf(std::span<const ShadowParticipant> participants);

/// The coarse step for a scene, by the participants' boxes and families: the pairs whose caster
/// casts shadows. Throws InputError as BoxTree and findShadowPairs do.
ShadowPairs findPairs(std::span<const ShadowParticipant> participants,
                      std::span<const AxisBox> boxes, const ShadowLight& light);

}  // namespace haarlight
