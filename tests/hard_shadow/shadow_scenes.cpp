#include "shadow_scenes.h"

#include <glm/trigonometric.hpp>

#include "mesh/builtin_meshes.h"

namespace haarlight::test {

void ShadowSetting::add(const Solid& solid, bool castsShadow) {
  participants.push_back({&solids.emplace_back(solid), castsShadow, {}});
}

void ShadowSetting::add(const TriangleMesh& mesh, bool castsShadow) {
  participants.push_back({&meshes.emplace_back(mesh), castsShadow, {}});
}

TriangleMesh floorAt(double height, float half) {
  TriangleMesh mesh = groundGrid(half, 1);
  for (glm::vec3& position : mesh.positions) position.y = float(height);
  return mesh;
}

ShadowSetting randomSetting(int objects, RandomNumbers& random) {
  ShadowSetting setting;
  setting.add(floorAt(-4, 5), false);
  for (int i = 0; i < objects; ++i) {
    if (i % 3 != 2) {
      setting.add(randomSolid(i % shapeKinds, 3, random));
      continue;
    }
    TriangleMesh mesh = i % 2 == 0 ? icosphere(2) : torusKnot({2, 3, 48, 8, 0.5});
    const glm::vec3 place(randomPoint(random, 3));
    for (glm::vec3& position : mesh.positions) position += place;
    setting.add(mesh);
  }
  return setting;
}

CameraDescription fromAbove(double width) {
  CameraDescription camera;
  camera.position = {0, 100, 0};
  camera.target = {0, 0, 0};
  camera.up = {0, 0, -1};
  camera.verticalFieldOfViewDegrees = 2 * glm::degrees(std::atan(width / 2 / 100));
  return camera;
}

}  // namespace haarlight::test
