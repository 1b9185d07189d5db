#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/compare.h"
#include "render/moving_scene.h"
#include "render/progress.h"
#include "render/radiance_method.h"
#include "spheres/sphere_set.h"

namespace haarlight {

/// Radii in a frame over those of the same spheres at second 0, both in the world. A motion that
/// doubles an object's size counts: it gives 2.
struct RadiusRatios {
  double smallest = 1;
  double mean = 1;
  double largest = 1;
};

/// `before` and `now` hold the same spheres; those that had no radius before do not count.
RadiusRatios radiusRatios(std::span<const Sphere> before, std::span<const Sphere> now);

/// How well an object's spheres stand in for its mesh in a frame.
struct ObjectFrame {
  SphereMeasures moved;
  RadiusRatios radii;
  /// Of spheres fitted to the mesh of this frame.
  std::optional<SphereMeasures> refitted;
};

/// Errors of the receiver's radiance with all spheres, against `pixel-mesh`.
struct PlaneErrors {
  ImageError moved;
  /// With spheres fitted to the meshes of this frame in place of those that were moved.
  std::optional<ImageError> refitted;
};

struct TrackFrame {
  int frame = 0;
  double seconds = 0;
  std::vector<ObjectFrame> objects;  ///< as SceneTracker::objectNames()
  std::optional<PlaneErrors> plane;
};

/// Points that coverage is measured at, and about as many for each volume. The standard error of a
/// covered part p is below √(p (1 − p) / points): 0.08 % of the surface at p = 97 %. Those of the
/// volumes are in spheres/sphere_measures.h, that of the silhouettes in spheres/silhouette_error.h.
constexpr std::size_t trackPoints = 50000;

/// The measures of one object's spheres, from the same random numbers in every frame, so that
/// curves over frames show what changes and not the noise.
class ObjectTracker {
 public:
  /// Of object number `index` of the scene; its spheres are fitted or read. Throws InputError.
  ObjectTracker(const SceneDescription& description, std::size_t index, const Progress& progress);

  /// Whether spheres are moved: the object moves and casts shadows.
  bool movesSpheres() const { return scene_.binding().sphereCount() > 0; }
  const std::vector<std::string>& warnings() const { return scene_.scene().warnings; }

  ObjectFrame measure(double seconds);
  /// Fits as many spheres to the mesh that measure() has shown, adds their measures, and returns
  /// them; where fewer suffice, the last one is repeated.
  std::vector<Sphere> refit(double seconds, ObjectFrame& frame);

 private:
  MovingScene scene_;  ///< the object alone
  std::vector<Sphere> spheresAtStart_;
};

/// Makes the method whose radiance is compared.
using MethodMaker = std::function<std::unique_ptr<RadianceMethod>(
    const Scene& scene, std::span<const SurfaceSample> samples)>;

/// The receiver's radiance with one set of spheres or another, against `pixel-mesh`.
class PlaneComparison {
 public:
  /// Throws InputError when the scene has no receiver.
  PlaneComparison(const SceneDescription& description, const MethodMaker& makeMethod,
                  const Progress& progress);

  std::string methodName() const { return method_->name(); }

  /// Computes the reference of a second.
  void show(double seconds);
  /// The spheres of moving objects as they were moved there.
  std::vector<Sphere> movedSpheres() const;
  /// With these as the spheres of moving objects.
  ImageError error(std::span<const Sphere> spheres);

 private:
  Image radiance(RadianceMethod& method) const;

  MovingScene scene_;
  glm::ivec2 size_{0};
  std::vector<SurfaceSample> samples_;
  std::unique_ptr<RadianceMethod> method_, reference_;
  Image referenceImage_;
};

/// Follows all objects of a scene whose spheres are moved. Frames do not depend on each other.
class SceneTracker {
 public:
  /// Throws InputError, also when no object of the scene both moves and casts shadows.
  explicit SceneTracker(const SceneDescription& description, const Progress& progress = {});

  /// From now on, radiance is compared, too. Throws InputError when the scene has no receiver.
  void comparePlane(const MethodMaker& makeMethod, const Progress& progress = {});

  const std::vector<std::string>& objectNames() const { return names_; }
  /// Of the method that is compared; empty without a comparison.
  std::string methodName() const { return plane_ ? plane_->methodName() : ""; }
  /// One line each: what is unusual in the objects.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// `refit`: also fits spheres from scratch to the meshes of this frame.
  TrackFrame measure(int frame, bool refit = false);

 private:
  SceneDescription description_;
  std::deque<ObjectTracker> objects_;
  std::vector<std::string> names_, warnings_;
  std::unique_ptr<PlaneComparison> plane_;
};

}  // namespace haarlight
