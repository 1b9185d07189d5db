#include "render/track.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/error.h"
#include "mesh/builtin_meshes.h"
#include "mesh/mesh_measures.h"
#include "render/track_summary.h"
#include "test_support.h"

using namespace haarlight;

namespace {

/// A unit ball with these spheres; 24 frames per second.
SceneDescription ballWith(const std::vector<Sphere>& spheres, const test::TemporaryFolder& folder) {
  SphereSet set;
  set.spheres = spheres;
  set.meshName = "builtin:sphere";
  set.meshHash = meshHash(builtinMesh("builtin:sphere"));
  set.method = "by hand";
  writeSphereSet(folder / "set.json", set);
  ObjectDescription object;
  object.name = "ball";
  object.mesh = "builtin:sphere";
  object.spheres = folder / "set.json";
  SceneDescription scene;
  scene.objects.push_back(object);
  scene.light.source = "builtin:constant";
  return scene;
}

/// From rest at second 0 to `end` at second 1.
MotionDescription motionTo(MotionKey end) {
  end.seconds = 1;
  return {{MotionKey{}, end}, Repeat::hold};
}

/// A turn by 100° about (1, 2, 2) with a shift.
MotionKey turnedAndShifted() {
  const double half = 50 * std::numbers::pi / 180;
  MotionKey key;
  key.rotation = glm::dvec4(std::sin(half) * glm::dvec3(1, 2, 2) / 3.0, std::cos(half));
  key.translate = {3, -1, 2};
  return key;
}

/// A ball that sticks out of the unit ball: what theory says of its measures.
struct Overlap {
  double distance = 0.8, radius = 0.9;

  Sphere sphere() const { return {{float(distance), 0, 0}, float(radius)}; }
  /// A cap of the unit sphere has the part h / 2 of its area, h its height.
  double covered() const {
    return (1 - (1 + distance * distance - radius * radius) / (2 * distance)) / 2;
  }
  /// All volumes are over that of the unit ball.
  double shared() const {
    const double sum = 1 + radius - distance, difference = 1 - radius;
    return sum * sum *
           (distance * distance + 2 * distance * (1 + radius) - 3 * difference * difference) /
           (16 * distance);
  }
  double outside() const { return std::pow(radius, 3) - shared(); }
};

/// Within four standard errors and what the mesh of a ball lacks of one.
void checkOverlap(const SphereMeasures& measures, const Overlap& overlap) {
  CHECK(measures.coveredFraction == doctest::Approx(overlap.covered()).epsilon(0.02));
  CHECK(*measures.outsideVolumeRatio == doctest::Approx(overlap.outside()).epsilon(0.04));
  CHECK(*measures.unionOutsideRatio == doctest::Approx(overlap.outside()).epsilon(0.04));
  CHECK(*measures.uncoveredVolumeRatio == doctest::Approx(1 - overlap.shared()).epsilon(0.04));
}

void checkRatios(const RadiusRatios& ratios, double expected) {
  for (const double ratio : {ratios.smallest, ratios.mean, ratios.largest})
    CHECK(ratio == doctest::Approx(expected).epsilon(1e-5));
}

MethodMaker pixelMethod() {
  return [](const Scene& scene, std::span<const SurfaceSample>) {
    return makePixelMethod(scene, nullptr);
  };
}

ReceiverDescription smallReceiver() {
  ReceiverDescription receiver;
  receiver.center = {0, -1, 0};
  receiver.size = {4, 4};
  receiver.samples = {8, 8};
  return receiver;
}

}  // namespace

TEST_CASE("an object that moves and turns keeps coverage, volumes and radii") {
  const test::TemporaryFolder folder;
  const Overlap overlap;
  SceneDescription scene = ballWith({overlap.sphere()}, folder);
  scene.objects[0].motion = motionTo(turnedAndShifted());
  SceneTracker tracker(scene);
  const double silhouette = tracker.measure(0).objects[0].moved.silhouette->mean;
  for (const int frame : {0, 9, 24}) {
    const TrackFrame tracked = tracker.measure(frame);
    CHECK(tracked.frame == frame);
    CHECK(tracked.seconds == doctest::Approx(frame / 24.0));
    REQUIRE(tracked.objects.size() == 1);
    checkOverlap(tracked.objects[0].moved, overlap);
    checkRatios(tracked.objects[0].radii, 1);
    CHECK(tracked.objects[0].moved.silhouette->mean == doctest::Approx(silhouette).epsilon(0.02));
    CHECK_FALSE(tracked.plane);
  }
}

