#include "render/moving_scene.h"

#include <algorithm>
#include <utility>

#include "mesh/mesh_transform.h"
#include "render/object_spheres.h"
#include "scene/keyframes.h"
#include "spheres/bind_spheres.h"

namespace haarlight {

namespace {

/// `world` is the pose's mesh in the world.
std::vector<Sphere> inWorld(const ObjectSpheres& spheres, const TriangleMesh& world,
                            const glm::mat4& toWorld) {
  if (&spheres.fitted == &world) return spheres.set.spheres;
  return transformed(spheres.set.spheres, toWorld);
}

}  // namespace

MovingScene::MovingScene(const SceneDescription& description, const Progress& progress,
                         SceneParts parts)
    : description_(description),
      parts_(parts),
      light_(parts == SceneParts::all ? description.light : LightDescription{}, scene_.warnings) {
  scene_.receiver = description.receiver;
  for (const ObjectDescription& object : description.objects) addObject(object, progress);
  show(0);
}

void MovingScene::addObject(const ObjectDescription& description, const Progress& progress) {
  MovingObject& object = objects_.emplace_back(description, description_, scene_.warnings);
  const TriangleMesh local = object.localMesh(0);
  SceneObject& shown =
      scene_.objects.emplace_back(SceneObject{description.name,
                                              transformed(local, object.toWorld(0)),
                                              {},
                                              {},
                                              description.albedo,
                                              description.castsShadow,
                                              object.worldSolid(0),
                                              description.family.value_or("")});
  if (!description.castsShadow || parts_ == SceneParts::hardShadows) return;
  const ObjectSpheres spheres =
      spheresOf(description, {object.loadedMesh(), local, shown.mesh}, scene_.warnings, progress);
  shown.measures = spheres.set.measures;
  if (object.moves()) {
    const auto firstVertex = std::uint32_t(boundVertices_.size());
    binding_.append(bindSpheres(spheres.fitted, spheres.set.spheres, spheres.set.objective),
                    firstVertex);
    boundVertices_.resize(firstVertex + local.positions.size());
    shown.spheres.resize(spheres.set.spheres.size());
  } else {
    shown.spheres = inWorld(spheres, shown.mesh, object.toWorld(0));
  }
}

bool MovingScene::moves() const {
  const auto hasMotion = [](const auto& light) { return light.motion.has_value(); };
  return light_.moves() || description_.camera.motion ||
         std::ranges::any_of(description_.pointLights, hasMotion) ||
         std::ranges::any_of(description_.directionalLights, hasMotion) ||
         std::ranges::any_of(objects_, &MovingObject::moves);
}

void MovingScene::show(double seconds) {
  showMeshes(seconds);
  showSpheres(moveSpheres(binding_, boundVertices_));
  showLight(seconds);
}

void MovingScene::showMeshes(double seconds) {
  auto bound = boundVertices_.begin();
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (!objects_[i].moves()) continue;
    SceneObject& shown = scene_.objects[i];
    const TriangleMesh before = std::exchange(shown.mesh, objects_[i].worldMesh(seconds));
    shown.solid = objects_[i].worldSolid(seconds);
    shown.revision += before.positions != shown.mesh.positions;
    if (!shown.castsShadow || parts_ == SceneParts::hardShadows) continue;
    for (const glm::vec3& position : shown.mesh.positions) *bound++ = glm::vec4(position, 0);
  }
}

bool MovingScene::showLight(double seconds, bool ontoCube) {
  scene_.punctualLights.clear();
  for (const PointLightDescription& description : description_.pointLights) {
    const PointLightDescription light = pointLightAt(description, seconds);
    scene_.punctualLights.push_back({PointLight{light.position}, light.intensity});
  }
  for (const DirectionalLightDescription& description : description_.directionalLights) {
    const DirectionalLightDescription light = directionalLightAt(description, seconds);
    scene_.punctualLights.push_back({DirectionalLight{light.towards}, light.irradiance});
  }
  return light_.show(seconds, scene_.light, ontoCube && parts_ == SceneParts::all);
}

void MovingScene::showSpheres(std::span<const Sphere> spheres) {
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    std::vector<Sphere>& shown = scene_.objects[i].spheres;
    if (!objects_[i].moves() || shown.empty()) continue;
    std::ranges::copy(spheres.first(shown.size()), shown.begin());
    spheres = spheres.subspan(shown.size());
  }
}

std::vector<Sphere> MovingScene::refittedSpheres(double seconds, const Progress& progress) {
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    SceneObject& shown = scene_.objects[i];
    if (!objects_[i].moves() || !shown.castsShadow) continue;
    ObjectDescription description = description_.objects[i];
    description.spheres = int(shown.spheres.size());
    const TriangleMesh local = objects_[i].localMesh(seconds);
    std::vector<std::string> warnings;
    const ObjectSpheres refitted =
        spheresOf(description, {objects_[i].loadedMesh(), local, shown.mesh}, warnings, progress);
    auto moved = inWorld(refitted, shown.mesh, objects_[i].toWorld(seconds));
    moved.resize(shown.spheres.size(), moved.back());
    spheres.insert(spheres.end(), moved.begin(), moved.end());
  }
  return spheres;
}

Scene loadScene(const SceneDescription& description, const Progress& progress) {
  return MovingScene(description, progress).scene();
}

}  // namespace haarlight
