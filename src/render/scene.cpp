#include "render/scene.h"

#include <glm/matrix.hpp>

namespace haarlight {

glm::vec3 SceneLight::radiance(const glm::vec3& direction) const {
  return scale * environment->radiance(glm::transpose(rotation) * direction);
}

std::vector<Sphere> Scene::blockerSpheres() const {
  std::vector<Sphere> all;
  for (const SceneObject& object : objects)
    all.insert(all.end(), object.spheres.begin(), object.spheres.end());
  return all;
}

}  // namespace haarlight
