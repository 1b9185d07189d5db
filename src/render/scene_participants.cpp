#include "render/scene_participants.h"

#include "render/receiver_grid.h"

namespace haarlight {

SceneParticipants::SceneParticipants(const Scene& scene) : scene_(scene) {
  for (const SceneObject& object : scene.objects)
    participants_.push_back({object.occluder(), object.castsShadow, object.family});
  if (!scene.receiver) return;
  receiver_ = receiverRectangle(*scene.receiver);
  participants_.push_back({&receiver_, false, {}});
}

std::vector<ShadowParticipant> SceneParticipants::asPolygons() const {
  std::vector<ShadowParticipant> polygons = participants_;
  for (std::size_t i = 0; i < scene_.objects.size(); ++i)
    polygons[i].shape = &scene_.objects[i].mesh;
  return polygons;
}

std::vector<glm::dvec3> SceneParticipants::albedos() const {
  std::vector<glm::dvec3> albedos;
  for (const SceneObject& object : scene_.objects) albedos.emplace_back(object.albedo);
  if (scene_.receiver) albedos.emplace_back(scene_.receiver->albedo);
  return albedos;
}

AxisBox SceneParticipants::bounds() const {
  AxisBox box;
  for (const ShadowParticipant& participant : participants_)
    box = united(box, boundsOf(participant.shape));
  return box;
}

}  // namespace haarlight
