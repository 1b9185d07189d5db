#include "render/scene.h"

#include <glm/matrix.hpp>

namespace haarlight {

glm::vec3 SceneLight::radiance(const glm::vec3& direction) const {
  return scale * environment->radiance(glm::transpose(rotation) * direction);
}

Occluder SceneObject::occluder() const {
  if (solid) return &*solid;
  return &mesh;
}

std::vector<Sphere> Scene::blockerSpheres() const {
  std::vector<Sphere> all;
  for (const SceneObject& object : objects)
    all.insert(all.end(), object.spheres.begin(), object.spheres.end());
  return all;
}

std::vector<Occluder> Scene::occluders() const {
  std::vector<Occluder> all;
  for (const SceneObject& object : objects)
    if (object.castsShadow) all.push_back(object.occluder());
  return all;
}

}  // namespace haarlight
