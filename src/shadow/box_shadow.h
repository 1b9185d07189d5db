#pragma once

#include "shadow/shadow_light.h"
#include "solids/axis_box.h"

namespace haarlight {

/// What the shadow of one box, the caster, may do to another, the receiver.
enum class BoxShadow {
  none,   ///< no point of the receiver has a point of the caster between itself and the light
  some,   ///< some point of the receiver has, and some point of the caster has one of the receiver
  behind  ///< some point of the receiver has, but no point of the caster has one of the receiver
};

/// Whether the receiver reaches into the caster's shadow volume. Boxes are closed, so that boxes
/// that touch shadow each other, and a light in the caster, or on its surface, leaves everything in
/// its shadow. Nothing has to do with an empty box. Exact for boxes, but for the 2·10⁻¹² of the
/// largest coordinate by which both are taken larger, so that rounding never says `none` or
/// `behind` where it is not so. The light must be one that checkLight accepts, and the boxes
/// finite.
///
/// A point b of the receiver on its way to a point light L is at b + u (L − b), with u from 0 to 1.
/// At each u the whole receiver is a box again, whose faces have moved linearly, so that it meets
/// the caster where six linear inequalities in u hold: in an interval. Below 0 the receiver moves
/// away from the light, and meeting the caster there means to stand before it. On the way to a
/// directional light b is at b + u · towards, with any u from 0 on.
BoxShadow shadowOf(const AxisBox& caster, const AxisBox& receiver, const ShadowLight& light);

}  // namespace haarlight
