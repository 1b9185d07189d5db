#include "verify/cases/random_cases.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>

#include "base/file.h"
#include "visibility/sphere_bin.h"

using namespace haarlight;
using namespace haarlight::verify;

namespace {

template <typename Value>
std::uint64_t hashOfValues(const std::vector<Value>& values) {
  return checksum(
      {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(Value)});
}

/// Of everything that is drawn; lobes follow from the normals.
std::uint64_t hashOfCase(const Case& value) {
  return hashOfValues(std::vector<std::uint64_t>{
      hashOfValues(value.spheres), hashOfValues(value.receivers.positions),
      hashOfValues(value.receivers.normals), hashOfValues(value.light.texels),
      hashOfValues(value.vertices), hashOfValues(value.binding.listStarts),
      hashOfValues(value.binding.vertices), hashOfValues(value.binding.weights),
      hashOfValues(value.binding.radiusFactors)});
}

/// A sphere as a receiver sees it; doubles hold all float32 differences of everyday numbers.
struct Sight {
  glm::dvec3 toCenter;
  double radius, distance, height;
};

Sight sightOf(const Sphere& sphere, const Receivers& receivers, std::size_t i) {
  const glm::dvec3 d = glm::dvec3(sphere.center) - glm::dvec3(receivers.positions[i]);
  const glm::dvec3 n(receivers.normals[i]);
  return {d, sphere.radius, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z),
          d.x * n.x + d.y * n.y + d.z * n.z};
}

/// How many components have the greatest magnitude, and how many are 0.
int ties(const glm::dvec3& d) {
  const double most = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  return (std::abs(d.x) == most) + (std::abs(d.y) == most) + (std::abs(d.z) == most);
}
int zeros(const glm::dvec3& d) {
  return (d.x == 0) + (d.y == 0) + (d.z == 0);
}

/// Whether s and t are odd (centres) or even (borders) 32nds of the face.
bool isOnTexelPlace(const glm::dvec3& d, int parity) {
  const FacePoint place = projectToCube(d);
  const auto fits = [&](double coordinate) {
    const double whole = coordinate * 32;
    return whole == std::round(whole) && (int(whole) & 1) == parity;
  };
  return fits(place.s) && fits(place.t) && zeros(d) == 0;
}

/// Whether the rim of a sphere passes within rounding of the centre of a texel.
bool hasRimThroughTexel(const Sight& s, double radius) {
  if (!(radius < s.distance) || s.distance > 10) return false;
  const double cosine = std::sqrt(1 - radius * radius / (s.distance * s.distance));
  for (int texel = 0; texel < texelCount; ++texel) {
    const glm::dvec3 c = texelDirection(texel), d = s.toCenter;
    const double along = (c.x * d.x + c.y * d.y + c.z * d.z) / s.distance;
    if (std::abs(along - cosine) < 3e-7) return true;
  }
  return false;
}

bool isOnBinBound(const Sight& s) {
  for (int bin = 1; bin < radiusBins; ++bin)
    if (s.radius * s.radius == double(radiusBinBound(bin)) * (s.distance * s.distance)) return true;
  return false;
}

bool isAtBinBound(const Sight& s) {
  const double squared = s.radius * s.radius / (s.distance * s.distance);
  for (int bin = 1; bin < radiusBins; ++bin)
    if (std::abs(squared / double(radiusBinBound(bin)) - 1) < 2e-7) return true;
  return false;
}

bool isNear(double a, double b) {
  return std::abs(a - b) <= 1e-6 * std::abs(b);
}

