#pragma once

/// The fields of a scene file, in the order of the document: their names, kinds and ranges.
/// docs/scene.schema.json says the same in JSON Schema; a test holds the two together.

#include "light/builtin_lights.h"
#include "mesh/builtin_meshes.h"
#include "scene/field_ranges.h"
#include "scene/motion_fields.h"
#include "scene/names.h"
#include "scene/scene_description.h"
#include "scene/solid_fields.h"

namespace haarlight {

template <typename Fields>
void visitFields(Fields& fields, TransformDescription& transform) {
  fields.numberOrWord("fit", transform.fit, "none", lengthRange);
  fields.numberOrVector("scale", transform.scale, lengthRange);
  fields.vector("rotateDegrees", transform.rotateDegrees, angleRange);
  fields.choice("rest", transform.rest, restNames);
  fields.vector("translate", transform.translate, coordinateRange);
}

template <typename Fields>
void visitFields(Fields& fields, ObjectDescription& object) {
  fields.text("name", object.name);
  fields.resource("mesh", object.mesh, builtinMeshNames());
  fields.object("solid", object.solid);
  fields.text("family", object.family);
  fields.object("transform", object.transform);
  fields.vector("albedo", object.albedo, unitRange);
  fields.countOrFile("spheres", object.spheres, Range{1, 4096});
  fields.choice("objective", object.objective, fitObjectiveNames);
  fields.flag("castsShadow", object.castsShadow);
  fields.path("transfer", object.transfer);
  fields.object("deformation", object.deformation);
  fields.object("motion", object.motion);
}

template <typename Fields>
void visitFields(Fields& fields, ReceiverDescription& receiver) {
  fields.vector("center", receiver.center, coordinateRange);
  fields.vector("size", receiver.size, lengthRange);
  fields.vector("samples", receiver.samples, Range{1, 4096});
  fields.vector("albedo", receiver.albedo, unitRange);
}

template <typename Fields>
void visitFields(Fields& fields, SkySettings& sky) {
  fields.number("sunAzimuthDegrees", sky.sunAzimuthDegrees, angleRange);
  fields.number("sunElevationDegrees", sky.sunElevationDegrees, elevationRange);
  fields.numberOrWord("zenithRadiance", sky.zenithRadiance, "auto", radianceRange);
  fields.number("sunDisc", sky.sunDisc, sunDiscRange);
  fields.vector("groundAlbedo", sky.groundAlbedo, unitRange);
}

template <typename Fields>
void visitFields(Fields& fields, LightSampleDescription& sample) {
  fields.require("source");
  fields.vector("position", sample.position, coordinateRange);
  fields.resource("source", sample.source, builtinLightNames());
  fields.word("layout", sample.layout, lightLayouts);
  fields.number("rotateDegrees", sample.rotateDegrees, angleRange);
  fields.number("scale", sample.scale, radianceRange);
}

template <typename Fields>
void visitFields(Fields& fields, LightDescription& light) {
  fields.resource("source", light.source, builtinLightNames());
  fields.word("layout", light.layout, lightLayouts);
  fields.number("rotateDegrees", light.rotateDegrees, angleRange);
  fields.number("scale", light.scale, radianceRange);
  fields.object("sky", light.sky);
  fields.list("samples", light.samples, 64);
  fields.object("motion", light.motion);
}

template <typename Fields>
void visitFields(Fields& fields, PointLightDescription& light) {
  fields.require("position");
  fields.require("intensity");
  fields.vector("position", light.position, coordinateRange);
  fields.vector("intensity", light.intensity, intensityRange);
  fields.object("motion", light.motion);
}

template <typename Fields>
void visitFields(Fields& fields, DirectionalLightDescription& light) {
  fields.require("towards");
  fields.require("irradiance");
  fields.vector("towards", light.towards, coordinateRange);
  fields.vector("irradiance", light.irradiance, radianceRange);
  fields.object("motion", light.motion);
}

template <typename Fields>
void visitFields(Fields& fields, CameraDescription& camera) {
  fields.vector("position", camera.position, coordinateRange);
  fields.vector("target", camera.target, coordinateRange);
  fields.vector("up", camera.up, coordinateRange);
  fields.number("verticalFieldOfViewDegrees", camera.verticalFieldOfViewDegrees, Range{1, 170});
  fields.object("motion", camera.motion);
}

template <typename Fields>
void visitFields(Fields& fields, ImageDescription& image) {
  fields.integer("width", image.width, Range{1, 65536});
  fields.integer("height", image.height, Range{1, 65536});
  fields.integer("samplesPerPixel", image.samplesPerPixel, Range{1, 4096});
  fields.numberOrWord("exposure", image.exposure, "auto", Range{-32, 32});
  fields.vectorOrWord("background", image.background, "light", radianceRange);
}

template <typename Fields>
void visitFields(Fields& fields, ShadingDescription& shading) {
  fields.choice("method", shading.method, shadingMethodNames);
  fields.integer("terms", shading.terms, Range{0, 6144});
  fields.integer("levels", shading.levels, Range{1, 2});
  fields.integer("order", shading.order, Range{1, 20});
  fields.choice("per", shading.per, shadedPerNames);
  fields.choice("visibility", shading.visibility, visibilityKindNames);
  fields.choice("engine", shading.engine, engineChoiceNames);
  fields.numberOrWord("shadowDetail", shading.shadowDetail, "auto", lengthRange);
}

/// Of one kind.
inline constexpr std::size_t maximumPunctualLights = 16;

template <typename Fields>
void visitFields(Fields& fields, SceneDescription& scene) {
  fields.ignoredText("$schema");
  fields.integer("version", scene.version, Range{1, 1});
  fields.list("objects", scene.objects, 1024);
  fields.object("receiver", scene.receiver);
  fields.object("light", scene.light);
  fields.list("pointLights", scene.pointLights, maximumPunctualLights);
  fields.list("directionalLights", scene.directionalLights, maximumPunctualLights);
  fields.object("camera", scene.camera);
  fields.object("image", scene.image);
  fields.object("shading", scene.shading);
  fields.object("animation", scene.animation);
}

}  // namespace haarlight
