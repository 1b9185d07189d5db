#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "image/clip_writer.h"
#include "image/write_image.h"
#include "render/render_image.h"
#include "scene/frame_pattern.h"
#include "scene/scene_description.h"

namespace haarlight {

/// Frames first … last, last included.
struct FrameRange {
  int first = 0;
  int last = 0;

  int count() const { return last - first + 1; }
};

/// "A:B" or "A". Throws InputError for other texts, negative numbers and B < A.
FrameRange parseFrameRange(const std::string& text);

/// Whether a name stands for many frames: numbered pictures or a clip.
bool namesFrames(const std::string& output);

/// Throws InputError when one of the names cannot be written, or does not suit the number of
/// frames, or is a clip that is to be resumed; so that no work is done in vain.
void checkFrameTargets(const std::vector<std::string>& outputs, const FrameRange& frames,
                       double framesPerSecond, bool resume);

/// The files that the frames of an animation go to: numbered pictures ("frame_%04d.png" or .exr),
/// clips, and for a single frame also pictures with plain names.
class FrameTargets {
 public:
  /// `outputs` have passed checkFrameTargets. Throws InputError when a clip cannot be started.
  FrameTargets(const std::vector<std::string>& outputs, const ImageDescription& image,
               double framesPerSecond);

  /// Whether all pictures of the frame are there, whole and of the right size.
  bool isComplete(int frame) const;
  /// Names of the frame's pictures.
  std::vector<std::string> pictures(int frame) const;
  const std::vector<std::string>& clips() const { return clipNames_; }

  void write(int frame, const RenderedImage& picture, float stops,
             const ImageAttributes& attributes);
  /// Completes the clips. Not to be called when no frame was written.
  void finish();

 private:
  ImageDescription image_;
  std::vector<FramePattern> patterns_;
  std::vector<std::string> plainNames_, clipNames_;
  std::vector<std::unique_ptr<ClipWriter>> clips_;
};

}  // namespace haarlight
