#include "light/sky_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace haarlight {

namespace {

/// A row of the standard's table: φ(Z) = 1 + a exp(b / cos Z) and
/// f(χ) = 1 + c (exp(dχ) − exp(dπ/2)) + e cos² χ.
struct GeneralSky {
  double a, b, c, d, e;
  const char* title;
};

constexpr GeneralSky generalSkies[] = {
    {4.0, -0.70, 0, -1.0, 0, "overcast, steep gradation to the zenith, alike all around"},
    {4.0, -0.70, 2, -1.5, 0.15, "overcast, steep gradation, slightly brighter towards the sun"},
    {1.1, -0.80, 0, -1.0, 0, "overcast, moderate gradation, alike all around"},
    {1.1, -0.80, 2, -1.5, 0.15, "overcast, moderate gradation, slightly brighter towards the sun"},
    {0.0, -1.00, 0, -1.0, 0, "uniform"},
    {0.0, -1.00, 2, -1.5, 0.15, "partly cloudy, no gradation, slightly brighter towards the sun"},
    {0.0, -1.00, 5, -2.5, 0.30, "partly cloudy, no gradation, brighter around the sun"},
    {0.0, -1.00, 10, -3.0, 0.45, "partly cloudy, no gradation, distinct corona"},
    {-1.0, -0.55, 2, -1.5, 0.15, "partly cloudy, the sun obscured"},
    {-1.0, -0.55, 5, -2.5, 0.30, "partly cloudy, brighter around the sun"},
    {-1.0, -0.55, 10, -3.0, 0.45, "white-blue, distinct corona"},
    {-1.0, -0.32, 10, -3.0, 0.45, "CIE standard clear sky, low turbidity"},
    {-1.0, -0.32, 16, -3.0, 0.30, "CIE standard clear sky, polluted air"},
    {-1.0, -0.15, 16, -3.0, 0.30, "cloudless turbid, broad corona"},
    {-1.0, -0.15, 24, -2.8, 0.15, "white-blue turbid, broad corona"}};

std::vector<SkyModel> makeSkies() {
  std::vector<SkyModel> skies{
      {"builtin:cie-overcast", "CIE overcast sky", {1.0 / 3, 2.0 / 3, 0, -1}, {1, 0, -1, 0}},
      {"builtin:cie-clear", "CIE clear sky", {1, 0, -1, -0.32}, {0.91, 10, -3, 0.45}},
      {"builtin:cie-partly-cloudy", "partly cloudy sky", {1, 0, -1, -0.8}, {0.526, 5, -1.5, 0}}};
  int type = 0;
  for (const auto& [a, b, c, d, e, title] : generalSkies)
    skies.push_back({"builtin:iso-sky-" + std::to_string(++type),
                     title,
                     {1, 0, a, b},
                     {1 - c * std::exp(d * std::numbers::pi / 2), c, d, e}});
  return skies;
}

}  // namespace

double SkyGradation::operator()(double cosZenithDistance) const {
  return constant + linear * cosZenithDistance + a * std::exp(b / cosZenithDistance);
}

double SkyIndicatrix::operator()(double sunAngle) const {
  const double cosine = std::cos(sunAngle);
  return constant + c * std::exp(d * sunAngle) + e * cosine * cosine;
}

double SkyModel::relativeLuminance(double cosZenithDistance, double sunAngle,
                                   double sunZenithDistance) const {
  return gradation(cosZenithDistance) * indicatrix(sunAngle) /
         (gradation(1) * indicatrix(sunZenithDistance));
}

std::span<const SkyModel> skyModels() {
  static const std::vector<SkyModel> skies = makeSkies();
  return skies;
}

const SkyModel* findSky(const std::string& name) {
  const auto found = std::ranges::find(skyModels(), name, &SkyModel::name);
  return found == skyModels().end() ? nullptr : &*found;
}

}  // namespace haarlight
