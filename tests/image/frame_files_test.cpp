#include "image/frame_files.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>

#include "image/write_image.h"
#include "image_test_support.h"

namespace haarlight::test {

namespace {

constexpr int width = 37, height = 41;

/// A frame of three layers, as `haarlight render` writes it.
std::string exrFrame(const std::filesystem::path& path) {
  const Image first = randomImage(width, height, 1), second = randomImage(width, height, 2);
  writeExr(path, {{"", first}, {"albedo", second}, {"N", first}});
  return readFile(path);
}

std::string pngFrame(const std::filesystem::path& path) {
  writePng(path, randomImage(width, height, 3));
  return readFile(path);
}

std::string flipped(std::string bytes, std::size_t bit) {
  bytes[bit / 8] = char(bytes[bit / 8] ^ (1 << bit % 8));
  return bytes;
}

/// How many of 50 beginnings of the file, from nothing to all but its last byte, are complete.
int completeBeginnings(const std::filesystem::path& path, const std::string& bytes) {
  int complete = 0;
  for (std::size_t i = 0; i < 50; ++i) {
    writeFile(path, bytes.substr(0, i * (bytes.size() - 1) / 49));
    complete += isCompleteFrame(path, width, height);
  }
  return complete;
}

void checkSizes(const std::filesystem::path& path) {
  CHECK(isCompleteFrame(path, width, height));
  CHECK_FALSE(isCompleteFrame(path, width + 1, height));
  CHECK_FALSE(isCompleteFrame(path, width, height - 1));
  CHECK_FALSE(isCompleteFrame(path, height, width));
}

}  // namespace

TEST_CASE("a written PNG is complete, every part of it is not") {
  const TemporaryFolder folder;
  const auto path = folder / "frame.png";
  const std::string bytes = pngFrame(path);
  checkSizes(path);
  CHECK(completeBeginnings(path, bytes) == 0);
  writeFile(path, bytes + "x");
  CHECK_FALSE(isCompleteFrame(path, width, height));
}

TEST_CASE("a PNG with a changed bit is not complete") {
  const TemporaryFolder folder;
  const auto path = folder / "frame.png";
  const std::string bytes = pngFrame(path);
  int complete = 0;
  // Signature and header have 264 bits.
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += bit < 264 ? 3 : 211) {
    writeFile(path, flipped(bytes, bit));
    complete += isCompleteFrame(path, width, height);
  }
  CHECK(complete == 0);
}

TEST_CASE("a PNG without pixels is not complete") {
  const TemporaryFolder folder;
  const auto path = folder / "frame.png";
  const std::string bytes = pngFrame(path);
  // Signature and IHDR have 8 + 25 bytes, IEND has 12.
  writeFile(path, bytes.substr(0, 33) + bytes.substr(bytes.size() - 12));
  CHECK_FALSE(isCompleteFrame(path, width, height));
}

TEST_CASE("a written EXR is complete, every part of it is not") {
  const TemporaryFolder folder;
  const auto path = folder / "frame.exr";
  const std::string bytes = exrFrame(path);
  checkSizes(path);
  CHECK(completeBeginnings(path, bytes) == 0);
}

TEST_CASE("an EXR that was written in part is not complete") {
  const TemporaryFolder folder;
  const auto path = folder / "frame.exr";
  Imf::Header header(width, height);
  header.channels().insert("R", Imf::Channel(Imf::FLOAT));
  Image image = randomImage(width, height, 4);
  Imf::FrameBuffer frame;
  frame.insert("R", Imf::Slice::Make(Imf::FLOAT, &image.pixels[0].r, header.dataWindow(),
                                     sizeof(glm::vec3), sizeof(glm::vec3) * width));
  for (const int lines : {0, 16, 40, 41}) {
    {
      Imf::OutputFile file(path.c_str(), header);
      file.setFrameBuffer(frame);
      if (lines > 0) file.writePixels(lines);
    }
    CHECK(isCompleteFrame(path, width, height) == (lines == height));
  }
}

TEST_CASE("damage in an EXR never throws, and no changed pixel block is complete") {
  const TemporaryFolder folder;
  const auto path = folder / "frame.exr";
  const std::string bytes = exrFrame(path);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += bit < 4000 ? 37 : 3989) {
    writeFile(path, flipped(bytes, bit));
    CHECK_NOTHROW(isCompleteFrame(path, width, height));
  }
  // ZIP blocks end with the Adler-32 of their content; the last one ends with the file.
  for (std::size_t byte = bytes.size() - 1000; byte < bytes.size(); byte += 7) {
    writeFile(path, flipped(bytes, 8 * byte + byte % 8));
    CHECK_FALSE(isCompleteFrame(path, width, height));
  }
}

TEST_CASE("what is no frame is not complete") {
  const TemporaryFolder folder;
  CHECK_FALSE(isCompleteFrame(folder / "missing.png", width, height));
  CHECK_FALSE(isCompleteFrame(folder.path(), width, height));
  CHECK_FALSE(isCompleteFrame("/dev/zero", width, height));
  writeFile(folder / "text.exr", "no picture");
  CHECK_FALSE(isCompleteFrame(folder / "text.exr", width, height));
  writeFile(folder / "other.exr", pngFrame(folder / "frame.png"));
  CHECK_FALSE(isCompleteFrame(folder / "other.exr", width, height));
  writeFile(folder / "other.jpg", readFile(folder / "frame.png"));
  CHECK_FALSE(isCompleteFrame(folder / "other.jpg", width, height));
}

}  // namespace haarlight::test
