#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "engine/devices.h"
#include "image/compare.h"
#include "light/builtin_lights.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_measures.h"
#include "render/light_coefficients.h"
#include "render/radiance_method.h"
#include "render/receiver_grid.h"
#include "sh/cube_basis.h"
#include "test_support.h"
#include "transfer/transfer_file.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// A ball that hovers over a plane, or whatever `mesh` is.
SceneDescription ballScene(const std::string& light = "builtin:sky",
                           const std::string& mesh = "builtin:sphere") {
  SceneDescription scene;
  ObjectDescription object;
  object.name = "ball";
  object.mesh = mesh;
  object.transform.fit = 1.0;
  object.transform.translate = {0.2, 0.9, -0.1};
  object.albedo = {0.8, 0.4, 0.2};
  object.spheres = 1;
  scene.objects.push_back(object);
  scene.receiver = ReceiverDescription{};
  scene.receiver->size = {4, 3};
  scene.receiver->samples = {24, 18};
  scene.light.source = light;
  return scene;
}

/// What `sh` makes of a scene, on the scalar engine.
struct Shading {
  explicit Shading(const SceneDescription& description, ShadedPer per = ShadedPer::vertex,
                   const std::vector<std::filesystem::path>& files = {})
      : moving(description),
        transfer(std::make_shared<const SceneTransfer>(
            makeSceneTransfer(description, moving, files, description.shading.order))),
        method(makeTransferMethod(moving.scene(), makeReferenceEngine(nullptr), transfer, per)) {}

  const Scene& scene() const { return moving.scene(); }
  std::vector<glm::vec3> ofPlane() {
    return method->radiance(planeSamples(*moving.scene().receiver));
  }
  std::vector<glm::vec3> ofObject(std::size_t object = 0) {
    return method->radiance(vertexSamples(moving.scene(), object));
  }

  MovingScene moving;
  std::shared_ptr<const SceneTransfer> transfer;
  std::unique_ptr<RadianceMethod> method;
};

Image asImage(const std::vector<glm::vec3>& radiance) {
  Image image(int(radiance.size()), 1);
  image.pixels = radiance;
  return image;
}

double relativeError(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  return compareImages(asImage(a), asImage(b)).relativeRootMeanSquare;
}

void checkColor(const glm::vec3& color, const glm::vec3& expected, double epsilon) {
  for (int c = 0; c < 3; ++c) CHECK(color[c] == doctest::Approx(expected[c]).epsilon(epsilon));
}

std::filesystem::path storedTransfer(const TemporaryFolder& folder, const TriangleMesh& mesh,
                                     const TransferOptions& options) {
  const auto path = folder / "transfer.prt";
  writeTransfer(path, computeTransfer(mesh, options).transfer);
  return path;
}

}  // namespace

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

TEST_CASE("a light that is turned is its coefficients turned") {
  constexpr int order = 5;
  LightCoefficients coefficients(order);
  SceneLight light{makeBuiltinLight("builtin:sky"), yawRotation(0), 1, {}, {}};
  for (const double degrees : {0.0, 40.0, -130.0}) {
    light.rotation = yawRotation(degrees);
    light.scale = 2;
    const TransferLights turned = coefficients.of(light);
    REQUIRE(turned.count() == 1);
    const ShVector<glm::vec3> again =
        projectToSh(order, projectToCube(*light.environment, light.rotation, light.scale).cube);
    const double largest = glm::length(again[0]);
    for (int channel = 0; channel < 3; ++channel)
      for (int k = 0; k < order * order; ++k)
        CHECK(std::abs(turned.light(0, channel)[k] - again[k][channel]) < 2e-3 * largest);
  }
}

TEST_CASE("the cube is left alone until somebody reads it") {
  SceneDescription description = ballScene();
  auto& keys = description.light.motion.emplace().keys;
  keys.resize(2);
  keys[1].seconds = 1;
  keys[1].scale = 2;
  MovingScene moving(description);
  const SceneLight& light = moving.scene().light;
  const glm::vec3 first = light.projection.cube[0];
  REQUIRE(first.x > 0);
  CHECK(moving.showLight(1, false));
  CHECK(light.scale == 2);
  CHECK(light.projection.cube[0] == first);
  CHECK_FALSE(moving.showLight(1, false));
  CHECK(moving.showLight(1));
  CHECK(light.projection.cube[0] == 2.0f * first);
  CHECK_FALSE(moving.showLight(1));
  CHECK_FALSE(moving.showLight(1, false));
}

TEST_CASE("when the light turns, so does what sh shows") {
  SceneDescription description = ballScene();
  auto& keys = description.light.motion.emplace().keys;
  keys.resize(2);
  keys[1].seconds = 1;
  keys[1].rotateDegrees = 90;
  Shading moving(description);
  const auto before = moving.ofPlane();
  CHECK_FALSE(moving.method->readsLightCube());
  moving.moving.showLight(1, false);
  moving.method->sceneChanged(true);
  const auto after = moving.ofPlane();
  SceneDescription turned = ballScene();
  turned.light.rotateDegrees = 90;
  CHECK(relativeError(after, before) > 0.02);
  CHECK(relativeError(after, Shading(turned).ofPlane()) < 1e-6);
}

