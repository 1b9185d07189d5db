#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hard_shadow/shadow_participant.h"
#include "render/scene.h"

namespace haarlight {

/// A scene's objects, in their order, and behind them its receiver, if there is one, for hard
/// shadows. The receiver casts none. They follow the scene, which must stay, as its objects move.
class SceneParticipants {
 public:
  explicit SceneParticipants(const Scene& scene);
  SceneParticipants(const SceneParticipants&) = delete;
  SceneParticipants& operator=(const SceneParticipants&) = delete;

  std::span<const ShadowParticipant> participants() const { return participants_; }
  /// The same with polygons in place of solids, for classic shadow volumes.
  std::vector<ShadowParticipant> asPolygons() const;

  std::vector<glm::dvec3> albedos() const;
  AxisBox bounds() const;

 private:
  const Scene& scene_;
  TriangleMesh receiver_;
  std::vector<ShadowParticipant> participants_;
};

}  // namespace haarlight
