#pragma once

/// What a scene file says about motion, as plain data (docs/scene.md). Every list of keys has at
/// least one, in the order of strictly increasing seconds. Before its first key a value is the
/// first key's; scene/keyframes.h says what it is between keys and after the last.

#include <filesystem>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/axis.h"
#include "scene/playback.h"

namespace haarlight {

/// How the time from a key to the next one runs, as a function of its part u that has passed:
/// u, 3u² − 2u³, or 0 (a jump at the next key).
enum class Ease { linear, smooth, hold };

struct AngleKey {
  double seconds = 0;
  double degrees = 0;
  Ease ease = Ease::linear;
};

/// Every point turns about the line along `axis` through the middle of the mesh's box by
/// degrees · (h − ½), where h is 0 at the lower and 1 at the upper end of the box along the axis.
struct TwistDescription {
  Axis axis = Axis::y;
  std::vector<AngleKey> keys;
};

/// The line along `axis` through the middle of the mesh's box becomes a circular arc of `degrees`
/// in total that curves towards the positive side of another axis.
struct BendDescription {
  Axis axis = Axis::y;
  /// Differs from `axis`; nothing: see bendDirection().
  std::optional<Axis> towards;
  std::vector<AngleKey> keys;
};

/// The axis that a bend curves towards: the one it names, else the one after its own in the circle
/// x, y, z.
inline Axis bendDirection(const BendDescription& bend) {
  return bend.towards.value_or(Axis((int(bend.axis) + 1) % 3));
}

/// How the vertices of a mesh move in its own coordinates: as one of three sources says, then
/// twisted, then bent.
struct DeformationDescription {
  /// At most one of the next three. A .pc2 or .mdd file with the positions of all vertices.
  std::optional<std::filesystem::path> pointCache;
  /// Mesh files of one topology, as for openMeshSequence (motion/mesh_sequence.h).
  std::optional<std::filesystem::path> sequence;
  /// Name or number of an animation in the mesh's glTF file, or "none"; nothing: the first one,
  /// unless there is another source.
  std::optional<std::string> animation;
  std::optional<TwistDescription> twist;
  std::optional<BendDescription> bend;
  /// Of a sequence or a .pc2 file; nothing: the scene's.
  std::optional<double> framesPerSecond;
  /// The clock of source, twist and bend; each of them repeats over its own time.
  Playback playback;
};

/// Where an object is besides its transform; `rotation` is a quaternion (x, y, z, w) of any length
/// but 0.
struct MotionKey {
  double seconds = 0;
  glm::dvec3 translate{0, 0, 0};
  glm::dvec4 rotation{0, 0, 0, 1};
  double scale = 1;
  Ease ease = Ease::linear;
};

/// A motion of the object as a whole, after its transform: about the object's pivot
/// (scene/transform.h), p' = pivot + translate + rotation · scale · (p − pivot).
struct MotionDescription {
  std::vector<MotionKey> keys;
  Repeat repeat = Repeat::hold;
};

struct LightKey {
  double seconds = 0;
  /// Added to the light's.
  double rotateDegrees = 0;
  /// Factor on the light's.
  double scale = 1;
  /// Nothing: the light's source with the light's layout. Otherwise as LightDescription::source,
  /// with `layout`.
  std::optional<std::string> source;
  std::string layout = "auto";
  Ease ease = Ease::linear;
  /// Where the sun of a source that is a sky stands, as in SkySettings but any number of turns;
  /// nothing: as the light's sky says.
  std::optional<double> sunAzimuthDegrees, sunElevationDegrees;
};

/// Between keys of different sources the radiances are cross-faded linearly; the sun, one for both,
/// goes from one place to the other by azimuth and elevation.
struct LightMotionDescription {
  std::vector<LightKey> keys;
  Repeat repeat = Repeat::hold;
};

struct PointLightKey {
  double seconds = 0;
  /// Nothing: the light's own.
  std::optional<glm::dvec3> position;
  Ease ease = Ease::linear;
};

struct PointLightMotionDescription {
  std::vector<PointLightKey> keys;
  Repeat repeat = Repeat::hold;
};

struct DirectionalLightKey {
  double seconds = 0;
  /// Not zero; nothing: the light's own.
  std::optional<glm::dvec3> towards;
  Ease ease = Ease::linear;
};

/// Between two keys, whose directions are not opposite unless the first one holds, the direction
/// takes the shorter way round.
struct DirectionalLightMotionDescription {
  std::vector<DirectionalLightKey> keys;
  Repeat repeat = Repeat::hold;
};

/// Nothing: the camera's own.
struct CameraKey {
  double seconds = 0;
  std::optional<glm::dvec3> position;
  std::optional<glm::dvec3> target;
  Ease ease = Ease::linear;
};

struct CameraMotionDescription {
  std::vector<CameraKey> keys;
  Repeat repeat = Repeat::hold;
};

/// The frames of the scene as a clip: frame f shows second f / framesPerSecond.
struct AnimationDescription {
  int firstFrame = 0;
  /// The last one shown, >= firstFrame.
  int lastFrame = 0;
  double framesPerSecond = 24;
};

}  // namespace haarlight
