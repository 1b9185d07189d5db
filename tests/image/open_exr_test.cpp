#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>
#include <half.h>

#include <array>
#include <cstring>
#include <limits>

#include "image/write_image.h"
#include "image_test_support.h"

namespace haarlight::test {

namespace {

template <typename Value>
constexpr Imf::PixelType pixelType = Imf::FLOAT;
template <>
constexpr Imf::PixelType pixelType<half> = Imf::HALF;
template <>
constexpr Imf::PixelType pixelType<unsigned> = Imf::UINT;

/// Writes `channels.size()` channels, channel k of pixel i having the value k + 4·i.
template <typename Value>
std::string fileWithChannels(Imf::Header header, const std::vector<std::string>& channels,
                             bool tiled = false) {
  const Imath::Box2i window = header.dataWindow();
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  std::vector<std::vector<Value>> values(channels.size());
  Imf::FrameBuffer frame;
  for (std::size_t k = 0; k < channels.size(); ++k) {
    for (int i = 0; i < width * height; ++i) values[k].push_back(Value(float(k + 4 * i)));
    header.channels().insert(channels[k], Imf::Channel(pixelType<Value>));
    frame.insert(channels[k], Imf::Slice::Make(pixelType<Value>, values[k].data(), window));
  }
  const TemporaryFolder folder;
  const std::string path = (folder / "image.exr").string();
  if (tiled) {
    header.setTileDescription(Imf::TileDescription(4, 4));
    Imf::TiledOutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  } else {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(height);
  }
  return readFile(path);
}

/// Red, green, blue of pixel i are first + 4·i, +1, +2 (or all first + 4·i).
void checkValues(const Image& image, int width, int height, float first, bool grey = false) {
  REQUIRE(image.width == width);
  REQUIRE(image.height == height);
  for (int i = 0; i < width * height; ++i) {
    const float value = first + 4.0f * i;
    CHECK(image.pixels[i] == (grey ? glm::vec3(value) : glm::vec3(value, value + 1, value + 2)));
  }
}

std::string deepFile() {
  Imf::Header header(2, 2);
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  header.channels().insert("R", Imf::Channel(Imf::FLOAT));
  const TemporaryFolder folder;
  const std::string path = (folder / "deep.exr").string();
  {
    std::vector<unsigned> counts(4, 0);
    std::vector<float*> samples(4, nullptr);
    Imf::DeepFrameBuffer frame;
    frame.insertSampleCountSlice(
        Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()), 4, 8));
    frame.insert("R",
                 Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(samples.data()), 8, 16, 4));
    Imf::DeepScanLineOutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(2);
  }
  return readFile(path);
}

std::string exrBytes(const Image& image) {
  const TemporaryFolder folder;
  writeExr(folder / "image.exr", {{"", image}});
  return readFile(folder / "image.exr");
}

/// The same file with another data window in its header.
std::string withDataWindow(std::string bytes, std::array<std::int32_t, 4> window) {
  const std::string name("dataWindow\0box2i\0\x10\0\0\0", 21);
  const std::size_t at = bytes.find(name);
  REQUIRE(at != std::string::npos);
  std::memcpy(bytes.data() + at + name.size(), window.data(), 16);
  return bytes;
}

}  // namespace

TEST_CASE("OpenEXR keeps every float32 bit") {
  Image image = randomImage(37, 19, 1);
  image.at(0, 0) = {0.0f, std::numeric_limits<float>::denorm_min(),
                    std::numeric_limits<float>::max()};
  const ImageFile file = readBytes(exrBytes(image));
  REQUIRE(file.image.pixels.size() == image.pixels.size());
  CHECK(std::memcmp(file.image.pixels.data(), image.pixels.data(),
                    image.pixels.size() * sizeof(glm::vec3)) == 0);
  CHECK(file.format == "OpenEXR");
  CHECK(file.exposure == glm::dvec3(1.0));
  CHECK(file.warnings.empty());
}

