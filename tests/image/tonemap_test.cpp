#include "image/tonemap.h"

#include "image_test_support.h"

namespace haarlight::test {

TEST_CASE("sRGB transfer function at its fixed points and back") {
  CHECK(srgbFromLinear(0) == 0);
  CHECK(srgbFromLinear(1) == doctest::Approx(1));
  CHECK(srgbFromLinear(0.0031308f) == doctest::Approx(0.04045).epsilon(1e-4));
  CHECK(srgbFromLinear(0.2140411f) == doctest::Approx(0.5));
  for (int byte = 0; byte < 256; ++byte) CHECK(srgbByte(linearFromSrgb(byte / 255.0f)) == byte);
}

TEST_CASE("exposure multiplies by powers of two and clamps") {
  Image image(2, 1);
  image.at(0, 0) = {0.1f, 0.2f, 0.9f};
  image.at(1, 0) = {0, -1, 4};
  const Image brighter = tonemap(image, 1);
  CHECK(brighter.at(0, 0) == glm::vec3(0.2f, 0.4f, 1));
  CHECK(brighter.at(1, 0) == glm::vec3(0, 0, 1));
  CHECK(tonemap(image, -2).at(1, 0).b == 1);
  CHECK(tonemap(image, -3).at(1, 0).b == 0.5f);
}

TEST_CASE("automatic exposure puts the 90th percentile at 0.65") {
  Image ramp(101, 1);
  for (int x = 0; x <= 100; ++x) ramp.at(x, 0) = glm::vec3(float(x + 1));
  CHECK(std::exp2(automaticExposure(ramp)) * 91 == doctest::Approx(0.65));
  Image constant(4, 4);
  for (glm::vec3& pixel : constant.pixels) pixel = glm::vec3(2.6f);
  CHECK(automaticExposure(constant) == doctest::Approx(-2));
  constant.at(0, 0) = glm::vec3(0.0f);  // black does not count
  CHECK(automaticExposure(constant) == doctest::Approx(-2));
  CHECK(automaticExposure(Image(4, 4)) == 0);
  CHECK(automaticExposure(Image()) == 0);
}

}  // namespace haarlight::test
