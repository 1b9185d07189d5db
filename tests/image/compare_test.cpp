#include "image/compare.h"

#include <cstdint>
#include <vector>

#include "image/tonemap.h"
#include "image_test_support.h"

namespace haarlight::test {

namespace {

Image constantImage(int width, int height, float value) {
  Image image(width, height);
  for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(value);
  return image;
}

}  // namespace

TEST_CASE("image error by hand") {
  const Image reference = constantImage(2, 2, 2);
  Image image = reference;
  image.at(1, 0) += glm::vec3(1, 0, 0);
  image.at(0, 1) -= glm::vec3(0, 3, 0);
  const ImageError error = compareImages(image, reference);
  CHECK(error.pixelCount == 4);
  CHECK(error.rootMeanSquare == doctest::Approx(std::sqrt(10.0 / 12)));
  CHECK(error.referenceMean == doctest::Approx(2));
  CHECK(error.relativeRootMeanSquare == doctest::Approx(std::sqrt(10.0 / 12) / 2));
  CHECK(error.maximum == 3);
  CHECK(error.maximumPixel == glm::ivec2(0, 1));
}

TEST_CASE("a mask selects the pixels compared") {
  const Image reference = constantImage(2, 1, 1);
  Image image = reference;
  image.at(0, 0) = glm::vec3(9.0f);
  image.at(1, 0) = glm::vec3(1.5f);
  const std::vector<std::uint8_t> second{0, 1}, none{0, 0};
  const ImageError error = compareImages(image, reference, second);
  CHECK(error.pixelCount == 1);
  CHECK(error.rootMeanSquare == doctest::Approx(0.5));
  CHECK(error.maximumPixel == glm::ivec2(1, 0));
  CHECK(contains(inputErrorOf([&] { compareImages(image, reference, none); }), "no pixel"));
}

TEST_CASE("comparing with black and comparing different sizes") {
  const Image black(2, 2);
  CHECK(compareImages(black, black).relativeRootMeanSquare == 0);
  CHECK(std::isinf(compareImages(constantImage(2, 2, 1), black).relativeRootMeanSquare));
  CHECK(contains(inputErrorOf([&] { compareImages(black, Image(2, 3)); }), "2×2 and 2×3"));
  CHECK(contains(inputErrorOf([&] { differenceImage(black, Image(2, 3)); }), "2×2 and 2×3"));
}

TEST_CASE("the colour map is matplotlib's inferno") {
  // First, middle and last entry of the published table, in sRGB.
  const std::vector<std::pair<float, glm::vec3>> table{{0.0f, {0.001f, 0.000f, 0.014f}},
                                                       {0.5f, {0.736f, 0.216f, 0.330f}},
                                                       {1.0f, {0.988f, 0.998f, 0.645f}}};
  for (const auto& [value, expected] : table)
    for (int c = 0; c < 3; ++c)
      CHECK(std::abs(srgbFromLinear(infernoColor(value)[c]) - expected[c]) < 0.02);
}

TEST_CASE("the difference image shows the largest channel's difference, scaled") {
  Image image(3, 1);
  image.at(1, 0) = {0, -0.25f, 0.1f};
  image.at(2, 0) = {0, 7, 0};
  const Image difference = differenceImage(image, Image(3, 1), 2);
  CHECK(difference.at(0, 0) == infernoColor(0));
  CHECK(difference.at(1, 0) == infernoColor(0.5f));
  CHECK(difference.at(2, 0) == infernoColor(1));
}

}  // namespace haarlight::test
