#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "image/clip_writer.h"
#include "image/tonemap.h"
#include "image_test_support.h"

namespace haarlight::test {

/// $PATH is the given folders while it lives.
class PathGuard {
 public:
  explicit PathGuard(const std::string& folders) : before_(std::getenv("PATH")) {
    setenv("PATH", folders.c_str(), 1);
  }
  ~PathGuard() { setenv("PATH", before_.c_str(), 1); }
  PathGuard(const PathGuard&) = delete;
  PathGuard& operator=(const PathGuard&) = delete;

 private:
  std::string before_;
};

/// While it lives, the only program on $PATH is this shell script as ffmpeg.
class FakeFfmpeg {
 public:
  explicit FakeFfmpeg(const std::string& script) : path_(folder_.path()) {
    writeFile(folder_ / "ffmpeg", "#!/bin/sh\nPATH=/bin:/usr/bin\n" + script + "\n");
    std::filesystem::permissions(folder_ / "ffmpeg", std::filesystem::perms::owner_all);
  }

 private:
  TemporaryFolder folder_;
  PathGuard path_;
};

inline bool hasFfmpeg() {
  if (findProgram("ffmpeg")) return true;
  std::printf("SKIPPED: the program ffmpeg is not on PATH\n");
  return false;
}

inline constexpr int frameCount = 10, squareSize = 16;
inline constexpr glm::ivec3 backgroundColor(40, 80, 160), squareColor(220, 180, 60);

inline glm::vec3 linear(const glm::ivec3& bytes) {
  return {linearFromSrgb(bytes.r / 255.0f), linearFromSrgb(bytes.g / 255.0f),
          linearFromSrgb(bytes.b / 255.0f)};
}

/// Left edge of the square, which is `squareSize` below the picture's top.
inline int squareLeft(int frame) {
  return 4 * frame;
}

inline Image movingSquare(int width, int height, int frame) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool inside = x >= squareLeft(frame) && x < squareLeft(frame) + squareSize &&
                          y >= squareSize && y < 2 * squareSize;
      image.at(x, y) = linear(inside ? squareColor : backgroundColor);
    }
  return image;
}

inline void writeClip(const std::filesystem::path& path, int width, int height) {
  ClipWriter clip(path, width, height, 25);
  for (int frame = 0; frame < frameCount; ++frame) clip.add(movingSquare(width, height, frame));
  clip.finish();
}

}  // namespace haarlight::test
