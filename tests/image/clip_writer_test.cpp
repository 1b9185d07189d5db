#include "image/clip_writer.h"

#include <algorithm>
#include <fstream>
#include <glm/vec2.hpp>

#include "clip_test_support.h"

namespace haarlight::test {

namespace {

namespace fs = std::filesystem;

struct DecodedFrame {
  int width = 0, height = 0;
  std::string samples;

  glm::dvec3 at(int x, int y) const {
    const auto* pixel =
        reinterpret_cast<const unsigned char*>(&samples[3 * (std::size_t(y) * width + x)]);
    return {pixel[0], pixel[1], pixel[2]};
  }
};

/// The mean over the left upper part of the given size.
glm::dvec3 mean(const DecodedFrame& frame, int width, int height) {
  glm::dvec3 sum(0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) sum += frame.at(x, y);
  return sum / double(width * height);
}

/// What ffmpeg reads from a clip: pictures in the PPM format, one behind the other.
std::vector<DecodedFrame> decode(const fs::path& clip) {
  const TemporaryFolder folder;
  const fs::path pictures = folder / "pictures";
  ChildProcess decoder(*findProgram("ffmpeg"),
                       {"-v", "error", "-nostdin", "-i", clip.string(), "-c:v", "ppm", "-f",
                        "image2pipe", "file:" + pictures.string()});
  const ChildEnd end = decoder.finish();
  REQUIRE_MESSAGE(end.success, end.words);
  std::ifstream in(pictures, std::ios::binary);
  std::vector<DecodedFrame> frames;
  DecodedFrame frame;
  for (std::string magic, maximum; in >> magic >> frame.width >> frame.height >> maximum;) {
    REQUIRE(magic == "P6");
    REQUIRE(maximum == "255");
    in.get();
    frame.samples.resize(std::size_t(3) * frame.width * frame.height);
    in.read(frame.samples.data(), std::streamsize(frame.samples.size()));
    REQUIRE(in);
    frames.push_back(frame);
  }
  return frames;
}

double largestDifference(const glm::dvec3& a, const glm::dvec3& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// Writes a clip, reads it back and compares all frames. Mean colours may differ by 2 of 255 and
/// single pixels away from edges by 6, as quantisation, chroma at half the size and dithering
/// allow.
void checkClip(const std::string& extension, glm::ivec2 size, glm::ivec2 clipSize) {
  const TemporaryFolder folder;
  const fs::path path = folder / ("clip 1:2 %d" + extension);
  writeClip(path, size.x, size.y);
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
  const auto frames = decode(path);
  REQUIRE(frames.size() == frameCount);
  const double part = double(squareSize * squareSize) / (size.x * size.y);
  const glm::dvec3 expected =
      part * glm::dvec3(squareColor) + (1 - part) * glm::dvec3(backgroundColor);
  const int middle = squareSize / 2;
  for (int i = 0; i < frameCount; ++i) {
    CAPTURE(i);
    REQUIRE(glm::ivec2(frames[i].width, frames[i].height) == clipSize);
    CHECK(largestDifference(mean(frames[i], size.x, size.y), expected) < 3);
    const auto pixel = frames[i].at(squareLeft(i) + middle, squareSize + middle);
    CHECK(largestDifference(pixel, squareColor) < 6);
    CHECK(largestDifference(frames[i].at(clipSize.x - 1, clipSize.y - 1), backgroundColor) < 6);
  }
}

/// What ffmpeg says about a file's picture stream.
std::string streamLine(const fs::path& clip) {
  ChildProcess reader(*findProgram("ffmpeg"), {"-hide_banner", "-nostdin", "-i", clip.string()});
  const std::string words = reader.finish().words;
  const std::size_t begin = words.find("Stream #0:0");
  return begin == std::string::npos ? words : words.substr(begin, words.find("; ", begin) - begin);
}

}  // namespace

TEST_CASE("a clip as MP4 holds its frames") {
  if (!hasFfmpeg()) return;
  checkClip(".mp4", {64, 48}, {64, 48});
  checkClip(".mp4", {65, 47}, {66, 48});
}

TEST_CASE("a clip as WebM holds its frames") {
  if (!hasFfmpeg()) return;
  checkClip(".webm", {64, 48}, {64, 48});
  checkClip(".webm", {64, 47}, {64, 48});
}

TEST_CASE("a clip as GIF holds its frames") {
  if (!hasFfmpeg()) return;
  checkClip(".gif", {64, 48}, {64, 48});
  checkClip(".gif", {65, 47}, {65, 47});
}

TEST_CASE("ffmpeg gets the bytes of a PNG, with the last column and row of odd sizes twice") {
  // This ffmpeg writes its input to the file of its last argument.
  const FakeFfmpeg fake("for last; do :; done; cat >\"${last#file:}\"");
  const TemporaryFolder folder;
  const Image image = randomImage(5, 3, 1);
  for (const std::string name : {"clip.mp4", "clip.gif"}) {
    ClipWriter clip(folder / name, 5, 3, 25);
    clip.add(image);
    clip.add(image);
    clip.finish();
    const int width = name == "clip.mp4" ? 6 : 5, height = name == "clip.mp4" ? 4 : 3;
    std::string expected;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c)
          expected += char(srgbByte(image.at(std::min(x, 4), std::min(y, 2))[c]));
    CHECK(readFile(folder / name) == expected + expected);
  }
}

TEST_CASE("the name of a clip may look like a protocol of ffmpeg") {
  if (!hasFfmpeg()) return;
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  CHECK(inputErrorOf([] { writeClip("pipe:1.mp4", 64, 48); }) == "");
  CHECK(fs::exists("pipe:1.mp4"));
  fs::current_path(before);
}

TEST_CASE("a clip is what browsers play") {
  if (!hasFfmpeg()) return;
  const TemporaryFolder folder;
  for (const std::string name : {"clip.mp4", "clip.webm", "clip.gif"}) {
    writeClip(folder / name, 64, 48);
    const std::string line = streamLine(folder / name);
    CAPTURE(line);
    CHECK(contains(line, "25 fps"));
    if (name == "clip.gif") continue;
    CHECK(contains(line, name == "clip.mp4" ? "h264 (High)" : "vp9 (Profile 0)"));
    CHECK(contains(line, "yuv420p(tv, bt709/bt709/iec61966-2-1"));
  }
  const std::string mp4 = readFile(folder / "clip.mp4"), gif = readFile(folder / "clip.gif");
  CHECK(mp4.find("moov") < mp4.find("mdat"));  // playing starts before all is loaded
  CHECK(contains(gif, std::string("NETSCAPE2.0\3\1\0\0\0", 16)));  // repeated for ever
}

TEST_CASE("a clip replaces an earlier file, and only when it is finished") {
  if (!hasFfmpeg()) return;
  const TemporaryFolder folder;
  const fs::path path = folder / "clip.mp4";
  writeFile(path, "earlier");
  {
    ClipWriter clip(path, 64, 48, 25);
    for (int frame = 0; frame < 3; ++frame) clip.add(movingSquare(64, 48, frame));
  }
  CHECK(readFile(path) == "earlier");
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
  writeClip(path, 64, 48);
  CHECK(decode(path).size() == frameCount);
}

TEST_CASE("an unfinished clip leaves nothing, not even a running encoder") {
  const FakeFfmpeg fake("trap '' TERM INT; cat >/dev/null; while :; do :; done");
  const TemporaryFolder folder;
  {
    ClipWriter clip(folder / "clip.webm", 64, 48, 25);
    CHECK_FALSE(fs::is_empty(folder.path()));
    clip.add(movingSquare(64, 48, 0));
  }
  CHECK(fs::is_empty(folder.path()));
}

}  // namespace haarlight::test
