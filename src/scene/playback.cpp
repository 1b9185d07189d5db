#include "scene/playback.h"

#include <algorithm>
#include <cmath>

namespace haarlight {

double motionSeconds(const Playback& playback, double duration, double sceneSeconds) {
  const double seconds = std::max(0.0, (sceneSeconds - playback.startSeconds) * playback.speed);
  if (playback.repeat == Repeat::hold || duration <= 0) return std::min(seconds, duration);
  if (playback.repeat == Repeat::loop) return std::fmod(seconds, duration);
  const double inCycle = std::fmod(seconds, 2 * duration);
  return std::min(inCycle, 2 * duration - inCycle);
}

}  // namespace haarlight
