#include "hard_shadow/shadow_participant.h"

#include <map>
#include <utility>

#include "shadow/box_tree.h"

namespace haarlight {

namespace {

std::vector<Family> familiesOf(std::span<const ShadowParticipant> participants) {
  std::map<std::string, Family> byName;
  for (std::uint32_t i = 0; i < participants.size(); ++i)
    if (!participants[i].family.empty()) byName[participants[i].family].objects.push_back(i);
  std::vector<Family> families;
  for (auto& [name, family] : byName) families.push_back(std::move(family));
  return families;
}

}  // namespace

bool mayShadowItself(const ShadowParticipant& participant) {
  const auto* solid = std::get_if<const Solid*>(&participant.shape);
  return !solid || !(*solid)->isConvex();
}

std::vector<Occluder> shapesOf(std::span<const ShadowParticipant> participants) {
  std::vector<Occluder> shapes;
  for (const ShadowParticipant& participant : participants) shapes.push_back(participant.shape);
  return shapes;
}

ShadowPairs findPairs(std::span<const ShadowParticipant> participants,
                      std::span<const AxisBox> boxes, const ShadowLight& light) {
  ShadowPairs pairs = findShadowPairs(BoxTree(boxes, familiesOf(participants)), light);
  std::erase_if(pairs.kept,
                [&](const ShadowPair& pair) { return !participants[pair.caster].castsShadow; });
  return pairs;
}

}  // namespace haarlight
