#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>
#include <string>

#include "error_text.h"
#include "image/image.h"
#include "test_support.h"

namespace haarlight::test {

inline glm::mat3 randomRotation(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return glm::mat3_cast(
      glm::normalize(glm::quat(normal(random), normal(random), normal(random), normal(random))));
}

}  // namespace haarlight::test
