#include "transfer/cosine_directions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

namespace haarlight {

namespace {

/// Place along Morton's curve of a point of [−1, 1]².
std::uint32_t mortonCode(const glm::vec2& point) {
  std::uint32_t code = 0;
  const auto x = static_cast<std::uint32_t>((point.x + 1) * 32767);
  const auto y = static_cast<std::uint32_t>((point.y + 1) * 32767);
  for (int bit = 0; bit < 16; ++bit)
    code |= (x >> bit & 1) << 2 * bit | (y >> bit & 1) << (2 * bit + 1);
  return code;
}

}  // namespace

CosineDirections::CosineDirections(int count) {
  if (count < 1) throw std::invalid_argument("a set of directions needs at least one");
  constexpr double goldenAngle = 2 * std::numbers::pi * (2 - std::numbers::phi);
  for (int i = 0; i < count; ++i) {
    const double angle = goldenAngle * i;
    points_.push_back({{std::cos(angle), std::sin(angle)}, static_cast<float>(i)});
  }
  std::ranges::stable_sort(points_, {}, [&](const Point& point) {
    return mortonCode(std::sqrt((point.rank + 0.5f) / static_cast<float>(count)) * point.azimuth);
  });
}

void CosineDirections::about(const glm::vec3& axis, float turn, float shift,
                             std::span<glm::vec3> directions) const {
  // A frame without a case that loses digits: Duff et al. 2017.
  const float sign = std::copysign(1.0f, axis.z), a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
  const glm::vec3 first(1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
  const glm::vec3 second(b, sign + axis.y * axis.y * a, -axis.y);
  const double angle = 2 * std::numbers::pi * turn;
  const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  const float perPoint = 1 / static_cast<float>(count());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto& [azimuth, rank] = points_[i];
    const float squaredRadius = std::min((rank + shift) * perPoint, 1.0f);
    const float radius = std::sqrt(squaredRadius);
    directions[i] = radius * (c * azimuth.x - s * azimuth.y) * first +
                    radius * (s * azimuth.x + c * azimuth.y) * second +
                    std::sqrt(1 - squaredRadius) * axis;
  }
}

}  // namespace haarlight
