#include "light/sky_model.h"

#include <algorithm>
#include <numbers>

#include "light_test_support.h"

namespace haarlight::test {

namespace {

constexpr double pi = std::numbers::pi;

const SkyModel& sky(const std::string& name) {
  const SkyModel* model = findSky("builtin:" + name);
  REQUIRE(model);
  return *model;
}

/// Calls visit(Z, χ, Zs) for places all over the sky and suns at all heights.
template <typename Visit>
void forPlaces(const Visit& visit) {
  for (double sunZenithDistance = 0; sunZenithDistance <= pi / 2; sunZenithDistance += pi / 20)
    for (double zenithDistance = 0; zenithDistance < pi / 2; zenithDistance += pi / 40)
      for (double azimuth = 0; azimuth <= pi; azimuth += pi / 10)
        visit(zenithDistance,
              std::acos(std::clamp(
                  std::cos(zenithDistance) * std::cos(sunZenithDistance) +
                      std::sin(zenithDistance) * std::sin(sunZenithDistance) * std::cos(azimuth),
                  -1.0, 1.0)),
              sunZenithDistance);
}

struct Row {
  double a, b, c, d, e;
};

/// Darula and Kittler 2002, table 1: six gradations by a, b and six indicatrices by c, d, e, and
/// which of them each type takes.
constexpr Row gradations[] = {{4, -0.7, 0, 0, 0},   {1.1, -0.8, 0, 0, 0}, {0, -1, 0, 0, 0},
                              {-1, -0.55, 0, 0, 0}, {-1, -0.32, 0, 0, 0}, {-1, -0.15, 0, 0, 0}};
constexpr Row indicatrices[] = {{0, 0, 0, -1, 0},     {0, 0, 2, -1.5, 0.15},
                                {0, 0, 5, -2.5, 0.3}, {0, 0, 10, -3, 0.45},
                                {0, 0, 16, -3, 0.3},  {0, 0, 24, -2.8, 0.15}};
constexpr int groups[15][2] = {{1, 1}, {1, 2}, {2, 1}, {2, 2}, {3, 1}, {3, 2}, {3, 3}, {3, 4},
                               {4, 2}, {4, 3}, {4, 4}, {5, 4}, {5, 5}, {6, 5}, {6, 6}};

}  // namespace

TEST_CASE("the fifteen general skies are those of the standard") {
  REQUIRE(skyModels().size() == 18);
  for (int type = 1; type <= 15; ++type) {
    CAPTURE(type);
    const Row& g = gradations[groups[type - 1][0] - 1];
    const Row& i = indicatrices[groups[type - 1][1] - 1];
    const SkyModel& model = sky("iso-sky-" + std::to_string(type));
    const auto phi = [&](double zenithDistance) {
      return 1 + g.a * std::exp(g.b / std::cos(zenithDistance));
    };
    const auto f = [&](double angle) {
      return 1 + i.c * (std::exp(i.d * angle) - std::exp(i.d * pi / 2)) +
             i.e * std::cos(angle) * std::cos(angle);
    };
    double largest = 0;
    forPlaces([&](double z, double chi, double zs) {
      const double expected = f(chi) * phi(z) / (f(zs) * phi(0));
      const double found = model.relativeLuminance(std::cos(z), chi, zs);
      REQUIRE(found > 0);
      largest = std::max(largest, std::abs(found / expected - 1));
    });
    CHECK(largest < 1e-13);
  }
}

TEST_CASE("every sky is 1 at the zenith") {
  for (const SkyModel& model : skyModels())
    for (const double zs : {0.0, 0.3, 1.0, pi / 2}) {
      CAPTURE(model.name);
      CHECK(model.relativeLuminance(1, zs, zs) == 1);
    }
}

TEST_CASE("the overcast sky is three times as bright at the zenith as at the horizon") {
  forPlaces([](double z, double chi, double zs) {
    REQUIRE(sky("cie-overcast").relativeLuminance(std::cos(z), chi, zs) ==
            doctest::Approx((1 + 2 * std::sin(pi / 2 - z)) / 3).epsilon(1e-14));
  });
  CHECK(sky("cie-overcast").relativeLuminance(0, 1, 1) == 1.0 / 3);
}

TEST_CASE("type 1 is the overcast sky within 0.03 of the zenith above and 0.092 below it") {
  double above = 0, below = 0;
  for (int i = 0; i < 9000; ++i) {
    const double cosine = std::cos(i * pi / 18000);
    const double difference = sky("iso-sky-1").relativeLuminance(cosine, 1, 1) -
                              sky("cie-overcast").relativeLuminance(cosine, 1, 1);
    above = std::max(above, difference);
    below = std::max(below, -difference);
  }
  MESSAGE("type 1 is brighter by up to " << above << ", darker by up to " << below);
  CHECK(above < 0.03);
  CHECK(below < 0.092);
  CHECK(sky("iso-sky-1").relativeLuminance(0, 1, 1) == doctest::Approx(1.0 / 3).epsilon(0.005));
}

TEST_CASE("the clear and the partly cloudy sky follow their formulas") {
  forPlaces([](double z, double chi, double zs) {
    // 0.274 is 1 − exp(−0.32) = 0.27385 with three digits.
    const double clear =
        (0.91 + 10 * std::exp(-3 * chi) + 0.45 * std::pow(std::cos(chi), 2)) *
        (1 - std::exp(-0.32 / std::cos(z))) /
        (0.274 * (0.91 + 10 * std::exp(-3 * zs) + 0.45 * std::pow(std::cos(zs), 2)));
    REQUIRE(sky("cie-clear").relativeLuminance(std::cos(z), chi, zs) ==
            doctest::Approx(clear).epsilon(6e-4));
    const double cloudy = (0.526 + 5 * std::exp(-1.5 * chi)) * (1 - std::exp(-0.8 / std::cos(z))) /
                          ((0.526 + 5 * std::exp(-1.5 * zs)) * (1 - std::exp(-0.8)));
    REQUIRE(sky("cie-partly-cloudy").relativeLuminance(std::cos(z), chi, zs) ==
            doctest::Approx(cloudy).epsilon(1e-13));
  });
}

TEST_CASE("type 12 is the clear sky but for digits, type 5 is uniform") {
  forPlaces([](double z, double chi, double zs) {
    REQUIRE(
        sky("iso-sky-12").relativeLuminance(std::cos(z), chi, zs) ==
        doctest::Approx(sky("cie-clear").relativeLuminance(std::cos(z), chi, zs)).epsilon(3e-4));
    REQUIRE(sky("iso-sky-5").relativeLuminance(std::cos(z), chi, zs) == 1);
  });
}

TEST_CASE("types with c = 0 do not know where the sun is, all others do") {
  for (int type = 1; type <= 15; ++type) {
    const SkyModel& model = sky("iso-sky-" + std::to_string(type));
    double largest = 0;
    forPlaces([&](double z, double chi, double zs) {
      largest = std::max(largest, std::abs(model.relativeLuminance(std::cos(z), chi, zs) -
                                           model.relativeLuminance(std::cos(z), 0, 0)));
    });
    CAPTURE(type);
    if (type == 1 || type == 3 || type == 5)
      CHECK(largest == 0);
    else
      CHECK(largest > 0.1);
  }
}

TEST_CASE("a name that no sky has finds none") {
  for (const char* name :
       {"", "cie-clear", "builtin:iso-sky-0", "builtin:iso-sky-16", "builtin:sky"})
    CHECK(findSky(name) == nullptr);
}

}  // namespace haarlight::test
