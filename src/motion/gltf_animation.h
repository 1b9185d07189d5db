#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/gltf_file.h"
#include "motion/gltf_pose.h"

namespace haarlight {

enum class AnimatedProperty { translation, rotation, scale, morphWeights };
enum class Interpolation { step, linear, cubicSpline };

/// One property of one node over time (glTF 2.0, appendix C). Before the first key the property has
/// the first key's value, after the last key the last one's.
struct AnimationTrack {
  int node = 0;
  AnimatedProperty property = AnimatedProperty::translation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> keySeconds;  ///< increasing
  std::size_t width = 0;          ///< numbers in a value
  /// The values of the keys, `width` numbers each; with cubicSpline, incoming tangent, value and
  /// outgoing tangent of each key. Rotations are x, y, z, w.
  std::vector<float> keys;

  std::vector<double> valueAt(double seconds) const;
};

struct GltfAnimation {
  std::vector<AnimationTrack> tracks;
  double duration = 0;  ///< the last key of all tracks

  /// Sets what the tracks say at that time.
  void apply(double seconds, std::vector<NodeState>& states) const;
};

/// The animation that `choice` names: "" the first one where there is any, "none" none, else a
/// name, else a number from 0. Throws InputError with the names there are when there is no such
/// one, and when key times do not increase, values are missing or nodes do not exist.
std::optional<GltfAnimation> readGltfAnimation(const GltfFile& file, const NodeHierarchy& nodes,
                                               const std::string& choice);

}  // namespace haarlight
