#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace haarlight {

/// A linear RGB image (Rec. 709 primaries), float32, row by row from the top-left pixel.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;

  Image() = default;
  Image(int imageWidth, int imageHeight)
      : width(imageWidth), height(imageHeight), pixels(std::size_t(imageWidth) * imageHeight) {}

  glm::vec3& at(int x, int y) { return pixels[std::size_t(y) * width + x]; }
  const glm::vec3& at(int x, int y) const { return pixels[std::size_t(y) * width + x]; }
};

}  // namespace haarlight
