#include "render/moving_object.h"

#include <glm/geometric.hpp>
#include <utility>

#include "mesh/mesh_file.h"
#include "mesh/mesh_transform.h"
#include "mesh/solid_mesh.h"
#include "motion/gltf_mesh.h"
#include "motion/mesh_sequence.h"
#include "motion/point_cache.h"
#include "scene/keyframes.h"
#include "scene/scene_file.h"
#include "scene/transform.h"
#include "solids/scaled_shape.h"

namespace haarlight {

namespace {

AngleOverTime angleOverTime(const std::vector<AngleKey>& keys, const Playback& playback) {
  return [keys, playback](double seconds) { return degreesAt(keys, playback, seconds); };
}

/// The mesh of an object's file, and the motion of its vertices that the object asks for.
AnimatedMesh loadAnimatedMesh(const ObjectDescription& description, double framesPerSecond) {
  const DeformationDescription deformation =
      description.deformation.value_or(DeformationDescription{});
  const double rate = deformation.framesPerSecond.value_or(framesPerSecond);
  const bool hasOtherSource = deformation.pointCache || deformation.sequence;
  AnimatedMesh animated =
      isGltfFile(description.mesh)
          ? loadGltf(description.mesh, deformation.animation.value_or(hasOtherSource ? "none" : ""))
          : AnimatedMesh{loadMeshOrBuiltin(description.mesh), nullptr};
  if (deformation.pointCache)
    animated.motion = openPointCache(*deformation.pointCache, animated.mesh, rate);
  if (deformation.sequence)
    animated.motion = openMeshSequence(*deformation.sequence, animated.mesh, rate);
  return animated;
}

DeformingMesh deformingMesh(const ObjectDescription& description, double framesPerSecond,
                            std::vector<std::string>& warnings) {
  if (description.solid) return DeformingMesh(solidMesh(*description.solid, standInSegments));
  AnimatedMesh animated = loadAnimatedMesh(description, framesPerSecond);
  for (const std::string& warning : animated.mesh.warnings)
    warnings.push_back(description.mesh + ": " + warning);
  MeshDeformation deformation{std::move(animated.motion), {}, {}, {}};
  if (description.deformation) {
    const DeformationDescription& wanted = *description.deformation;
    deformation.playback = wanted.playback;
    if (wanted.twist)
      deformation.twist = {wanted.twist->axis, angleOverTime(wanted.twist->keys, wanted.playback)};
    if (wanted.bend)
      deformation.bend = {wanted.bend->axis, bendDirection(*wanted.bend),
                          angleOverTime(wanted.bend->keys, wanted.playback)};
  }
  return DeformingMesh(std::move(animated.mesh.mesh), std::move(deformation));
}

}  // namespace

MovingObject::MovingObject(const ObjectDescription& description, const SceneDescription& scene,
                           std::vector<std::string>& warnings)
    : mesh_(deformingMesh(description, scene.animation.framesPerSecond, warnings)),
      motion_(description.motion) {
  const TransformDescription& transform = description.transform;
  const double ground = groundHeight(scene);
  if (description.solid) {
    toWorld_ = solidToWorld(transform, *description.solid, ground);
    pivot_ = solidPivot(transform, *description.solid, ground);
    solid_ = scaled(*description.solid, transform.scale.x);
  } else {
    toWorld_ = objectToWorld(transform, mesh_.rest().positions, ground);
    pivot_ = objectPivot(transform, mesh_.rest().positions, ground);
  }
}

glm::dmat4 MovingObject::exactToWorld(double seconds) const {
  return motion_ ? motionMatrix(*motion_, pivot_, seconds) * toWorld_ : toWorld_;
}

glm::mat4 MovingObject::toWorld(double seconds) const {
  return glm::mat4(exactToWorld(seconds));
}

std::optional<Solid> MovingObject::worldSolid(double seconds) const {
  if (!solid_) return std::nullopt;
  const glm::dmat4 toWorld = exactToWorld(seconds);
  const double scale = motion_ ? motionScale(*motion_, seconds) : 1;
  const double length = glm::length(glm::dvec3(toWorld[0]));
  return Solid(scaled(*solid_, scale),
               Placement(glm::dvec3(toWorld[3]), glm::dmat3(toWorld) / length));
}

TriangleMesh MovingObject::worldMesh(double seconds) {
  return transformed(localMesh(seconds), toWorld(seconds));
}

}  // namespace haarlight
