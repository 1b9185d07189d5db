#include "verify/report/picture.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "base/html.h"
#include "png_test_support.h"

using namespace haarlight;
using namespace haarlight::test;
using namespace haarlight::verify;

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytesOf(const std::string& text) {
  return {text.begin(), text.end()};
}

Bytes pixelAt(const DifferencePicture& picture, const Bytes& pixels, int column, int row) {
  const auto begin = pixels.begin() + 3 * (row * picture.width + column);
  return {begin, begin + 3};
}

}  // namespace

TEST_CASE("a PNG of one red pixel, byte by byte") {
  // Lengths, CRC-32 of the chunks and Adler-32 as zlib computes them.
  const Bytes expected{0x89, 'P',  'N',  'G',  '\r', '\n', 0x1A, '\n', 0,    0,    0,    13,
                       'I',  'H',  'D',  'R',  0,    0,    0,    1,    0,    0,    0,    1,
                       8,    2,    0,    0,    0,    0x90, 0x77, 0x53, 0xDE, 0,    0,    0,
                       15,   'I',  'D',  'A',  'T',  0x78, 0x01, 0x01, 0x04, 0x00, 0xFB, 0xFF,
                       0x00, 0xFF, 0x00, 0x00, 0x03, 0x01, 0x01, 0x00, 0x8D, 0x1D, 0xE5, 0x82,
                       0,    0,    0,    0,    'I',  'E',  'N',  'D',  0xAE, 0x42, 0x60, 0x82};
  CHECK(encodePng(1, 1, Bytes{255, 0, 0}) == expected);
}

TEST_CASE("a PNG of several stored blocks decodes to its pixels") {
  const int width = 191, height = 257;
  Bytes pixels(3 * width * height);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = std::uint8_t(i * 2654435761u >> 13);
  const Png png = readPng(encodePng(width, height, pixels));
  CHECK(png.width == width);
  CHECK(png.height == height);
  CHECK(png.pixels == pixels);
}

TEST_CASE("a PNG that fills one stored block") {
  const Bytes pixels(3 * 1456 * 15, 77);  // with the rows' filters 15 · (1 + 3 · 1456) = 65,535
  CHECK(readPng(encodePng(1456, 15, pixels)).pixels == pixels);
}

TEST_CASE("a PNG of another size than its pixels is refused") {
  const Bytes pixels(12);
  CHECK_THROWS_AS(encodePng(2, 3, pixels), std::invalid_argument);
  CHECK_THROWS_AS(encodePng(-2, -2, pixels), std::invalid_argument);
  CHECK_THROWS_AS(encodePng(0, 0, {}), std::invalid_argument);
  CHECK(readPng(encodePng(2, 2, pixels)).pixels == pixels);
}

TEST_CASE("base64 as in RFC 4648, section 10") {
  const std::vector<std::string> expected{"",         "Zg==",     "Zm8=",    "Zm9v",
                                          "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
  for (std::size_t length = 0; length < expected.size(); ++length)
    CHECK(base64(bytesOf(std::string("foobar").substr(0, length))) == expected[length]);
  CHECK(base64(Bytes{0xFB, 0xFF, 0xBF}) == "+/+/");
}

TEST_CASE("steps between float32 numbers") {
  const float infinity = std::numeric_limits<float>::infinity();
  const float denormal = std::numeric_limits<float>::denorm_min();
  CHECK(ulpDistance(1, 1) == 0);
  CHECK(ulpDistance(1, 1.00000012f) == 1);
  CHECK(ulpDistance(1, 2) == 1u << 23);
  CHECK(ulpDistance(2, 1) == 1u << 23);
  CHECK(ulpDistance(0, denormal) == 1);
  CHECK(ulpDistance(0.0f, -0.0f) == 1);
  CHECK(ulpDistance(-denormal, denormal) == 3);
  CHECK(ulpDistance(std::numeric_limits<float>::max(), infinity) == 1);
  CHECK(ulpDistance(-infinity, infinity) == 2 * 0x7F800000ull + 1);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(ulpDistance(nan, nan) == 0);
  CHECK(ulpDistance(nan, 1) == 0xFFFFFFFF);
  CHECK(ulpDistance(1, nan) == 0xFFFFFFFF);
}

TEST_CASE("the picture of a bit cube shows face after face, wrong texels in red") {
  BitCube expected, actual;
  // Face −Y, row 5, columns 0 and 31.
  expected.rows[3 * faceSize + 5] = 0x80000001;
  actual.rows[3 * faceSize + 5] = 0x00000001;
  const DifferencePicture picture = bitCubePicture("case", expected, actual);
  CHECK(picture.title == "case");
  CHECK(picture.width == 192);
  CHECK(picture.height == 32);
  REQUIRE(picture.expected.size() == 3 * 192 * 32);
  const int first = 3 * 32, last = first + 31;
  const Bytes blocked = pixelAt(picture, picture.expected, first, 5);
  const Bytes open = pixelAt(picture, picture.expected, first + 1, 5);
  CHECK(blocked[1] < 64);
  CHECK(open[1] > 192);
  CHECK(pixelAt(picture, picture.expected, last, 5) == blocked);
  CHECK(pixelAt(picture, picture.actual, last, 5) == open);
  int red = 0;
  for (int row = 0; row < 32; ++row)
    for (int column = 0; column < 192; ++column) {
      const Bytes pixel = pixelAt(picture, picture.difference, column, row);
      const bool isRed = pixel[0] > 192 && pixel[1] < 64 && pixel[2] < 64;
      red += isRed;
      CHECK(isRed == (row == 5 && column == last));
    }
  CHECK(red == 1);
}

TEST_CASE("the picture of a frame is exposed by the expected maximum") {
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<glm::vec4> expected{{4, 2, 0, 0}, {infinity, 1, 0.01f, 0}, {1, 1, 1, 0}};
  std::vector<glm::vec4> actual = expected;
  actual[0].r = std::nextafter(4.0f, 5.0f);
  actual[2].b = -1;
  const DifferencePicture picture = framePicture("frame", 3, 1, expected, actual);
  // sRGB of 1, 1/2, 0; of infinity, 1/4, 1/400 (on the curve's straight part: 12.92/400).
  CHECK(pixelAt(picture, picture.expected, 0, 0) == Bytes{255, 188, 0});
  CHECK(pixelAt(picture, picture.expected, 1, 0) == Bytes{255, 137, 8});
  CHECK(pixelAt(picture, picture.actual, 2, 0) == Bytes{137, 137, 0});
  const Bytes oneUlp = pixelAt(picture, picture.difference, 0, 0);
  const Bytes equal = pixelAt(picture, picture.difference, 1, 0);
  const Bytes sign = pixelAt(picture, picture.difference, 2, 0);
  CHECK(oneUlp[2] > 192);  // blue
  CHECK(oneUlp[0] < 128);
  CHECK(equal[0] < 96);  // dark grey
  CHECK(equal[2] < 96);
  CHECK(sign[0] > 192);  // red: as many steps as to the other sign
  CHECK(sign[2] < 64);
  CHECK_THROWS_AS(framePicture("frame", 2, 1, expected, actual), std::invalid_argument);
}
