// Own decoder: stb_image reads neither old run-length encoding nor other orientations than -Y +X,
// and ignores EXPOSURE.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>

#include "image/image_decoding.h"
#include "image/radiance_header.h"
#include "image/rec709.h"

namespace haarlight {

namespace {

/// Three mantissas and a shared exponent.
using SharedExponentPixel = std::array<std::uint8_t, 4>;

/// Decodes the scanlines that follow one another in a file's bytes.
class ScanlineReader {
 public:
  ScanlineReader(std::span<const std::uint8_t> bytes, std::size_t position,
                 const std::filesystem::path& path)
      : bytes_(bytes), position_(position), path_(path) {}

  void read(std::span<SharedExponentPixel> scanline) {
    if (startsNewEncoding(scanline.size()))
      readByComponent(scanline);
    else
      readByPixel(scanline);
    ++scanlineNumber_;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    cannotReadImage(path_, "it is damaged: scanline " + std::to_string(scanlineNumber_) +
                               ", byte " + std::to_string(position_) + ": " + reason);
  }

  std::span<const std::uint8_t> take(std::size_t count) {
    if (bytes_.size() - position_ < count) fail("the file ends too early");
    position_ += count;
    return bytes_.subspan(position_ - count, count);
  }

  SharedExponentPixel takePixel() {
    const auto bytes = take(4);
    return {bytes[0], bytes[1], bytes[2], bytes[3]};
  }

  /// New encoding starts with 2 2 and the scanline's length, which no normalised pixel looks like.
  bool startsNewEncoding(std::size_t length) const {
    return length >= 8 && length <= 32767 && bytes_.size() - position_ >= 4 &&
           bytes_[position_] == 2 && bytes_[position_ + 1] == 2 && bytes_[position_ + 2] < 128;
  }

  void readByComponent(std::span<SharedExponentPixel> scanline) {
    const SharedExponentPixel start = takePixel();
    if (std::size_t(start[2] << 8 | start[3]) != scanline.size())
      fail("its length is not the image's");
    for (int component = 0; component < 4; ++component)
      for (std::size_t done = 0; done < scanline.size();)
        done += readComponentRun(scanline.subspan(done), component);
  }

  std::size_t readComponentRun(std::span<SharedExponentPixel> rest, int component) {
    const std::uint8_t code = take(1)[0];
    const bool repeats = code > 128;
    const std::size_t count = repeats ? code - 128 : code;
    if (count == 0 || count > rest.size()) fail("a run does not fit into the scanline");
    const auto values = take(repeats ? 1 : count);
    for (std::size_t i = 0; i < count; ++i) rest[i][component] = values[repeats ? 0 : i];
    return count;
  }

  /// Flat pixels, among which (1, 1, 1, n) is old encoding: repeat the last pixel n times, n
  /// shifted left by 8 bits for each such code directly before.
  void readByPixel(std::span<SharedExponentPixel> scanline) {
    int shift = 0;
    for (std::size_t done = 0; done < scanline.size();) {
      const SharedExponentPixel pixel = takePixel();
      if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
        scanline[done++] = pixel;
        shift = 0;
        continue;
      }
      const std::size_t count = shift > 24 ? SIZE_MAX : std::size_t(pixel[3]) << shift;
      if (done == 0 || count > scanline.size() - done) fail("a run does not fit into the scanline");
      std::fill_n(scanline.begin() + done, count, scanline[done - 1]);
      done += count;
      shift += 8;
    }
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t position_;
  const std::filesystem::path& path_;
  int scanlineNumber_ = 0;
};

glm::dvec3 toColor(const SharedExponentPixel& pixel) {
  if (pixel[3] == 0) return glm::dvec3(0.0);
  return glm::dvec3(pixel[0], pixel[1], pixel[2]) * std::ldexp(1.0, pixel[3] - 136);
}

}  // namespace

ImageFile decodeRadianceHdr(std::span<const std::uint8_t> bytes,
                            const std::filesystem::path& path) {
  RadianceHeader header = parseRadianceHeader(bytes, path);
  const glm::dmat3 toRec709 = header.isXyz ? rec709FromXyz() : glm::dmat3(1.0);
  Image image(header.width, header.height);
  ScanlineReader reader(bytes, header.dataOffset, path);
  std::vector<SharedExponentPixel> scanline(header.scanlineLength());
  for (int i = 0; i < header.scanlineCount(); ++i) {
    reader.read(scanline);
    for (int j = 0; j < header.scanlineLength(); ++j) {
      const glm::ivec2 position = header.pixelPosition(i, j);
      image.at(position.x, position.y) =
          glm::vec3(toRec709 * toColor(scanline[j]) / header.exposure);
    }
  }
  const std::vector<std::string> channels = header.isXyz ? std::vector<std::string>{"X", "Y", "Z"}
                                                         : std::vector<std::string>{"R", "G", "B"};
  return {
      std::move(image), "Radiance HDR", header.exposure, channels, std::move(header.variables), {}};
}

}  // namespace haarlight
