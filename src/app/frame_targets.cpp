#include "app/frame_targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "app/options.h"
#include "app/picture_file.h"
#include "base/error.h"
#include "image/frame_files.h"
#include "image/tonemap.h"

namespace haarlight {

namespace {

constexpr int largestFrame = 1000000;

/// A whole number at the start of `text`, which is cut off it; −1 when there is none.
int takeFrame(std::string_view& text) {
  int number = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || text.front() == '-' || number > largestFrame) return -1;
  text.remove_prefix(std::size_t(end - text.data()));
  return number;
}

}  // namespace

FrameRange parseFrameRange(const std::string& text) {
  std::string_view rest = text;
  FrameRange range;
  range.first = range.last = takeFrame(rest);
  if (range.first >= 0 && !rest.empty() && rest.front() == ':') {
    rest.remove_prefix(1);
    range.last = takeFrame(rest);
  }
  if (range.first < 0 || range.last < range.first || !rest.empty())
    throw InputError(
        fmt::format("--frames takes first:last such as 0:95, or one number, from 0 to {}, not '{}'",
                    largestFrame, text));
  return range;
}

bool namesFrames(const std::string& output) {
  return FramePattern::isPattern(output) || ClipWriter::isClip(output);
}

void checkFrameTargets(const std::vector<std::string>& outputs, const FrameRange& frames,
                       double framesPerSecond, bool resume) {
  for (const std::string& output : outputs) {
    if (FramePattern::isPattern(output)) {
      checkTarget(FramePattern(output).path(frames.last), {".png", ".exr"});
    } else if (ClipWriter::isClip(output)) {
      if (resume)
        throw InputError(output + ": a clip cannot be resumed; write frames, -o frame_%04d.png");
      ClipWriter::checkTarget(output, framesPerSecond);
    } else if (frames.count() == 1) {
      checkTarget(output, {".png", ".exr"});
    } else {
      throw InputError(
          fmt::format("{} is one file for {} frames; put the number into the name, as in "
                      "frame_%04d.png, or write "
                      "a clip: .mp4, .webm or .gif",
                      output, frames.count()));
    }
  }
}

FrameTargets::FrameTargets(const std::vector<std::string>& outputs, const ImageDescription& image,
                           double framesPerSecond)
    : image_(image) {
  for (const std::string& output : outputs) {
    if (FramePattern::isPattern(output))
      patterns_.emplace_back(output);
    else
      (ClipWriter::isClip(output) ? clipNames_ : plainNames_).push_back(output);
  }
  for (const std::string& clip : clipNames_)
    clips_.push_back(
        std::make_unique<ClipWriter>(clip, image.width, image.height, framesPerSecond));
}

std::vector<std::string> FrameTargets::pictures(int frame) const {
  std::vector<std::string> names = plainNames_;
  for (const FramePattern& pattern : patterns_) names.push_back(pattern.path(frame).string());
  return names;
}

bool FrameTargets::isComplete(int frame) const {
  return std::ranges::all_of(pictures(frame), [&](const std::string& name) {
    return isCompleteFrame(name, image_.width, image_.height);
  });
}

void FrameTargets::write(int frame, const RenderedImage& picture, float stops,
                         const ImageAttributes& attributes) {
  for (const std::string& name : pictures(frame)) writePicture(name, picture, stops, attributes);
  if (clips_.empty()) return;
  const Image exposed = tonemap(picture.radiance, stops);
  for (const auto& clip : clips_) clip->add(exposed);
}

void FrameTargets::finish() {
  for (const auto& clip : clips_) clip->finish();
}

}  // namespace haarlight
