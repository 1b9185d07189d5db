#pragma once

/// Luminance distributions of the sky: the fifteen general skies of ISO 15469:2004 (CIE S 011/E:
/// 2003), and the overcast, clear and partly cloudy skies that R. Green names as lights ("Spherical
/// Harmonic Lighting: The Gritty Details", GDC 2003). docs/skies.md has formulas and sources.

#include <span>
#include <string>

namespace haarlight {

/// Brightness by zenith distance Z: constant + linear · cos Z + a · exp(b / cos Z), with b < 0.
struct SkyGradation {
  double constant, linear, a, b;

  double operator()(double cosZenithDistance) const;
};

/// Brightness by the angle χ to the sun, in radians: constant + c · exp(d χ) + e · cos² χ.
struct SkyIndicatrix {
  double constant, c, d, e;

  double operator()(double sunAngle) const;
};

struct SkyModel {
  std::string name;   ///< "builtin:iso-sky-12"
  std::string title;  ///< what it stands for, in words
  SkyGradation gradation;
  SkyIndicatrix indicatrix;

  /// Luminance over that of the zenith, from the horizon (cosine 0) up; angles in radians.
  double relativeLuminance(double cosZenithDistance, double sunAngle,
                           double sunZenithDistance) const;
};

/// All of them: `builtin:cie-overcast`, `builtin:cie-clear`, `builtin:cie-partly-cloudy`, then
/// `builtin:iso-sky-1` to `builtin:iso-sky-15` with the standard's numbers.
std::span<const SkyModel> skyModels();

/// The sky of this name; null when there is none.
const SkyModel* findSky(const std::string& name);

}  // namespace haarlight
