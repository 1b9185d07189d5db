#include "hard_shadow/exact_shadows.h"

#include <algorithm>

#include "mesh_shadow/lit_mesh.h"
#include "shadow/octree_refinement.h"

namespace haarlight {

ExactShadows::ExactShadows(std::span<const ShadowParticipant> participants,
                           const ShadowLight& light)
    : participants_(participants.begin(), participants.end()),
      light_(light),
      rays_(shapesOf(participants), light) {
  for (const ShadowParticipant& participant : participants)
    boxes_.push_back(boundsOf(participant.shape));
  ShadowPairs pairs = findPairs(participants, boxes_, light);
  std::erase_if(pairs.kept, [&](const ShadowPair& pair) {
    return pair.caster == pair.receiver && !mayShadowItself(participants_[pair.caster]);
  });
  casters_ = castersByReceiver(pairs.kept, participants.size());
  std::vector<bool> holdsLight;
  for (const ShadowParticipant& participant : participants_) {
    const auto* mesh = std::get_if<const TriangleMesh*>(&participant.shape);
    holdsLight.push_back(mesh && liesOn(**mesh, light));
  }
  for (const auto& casters : casters_)
    isAllDark_.push_back(
        std::ranges::any_of(casters, [&](std::uint32_t caster) { return holdsLight[caster]; }));
}

/// From a mesh's own surface, off it by more than single precision's rounding.
OcclusionRay ExactShadows::rayFrom(const ReceiverPoint& point, std::uint32_t caster) const {
  const bool leavesCaster = point.object == caster;
  const Occluder& shape = participants_[caster].shape;
  if (!leavesCaster || !std::holds_alternative<const TriangleMesh*>(shape))
    return {point.position, caster, leavesCaster};
  const AxisBox box = united(boxes_[caster], {point.position, point.position});
  return {point.position + 4 * singlePrecisionMargin(box) * point.normal, caster, true};
}

std::uint64_t ExactShadows::answer(std::span<const ReceiverPoint> points,
                                   std::span<std::uint8_t> inShadow) const {
  std::vector<std::uint32_t> open;  // points that are not known to be in shadow
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const bool isSomething = points[i].object != ReceiverPoint::nothing;
    inShadow[i] = isSomething && (isAllDark_[points[i].object] || !facesLight(points[i], light_));
    if (isSomething && !inShadow[i]) open.push_back(i);
  }
  std::uint64_t count = 0;
  for (std::size_t turn = 0; !open.empty(); ++turn) {
    std::erase_if(open, [&](std::uint32_t i) {
      return inShadow[i] || turn >= casters_[points[i].object].size();
    });
    std::vector<OcclusionRay> rays;
    for (const std::uint32_t i : open)
      rays.push_back(rayFrom(points[i], casters_[points[i].object][turn]));
    std::vector<std::uint8_t> blocked(rays.size());
    rays_.answer(rays, blocked);
    for (std::size_t k = 0; k < open.size(); ++k) inShadow[open[k]] = blocked[k];
    count += rays.size();
  }
  return count;
}

}  // namespace haarlight