TEST_CASE("radii grow with an object, relative to second 0") {
  const test::TemporaryFolder folder;
  const Overlap overlap;
  SceneDescription scene = ballWith({overlap.sphere()}, folder);
  scene.objects[0].transform.scale = {3, 3, 3};
  MotionKey end;
  end.scale = 2;
  scene.objects[0].motion = motionTo(end);
  SceneTracker tracker(scene);
  checkRatios(tracker.measure(0).objects[0].radii, 1);
  checkRatios(tracker.measure(12).objects[0].radii, 1.5);
  const ObjectFrame grown = tracker.measure(24).objects[0];
  checkRatios(grown.radii, 2);
  checkOverlap(grown.moved, overlap);
}

TEST_CASE("ratios of radii leave out spheres that had none") {
  const std::vector<Sphere> before{{{0, 0, 0}, 1}, {{1, 0, 0}, 0}, {{0, 1, 0}, 2}};
  const std::vector<Sphere> now{{{0, 0, 0}, 3}, {{1, 0, 0}, 5}, {{0, 1, 0}, 1}};
  const RadiusRatios ratios = radiusRatios(before, now);
  CHECK(ratios.smallest == 0.5);
  CHECK(ratios.mean == 1.75);
  CHECK(ratios.largest == 3);
  checkRatios(radiusRatios(std::span(before).subspan(1, 1), std::span(now).subspan(1, 1)), 1);
}

TEST_CASE("triangles of a twisted knot that lay in one sphere stay covered") {
  SceneDescription scene;
  ObjectDescription& knot = scene.objects.emplace_back();
  knot.mesh = "builtin:torusknot";
  knot.spheres = 24;
  knot.objective = FitObjective::cover;
  knot.deformation = DeformationDescription{};
  knot.deformation->twist = TwistDescription{Axis::y, {{0, 0}, {1, 120}}};
  scene.light.source = "builtin:constant";

  MovingScene moving(scene);
  const TriangleMesh atRest = moving.scene().objects[0].mesh;
  const std::vector<Sphere> spheres = moving.scene().blockerSpheres();
  const auto holds = [&](const Sphere& sphere, const glm::uvec3& triangle) {
    for (int corner = 0; corner < 3; ++corner)
      if (glm::distance(atRest.positions[triangle[corner]], sphere.center) > sphere.radius)
        return false;
    return true;
  };
  moving.show(1);
  const TriangleMesh& twisted = moving.scene().objects[0].mesh;
  double held = 0, area = 0;
  for (const glm::uvec3& triangle : twisted.triangles) {
    const double own = triangleArea(twisted.positions[triangle.x], twisted.positions[triangle.y],
                                    twisted.positions[triangle.z]);
    area += own;
    if (std::ranges::any_of(spheres, [&](const Sphere& s) { return holds(s, triangle); }))
      held += own;
  }
  const double guaranteed = held / area;
  const double standardError = std::sqrt(guaranteed * (1 - guaranteed) / trackPoints);
  REQUIRE(guaranteed > 0.9);
  SceneTracker tracker(scene);
  const ObjectFrame end = tracker.measure(24).objects[0];
  CHECK(end.moved.coveredFraction >= guaranteed - 4 * standardError);
  CHECK(end.radii.largest > 1);  // the twist stretches
}