TEST_CASE(
    "transfer from a file is that of the mesh, wherever and however large the object stands") {
  const TemporaryFolder folder;
  const auto path = storedTransfer(folder, builtinMesh("builtin:torusknot"),
                                   {.kind = TransferKind::shadowed,
                                    .order = 4,
                                    .raysPerVertex = 1024,
                                    .albedo = {0.3f, 0.6f, 0.1f},
                                    .seed = 5});
  SceneDescription description = ballScene("builtin:sky", "builtin:torusknot");
  description.receiver.reset();
  description.objects[0].transform.rotateDegrees = {20, 130, 70};
  description.shading.order = 4;
  Shading computed(description), stored(description, ShadedPer::vertex, {path});
  CHECK(stored.transfer->rows.order == 4);
  CHECK(stored.transfer->rows.channels == 1);
  CHECK(relativeError(stored.ofObject(), computed.ofObject()) < 0.01);
  description.objects[0].transfer = path;
  description.shading.order.reset();
  Shading field(description);
  CHECK(field.transfer->rows.order == 4);
  CHECK(field.ofObject() == stored.ofObject());
}

TEST_CASE("light that is reflected on the mesh brings its albedo with it, and the object is told") {
  const TemporaryFolder folder;
  const TriangleMesh ball = builtinMesh("builtin:sphere");
  const auto path = storedTransfer(folder, ball,
                                   {.kind = TransferKind::interreflected,
                                    .order = 3,
                                    .bounces = 1,
                                    .raysPerVertex = 64,
                                    .albedo = {0.5f, 0.25f, 0.75f}});
  SceneDescription description = ballScene("builtin:constant");
  description.receiver.reset();
  Shading sh(description, ShadedPer::vertex, {path});
  CHECK(sh.transfer->rows.channels == 3);
  REQUIRE(sh.transfer->warnings.size() == 1);
  CHECK(sh.transfer->warnings[0].find("albedo of its transfer") != std::string::npos);
  for (const glm::vec3& radiance : sh.ofObject())
    checkColor(radiance, glm::vec3(0.5, 0.25, 0.75), 1e-4);
}

TEST_CASE("one file serves a whole scene") {
  const TemporaryFolder folder;
  const SceneDescription description = ballScene();
  Shading computed(description);
  const auto path = storedTransfer(
      folder, wholeSceneMesh(computed.scene()),
      {.kind = TransferKind::shadowed, .order = 5, .raysPerVertex = 1024, .albedo = glm::vec3(1)});
  Shading stored(description, ShadedPer::vertex, {path});
  CHECK(stored.ofPlane() == computed.ofPlane());
  CHECK(stored.ofObject() == computed.ofObject());
}

TEST_CASE("transfer for another mesh, and for one that is stretched or deformed, is refused") {
  const TemporaryFolder folder;
  const auto path = storedTransfer(folder, builtinMesh("builtin:torusknot"),
                                   {.kind = TransferKind::unshadowed, .order = 2});
  const auto complaint = [&](const SceneDescription& description) -> std::string {
    try {
      Shading(description, ShadedPer::vertex, {path});
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  CHECK(complaint(ballScene()) == "transfer " + path.string() +
                                      " was computed for no mesh of this scene; compute it with "
                                      "haarlight prt");
  SceneDescription knot = ballScene("builtin:sky", "builtin:torusknot");
  CHECK(complaint(knot).empty());
  SceneDescription stretched = knot, twisted = knot, other = ballScene();
  stretched.objects[0].transform.scale = {1, 2, 1};
  CHECK(complaint(stretched).starts_with("object 'ball' is stretched unevenly, so that transfer "));
  twisted.objects[0].deformation.emplace().twist.emplace().keys.resize(1);
  twisted.objects[0].deformation->twist->keys[0].degrees = 30;
  CHECK(complaint(twisted).starts_with("object 'ball' is deformed, so that transfer "));
  other.objects[0].transfer = path;
  CHECK_THROWS_WITH_AS(Shading{other}, doctest::Contains("another mesh than builtin:sphere"),
                       InputError);
}

TEST_CASE("near light goes from one sample to another by the inverse square of the distance") {
  SceneDescription description = ballScene("builtin:sky");
  description.objects.clear();
  const auto addSample = [&](const glm::dvec3& position, double scale) {
    LightSampleDescription& sample = description.light.samples.emplace_back();
    sample.position = position;
    sample.source = "builtin:constant";
    sample.scale = scale;
  };
  addSample({-2, 0, 0}, 1);
  addSample({1, 0, 0}, 4);
  Shading vertex(description), pixel(description, ShadedPer::pixel);
  const auto samples = planeSamples(*description.receiver);
  const auto shaded = pixel.ofPlane();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const glm::dvec3 p(samples[i].position);
    const double first = 1 / glm::dot(p - glm::dvec3(-2, 0, 0), p - glm::dvec3(-2, 0, 0));
    const double second = 1 / glm::dot(p - glm::dvec3(1, 0, 0), p - glm::dvec3(1, 0, 0));
    checkColor(shaded[i], glm::vec3(0.5 * (first + 4 * second) / (first + second)), 1e-4);
  }
  CHECK(relativeError(vertex.ofPlane(), shaded) < 0.01);
}

TEST_CASE("at the place of a light sample it shines alone") {
  SceneLight light;
  light.samples.resize(3);
  light.samples[1].position = {1, 2, 3};
  light.samples[2].position = {4, 0, 0};
  std::vector<float> weights(3);
  weighLights(light, {1, 2, 3}, weights);
  CHECK(weights == std::vector<float>{0, 1, 0});
  weighLights(light, {2, 0, 0}, weights);
  CHECK(weights[0] == weights[2]);
  CHECK(weights[0] + weights[1] + weights[2] == doctest::Approx(1).epsilon(1e-6));
  light.samples.clear();
  weighLights(light, {2, 0, 0}, std::span(weights).first(1));
  CHECK(weights[0] == 1);
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
