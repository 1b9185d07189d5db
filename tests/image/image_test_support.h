#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <random>
#include <string>

#include "error_text.h"
#include "image/image.h"
#include "image/read_image.h"
#include "test_support.h"

namespace haarlight::test {

/// Positive values over many orders of magnitude.
inline Image randomImage(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> stops(-20, 20);
  Image image(width, height);
  for (glm::vec3& pixel : image.pixels)
    for (int c = 0; c < 3; ++c) pixel[c] = std::exp2(stops(random));
  return image;
}

/// Writes the bytes to a file and reads it as an image.
inline ImageFile readBytes(const std::string& bytes) {
  const TemporaryFolder folder;
  writeFile(folder / "image", bytes);
  return readImage(folder / "image");
}

inline std::string readErrorOf(const std::string& bytes) {
  return inputErrorOf([&] { readBytes(bytes); });
}

}  // namespace haarlight::test