const std::map<std::string, std::function<bool(const Sight&)>> kinds{
    {"sample on the sphere", [](const Sight& s) { return isNear(s.radius, s.distance); }},
    {"sample a hair inside",
     [](const Sight& s) { return isNear(s.radius, s.distance) && s.radius > s.distance; }},
    {"sample a hair outside",
     [](const Sight& s) { return isNear(s.radius, s.distance) && s.radius < s.distance; }},
    {"tangent plane touches",
     [](const Sight& s) { return isNear(s.radius, s.height) && s.distance < 10; }},
    {"tangent plane touches from below",
     [](const Sight& s) { return isNear(s.radius, -s.height) && s.distance < 10; }},
    {"end of the horizon rule", [](const Sight& s) { return isNear(-4 * s.height, s.distance); }},
    {"within the horizon rule",
     [](const Sight& s) { return s.height < 0 && -4 * s.height < s.distance && s.distance < 10; }},
    {"inside, centre above", [](const Sight& s) { return s.distance < s.radius && s.height > 0; }},
    {"inside, centre below", [](const Sight& s) { return s.distance < s.radius && s.height < 0; }},
    {"centre at the sample", [](const Sight& s) { return s.distance == 0; }},
    {"tiny", [](const Sight& s) { return s.radius < 1e-8 && s.distance > 0.01; }},
    {"huge and far", [](const Sight& s) { return s.radius > 1e4 && s.distance > 1e4; }},
    {"the ground", [](const Sight& s) { return s.radius > 1e4 && isNear(-s.height, s.radius); }},
    {"farther than files allow",
     [](const Sight& s) { return s.distance > 1e13 && s.distance < 2e15; }},
    {"squared distance overflows", [](const Sight& s) { return s.distance > 2e19; }},
    {"squared radius overflows", [](const Sight& s) { return s.radius > 2e19; }},
    {"along an axis", [](const Sight& s) { return zeros(s.toCenter) == 2; }},
    {"along an edge",
     [](const Sight& s) { return zeros(s.toCenter) == 1 && ties(s.toCenter) == 2; }},
    {"along a corner",
     [](const Sight& s) { return zeros(s.toCenter) == 0 && ties(s.toCenter) == 3; }},
    {"on a texel's border", [](const Sight& s) { return isOnTexelPlace(s.toCenter, 0); }},
    {"on a texel's centre", [](const Sight& s) { return isOnTexelPlace(s.toCenter, 1); }},
    {"on a bin's bound", isOnBinBound},
    {"at a denormal square", [](const Sight& s) { return s.distance > 0 && s.distance < 1e-19; }},
    {"at a denormal distance",
     [](const Sight& s) { return s.distance > 0 && s.distance < 1.17e-38; }},
    {"denormal radius", [](const Sight& s) { return s.radius < 1.17e-38; }},
    {"everyday",
     [](const Sight& s) { return s.height > s.radius && s.radius > 0.05 && s.radius < 2; }},
};

/// Whether d² − R² is a number in float32: that infinity less infinity is not, and no engine is
/// asked for it.
bool isDifferenceDefined(const Sphere& sphere, const glm::vec3& position) {
  const glm::vec3 d = sphere.center - position;
  return !std::isnan(((d.x * d.x + d.y * d.y) + d.z * d.z) - sphere.radius * sphere.radius);
}

bool allFinite(const Case& value) {
  const auto finite = [](const auto& v) {
    for (int i = 0; i < v.length(); ++i)
      if (!std::isfinite(v[i])) return false;
    return true;
  };
  bool all = true;
  for (const Sphere& sphere : value.spheres)
    all = all && finite(sphere.center) && std::isfinite(sphere.radius) && sphere.radius > 0;
  for (const glm::vec4& position : value.receivers.positions) all = all && finite(position);
  for (const glm::vec3& texel : value.light.texels) all = all && finite(texel);
  return all;
}

}  // namespace

TEST_CASE("the generator is SplitMix64") {
  // First outputs for seed 1234567, as the author's reference implementation gives them.
  PortableRandom random(1234567);
  for (const std::uint64_t expected :
       {6457827717110365317u, 3203168211198807973u, 9817491932198370423u, 4593380528125082431u})
    CHECK(random.next() == expected);
}

TEST_CASE("numbers keep to their ranges and reach all of them") {
  PortableRandom random(1);
  std::vector<int> counts(7);
  float least = 1, most = -1;
  for (int i = 0; i < 10000; ++i) {
    ++counts[std::size_t(random.below(7))];
    const float value = random.uniform(-0.5f, 0.75f);
    REQUIRE(value >= -0.5f);
    REQUIRE(value < 0.75f);
    least = std::min(least, value);
    most = std::max(most, value);
    REQUIRE(random.uniform(1, std::nextafter(1.0f, 2.0f)) == 1);
  }
  for (const int count : counts) CHECK(std::abs(count - 10000 / 7) < 200);
  CHECK(least < -0.499f);
  CHECK(most > 0.749f);
}

TEST_CASE("the same seed and index give the same case, on every platform") {
  CHECK(hashOfCase(randomCase(1, 3)) == hashOfCase(randomCase(1, 3)));
  CHECK(hashOfCase(randomCase(1, 3)) != hashOfCase(randomCase(1, 4)));
  CHECK(hashOfCase(randomCase(1, 3)) != hashOfCase(randomCase(2, 3)));
  std::vector<std::uint64_t> hashes;
  for (std::size_t index = 0; index < 200; ++index)
    hashes.push_back(hashOfCase(randomCase(1, index)));
  CHECK(hashOfValues(hashes) == 6870703649386430336u);
}

TEST_CASE("every kind of sphere occurs within 200 cases") {
  std::map<std::string, int> found;
  for (std::size_t index = 0; index < 200; ++index) {
    const Case value = randomCase(1, index);
    for (const Sphere& sphere : value.spheres)
      for (std::size_t i = 0; i < value.receivers.size(); ++i)
        for (const auto& [name, fits] : kinds)
          found[name] += fits(sightOf(sphere, value.receivers, i));
  }
  for (const auto& [name, fits] : kinds) {
    CAPTURE(name);
    CHECK(found[name] >= 10);
  }
}