TEST_CASE("OpenEXR layers and attributes come back") {
  const Image beauty = randomImage(5, 4, 2), albedo = randomImage(5, 4, 3);
  const TemporaryFolder folder;
  writeExr(folder / "a.exr", {{"", beauty}, {"albedo", albedo}},
           {{"method", "triple"}, {"terms", 96}, {"scale", 0.5f}});
  const ImageFile file = readImage(folder / "a.exr");
  CHECK(file.image.pixels == beauty.pixels);
  CHECK(file.channels ==
        std::vector<std::string>{"B", "G", "R", "albedo.B", "albedo.G", "albedo.R"});
  std::map<std::string, std::string> attributes(file.attributes.begin(), file.attributes.end());
  CHECK(attributes["method"] == "triple");
  CHECK(attributes["terms"] == "96");
  CHECK(attributes["scale"] == "0.5");
  writeExr(folder / "b.exr", {{"albedo", albedo}});
  CHECK(readImage(folder / "b.exr").image.pixels == albedo.pixels);
  CHECK(contains(inputErrorOf([&] {
                   writeExr(folder / "c.exr", {{"", beauty}}, {{"compression", 1}});
                 }),
                 "attribute compression has a fixed meaning"));
  CHECK_FALSE(std::filesystem::exists(folder / "c.exr"));
}

TEST_CASE("OpenEXR pixel types, tiles and channel choices") {
  const Imf::Header header(7, 5);
  const std::vector<std::string> rgb{"R", "G", "B"};
  checkValues(readBytes(fileWithChannels<float>(header, rgb)).image, 7, 5, 0);
  checkValues(readBytes(fileWithChannels<half>(header, rgb)).image, 7, 5, 0);
  checkValues(readBytes(fileWithChannels<unsigned>(header, rgb)).image, 7, 5, 0);
  checkValues(readBytes(fileWithChannels<half>(header, rgb, true)).image, 7, 5, 0);
  checkValues(readBytes(fileWithChannels<half>(header, {"A", "R", "G", "B"})).image, 7, 5, 1);
  checkValues(readBytes(fileWithChannels<float>(header, {"A", "Y"})).image, 7, 5, 1, true);
  checkValues(readBytes(fileWithChannels<float>(header, {"l.R", "l.G", "l.B"})).image, 7, 5, 0);
  const std::vector<std::string> layers{"x.Z", "b.R", "b.G", "b.B", "c.R", "c.G", "c.B"};
  checkValues(readBytes(fileWithChannels<float>(header, layers)).image, 7, 5, 1);
}

TEST_CASE("the first part with colour of a multi-part OpenEXR file is read") {
  const std::vector<std::string> parts{"Z", "Y"};
  std::vector<Imf::Header> headers(2, Imf::Header(3, 2));
  const std::vector<float> values{0, 4, 8, 12, 16, 20};
  const TemporaryFolder folder;
  const std::string path = (folder / "parts.exr").string();
  for (int i = 0; i < 2; ++i) {
    headers[i].setName(parts[i]);
    headers[i].setType(Imf::SCANLINEIMAGE);
    headers[i].channels().insert(parts[i], Imf::Channel(Imf::FLOAT));
  }
  {
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), 2);
    for (int i = 0; i < 2; ++i) {
      Imf::FrameBuffer frame;
      frame.insert(parts[i], Imf::Slice::Make(Imf::FLOAT, values.data(), headers[i].dataWindow()));
      Imf::OutputPart part(file, i);
      part.setFrameBuffer(frame);
      part.writePixels(2);
    }
  }
  checkValues(readImage(path).image, 3, 2, 0, true);
}

TEST_CASE("the OpenEXR data window is the image") {
  const Imath::Box2i display({0, 0}, {9, 9}), data({-2, 3}, {4, 7});
  const Imf::Header header(display, data);
  checkValues(readBytes(fileWithChannels<float>(header, {"R", "G", "B"})).image, 7, 5, 0);
  checkValues(readBytes(fileWithChannels<float>(header, {"R", "G", "B"}, true)).image, 7, 5, 0);
}

