#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include "image/write_image.h"

#include <stb_image.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <memory>

#include "image_test_support.h"

namespace haarlight::test {

TEST_CASE("a PNG holds the sRGB values of the image") {
  Image image(2, 2);
  // 0.5 encodes to 1.055·0.5^(1/2.4) − 0.055 = 0.73536 (187.5), 0.2 to 0.48453 (123.6),
  // 0.001 to 0.01292 (3.3), 0.18 to 0.46136 (117.6).
  image.at(0, 0) = {0, 0.5f, 1};
  image.at(1, 0) = {0.2f, 0.001f, 0.18f};
  image.at(0, 1) = {-1, 7, std::nanf("")};
  image.at(1, 1) = {1, 0, 0};
  const TemporaryFolder folder;
  writePng(folder / "a.png", image);
  int width = 0, height = 0, components = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load((folder / "a.png").c_str(), &width, &height, &components, 0), stbi_image_free);
  REQUIRE(pixels);
  REQUIRE(width == 2);
  REQUIRE(height == 2);
  REQUIRE(components == 3);
  const std::array<int, 12> expected{0, 188, 255, 124, 3, 118, 0, 255, 0, 255, 0, 0};
  for (int i = 0; i < 12; ++i) CHECK(int(pixels.get()[i]) == expected[i]);
  const auto bytes = encodePng(image);
  CHECK(std::string(bytes.begin(), bytes.end()) == readFile(folder / "a.png"));
}

TEST_CASE("what cannot be written is said and leaves nothing") {
  const Image image(3, 2);
  const TemporaryFolder folder;
  for (const auto& path :
       {std::filesystem::path("/dev/full"), folder / "missing/x", folder.path()}) {
    CAPTURE(path);
    CHECK(contains(inputErrorOf([&] { writePng(path, image); }), "cannot write"));
    CHECK(contains(inputErrorOf([&] { writeExr(path, {{"", image}}); }), "cannot write"));
  }
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("layers to write must have one size") {
  const Image small(2, 2), large(3, 2), empty;
  const TemporaryFolder folder;
  CHECK_THROWS_AS(writeExr(folder / "x", {{"", small}, {"b", large}}), std::invalid_argument);
  CHECK_THROWS_AS(writeExr(folder / "x", {{"", empty}}), std::invalid_argument);
  CHECK_THROWS_AS(writePng(folder / "x", empty), std::invalid_argument);
  CHECK_THROWS_AS(encodePng(empty), std::invalid_argument);
}

}  // namespace haarlight::test
