#pragma once

#include <ImfChromaticities.h>

#include <glm/mat3x3.hpp>

namespace haarlight {

/// Matrix from CIE XYZ (white: D65 with Y = 1) to linear RGB with Rec. 709 primaries.
glm::dmat3 rec709FromXyz();

/// Matrix to linear RGB with Rec. 709 primaries from other primaries and white, by way of XYZ
/// without white adaptation.
glm::dmat3 rec709From(const Imf::Chromaticities& chromaticities);

}  // namespace haarlight
