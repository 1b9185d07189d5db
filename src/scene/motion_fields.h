#pragma once

/// The fields of a scene file that describe motion: the counterpart of scene/scene_fields.h.

#include "light/builtin_lights.h"
#include "scene/field_ranges.h"
#include "scene/motion_description.h"
#include "scene/names.h"

namespace haarlight {

template <typename Fields>
void visitFields(Fields& fields, AngleKey& key) {
  fields.require("seconds");
  fields.number("seconds", key.seconds, secondsRange);
  fields.number("degrees", key.degrees, turningRange);
  fields.choice("ease", key.ease, easeNames);
}

template <typename Fields>
void visitFields(Fields& fields, TwistDescription& twist) {
  fields.choice("axis", twist.axis, axisNames);
  fields.keys("keys", twist.keys);
}

template <typename Fields>
void visitFields(Fields& fields, BendDescription& bend) {
  fields.choice("axis", bend.axis, axisNames);
  fields.choice("towards", bend.towards, axisNames);
  fields.keys("keys", bend.keys);
}

template <typename Fields>
void visitFields(Fields& fields, DeformationDescription& deformation) {
  fields.path("pointCache", deformation.pointCache);
  fields.path("sequence", deformation.sequence);
  fields.text("animation", deformation.animation);
  fields.object("twist", deformation.twist);
  fields.object("bend", deformation.bend);
  fields.number("framesPerSecond", deformation.framesPerSecond, frameRateRange);
  fields.number("startSeconds", deformation.playback.startSeconds, startRange);
  fields.number("speed", deformation.playback.speed, factorRange);
  fields.choice("repeat", deformation.playback.repeat, repeatNames);
}

template <typename Fields>
void visitFields(Fields& fields, MotionKey& key) {
  fields.require("seconds");
  fields.number("seconds", key.seconds, secondsRange);
  fields.vector("translate", key.translate, coordinateRange);
  fields.vector("rotation", key.rotation, coordinateRange);
  fields.number("scale", key.scale, factorRange);
  fields.choice("ease", key.ease, easeNames);
}

template <typename Fields>
void visitFields(Fields& fields, LightKey& key) {
  fields.require("seconds");
  fields.number("seconds", key.seconds, secondsRange);
  fields.number("rotateDegrees", key.rotateDegrees, turningRange);
  fields.number("scale", key.scale, radianceRange);
  fields.resource("source", key.source, builtinLightNames());
  fields.word("layout", key.layout, lightLayouts);
  fields.number("sunAzimuthDegrees", key.sunAzimuthDegrees, turningRange);
  fields.number("sunElevationDegrees", key.sunElevationDegrees, elevationRange);
  fields.choice("ease", key.ease, easeNames);
}

template <typename Fields>
void visitFields(Fields& fields, PointLightKey& key) {
  fields.require("seconds");
  fields.number("seconds", key.seconds, secondsRange);
  fields.vector("position", key.position, coordinateRange);
  fields.choice("ease", key.ease, easeNames);
}

template <typename Fields>
void visitFields(Fields& fields, DirectionalLightKey& key) {
  fields.require("seconds");
  fields.number("seconds", key.seconds, secondsRange);
  fields.vector("towards", key.towards, coordinateRange);
  fields.choice("ease", key.ease, easeNames);
}

template <typename Fields>
void visitFields(Fields& fields, CameraKey& key) {
  fields.require("seconds");
  fields.number("seconds", key.seconds, secondsRange);
  fields.vector("position", key.position, coordinateRange);
  fields.vector("target", key.target, coordinateRange);
  fields.choice("ease", key.ease, easeNames);
}

template <typename Description>
concept KeyedMotion = requires(Description motion) {
  motion.keys;
  motion.repeat;
};

template <typename Fields, KeyedMotion Description>
void visitFields(Fields& fields, Description& motion) {
  fields.keys("keys", motion.keys);
  fields.choice("repeat", motion.repeat, repeatNames);
}

template <typename Fields>
void visitFields(Fields& fields, AnimationDescription& animation) {
  fields.integer("firstFrame", animation.firstFrame, frameRange);
  fields.integer("lastFrame", animation.lastFrame, frameRange);
  fields.number("framesPerSecond", animation.framesPerSecond, frameRateRange);
}

}  // namespace haarlight
