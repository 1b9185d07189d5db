#pragma once

/// What the keys of a scene (scene/motion_description.h) say at a second. Before the first key it
/// is the first one's value. After the last it is the last one's, or the time between first and
/// last key repeats: with Repeat::loop the last key's second is the first one's again. At a key's
/// own second the key's values come out as they are. Frames do not depend on each other.

#include <algorithm>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <iterator>
#include <string>
#include <vector>

#include "scene/scene_description.h"

namespace haarlight {

/// The second that a frame shows.
double frameSeconds(const AnimationDescription& animation, int frame);

/// Between two keys, or at one (then they are the same).
struct KeyPlace {
  std::size_t from = 0, to = 0;
  /// Of the way from `from` to `to`, after easing; 0 at `from`, below 1 or rounded to it before
  /// `to`.
  double fraction = 0;

  /// The value there, for values that add up and scale.
  template <typename Value>
  Value between(const Value& first, const Value& second) const {
    return first + fraction * (second - first);
  }
};

/// `seconds` as a time from `first` to `last`.
double repeatedSeconds(double first, double last, Repeat repeat, double seconds);

/// The part of the way that is done when the part `passed`, 0 to 1, of the time is over.
double easedFraction(Ease ease, double passed);

/// `keys` as in scene/motion_description.h.
template <typename Key>
KeyPlace keyPlace(const std::vector<Key>& keys, Repeat repeat, double seconds) {
  const double time = repeatedSeconds(keys.front().seconds, keys.back().seconds, repeat, seconds);
  const auto next = std::ranges::upper_bound(keys, time, {}, &Key::seconds);
  const auto key = std::prev(next);
  const auto from = std::size_t(key - keys.begin());
  if (next == keys.end()) return {from, from, 0};
  const double passed = (time - key->seconds) / (next->seconds - key->seconds);
  return {from, from + 1, easedFraction(key->ease, passed)};
}

/// The angle of a twist or a bend at a second of the scene; `playback` is its deformation's.
double degreesAt(const std::vector<AngleKey>& keys, const Playback& playback, double sceneSeconds);

/// What an object goes through after objectToWorld; `pivot` is its objectPivot (scene/transform.h).
/// Rotations take the shorter way round, at constant speed where the ease is linear. Its
/// upper left 3 × 3 part is a rotation times a factor > 0.
glm::dmat4 motionMatrix(const MotionDescription& motion, const glm::dvec3& pivot, double seconds);

/// The factor in motionMatrix.
double motionScale(const MotionDescription& motion, double seconds);

/// As in LightDescription.
struct LightSource {
  std::string source, layout;

  bool operator==(const LightSource&) const = default;
};

/// Radiance is `scale` times that of `from` and of `to` in the parts 1 − fraction and fraction,
/// both rotated by rotateDegrees and, where they are skies, with the settings `sky`.
struct LightState {
  LightSource from, to;
  double fraction = 0;
  double rotateDegrees = 0;
  double scale = 1;
  SkySettings sky;

  bool operator==(const LightState&) const = default;
};

LightState lightAt(const LightDescription& light, double seconds);

/// The light at a second; without motion.
PointLightDescription pointLightAt(const PointLightDescription& light, double seconds);

/// The same. Between two keys the direction goes along the great circle through both of theirs, at
/// constant speed where the ease is linear, and has the length 1. Throws InputError when these are
/// opposite.
DirectionalLightDescription directionalLightAt(const DirectionalLightDescription& light,
                                               double seconds);

/// Whether two directions, of any length but 0, are opposite as far as rounding can tell, so that
/// no way from one to the other is shorter than others.
bool areOpposite(const glm::dvec3& a, const glm::dvec3& b);

/// The camera where a key puts it; without motion.
CameraDescription cameraAtKey(const CameraDescription& camera, const CameraKey& key);

/// The camera at a second; without motion. Throws InputError when it then sees nothing
/// (sightProblem in scene/camera.h), which can happen on the way between two keys.
CameraDescription cameraAt(const CameraDescription& camera, double seconds);

}  // namespace haarlight
