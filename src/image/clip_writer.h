#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/child_process.h"
#include "image/image.h"

namespace haarlight {

/// Writes pictures as a clip by the program ffmpeg, picture by picture:
///   .mp4   H.264 (libx264), yuv420p, index in front, as every browser plays it
///   .webm  VP9 (libvpx-vp9), yuv420p
///   .gif   one palette for all pictures, repeated for ever; ffmpeg keeps all pictures in memory,
///          4 bytes a pixel, until finish(), as the palette depends on all of them
/// Colours are tagged as Rec. 709 primaries with the sRGB curve. As yuv420p needs even sizes, odd
/// ones get their last column or row twice in .mp4 and .webm.
///
/// The clip appears under its name when finish() has returned; before, it is a hidden file beside
/// it, which goes when the writer goes. Ctrl-C reaches only us and not ffmpeg, so that after it the
/// pictures so far can be made a clip by finish().
class ClipWriter {
 public:
  /// Whether the name ends like a clip's.
  static bool isClip(const std::filesystem::path& path);

  /// Throws InputError when no clip can be made: the name's end is none of the above, the path is
  /// a folder or device, the rate is not from 0.01 to 1000 (.gif: 50, as browsers slow down faster
  /// ones), or ffmpeg is not on PATH.
  static void checkTarget(const std::filesystem::path& path, double framesPerSecond);

  /// Starts ffmpeg. Throws InputError as checkTarget does, and when the file cannot be made.
  ClipWriter(const std::filesystem::path& path, int width, int height, double framesPerSecond);

  /// Adds a linear picture of the clip's size as the bytes that writePng would write (expose it by
  /// tonemap first). Throws InputError with ffmpeg's last words when it has failed.
  void add(const Image& image);

  /// Completes the clip and gives it its name, to be called once, after the last add(). Throws
  /// InputError when there is no picture, when ffmpeg has failed, or as writeFileAtomically does.
  void finish();

 private:
  /// A file of ffmpeg's beside the target, removed when the object goes.
  class PartialFile {
   public:
    explicit PartialFile(const std::filesystem::path& target);
    ~PartialFile();
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

   private:
    std::filesystem::path path_;
  };

  [[noreturn]] void fail(const std::string& words) const;

  std::filesystem::path target_;
  int width_, height_;               ///< of the pictures
  int paddedWidth_, paddedHeight_;   ///< of the clip
  std::vector<std::uint8_t> frame_;  ///< rgb24, row by row from the top
  bool empty_ = true;
  PartialFile file_;
  ChildProcess encoder_;  // after file_, so that it has ended when its file is removed
};

}  // namespace haarlight
