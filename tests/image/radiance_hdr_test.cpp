#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_HDR
#include <stb_image.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "image_test_support.h"

namespace haarlight::test {

namespace {

using Rgbe = std::array<std::uint8_t, 4>;
using Scanline = std::vector<Rgbe>;

std::string header(const std::string& lines, const std::string& resolution) {
  return "#?RADIANCE\n" + lines + "FORMAT=32-bit_rle_rgbe\n\n" + resolution + "\n";
}

std::string flat(const Scanline& scanline) {
  std::string bytes;
  for (const Rgbe& pixel : scanline) bytes.append(pixel.begin(), pixel.end());
  return bytes;
}

/// Old encoding: 1 1 1 n repeats the pixel before; longer counts go on in higher bytes.
std::string oldEncoding(const Scanline& scanline) {
  std::string bytes;
  for (std::size_t i = 0; i < scanline.size();) {
    std::size_t end = i + 1;
    while (end < scanline.size() && scanline[end] == scanline[i]) ++end;
    bytes.append(scanline[i].begin(), scanline[i].end());
    for (std::size_t rest = end - i - 1; rest > 0; rest /= 256)
      bytes += {1, 1, 1, char(rest % 256)};
    i = end;
  }
  return bytes;
}

/// New encoding, runs of at least three, by component.
std::string newEncoding(const Scanline& scanline) {
  std::string bytes{2, 2, char(scanline.size() >> 8), char(scanline.size() & 255)};
  for (int component = 0; component < 4; ++component)
    for (std::size_t i = 0; i < scanline.size();) {
      std::size_t end = i + 1;
      while (end < scanline.size() && end - i < 127 &&
             scanline[end][component] == scanline[i][component])
        ++end;
      if (end - i >= 3) {
        bytes += char(128 + (end - i));
      } else {
        end = i + 1;
        bytes += char(1);
      }
      bytes += char(scanline[i][component]);
      i = end;
    }
  return bytes;
}

/// Mantissas of which the largest is at least 128, as Radiance normalises them, with long runs.
Rgbe somePixel(int column, int row) {
  if (column > 3 && column < 700) return {200, 17, std::uint8_t(row), 130};
  return {std::uint8_t(128 + column % 128), std::uint8_t(7 * row), std::uint8_t(column + row),
          std::uint8_t(120 + (column + 3 * row) % 20)};
}

glm::vec3 decoded(const Rgbe& p) {
  return glm::vec3(p[0], p[1], p[2]) * std::exp2(float(p[3]) - 136);
}

/// The picture somePixel(column, row), row 0 at the top, in a file with the given axes: Radiance's
/// X counts columns from the left and Y rows from the bottom.
std::string fileWithAxes(const std::string& first, const std::string& second, int width, int height,
                         const std::function<std::string(const Scanline&)>& encode) {
  const auto sizeOf = [&](const std::string& axis) { return axis[1] == 'X' ? width : height; };
  std::string bytes = header("", first + " " + std::to_string(sizeOf(first)) + " " + second + " " +
                                     std::to_string(sizeOf(second)));
  for (int i = 0; i < sizeOf(first); ++i) {
    Scanline scanline;
    for (int j = 0; j < sizeOf(second); ++j) {
      const int a = first[0] == '+' ? i : sizeOf(first) - 1 - i;
      const int b = second[0] == '+' ? j : sizeOf(second) - 1 - j;
      const int x = first[1] == 'X' ? a : b, y = first[1] == 'X' ? b : a;
      scanline.push_back(somePixel(x, height - 1 - y));
    }
    bytes += encode(scanline);
  }
  return bytes;
}

void checkPicture(const ImageFile& file, int width, int height) {
  REQUIRE(file.image.width == width);
  REQUIRE(file.image.height == height);
  CHECK(file.format == "Radiance HDR");
  int wrong = 0;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      wrong += file.image.at(column, row) != decoded(somePixel(column, row));
  CHECK(wrong == 0);
}

/// One scanline of `count` equal pixels of value (1, 1, 1).
std::string whiteFile(const std::string& headerLines, int count = 1) {
  return header(headerLines, "-Y 1 +X " + std::to_string(count)) +
         flat(Scanline(count, Rgbe{128, 128, 128, 129}));
}

}  // namespace

TEST_CASE("a Radiance picture is the same in every orientation and encoding") {
  const std::vector<std::function<std::string(const Scanline&)>> encodings{flat, oldEncoding,
                                                                           newEncoding};
  for (const auto& encode : encodings)
    for (const std::string y : {"+Y", "-Y"})
      for (const std::string x : {"+X", "-X"}) {
        CAPTURE(y + " " + x);
        checkPicture(readBytes(fileWithAxes(y, x, 11, 9, encode)), 11, 9);
        checkPicture(readBytes(fileWithAxes(x, y, 11, 9, encode)), 11, 9);
      }
}

TEST_CASE("Radiance runs longer than a byte can count") {
  checkPicture(readBytes(fileWithAxes("-Y", "+X", 900, 3, oldEncoding)), 900, 3);
  checkPicture(readBytes(fileWithAxes("-Y", "+X", 900, 3, newEncoding)), 900, 3);
}

TEST_CASE("Radiance encodings may change from scanline to scanline") {
  int scanline = 0;
  checkPicture(readBytes(fileWithAxes("-Y", "+X", 40, 9,
                                      [&](const Scanline& pixels) {
                                        const int kind = scanline++ % 3;
                                        return kind == 0   ? newEncoding(pixels)
                                               : kind == 1 ? flat(pixels)
                                                           : oldEncoding(pixels);
                                      })),
               40, 9);
}

TEST_CASE("narrow Radiance pictures are flat even when they look encoded") {
  const std::string bytes = header("", "-Y 1 +X 2") + flat({Rgbe{2, 2, 0, 2}, Rgbe{9, 9, 9, 0}});
  const Image image = readBytes(bytes).image;
  CHECK(image.at(0, 0) == decoded({2, 2, 0, 2}));
  CHECK(image.at(1, 0) == glm::vec3(0.0f));
}

TEST_CASE("exposure and colour correction of a Radiance header are divided out") {
  const ImageFile file = readBytes(
      whiteFile("EXPOSURE=2\nEXPOSURE= 4.0\nCOLORCORR= 1 2 0.5\nVIEW= -vp 1 2 3\n# a note\n"));
  CHECK(file.image.at(0, 0) == glm::vec3(1 / 8.0f, 1 / 16.0f, 1 / 4.0f));
  CHECK(file.exposure == glm::dvec3(8, 16, 4));
  REQUIRE(file.attributes.size() == 5);
  CHECK(file.attributes[3] == std::pair<std::string, std::string>("VIEW", "-vp 1 2 3"));
  CHECK(contains(readErrorOf(whiteFile("EXPOSURE=0\n")), "header line 2 needs 1 positive number"));
  CHECK(contains(readErrorOf(whiteFile("EXPOSURE=nan\n")), "positive number"));
  CHECK(contains(readErrorOf(whiteFile("COLORCORR=1 2\n")), "needs 3 positive numbers"));
  CHECK(contains(readErrorOf(whiteFile("EXPOSURE=1e-300\n")), "not a finite number"));
}

TEST_CASE("Radiance XYZ pictures become RGB") {
  // White of Rec. 709, D65: XYZ (0.9505, 1, 1.0891); mantissas over 128 with exponent 0.
  const std::string bytes =
      "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + flat({Rgbe{122, 128, 139, 129}});
  const glm::vec3 white = readBytes(bytes).image.at(0, 0);
  for (int c = 0; c < 3; ++c) CHECK(white[c] == doctest::Approx(1).epsilon(0.01));
  // XYZ (0, 1, 0) has negative red and blue (IEC 61966-2-1: −1.5372, 1.8758, −0.2040).
  const ImageFile green =
      readBytes("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + flat({Rgbe{0, 128, 0, 129}}));
  CHECK(green.image.at(0, 0).g == doctest::Approx(1.8758).epsilon(1e-3));
  CHECK(green.image.at(0, 0).r == 0);
  REQUIRE(green.warnings.size() == 1);
  CHECK(contains(green.warnings[0],
                 "negative values in 1 of 1 pixels, the first at (column 0, row 0"));
}

TEST_CASE("Radiance headers that other programs write") {
  const std::string pixel = flat({Rgbe{128, 128, 128, 129}});
  for (const std::string start :
       {"#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n", "#?RADIANCE\n\n", "#?RGBE\n\n",
        "#?AUTOPANO\nFORMAT=32-bit_rle_rgbe\n\n", "#?RADIANCE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n",
        "#?RADIANCE\npfilt -x 4\n\tEXPOSURE=9\nFORMAT=32-bit_rle_rgbe\n\n"}) {
    CAPTURE(start);
    CHECK(readBytes(start + "-Y 1 +X 1\n" + pixel).image.at(0, 0) == glm::vec3(1.0f));
  }
  CHECK(contains(readErrorOf("#?OTHER\n\n-Y 1 +X 1\n" + pixel), "neither a FORMAT line"));
  CHECK(contains(readErrorOf("#?RGBE\nFORMAT=16-bit\n\n-Y 1 +X 1\n" + pixel),
                 "header line 2 says FORMAT=16-bit"));
}

TEST_CASE("damaged Radiance files are refused with the place") {
  const std::string start = header("", "-Y 2 +X 8");
  const std::string good = fileWithAxes("-Y", "+X", 8, 2, newEncoding);
  for (std::size_t length = 0; length < good.size(); ++length)
    CHECK(contains(readErrorOf(good.substr(0, length)), "cannot read image"));
  CHECK(contains(readErrorOf(good.substr(0, good.size() - 1)), "scanline 1, byte "));
  CHECK(contains(readErrorOf(""), "the file is empty"));
  CHECK(contains(readErrorOf("P6 2 2 255\n"), "neither a Radiance HDR nor an OpenEXR image"));
  const std::string runs = start + std::string{1, 1, 1, 5} + std::string(100, 7);
  CHECK(contains(readErrorOf(runs), "a run does not fit"));
  const std::string wrongLength = start + std::string{2, 2, 0, 9} + std::string(100, 1);
  CHECK(contains(readErrorOf(wrongLength), "its length is not the image's"));
  const std::string longRun =
      start + std::string{2, 2, 0, 8, char(128 + 9), 1} + std::string(99, 1);
  CHECK(contains(readErrorOf(longRun), "a run does not fit"));
  const std::string emptyRun = start + std::string{2, 2, 0, 8, 0} + std::string(99, 0);
  CHECK(contains(readErrorOf(emptyRun), "a run does not fit"));
}

TEST_CASE("Radiance sizes that the file cannot hold are refused before any memory is taken") {
  const std::string pixels(4000, 7);
  CHECK(contains(readErrorOf(header("", "-Y 1000000000 +X 1000000000") + pixels), "at most 65536"));
  CHECK(contains(readErrorOf(header("", "-Y 60000 +X 60000") + pixels), "at most 65536"));
  CHECK(contains(readErrorOf(header("", "-Y 10000 +X 10000") + pixels), "cannot be in a file of"));
  for (const std::string bad : {"-Y 0 +X 4", "-Y -3 +X 4", "-Y 99999999999999999999 +X 1",
                                "-Y 3 +Y 4", "3 4", "-Y 3", "-Y 3 +X 4 5", "-Y 3x +X 4"})
    CHECK(contains(readErrorOf(header("", bad) + pixels), "header line 4"));
}

TEST_CASE("real probes read as stb_image reads them") {
  for (const std::string name : {"probes/grace.hdr", "probes/uffizi.hdr"}) {
    const auto path = testData(name);
    if (!path) return;
    int width = 0, height = 0, components = 0;
    const std::unique_ptr<float, void (*)(void*)> expected(
        stbi_loadf(path->c_str(), &width, &height, &components, 3), stbi_image_free);
    REQUIRE(expected);
    const Image image = readImage(*path).image;
    REQUIRE(image.width == width);
    REQUIRE(image.height == height);
    const float* values = &image.pixels[0].x;
    CHECK(std::equal(values, values + 3 * image.pixels.size(), expected.get()));
  }
}

}  // namespace haarlight::test
