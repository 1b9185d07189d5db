#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "light/light_projection.h"
#include "mesh/occluder.h"
#include "scene/scene_description.h"
#include "shadow/punctual_light.h"
#include "spheres/sphere_set.h"

namespace haarlight {

/// An object as it stands in the world.
struct SceneObject {
  std::string name;
  /// The object itself, or polygons that stand in for `solid` where spheres are fitted to it or
  /// follow it.
  TriangleMesh mesh;
  /// The spheres that block light in its stead; empty when it casts no shadow.
  std::vector<Sphere> spheres;
  /// Of the spheres before they were moved into the world.
  SphereMeasures measures;
  glm::vec3 albedo;
  bool castsShadow;
  std::optional<Solid> solid;
  /// Empty: none.
  std::string family;
  /// Another number whenever mesh or solid are elsewhere.
  std::uint64_t revision = 0;

  /// What rays meet: the solid, else the mesh.
  Occluder occluder() const;
};

/// Light as it was measured at a place.
struct SceneLightSample {
  glm::vec3 position;
  std::shared_ptr<const Environment> environment;
  glm::mat3 rotation;
  float scale;
};

struct SceneLight {
  std::shared_ptr<const Environment> environment;
  glm::mat3 rotation;
  float scale;
  /// Of the light as rotated and scaled.
  LightProjection projection;
  /// For methods that know near light, what shines on surfaces instead, if there are any.
  std::vector<SceneLightSample> samples;

  /// Radiance from a world direction, for backgrounds.
  glm::vec3 radiance(const glm::vec3& direction) const;
};

/// A scene at one moment, with everything loaded: what engines and methods work on. See
/// render/moving_scene.h.
struct Scene {
  std::vector<SceneObject> objects;
  std::optional<ReceiverDescription> receiver;
  SceneLight light;
  /// The point lights, then the directional ones.
  std::vector<PunctualLight> punctualLights;
  /// One line each: what is unusual in the inputs.
  std::vector<std::string> warnings;

  /// All objects' spheres, in the order of the objects.
  std::vector<Sphere> blockerSpheres() const;
  /// What blocks rays: the objects that cast shadows, in their order.
  std::vector<Occluder> occluders() const;
};

}  // namespace haarlight
