#include "scene/scene_checks.h"

#include <fmt/format.h>

#include "base/error.h"
#include "scene/camera.h"
#include "scene/keyframes.h"
#include "scene/numbered_files.h"
#include "scene/scene_file.h"

namespace haarlight {

namespace {

void checkSequence(const std::filesystem::path& pattern, const JsonValue& sequence) {
  try {
    const NumberedFiles files(pattern);
  } catch (const InputError&) {
    sequence.failWithValue("must be a file's name with one %d or %0Nd, such as walk_%04d.obj");
  }
}

void checkDeformation(const ObjectDescription& object, const JsonValue& place) {
  const DeformationDescription& deformation = *object.deformation;
  if (deformation.pointCache.has_value() + deformation.sequence.has_value() +
          deformation.animation.has_value() >
      1)
    place.fail("give at most one of pointCache, sequence and animation");
  if (deformation.sequence) checkSequence(*deformation.sequence, place.member("sequence"));
  if (deformation.animation && !isGltfFile(object.mesh))
    place.member("animation").fail("only meshes from .gltf and .glb files have animations");
  if (deformation.bend && deformation.bend->towards == deformation.bend->axis)
    place.member("bend").member("towards").failWithValue("must not be the bend's axis");
}

void checkRotations(const MotionDescription& motion, const JsonValue& place) {
  for (std::size_t i = 0; i < motion.keys.size(); ++i)
    if (motion.keys[i].rotation == glm::dvec4(0))
      place.member("keys").element(i).member("rotation").fail("must not be zero");
}

void checkObject(const ObjectDescription& object, const JsonValue& place) {
  if (object.deformation) checkDeformation(object, place.member("deformation"));
  if (object.motion) checkRotations(*object.motion, place.member("motion"));
}

void checkLightKeys(const LightMotionDescription& motion, const JsonValue& place) {
  for (std::size_t i = 0; i < motion.keys.size(); ++i)
    if (!motion.keys[i].source && motion.keys[i].layout != "auto")
      place.member("keys").element(i).member("layout").fail("needs a source beside it");
}

void checkCamera(const CameraDescription& camera, const JsonValue& scene) {
  if (const auto wrong = sightProblem(camera))
    scene.fail(fmt::format("camera.{}: {}", wrong->field, wrong->problem));
  if (!camera.motion) return;
  for (std::size_t i = 0; i < camera.motion->keys.size(); ++i)
    if (const auto wrong = sightProblem(cameraAtKey(camera, camera.motion->keys[i])))
      scene.fail(fmt::format("camera.motion.keys[{}]: {} {}", i, wrong->field, wrong->problem));
}

void checkFrames(const AnimationDescription& animation, const JsonValue& scene) {
  if (animation.lastFrame < animation.firstFrame)
    scene.fail(fmt::format("animation.lastFrame: must be >= firstFrame ({}), is {}",
                           animation.firstFrame, animation.lastFrame));
}

}  // namespace

void checkTogether(const SceneDescription& scene, const JsonValue& document) {
  if (scene.objects.empty() && !scene.receiver)
    document.fail("there is nothing to see; give objects or a receiver");
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    checkObject(scene.objects[i], document.member("objects").element(i));
  if (scene.light.motion)
    checkLightKeys(*scene.light.motion, document.member("light").member("motion"));
  const long long pixelCount = 1ll * scene.image.width * scene.image.height;
  if (pixelCount > maximumPixelCount)
    document.fail(fmt::format("image: width x height must be <= {} pixels, is {}",
                              maximumPixelCount, pixelCount));
  checkCamera(scene.camera, document);
  checkFrames(scene.animation, document);
}

}  // namespace haarlight
