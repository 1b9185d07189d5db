#pragma once

/// What numbers in a scene file may be.

#include "scene/json_value.h"

namespace haarlight {

/// Within these bounds no product of three values leaves float32.
inline constexpr Range coordinateRange{-1e6, 1e6};
inline constexpr Range lengthRange{1e-6, 1e6};
/// A length, or 0; between 0 and the smallest length there is nothing (scene/scene_checks.cpp).
inline constexpr Range lengthOrZeroRange{0, 1e6};
inline constexpr Range radianceRange{0, 1e6};
/// Of point lights, whose squared distance may be large.
inline constexpr Range intensityRange{0, 1e12};
inline constexpr Range unitRange{0, 1};
/// Factors on lengths or on time.
inline constexpr Range factorRange{1e-6, 1e6};

/// Degrees, of one turn and of a hundred.
inline constexpr Range angleRange{-360, 360};
inline constexpr Range turningRange{-36000, 36000};
/// From the horizon to the zenith.
inline constexpr Range elevationRange{0, 90};

/// Of SkySettings::sunDisc.
inline constexpr Range sunDiscRange{0, 100};

inline constexpr Range secondsRange{0, 1e6};
inline constexpr Range startRange{-1e6, 1e6};
inline constexpr Range frameRange{0, 1e6};
inline constexpr Range frameRateRange{1e-3, 1e4};

}  // namespace haarlight
