#include "scene/scene_checks.h"

#include <fmt/format.h>

#include "base/error.h"
#include "scene/camera.h"
#include "scene/field_ranges.h"
#include "scene/keyframes.h"
#include "scene/numbered_files.h"
#include "scene/scene_file.h"
#include "solids/solid_checks.h"

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

/// As checkShape does, and a cone's top.
void checkMeasures(const Shape& shape, const JsonValue& solid) {
  const auto* cone = std::get_if<ConeShape>(&shape);
  if (cone && cone->topRadius != 0 && cone->topRadius < lengthRange.minimum)
    solid.member("cone")
        .member("topRadius")
        .failWithValue(fmt::format("must be 0 or >= {}", lengthRange.minimum));
  try {
    checkShape(shape);
  } catch (const InputError& error) {
    solid.fail(error.what());
  }
}

/// A solid stays one under what turns, moves and scales it evenly.
void checkSolid(const ObjectDescription& object, const JsonValue& place) {
  checkMeasures(*object.solid, place.member("solid"));
  if (object.transform.fit)
    place.member("transform").member("fit").fail("a solid's size is given by its measures");
  const nlohmann::json& json = place.json();
  if (json.contains("transform") && json["transform"].contains("scale") &&
      !json["transform"]["scale"].is_number())
    place.member("transform")
        .member("scale")
        .fail("a solid's is one number; stretch it by its measures");
  if (object.deformation)
    place.member("deformation").fail("a solid keeps its shape; give a mesh for one that changes");
  if (object.transfer)
    place.member("transfer").fail("transfer is for the vertices of a mesh, and a solid has none");
}

void checkMeshOrSolid(const ObjectDescription& object, const JsonValue& place) {
  if (object.mesh.empty() && !object.solid) place.fail("give a mesh or a solid");
  if (!object.mesh.empty() && object.solid) place.fail("give a mesh or a solid, not both");
  if (object.solid) checkSolid(object, place);
}

void checkObject(const ObjectDescription& object, const JsonValue& place) {
  checkMeshOrSolid(object, place);
  if (object.deformation) checkDeformation(object, place.member("deformation"));
  if (object.motion) checkRotations(*object.motion, place.member("motion"));
}

void checkLightKeys(const LightMotionDescription& motion, const JsonValue& place) {
  for (std::size_t i = 0; i < motion.keys.size(); ++i)
    if (!motion.keys[i].source && motion.keys[i].layout != "auto")
      place.member("keys").element(i).member("layout").fail("needs a source beside it");
}

void checkDirections(const DirectionalLightDescription& light, const JsonValue& place) {
  if (light.towards == glm::dvec3(0)) place.member("towards").fail("must not be zero");
  if (!light.motion) return;
  const std::vector<DirectionalLightKey>& keys = light.motion->keys;
  const auto towards = [&](std::size_t i) { return keys[i].towards.value_or(light.towards); };
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const JsonValue key = place.member("motion").member("keys").element(i);
    if (towards(i) == glm::dvec3(0)) key.member("towards").fail("must not be zero");
    if (i > 0 && keys[i - 1].ease != Ease::hold && areOpposite(towards(i - 1), towards(i)))
      key.fail("towards is opposite to that of the key before; put a key in between");
  }
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
  for (std::size_t i = 0; i < scene.directionalLights.size(); ++i)
    checkDirections(scene.directionalLights[i], document.member("directionalLights").element(i));
  const long long pixelCount = 1ll * scene.image.width * scene.image.height;
  if (pixelCount > maximumPixelCount)
    document.fail(fmt::format("image: width x height must be <= {} pixels, is {}",
                              maximumPixelCount, pixelCount));
  checkCamera(scene.camera, document);
  checkFrames(scene.animation, document);
}

}  // namespace haarlight
