#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "hard_shadow/hard_shadow_method.h"
#include "hard_shadow/shadow_difference.h"
#include "mesh/builtin_meshes.h"
#include "shadow_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

std::vector<std::uint8_t> answerOf(HardShadowMethod& method, const SurfaceView& view) {
  std::vector<std::uint8_t> inShadow(view.points.size(), 7);
  method.answer(0, view, inShadow);
  return inShadow;
}

ShadowDifference differenceOf(const SurfaceView& view, const ShadowLight& light,
                              const std::vector<std::uint8_t>& answer,
                              const std::vector<std::uint8_t>& reference) {
  ShadowDifference difference;
  difference.add(view, light, answer, reference);
  return difference;
}

constexpr int pixels = 300;

}  // namespace

TEST_CASE("a sphere's shadow on the floor is the disc that its radius tells, by every method") {
  // The light's cone around the sphere, of half angle asin(r/d), meets the floor straight below.
  ShadowSetting setting;
  setting.add(floorAt(0, 3), false);
  setting.add(Solid(SphereShape{0.5}, Placement({0, 2, 0})));
  const ShadowLight light = PointLight{{0, 6, 0}};
  const double radius = 6 * std::tan(std::asin(0.5 / 4));
  CameraDescription below = fromAbove(6);
  below.position.y = -100;
  const SurfaceViewer viewer(setting.participants, Camera(below, pixels, pixels), pixels, pixels,
                             1);
  SurfaceView view = viewer.rows(0, pixels);
  std::size_t inDisc = 0, seen = 0;
  std::vector<std::uint8_t> disc(view.points.size());
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    if (view.points[i].object == ReceiverPoint::nothing) continue;
    ++seen;
    REQUIRE(view.points[i].object == 0);
    REQUIRE(std::abs(view.points[i].position.y) < 1e-12);
    view.points[i].normal = {0, 1, 0};  // of the other side
    disc[i] = std::hypot(view.points[i].position.x, view.points[i].position.z) <= radius;
    inDisc += disc[i];
  }
  CHECK(seen > 0.95 * double(view.points.size()));
  CHECK(double(inDisc) / double(seen) ==
        doctest::Approx(std::numbers::pi * radius * radius / 36).epsilon(0.01));

  const ShadowLight lights[] = {light};
  CHECK(answerOf(*makeExactShadows(setting.participants, lights), view) == disc);
  double last = 1;
  for (const int depth : {4, 6, 8, 10}) {
    const auto octree = makeOctreeShadows(setting.participants, lights, {depth, 0});
    const auto difference = differenceOf(view, light, answerOf(*octree, view), disc);
    CAPTURE(depth);
    CHECK(difference.wrongPart() < last / 2);
    last = difference.wrongPart();
    if (depth == 10) CHECK(std::abs(difference.areaError()) < 0.005);
  }

  ShadowSetting polygons;
  polygons.add(floorAt(0, 3), false);
  TriangleMesh ball = icosphere(5);
  for (glm::vec3& position : ball.positions) position = 0.5f * position + glm::vec3(0, 2, 0);
  polygons.add(ball);
  const auto classic = makeClassicShadows(polygons.participants, lights);
  CHECK(differenceOf(view, light, answerOf(*classic, view), disc).wrongPart() < 0.005);
}

TEST_CASE("on meshes, classic volumes and exact rays agree but for points next to edges") {
  ShadowSetting setting;
  setting.add(floorAt(-1, 3), false);
  setting.add(torusKnot());
  TriangleMesh ball = icosphere(3);
  for (glm::vec3& position : ball.positions) position = 0.4f * position + glm::vec3(1, 1.5f, 0.5f);
  setting.add(ball);
  CameraDescription camera;
  camera.position = {3, 4, 5};
  camera.target = {0, -0.5, 0};
  const SurfaceViewer viewer(setting.participants, Camera(camera, pixels, pixels), pixels, pixels,
                             1);
  const SurfaceView view = viewer.rows(0, pixels);
  for (const ShadowLight& light :
       {ShadowLight(PointLight{{2, 4, 1}}), ShadowLight(DirectionalLight{{1, 2, 0.5}})}) {
    const ShadowLight lights[] = {light};
    const auto exact = answerOf(*makeExactShadows(setting.participants, lights), view);
    const auto classic = answerOf(*makeClassicShadows(setting.participants, lights), view);
    const auto octree = answerOf(*makeOctreeShadows(setting.participants, lights, {9, 0}), view);
    const ShadowDifference ofClassic = differenceOf(view, light, classic, exact);
    CHECK(ofClassic.inShadow > 3000);
    CHECK(ofClassic.wrongPart() < 0.001);
    CHECK(differenceOf(view, light, octree, exact).wrongPart() < 0.02);
  }
}

