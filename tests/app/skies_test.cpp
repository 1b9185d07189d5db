#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight::test;

TEST_CASE("skies lists the eighteen and puts them on one sheet") {
  const TemporaryFolder folder;
  const auto results = resultsOf(
      {"skies", "--sun", "90,30", "--sun-disc", "1", "--side", "40", "-o", folder / "s.png"});
  CHECK(results.at("sun_azimuth_degrees") == 90);
  CHECK(results.at("sun_elevation_degrees") == 30);
  const auto& skies = results.at("sky");
  REQUIRE(skies.size() == 18);
  CHECK(skies[0].at("name") == "builtin:cie-overcast");
  CHECK(skies[0].at("sky_irradiance_per_zenith_radiance").get<double>() ==
        doctest::Approx(7 * std::numbers::pi / 9));
  CHECK(skies[7].at("name") == "builtin:iso-sky-5");
  CHECK(skies[7].at("sun_irradiance_per_zenith_radiance").get<double>() ==
        doctest::Approx(std::numbers::pi * 128 * std::exp(-0.42) / (0.8 + 15.5 * std::sqrt(0.5))));
  CHECK(readFile(folder / "s.png").starts_with("\x89PNG"));
}

TEST_CASE("a sky is a light of every command, with a sun by option") {
  const auto power = [](const std::string& sun) {
    const TemporaryFolder folder;
    const auto results =
        resultsOf({"bake", "--mesh", "builtin:sphere", "--light", "builtin:cie-clear", "--sun", sun,
                   "--sun-disc", "1", "--spheres", "1", "--size", "4x4", "--method", "pixel", "-o",
                   folder / "x.exr"});
    CHECK(results.at("light") == "builtin:cie-clear");
    return results.at("light_power_kept").get<double>();
  };
  CHECK(power("0,45") == doctest::Approx(1).epsilon(1e-4));
  CHECK(power("-77,3") == doctest::Approx(1).epsilon(1e-4));
  CHECK(resultsOf({"info", "builtin:iso-sky-3"}).at("kind") == "light");
}

TEST_CASE("skies refuses a sun that stands nowhere and a sheet that is none") {
  checkRefused({"skies", "--sun", "0,-3"}, "--sun's elevation takes a number from 0 to 90, not -3");
  checkRefused({"skies", "--sun-disc", "-1"}, "--sun-disc");
  checkRefused({"skies", "-o", "skies.gif"}, ".png");
  checkRefused({"render", "--light", "builtin:lamps", "--sun", "0,3", "-o", "x.png"},
               "--sun is for skies such as builtin:cie-clear, not for builtin:lamps");
}
