#pragma once

#include <string>
#include <vector>

#include "app/frame_targets.h"
#include "app/shading_setup.h"

namespace haarlight {

/// How `render` goes through frames.
struct FrameSettings {
  FrameRange range;
  /// Pass over frames whose pictures are complete.
  bool resume = false;
  /// Whether the results tell of every frame.
  bool listFrames = false;
};

/// Renders the frames of a scene in ascending order to their files. Frame f shows second
/// f / framesPerSecond of the scene's animation, and its bits depend on nothing else. What is
/// chosen from the picture where a still does so is chosen from second 0 for all frames, lest
/// pictures flicker: the exposure, and which light terms are kept.
///
/// Ctrl-C ends after the current frame; clips are completed then, too. An error leaves all frames
/// written before as they are. Returns what to print.
nlohmann::ordered_json renderFrames(ShadingSetup& setup, const std::vector<std::string>& outputs,
                                    const FrameSettings& settings);

}  // namespace haarlight
