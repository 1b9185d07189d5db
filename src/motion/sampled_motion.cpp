#include "motion/sampled_motion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace haarlight {

SampledMotion::SampledMotion(std::size_t vertexCount, std::vector<double> seconds)
    : vertexCount_(vertexCount), seconds_(std::move(seconds)) {}

std::vector<glm::vec3> SampledMotion::positions(double seconds) {
  const double moment = seconds > 0 ? std::min(seconds, duration()) : 0;
  const auto after = std::ranges::upper_bound(seconds_, moment);
  const auto frame = std::size_t(after - seconds_.begin()) - 1;
  const std::vector<glm::vec3>& from = keptFrame(frame);
  if (moment == seconds_[frame]) return from;
  const std::vector<glm::vec3>& to = keptFrame(frame + 1);
  const double part = (moment - seconds_[frame]) / (*after - seconds_[frame]);
  std::vector<glm::vec3> result(vertexCount_);
  for (std::size_t i = 0; i < vertexCount_; ++i)
    result[i] = glm::dvec3(from[i]) + part * (glm::dvec3(to[i]) - glm::dvec3(from[i]));
  return result;
}

const std::vector<glm::vec3>& SampledMotion::keptFrame(std::size_t frame) {
  KeptFrame& kept = kept_[frame % 2];
  if (kept.number != frame) kept = {frame, readFrame(frame)};
  return kept.positions;
}

std::vector<double> evenSeconds(std::size_t count, double step, double framesPerSecond) {
  std::vector<double> seconds(count);
  for (std::size_t i = 0; i < count; ++i) seconds[i] = double(i) * step / framesPerSecond;
  const bool increasing = step > 0 && framesPerSecond > 0 && step / framesPerSecond > 0;
  if (!increasing || !std::isfinite(seconds.back()))
    throw std::invalid_argument("frames need a step and a rate above 0");
  return seconds;
}

}  // namespace haarlight