TEST_CASE("OpenEXR primaries other than Rec. 709 are converted") {
  Imf::Header header(1, 1);
  // Primaries of Rec. 709 in another order: red is what the file calls green.
  const Imf::Chromaticities rec709;
  Imf::addChromaticities(header,
                         Imf::Chromaticities(rec709.green, rec709.red, rec709.blue, rec709.white));
  const glm::vec3 pixel =
      readBytes(fileWithChannels<float>(header, {"R", "G", "B"})).image.at(0, 0);
  CHECK(pixel.r == doctest::Approx(1));
  CHECK(pixel.g == doctest::Approx(0).epsilon(1e-5));
  CHECK(pixel.b == doctest::Approx(2));
}

TEST_CASE("OpenEXR files without usable colour are refused") {
  const Imf::Header header(2, 2);
  CHECK(contains(readErrorOf(fileWithChannels<float>(header, {"Z", "R"})),
                 "it has no channels R, G, B or Y alone, only R, Z"));
  CHECK(
      contains(readErrorOf(fileWithChannels<float>(header, {"Y", "RY", "BY"})), "only BY, RY, Y"));
  CHECK(contains(readErrorOf(deepFile()), "deep OpenEXR images are not supported"));
}

TEST_CASE("NaN, infinite and negative OpenEXR pixels") {
  Image image = randomImage(6, 5, 4);
  image.at(4, 2).g = std::numeric_limits<float>::quiet_NaN();
  image.at(1, 3).r = std::numeric_limits<float>::infinity();
  CHECK(contains(readErrorOf(exrBytes(image)), "pixel (column 4, row 2) is not a finite number"));
  image.at(4, 2).g = 1;
  CHECK(contains(readErrorOf(exrBytes(image)), "pixel (column 1, row 3) is not a finite number"));
  image.at(1, 3) = {-1, 2, -0.5};
  image.at(5, 4) = {1, 2, -3};
  const ImageFile file = readBytes(exrBytes(image));
  CHECK(file.image.at(1, 3) == glm::vec3(0, 2, 0));
  CHECK(file.image.at(5, 4) == glm::vec3(1, 2, 0));
  REQUIRE(file.warnings.size() == 1);
  CHECK(contains(file.warnings[0],
                 "negative values in 2 of 30 pixels, the first at (column 1, row 3)"));
}

TEST_CASE("damaged OpenEXR files are refused") {
  const std::string bytes = exrBytes(randomImage(16, 40, 5));
  for (std::size_t length = 1; length < bytes.size(); length += length < 400 ? 7 : 211)
    CHECK(contains(readErrorOf(bytes.substr(0, length)), "cannot read image"));
  CHECK(contains(readErrorOf(std::string("\x76\x2f\x31\x01", 4) + std::string(500, 'x')),
                 "damaged or not supported"));
}

TEST_CASE("changed bytes in an OpenEXR file do no harm") {
  const std::string bytes = exrBytes(randomImage(16, 12, 6));
  std::mt19937 random(7);
  for (int round = 0; round < 400; ++round) {
    std::string changed = bytes;
    const std::size_t range = round % 2 ? changed.size() : 400;
    for (int i = 0; i < 3; ++i) changed[random() % range] = char(random());
    const std::string message = readErrorOf(changed);  // any other exception fails the test
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("OpenEXR sizes that the file cannot hold are refused before any memory is taken") {
  const std::string bytes = exrBytes(randomImage(4, 4, 8));
  for (const std::array<std::int32_t, 4> window :
       {std::array{0, 0, 999999999, 999999999}, std::array{0, 0, 59999, 39999},
        std::array{0, 0, 65535, 3}, std::array{0, 0, 3, 999999999}, std::array{5, 5, 0, 0},
        std::array{INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX}})
    CHECK(contains(readErrorOf(withDataWindow(bytes, window)), "cannot read image"));
}

}  // namespace haarlight::test
