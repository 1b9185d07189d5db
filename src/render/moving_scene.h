#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/moving_light.h"
#include "render/moving_object.h"
#include "render/progress.h"
#include "render/scene.h"
#include "scene/scene_description.h"
#include "visibility/sphere_binding.h"

namespace haarlight {

/// What is needed of a scene: for hard shadows neither spheres nor the light all around.
enum class SceneParts { all, hardShadows };

/// A scene file with everything loaded, at any time. What is shown at a second depends on nothing
/// that was shown before.
///
/// Objects that move take their spheres with them: these are bound (spheres/bind_spheres.h) where
/// they were fitted, that is at second 0, unless a file's set was made for the mesh as loaded.
class MovingScene {
 public:
  /// Loads meshes and lights, fits or reads the spheres, and shows second 0. Throws InputError.
  explicit MovingScene(const SceneDescription& description, const Progress& progress = {},
                       SceneParts parts = SceneParts::all);

  /// Whether anything, the lights and the camera included, changes over time.
  bool moves() const;

  /// The objects with all that moves them, in the order of scene().objects.
  const std::vector<MovingObject>& objects() const { return objects_; }

  /// As shown.
  const Scene& scene() const { return scene_; }

  /// Brings meshes, solids, spheres and lights to a second.
  void show(double seconds);

  /// The same in steps, so that an engine can move the spheres: Engine::setSphereBinding(binding())
  /// once, then showMeshes, showSpheres(Engine::moveSpheres(boundVertices())), showLight.
  void showMeshes(double seconds);  ///< and solids
  void showSpheres(std::span<const Sphere> spheres);
  /// Returns whether the light all around has changed; `ontoCube` as for MovingLight. Lights with
  /// hard shadows are brought to the second, too.
  bool showLight(double seconds, bool ontoCube = true);

  /// Binds the spheres of all moving objects that cast shadows, in order of the objects, to
  /// boundVertices().
  const SphereBinding& binding() const { return binding_; }
  /// World positions of the vertices of those objects, one object after another (x, y, z, 0).
  std::span<const glm::vec4> boundVertices() const { return boundVertices_; }

  /// The spheres of moving objects fitted anew to their meshes at the second that is shown, in
  /// place of those that were moved there; for comparison. As many: where fewer fit, the last one
  /// of an object stands there several times.
  std::vector<Sphere> refittedSpheres(double seconds, const Progress& progress = {});

 private:
  void addObject(const ObjectDescription& description, const Progress& progress);

  SceneDescription description_;
  SceneParts parts_;
  Scene scene_;
  std::vector<MovingObject> objects_;
  MovingLight light_;
  SphereBinding binding_;
  std::vector<glm::vec4> boundVertices_;
};

/// The scene at second 0.
Scene loadScene(const SceneDescription& description, const Progress& progress = {});

}  // namespace haarlight
