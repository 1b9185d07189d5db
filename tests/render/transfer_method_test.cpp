#include <algorithm>
#include <glm/geometric.hpp>

#include "render/receiver_grid.h"
#include "shading_by_transfer.h"

using namespace haarlight;
using namespace haarlight::test;

TEST_CASE("a convex object under constant light has its radiance times its albedo") {
  SceneDescription scene = ballScene("builtin:constant");
  scene.receiver.reset();
  for (const int order : {1, 2, 4}) {
    scene.shading.order = order;
    for (const glm::vec3& radiance : Shading(scene).ofObject())
      checkColor(radiance, glm::vec3(0.8, 0.4, 0.2), 1e-4);
  }
}

TEST_CASE("under a smooth light sh has the radiance and the shadows of pixel-mesh") {
  const SceneDescription description = ballScene();
  Shading sh(description);
  const auto mesh = makePixelMeshMethod(sh.scene());
  const auto plane = mesh->radiance(planeSamples(*sh.scene().receiver));
  CHECK(relativeError(sh.ofPlane(), plane) < 0.01);
  const auto object = vertexSamples(sh.scene(), 0);
  CHECK(relativeError(sh.ofObject(), mesh->radiance(object)) < 0.02);
  const auto open =
      std::max_element(plane.begin(), plane.end(), [](auto& a, auto& b) { return a.y < b.y; });
  const auto dark =
      std::min_element(plane.begin(), plane.end(), [](auto& a, auto& b) { return a.y < b.y; });
  CHECK(dark->y < 0.8f * open->y);  // there is a shadow to agree about
}

TEST_CASE("objects that cast no shadow shadow neither the plane nor themselves") {
  SceneDescription description = ballScene("builtin:constant");
  description.objects[0].castsShadow = false;
  Shading sh(description);
  for (const glm::vec3& radiance : sh.ofPlane()) checkColor(radiance, glm::vec3(0.5), 1e-4);
  for (const glm::vec3& radiance : sh.ofObject())
    checkColor(radiance, description.objects[0].albedo, 1e-4);
}

TEST_CASE("shading per vertex and per pixel agree, at vertices and between them") {
  for (const int order : {2, 5}) {
    SceneDescription description = ballScene();
    description.shading.order = order;
    Shading vertex(description), pixel(description, ShadedPer::pixel);
    CHECK(relativeError(pixel.ofObject(), vertex.ofObject()) < 1e-6);
    CHECK(relativeError(pixel.ofPlane(), vertex.ofPlane()) < 1e-6);
  }
}

TEST_CASE("the backs of surfaces are black") {
  Shading sh(ballScene());
  auto samples = vertexSamples(sh.scene(), 0);
  samples[0].point.fromBehind = true;
  const auto radiance = sh.method->radiance(samples);
  CHECK(radiance[0] == glm::vec3(0));
  CHECK(radiance[1].y > 0);
}

TEST_CASE("a point of the receiver's grid is the blend of its vertices") {
  ReceiverDescription receiver;
  receiver.center = {1, 2, 3};
  receiver.size = {4, 2};
  receiver.samples = {5, 3};
  const ReceiverGrid grid(receiver);
  const TriangleMesh vertices = grid.vertices();
  CHECK(vertices.positions.size() == 6 * 4);
  CHECK(grid.vertexCount() == vertices.positions.size());
  for (const glm::vec3 position : {glm::vec3(1, 2, 3),
                                   {-1, 2, 2},
                                   {3, 2, 4},
                                   {2.9f, 2, 2.05f},
                                   {0.1f, 2, 3.9f},
                                   {1.37f, 2, 3.21f}}) {
    const MeshPoint point = grid.pointAt(position);
    glm::vec3 blend(0);
    for (int k = 0; k < 3; ++k) {
      CHECK(point.weights[k] >= 0);
      blend += point.weights[k] * vertices.positions[point.vertices[k]];
    }
    CHECK(glm::distance(blend, position) < 1e-5f);
  }
}
