#pragma once

namespace haarlight {

/// What comes after the end of a motion: it stays as it is, starts again, or runs backwards and
/// forwards in turn.
enum class Repeat { hold, loop, pingpong };

/// How the clock of a motion hangs on the scene's.
struct Playback {
  /// The scene's second at which the motion starts; before, it stands still at its own second 0.
  double startSeconds = 0;
  /// The motion's seconds per second of the scene, > 0.
  double speed = 1;
  Repeat repeat = Repeat::hold;
};

/// The motion's second, 0 … duration, at a second of the scene. With `loop` the end and the start
/// are one moment: at startSeconds + k · duration / speed the motion is at 0 for k >= 1.
double motionSeconds(const Playback& playback, double duration, double sceneSeconds);

}  // namespace haarlight
