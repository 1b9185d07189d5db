#include "verify/cases/random_cases.h"

#include <array>

#include "verify/cases/random_binding.h"
#include "verify/cases/random_spheres.h"

namespace haarlight::verify {

namespace {

constexpr int receiverCount = 4;
/// The first receivers stand on a grid, so that vectors from them can be exact.
constexpr int gridReceiverCount = 2;

glm::vec3 gridPoint(PortableRandom& random) {
  const auto coordinate = [&] { return float(random.below(257) - 128) / 64; };
  return {coordinate(), coordinate(), coordinate()};
}

glm::vec3 randomNormal(PortableRandom& random) {
  switch (random.below(4)) {
    case 0:
      return {0, 1, 0};
    case 1:
      return randomAxis(random);
    default:
      return randomDirection(random);
  }
}

/// Every other receiver lies exactly in the plane y = 0.
Receivers randomReceivers(PortableRandom& random, bool startAtOrigin) {
  Receivers receivers;
  for (int i = 0; i < receiverCount; ++i) {
    glm::vec3 position =
        i < gridReceiverCount
            ? gridPoint(random)
            : glm::vec3{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
    if (i % 2) position.y = 0;
    if (i == 0 && startAtOrigin) position = glm::vec3(0);
    receivers.add(position, randomNormal(random));
  }
  return receivers;
}

/// Two tiles on a grid around a place, which all look the same way, as on a surface that is finely
/// sampled.
Receivers closeReceivers(PortableRandom& random) {
  constexpr int count = 32, reach = 8;
  Receivers receivers;
  const glm::vec3 middle = gridPoint(random), normal = randomNormal(random);
  const auto offset = [&] { return float(random.below(2 * reach + 1) - reach) / 64; };
  for (int i = 0; i < count; ++i)
    receivers.add(middle + glm::vec3(offset(), offset(), offset()), normal);
  return receivers;
}

/// Often few, so that a case is quick; at times the counts around the sizes of groups.
int randomSphereCount(PortableRandom& random) {
  constexpr std::array special{1, 31, 32, 33, 64, 255, 256};
  return random.below(6) ? 1 + random.below(59)
                         : special[std::size_t(random.below(special.size()))];
}

Viewpoint viewpoint(const Receivers& receivers, int index) {
  return {receivers.positions[std::size_t(index)], receivers.normals[std::size_t(index)]};
}

enum class CaseKind { any, close, bounds, far, denormals };

/// Of every eight cases one has receivers close together; one nothing but small spheres on bounds,
/// which do not hide one another as others do; one close receivers and spheres that are far, for
/// the most part; and one spheres at denormal distances.
CaseKind kindOf(std::size_t index) {
  switch (index % 8) {
    case 3:
      return CaseKind::close;
    case 5:
      return CaseKind::bounds;
    case 6:
      return CaseKind::far;
    case 7:
      return CaseKind::denormals;
    default:
      return CaseKind::any;
  }
}

Receivers receiversFor(CaseKind kind, PortableRandom& random) {
  if (kind == CaseKind::close || kind == CaseKind::far) return closeReceivers(random);
  return randomReceivers(random, kind != CaseKind::any || random.below(2));
}

Sphere randomSphere(PortableRandom& random, const Case& before, CaseKind kind) {
  const int count = int(before.spheres.size());
  if (kind == CaseKind::bounds) return smallSphereOnBound(random, before.receivers.normals[0]);
  if (kind == CaseKind::close && random.below(8)) {
    Sphere sphere =
        ordinarySphere(random, viewpoint(before.receivers, random.below(receiverCount)));
    sphere.radius *= 0.3f;  // so that the first ones do not block everything
    return sphere;
  }
  if (kind == CaseKind::far && random.below(4))
    return farSphere(random, viewpoint(before.receivers, random.below(receiverCount)));
  if (kind == CaseKind::denormals && (count == 0 || random.below(4) == 0))
    return denormalSphere(random);
  if (count > 0 && random.below(12) == 0) return before.spheres[std::size_t(random.below(count))];
  if (random.below(3) == 0)
    return alignedSphere(random, viewpoint(before.receivers, random.below(gridReceiverCount)));
  return anySphere(random, viewpoint(before.receivers, random.below(receiverCount)));
}

}  // namespace

std::uint64_t PortableRandom::next() {
  state_ += 0x9e3779b97f4a7c15;
  std::uint64_t bits = state_;
  bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ bits >> 27) * 0x94d049bb133111eb;
  return bits ^ bits >> 31;
}

float PortableRandom::uniform(float low, float high) {
  const float value = low + float(next() >> 40) * 0x1p-24f * (high - low);
  return value < high ? value : low;  // the sum may be rounded up to `high`
}

int PortableRandom::below(int count) {
  return int((next() >> 32) * std::uint64_t(count) >> 32);
}

Case randomCase(std::uint64_t seed, std::size_t index) {
  // Hashed, since the generator's states for neighbouring cases would follow one another.
  PortableRandom random(PortableRandom(seed).next() ^ PortableRandom(~index).next());
  const CaseKind kind = kindOf(index);
  Case result;
  result.name = "random " + std::to_string(index);
  result.receivers = receiversFor(kind, random);
  // Close receivers need many spheres, so that some are hidden from all of them.
  const int count = kind == CaseKind::close ? 96 + random.below(161) : randomSphereCount(random);
  while (int(result.spheres.size()) < count)
    result.spheres.push_back(randomSphere(random, result, kind));
  result.light = randomLight(random.next());
  addRandomBinding(random, kind == CaseKind::denormals, result);
  result.hasDenormals = involvesDenormals(result);
  return result;
}

RadianceCube randomLight(std::uint64_t seed) {
  PortableRandom random(seed);
  RadianceCube light;
  for (glm::vec3& texel : light.texels) {
    texel = {random.uniform(0, 0.2f), random.uniform(0, 0.3f), random.uniform(0, 0.4f)};
    if (random.below(300) == 0) texel *= random.uniform(10, 10000);
  }
  return light;
}

}  // namespace haarlight::verify
