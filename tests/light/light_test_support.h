#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>
#include <string>

#include "base/error.h"
#include "image/image.h"
#include "test_support.h"

namespace haarlight::test {

inline glm::mat3 randomRotation(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return glm::mat3_cast(
      glm::normalize(glm::quat(normal(random), normal(random), normal(random), normal(random))));
}

/// The message of the InputError that `action` throws; empty when it throws none.
template <typename Action>
std::string inputErrorOf(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace haarlight::test