TEST_CASE("rims pass through the centres of texels more often than by chance") {
  int found = 0, byChance = 0;
  for (std::size_t index = 0; index < 60; ++index) {
    const Case value = randomCase(1, index);
    for (const Sphere& sphere : value.spheres) {
      const Sight sight = sightOf(sphere, value.receivers, 2);
      found += hasRimThroughTexel(sight, sight.radius);
      byChance += hasRimThroughTexel(sight, 1.01 * sight.radius);
    }
  }
  CHECK(found >= 10 + 3 * byChance);
}

TEST_CASE("every eighth case has nothing but small spheres on bounds") {
  int rims = 0, binBounds = 0;
  for (std::size_t index = 5; index < 200; index += 8) {
    const Case value = randomCase(1, index);
    REQUIRE(value.receivers.positions[0] == glm::vec4(0));
    for (const Sphere& sphere : value.spheres) {
      const Sight sight = sightOf(sphere, value.receivers, 0);
      CHECK(sight.radius < 0.2 * sight.distance);
      const bool isRim = hasRimThroughTexel(sight, sight.radius);
      REQUIRE((isRim || isAtBinBound(sight)));
      ++(isRim ? rims : binBounds);
    }
  }
  CHECK(rims > 200);
  CHECK(binBounds > 200);
}

TEST_CASE("two of eight cases have receivers close together, that look the same way") {
  for (std::size_t index = 3; index < 100; index += index % 8 == 3 ? 3 : 5) {
    const Receivers receivers = randomCase(1, index).receivers;
    for (std::size_t i = 1; i < receivers.size(); ++i) {
      CHECK(receivers.normals[i] == receivers.normals[0]);
      for (int axis = 0; axis < 3; ++axis)
        CHECK(std::abs(receivers.positions[i][axis] - receivers.positions[0][axis]) <= 0.25f);
    }
  }
}

TEST_CASE(
    "one of eight cases has mostly spheres that are far, about half of them almost overflowing") {
  int all = 0, far = 0, almost = 0;
  for (std::size_t index = 6; index < 200; index += 8)
    for (const Sphere& sphere : randomCase(1, index).spheres) {
      const double distance = glm::length(glm::dvec3(sphere.center));
      ++all;
      far += distance > 100 || sphere.radius > 100;
      almost += distance > 0x1p62 && distance < 0x1p66;
    }
  CHECK(far > 0.6 * all);
  CHECK(almost > 0.25 * all);
}

TEST_CASE("cases keep to their bounds, and all counts of spheres occur") {
  std::map<std::size_t, int> counts;
  int twins = 0, axisNormals = 0, onPlane = 0;
  for (std::size_t index = 0; index < 200; ++index) {
    const Case value = randomCase(1, index);
    CAPTURE(index);
    REQUIRE(allFinite(value));
    const bool isClose = index % 8 == 3 || index % 8 == 6;
    REQUIRE(value.receivers.size() == (isClose ? 32 : 4));
    REQUIRE(value.spheres.size() >= 1);
    REQUIRE(value.spheres.size() <= 256);
    CHECK(value.hasDenormals == (index % 8 == 7));
    ++counts[value.spheres.size()];
    for (std::size_t i = 1; i < value.spheres.size(); ++i)
      twins += value.spheres[i].center == value.spheres[i - 1].center &&
               value.spheres[i].radius == value.spheres[i - 1].radius;
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec3 n(value.receivers.normals[i]);
      CHECK(n.x * n.x + n.y * n.y + n.z * n.z == doctest::Approx(1).epsilon(1e-6));
      axisNormals += zeros(n) == 2;
      for (const Sphere& sphere : value.spheres)
        REQUIRE(isDifferenceDefined(sphere, value.receivers.positions[i]));
      onPlane += value.receivers.positions[i].y == 0;
    }
  }
  for (const std::size_t count : {1, 31, 32, 33, 64, 255, 256}) {
    CAPTURE(count);
    CHECK(counts[count] >= 1);
  }
  CHECK(twins >= 10);
  CHECK(axisNormals >= 100);
  CHECK(axisNormals <= 700);
  CHECK(onPlane >= 300);  // two of four receivers, in six of eight cases
}

TEST_CASE("lights are a dim sky and a few lamps") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const RadianceCube light = randomLight(seed);
    int lamps = 0;
    for (const glm::vec3& texel : light.texels) {
      REQUIRE(std::min({texel.r, texel.g, texel.b}) >= 0);
      lamps += texel.r > 0.2f || texel.g > 0.3f || texel.b > 0.4f;
    }
    CHECK(lamps >= 5);
    CHECK(lamps <= 60);
  }
}