TEST_CASE("spheres fitted anew to an object that only moves and grows are the same again") {
  const test::TemporaryFolder folder;
  SceneDescription scene = ballWith({{{0, 0, 0}, 1}}, folder);
  scene.objects[0].mesh = "builtin:torusknot";
  scene.objects[0].spheres = 6;
  scene.receiver = smallReceiver();
  MotionKey end = turnedAndShifted();
  end.translate = {0, 0, 0};
  end.scale = 1.5;
  scene.objects[0].motion = motionTo(end);
  SceneTracker tracker(scene);
  CHECK(tracker.methodName() == "");
  tracker.comparePlane(pixelMethod());
  CHECK(tracker.methodName() == "pixel");
  const TrackFrame frame = tracker.measure(24, true);
  REQUIRE(frame.objects[0].refitted);
  const SphereMeasures &moved = frame.objects[0].moved, &refitted = *frame.objects[0].refitted;
  CHECK(refitted.coveredFraction == doctest::Approx(moved.coveredFraction).epsilon(1e-3));
  CHECK(*refitted.outsideVolumeRatio == doctest::Approx(*moved.outsideVolumeRatio).epsilon(1e-2));
  CHECK(refitted.silhouette->mean == doctest::Approx(moved.silhouette->mean).epsilon(1e-2));
  REQUIRE(frame.plane->refitted);
  CHECK(frame.plane->moved.relativeRootMeanSquare > 0);
  CHECK(frame.plane->refitted->relativeRootMeanSquare ==
        doctest::Approx(frame.plane->moved.relativeRootMeanSquare).epsilon(2e-2));
  const TrackSummary summary = summarize({&frame, 1});
  CHECK(summary.planeRefits->ratioOfMeans == doctest::Approx(1).epsilon(2e-2));
}

TEST_CASE("the plane's error is that of the scene at that moment") {
  const test::TemporaryFolder folder;
  SceneDescription scene = ballWith({{{0.25f, 0, 0}, 0.875f}}, folder);
  scene.receiver = smallReceiver();
  SceneDescription still = scene;
  still.objects[0].transform.translate = {0.5, 0.25, 0};
  MotionKey end;
  end.translate = {0.5, 0.25, 0};
  scene.objects[0].motion = motionTo(end);

  const Scene placed = loadScene(still);
  const auto samples = planeSamples(*still.receiver);
  Image image(8, 8), reference(8, 8);
  image.pixels = makePixelMethod(placed, nullptr)->radiance(samples);
  reference.pixels = makePixelMeshMethod(placed)->radiance(samples);
  const ImageError expected = compareImages(image, reference);
  REQUIRE(expected.relativeRootMeanSquare > 0.01);

  SceneTracker tracker(scene);
  tracker.comparePlane(pixelMethod());
  const double atRest = tracker.measure(0).plane->moved.rootMeanSquare;
  const PlaneErrors errors = *tracker.measure(24).plane;
  CHECK(errors.moved.rootMeanSquare == doctest::Approx(expected.rootMeanSquare).epsilon(5e-3));
  CHECK(errors.moved.referenceMean == doctest::Approx(expected.referenceMean).epsilon(1e-3));
  CHECK_FALSE(errors.refitted);
  CHECK(tracker.measure(0).plane->moved.rootMeanSquare == atRest);
}

TEST_CASE("where fewer spheres suffice, fitting anew still gives one for each that was moved") {
  const test::TemporaryFolder folder;
  SceneDescription scene = ballWith(std::vector<Sphere>(20, {{0, 0, 0}, 1}), folder);
  scene.objects[0].motion = motionTo(turnedAndShifted());
  ObjectTracker tracker(scene, 0, {});
  ObjectFrame frame = tracker.measure(1);
  CHECK(tracker.refit(1, frame).size() == 20);
  CHECK(frame.refitted->silhouette->mean < 0.02);
}

TEST_CASE("only objects that move and cast shadows are followed") {
  const test::TemporaryFolder folder;
  SceneDescription scene = ballWith({{{0, 0, 0}, 1}}, folder);
  CHECK_THROWS_WITH_AS(SceneTracker{scene}, doctest::Contains("nothing to track"), InputError);
  ObjectDescription other = scene.objects[0];
  other.name = "other";
  other.motion = motionTo(turnedAndShifted());
  scene.objects.push_back(other);
  SceneTracker tracker(scene);
  CHECK(tracker.objectNames() == std::vector<std::string>{"other"});
  CHECK(tracker.measure(3).objects.size() == 1);
  CHECK_THROWS_WITH_AS(tracker.comparePlane(pixelMethod()), doctest::Contains("receiver"),
                       InputError);
  scene.objects[1].castsShadow = false;
  CHECK_THROWS_AS(SceneTracker{scene}, InputError);
}