TEST_CASE("rows of a view are those of the whole view") {
  ShadowSetting setting;
  setting.add(floorAt(0, 3));
  setting.add(Solid(TorusShape{1, 0.3}, Placement({0, 0.5, 0})));
  const SurfaceViewer viewer(setting.participants, Camera({}, 40, 30), 40, 30, 2);
  const SurfaceView whole = viewer.rows(0, 60), part = viewer.rows(20, 10);
  REQUIRE(part.points.size() == 800);
  for (std::size_t i = 0; i < 800; ++i) {
    CHECK(part.points[i].object == whole.points[1600 + i].object);
    if (part.points[i].object != ReceiverPoint::nothing)
      CHECK(part.depths[i] == doctest::Approx(whole.depths[1600 + i]).epsilon(1e-6));
  }
}

TEST_CASE("classic shadow volumes refuse solids") {
  ShadowSetting setting;
  setting.add(Solid(SphereShape{0.5}));
  const ShadowLight lights[] = {PointLight{{0, 6, 0}}};
  CHECK_THROWS_AS(makeClassicShadows(setting.participants, lights), InputError);
}

TEST_CASE("seen from within, a solid is dark, be light outside or within") {
  const std::pair<Shape, glm::dvec3> solids[] = {{SphereShape{2}, {0.5, 0, 0}},
                                                 {BoxShape{{2, 1, 3}}, {0, 0.3, 0}},
                                                 {ConeShape{3, 4}, {0, 0.5, 0}},
                                                 {TorusShape{3, 1}, {-3, 0, 0}}};
  CameraDescription camera;
  camera.position = {0, 0, 0};
  camera.target = {0.3, 0.2, -1};
  for (const auto& [shape, place] : solids)
    for (const glm::dvec3& lamp : {glm::dvec3(2, 9, 3), glm::dvec3(0.1, 0.2, -0.1)}) {
      ShadowSetting setting;
      setting.add(Solid(shape, Placement(place)));
      const ShadowLight lights[] = {PointLight{lamp}};
      const SurfaceViewer viewer(setting.participants, Camera(camera, 40, 30), 40, 30, 1);
      const SurfaceView view = viewer.rows(0, 30);
      const std::vector<std::uint8_t> dark(view.points.size(), 1);
      CHECK(answerOf(*makeExactShadows(setting.participants, lights), view) == dark);
      CHECK(answerOf(*makeOctreeShadows(setting.participants, lights, {6, 0}), view) == dark);
    }
}

TEST_CASE("light on a mesh, be it on an edge or a corner, leaves all dark by every method") {
  TriangleMesh triangle;
  triangle.positions = {{0, 0.2f, 0}, {1, 0.2f, 0}, {0.1f, 1, 0.2f}};
  triangle.triangles = {{0, 1, 2}};
  ShadowSetting setting;
  setting.add(floorAt(0, 3), false);
  setting.add(triangle);
  const SurfaceViewer viewer(setting.participants, Camera(fromAbove(5), 40, 40), 40, 40, 1);
  const SurfaceView view = viewer.rows(0, 40);
  const std::vector<std::uint8_t> dark(view.points.size(), 1);
  const glm::dvec3 a(triangle.positions[0]), b(triangle.positions[1]), c(triangle.positions[2]);
  for (const glm::dvec3& place :
       {a, c, 0.5 * (a + b), 0.3 * a + 0.7 * c, 0.2 * a + 0.8 * c, 0.3 * a + 0.3 * b + 0.4 * c}) {
    const ShadowLight lights[] = {PointLight{place}};
    for (const auto& method : {makeExactShadows(setting.participants, lights),
                               makeOctreeShadows(setting.participants, lights, {6, 0}),
                               makeClassicShadows(setting.participants, lights)}) {
      CAPTURE(method->name());
      CHECK(answerOf(*method, view) == dark);
    }
  }
}
