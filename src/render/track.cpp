#include "render/track.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"
#include "mesh/solid_repair.h"
#include "render/surface_sample.h"
#include "scene/keyframes.h"
#include "spheres/sphere_measures.h"

namespace haarlight {

namespace {

/// One object under a light that costs nothing.
SceneDescription objectAlone(SceneDescription description, std::size_t index) {
  description.objects = {description.objects[index]};
  description.light = {};
  description.light.source = "builtin:constant";
  return description;
}

SphereMeasures measuresOf(const TriangleMesh& mesh, std::span<const Sphere> spheres) {
  return measureSpheres(prepareSolid(mesh).mesh, spheres, trackPoints);
}

}  // namespace

RadiusRatios radiusRatios(std::span<const Sphere> before, std::span<const Sphere> now) {
  RadiusRatios ratios{std::numeric_limits<double>::infinity(), 0, 0};
  std::size_t count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!(before[i].radius > 0)) continue;
    const double ratio = double(now[i].radius) / double(before[i].radius);
    ratios.smallest = std::min(ratios.smallest, ratio);
    ratios.largest = std::max(ratios.largest, ratio);
    ratios.mean += ratio;
    ++count;
  }
  if (count == 0) return {};
  ratios.mean /= double(count);
  return ratios;
}

ObjectTracker::ObjectTracker(const SceneDescription& description, std::size_t index,
                             const Progress& progress)
    : scene_(objectAlone(description, index), progress),
      spheresAtStart_(scene_.scene().blockerSpheres()) {}

ObjectFrame ObjectTracker::measure(double seconds) {
  scene_.show(seconds);
  const SceneObject& object = scene_.scene().objects.front();
  return {measuresOf(object.mesh, object.spheres), radiusRatios(spheresAtStart_, object.spheres),
          std::nullopt};
}

std::vector<Sphere> ObjectTracker::refit(double seconds, ObjectFrame& frame) {
  std::vector<Sphere> spheres = scene_.refittedSpheres(seconds);
  frame.refitted = measuresOf(scene_.scene().objects.front().mesh, spheres);
  spheres.resize(spheresAtStart_.size(), spheres.back());
  return spheres;
}

PlaneComparison::PlaneComparison(const SceneDescription& description, const MethodMaker& makeMethod,
                                 const Progress& progress)
    : scene_(description, progress) {
  if (!description.receiver)
    throw InputError("the scene has no receiver plane whose radiance could be compared");
  size_ = description.receiver->samples;
  samples_ = planeSamples(*description.receiver);
  method_ = makeMethod(scene_.scene(), samples_);
  reference_ = makePixelMeshMethod(scene_.scene());
}

Image PlaneComparison::radiance(RadianceMethod& method) const {
  Image image(size_.x, size_.y);
  image.pixels = method.radiance(samples_);
  return image;
}

void PlaneComparison::show(double seconds) {
  scene_.showMeshes(seconds);
  const bool lightToo = scene_.showLight(seconds);
  method_->sceneChanged(lightToo);
  reference_->sceneChanged(lightToo);
  referenceImage_ = radiance(*reference_);
}

std::vector<Sphere> PlaneComparison::movedSpheres() const {
  return moveSpheres(scene_.binding(), scene_.boundVertices());
}

ImageError PlaneComparison::error(std::span<const Sphere> spheres) {
  scene_.showSpheres(spheres);
  method_->sceneChanged(false);
  return compareImages(radiance(*method_), referenceImage_);
}

SceneTracker::SceneTracker(const SceneDescription& description, const Progress& progress)
    : description_(description) {
  for (std::size_t i = 0; i < description.objects.size(); ++i) {
    if (!description.objects[i].castsShadow) continue;
    const ObjectTracker& object = objects_.emplace_back(description, i, progress);
    if (!object.movesSpheres()) {
      objects_.pop_back();
      continue;
    }
    names_.push_back(description.objects[i].name);
    warnings_.insert(warnings_.end(), object.warnings().begin(), object.warnings().end());
  }
  if (objects_.empty())
    throw InputError(
        "no object of the scene both moves and casts shadows, so there is nothing to track; "
        "builtin:twist has one");
}

void SceneTracker::comparePlane(const MethodMaker& makeMethod, const Progress& progress) {
  plane_ = std::make_unique<PlaneComparison>(description_, makeMethod, progress);
}

TrackFrame SceneTracker::measure(int frame, bool refit) {
  TrackFrame result{frame, frameSeconds(description_.animation, frame), {}, {}};
  std::vector<Sphere> refitted;
  for (ObjectTracker& object : objects_) {
    ObjectFrame& measured = result.objects.emplace_back(object.measure(result.seconds));
    if (!refit) continue;
    const std::vector<Sphere> spheres = object.refit(result.seconds, measured);
    refitted.insert(refitted.end(), spheres.begin(), spheres.end());
  }
  if (!plane_) return result;
  plane_->show(result.seconds);
  result.plane = PlaneErrors{plane_->error(plane_->movedSpheres()), std::nullopt};
  if (refit) result.plane->refitted = plane_->error(refitted);
  return result;
}

}  // namespace haarlight
