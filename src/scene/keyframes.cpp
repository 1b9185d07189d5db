#include "scene/keyframes.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "base/error.h"
#include "scene/camera.h"

namespace haarlight {

namespace {

/// Divided by the largest component, so that no square leaves the range of numbers.
template <typename Vector>
Vector scaledToOne(const Vector& vector) {
  double largest = 0;
  for (int i = 0; i < Vector::length(); ++i) largest = std::max(largest, std::abs(vector[i]));
  return vector / largest;
}

glm::dvec3 unit(const glm::dvec3& direction) {
  return glm::normalize(scaledToOne(direction));
}

glm::dquat unitQuaternion(const glm::dvec4& xyzw) {
  const glm::dvec4 scaled = scaledToOne(xyzw);
  return glm::normalize(glm::dquat(scaled.w, scaled.x, scaled.y, scaled.z));
}

/// Of unit vectors that are not opposite.
glm::dvec3 directionBetween(const glm::dvec3& from, const glm::dvec3& to, double fraction) {
  const glm::dvec3 axis = glm::cross(from, to);
  const double sine = glm::length(axis);
  if (sine == 0) return from;
  const double angle = fraction * std::atan2(sine, glm::dot(from, to));
  return glm::normalize(std::cos(angle) * from + std::sin(angle) * glm::cross(axis / sine, from));
}

glm::dquat rotationAt(const MotionKey& from, const MotionKey& to, double fraction) {
  const glm::dquat start = unitQuaternion(from.rotation);
  if (fraction == 0) return start;
  return glm::normalize(glm::slerp(start, unitQuaternion(to.rotation), fraction));
}

/// The settings at a key.
SkySettings skyAt(const LightDescription& light, const LightKey& key) {
  SkySettings sky = light.sky.value_or(SkySettings{});
  sky.sunAzimuthDegrees = key.sunAzimuthDegrees.value_or(sky.sunAzimuthDegrees);
  sky.sunElevationDegrees = key.sunElevationDegrees.value_or(sky.sunElevationDegrees);
  return sky;
}

SkySettings skyBetween(const SkySettings& from, const SkySettings& to, const KeyPlace& place) {
  SkySettings sky = from;
  sky.sunAzimuthDegrees = place.between(from.sunAzimuthDegrees, to.sunAzimuthDegrees);
  // Rounding must not lift the sun beyond the zenith.
  sky.sunElevationDegrees =
      std::min(place.between(from.sunElevationDegrees, to.sunElevationDegrees), 90.0);
  return sky;
}

LightSource sourceAt(const LightDescription& light, const LightKey& key) {
  return key.source ? LightSource{*key.source, key.layout}
                    : LightSource{light.source, light.layout};
}

}  // namespace

double frameSeconds(const AnimationDescription& animation, int frame) {
  return frame / animation.framesPerSecond;
}

double repeatedSeconds(double first, double last, Repeat repeat, double seconds) {
  // The first time through takes seconds as they are, so that keys are met exactly.
  const bool firstTime = repeat == Repeat::loop ? seconds < last : seconds <= last;
  if (firstTime || repeat == Repeat::hold) return std::clamp(seconds, first, last);
  const Playback playback{first, 1, repeat};
  return std::min(first + motionSeconds(playback, last - first, seconds), last);
}

double easedFraction(Ease ease, double passed) {
  if (ease == Ease::hold) return 0;
  return ease == Ease::smooth ? passed * passed * (3 - 2 * passed) : passed;
}

double degreesAt(const std::vector<AngleKey>& keys, const Playback& playback, double sceneSeconds) {
  const double seconds = (sceneSeconds - playback.startSeconds) * playback.speed;
  const KeyPlace place = keyPlace(keys, playback.repeat, seconds);
  return place.between(keys[place.from].degrees, keys[place.to].degrees);
}

glm::dmat4 motionMatrix(const MotionDescription& motion, const glm::dvec3& pivot, double seconds) {
  const KeyPlace place = keyPlace(motion.keys, motion.repeat, seconds);
  const MotionKey& from = motion.keys[place.from];
  const MotionKey& to = motion.keys[place.to];
  const glm::dmat3 turning =
      place.between(from.scale, to.scale) * glm::mat3_cast(rotationAt(from, to, place.fraction));
  glm::dmat4 matrix(turning);
  matrix[3] =
      glm::dvec4(place.between(from.translate, to.translate) + (pivot - turning * pivot), 1);
  return matrix;
}

double motionScale(const MotionDescription& motion, double seconds) {
  const KeyPlace place = keyPlace(motion.keys, motion.repeat, seconds);
  return place.between(motion.keys[place.from].scale, motion.keys[place.to].scale);
}

LightState lightAt(const LightDescription& light, double seconds) {
  const LightSource own{light.source, light.layout};
  if (!light.motion)
    return {own, own, 0, light.rotateDegrees, light.scale, light.sky.value_or(SkySettings{})};
  const std::vector<LightKey>& keys = light.motion->keys;
  const KeyPlace place = keyPlace(keys, light.motion->repeat, seconds);
  const LightKey& from = keys[place.from];
  const LightKey& to = keys[place.to];
  return {sourceAt(light, from),
          sourceAt(light, to),
          place.fraction,
          light.rotateDegrees + place.between(from.rotateDegrees, to.rotateDegrees),
          light.scale * place.between(from.scale, to.scale),
          skyBetween(skyAt(light, from), skyAt(light, to), place)};
}

PointLightDescription pointLightAt(const PointLightDescription& light, double seconds) {
  PointLightDescription result = light;
  result.motion.reset();
  if (!light.motion) return result;
  const KeyPlace place = keyPlace(light.motion->keys, light.motion->repeat, seconds);
  const auto position = [&](std::size_t key) {
    return light.motion->keys[key].position.value_or(light.position);
  };
  result.position = place.between(position(place.from), position(place.to));
  return result;
}

DirectionalLightDescription directionalLightAt(const DirectionalLightDescription& light,
                                               double seconds) {
  DirectionalLightDescription result = light;
  result.motion.reset();
  if (!light.motion) return result;
  const KeyPlace place = keyPlace(light.motion->keys, light.motion->repeat, seconds);
  const auto towards = [&](std::size_t key) {
    return light.motion->keys[key].towards.value_or(light.towards);
  };
  result.towards = towards(place.from);
  if (place.fraction == 0) return result;
  if (areOpposite(towards(place.from), towards(place.to)))
    throw InputError(fmt::format(
        "a directional light at second {}: the directions of two keys are opposite", seconds));
  result.towards =
      directionBetween(unit(towards(place.from)), unit(towards(place.to)), place.fraction);
  return result;
}

bool areOpposite(const glm::dvec3& a, const glm::dvec3& b) {
  constexpr double rounding = 1e-12;
  return glm::length(unit(a) + unit(b)) < rounding;
}

CameraDescription cameraAtKey(const CameraDescription& camera, const CameraKey& key) {
  CameraDescription result = camera;
  result.motion.reset();
  result.position = key.position.value_or(camera.position);
  result.target = key.target.value_or(camera.target);
  return result;
}

CameraDescription cameraAt(const CameraDescription& camera, double seconds) {
  if (!camera.motion) return camera;
  const std::vector<CameraKey>& keys = camera.motion->keys;
  const KeyPlace place = keyPlace(keys, camera.motion->repeat, seconds);
  CameraDescription result = cameraAtKey(camera, keys[place.from]);
  const CameraDescription to = cameraAtKey(camera, keys[place.to]);
  result.position = place.between(result.position, to.position);
  result.target = place.between(result.target, to.target);
  if (const auto wrong = sightProblem(result))
    throw InputError(
        fmt::format("camera at second {}: {} {}", seconds, wrong->field, wrong->problem));
  return result;
}

}  // namespace haarlight
