#include "verify/report/picture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <stdexcept>

#include "base/crc32.h"

namespace haarlight::verify {

namespace {

using Bytes = std::vector<std::uint8_t>;

struct Color {
  double red, green, blue;
};

void append(Bytes& pixels, const Color& color) {
  for (const double channel : {color.red, color.green, color.blue})
    pixels.push_back(std::uint8_t(std::lround(channel)));
}

Color mix(const Color& a, const Color& b, double part) {
  return {std::lerp(a.red, b.red, part), std::lerp(a.green, b.green, part),
          std::lerp(a.blue, b.blue, part)};
}

void appendBigEndian(Bytes& bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(std::uint8_t(value >> shift));
}

void appendChunk(Bytes& png, std::string_view type, const Bytes& content) {
  appendBigEndian(png, std::uint32_t(content.size()));
  const std::size_t checked = png.size();
  png.insert(png.end(), type.begin(), type.end());
  png.insert(png.end(), content.begin(), content.end());
  appendBigEndian(png, crc32(std::span(png).subspan(checked)));
}

std::uint32_t adler32(const Bytes& bytes) {
  std::uint32_t a = 1, b = 0;
  for (const std::uint8_t byte : bytes) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

/// A zlib stream (RFC 1950) of stored blocks (RFC 1951, 3.2.4).
Bytes storedStream(const Bytes& content) {
  constexpr std::size_t longestBlock = 65535;
  Bytes stream{0x78, 0x01};
  for (std::size_t begin = 0; begin < content.size(); begin += longestBlock) {
    const std::size_t size = std::min(longestBlock, content.size() - begin);
    stream.push_back(begin + size == content.size());
    for (const std::size_t half : {size, ~size}) {
      stream.push_back(std::uint8_t(half));
      stream.push_back(std::uint8_t(half >> 8));
    }
    stream.insert(stream.end(), &content[begin], &content[begin] + size);
  }
  appendBigEndian(stream, adler32(content));
  return stream;
}

DifferencePicture emptyPicture(const std::string& title, int width, int height) {
  DifferencePicture picture;
  picture.title = title;
  picture.width = width;
  picture.height = height;
  return picture;
}

void appendTexel(DifferencePicture& picture, bool expected, bool actual) {
  constexpr Color blocked{38, 42, 52}, open{240, 238, 226}, faint{214, 214, 212},
      wrong{214, 20, 28};
  append(picture.expected, expected ? blocked : open);
  append(picture.actual, actual ? blocked : open);
  append(picture.difference,
         expected == actual ? mix(faint, expected ? blocked : open, 0.2) : wrong);
}

/// IEC 61966-2-1, in 0 … 255; 0 for NaN.
double srgb(double linear) {
  const double value = linear > 0 ? std::min(linear, 1.0) : 0;
  return 255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055);
}

Color exposed(const glm::vec4& radiance, double exposure) {
  return {srgb(radiance.r * exposure), srgb(radiance.g * exposure), srgb(radiance.b * exposure)};
}

double exposureOf(std::span<const glm::vec4> radiance) {
  float maximum = 0;
  for (const glm::vec4& pixel : radiance)
    for (const float channel : {pixel.r, pixel.g, pixel.b})
      if (std::isfinite(channel)) maximum = std::max(maximum, channel);
  return maximum > 0 ? 1.0 / maximum : 1.0;
}

Color differenceColor(const glm::vec4& expected, const glm::vec4& actual) {
  std::uint64_t ulp = 0;
  for (int channel = 0; channel < 3; ++channel)
    ulp = std::max(ulp, ulpDistance(expected[channel], actual[channel]));
  constexpr Color equal{56, 56, 60}, smallest{70, 150, 255}, largest{255, 40, 30};
  return ulp == 0 ? equal : mix(smallest, largest, std::min(std::log2(double(ulp)) / 31, 1.0));
}

}  // namespace

DifferencePicture bitCubePicture(const std::string& title, const BitCube& expected,
                                 const BitCube& actual) {
  DifferencePicture picture = emptyPicture(title, faceCount * faceSize, faceSize);
  for (int row = 0; row < faceSize; ++row)
    for (int face = 0; face < faceCount; ++face)
      for (int column = 0; column < faceSize; ++column) {
        const int texel = (face * faceSize + row) * faceSize + column;
        appendTexel(picture, expected.blocked(texel), actual.blocked(texel));
      }
  return picture;
}

DifferencePicture framePicture(const std::string& title, int width, int height,
                               std::span<const glm::vec4> expected,
                               std::span<const glm::vec4> actual) {
  if (width <= 0 || height <= 0 || expected.size() != std::size_t(width) * height ||
      actual.size() != expected.size())
    throw std::invalid_argument("pixels do not fit the picture's size");
  DifferencePicture picture = emptyPicture(title, width, height);
  const double exposure = exposureOf(expected);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    append(picture.expected, exposed(expected[i], exposure));
    append(picture.actual, exposed(actual[i], exposure));
    append(picture.difference, differenceColor(expected[i], actual[i]));
  }
  return picture;
}

std::uint64_t ulpDistance(float a, float b) {
  const auto bitsA = std::bit_cast<std::uint32_t>(a), bitsB = std::bit_cast<std::uint32_t>(b);
  if (bitsA == bitsB) return 0;
  if (std::isnan(a) || std::isnan(b)) return 0xFFFFFFFFu;
  // −0 is −1, so that it is not +0's equal.
  const auto position = [](std::uint32_t bits) {
    const std::int64_t magnitude = bits & 0x7FFFFFFFu;
    return bits >> 31 ? -1 - magnitude : magnitude;
  };
  return std::uint64_t(std::abs(position(bitsA) - position(bitsB)));
}

std::vector<std::uint8_t> encodePng(int width, int height, std::span<const std::uint8_t> pixels) {
  const std::size_t rowBytes = 3 * std::size_t(std::max(width, 0));
  if (width <= 0 || height <= 0 || pixels.size() != rowBytes * height)
    throw std::invalid_argument("pixels do not fit the picture's size");
  Bytes header;
  appendBigEndian(header, std::uint32_t(width));
  appendBigEndian(header, std::uint32_t(height));
  // 8 bits a channel, RGB; deflate, filters by row, not interlaced.
  for (const int setting : {8, 2, 0, 0, 0}) header.push_back(std::uint8_t(setting));
  Bytes rows;
  for (std::size_t begin = 0; begin < pixels.size(); begin += rowBytes) {
    rows.push_back(0);  // no filter
    rows.insert(rows.end(), &pixels[begin], &pixels[begin] + rowBytes);
  }
  Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  appendChunk(png, "IHDR", header);
  appendChunk(png, "IDAT", storedStream(rows));
  appendChunk(png, "IEND", {});
  return png;
}

}  // namespace haarlight::verify
