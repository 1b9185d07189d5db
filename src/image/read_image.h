#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

#include "image/image.h"

namespace haarlight {

/// An image and what its file said about it.
struct ImageFile {
  Image image;
  std::string format;  ///< "Radiance HDR" or "OpenEXR"
  /// Product of all EXPOSURE and COLORCORR lines of a Radiance file, by which the stored values
  /// were divided; 1 for OpenEXR.
  glm::dvec3 exposure{1.0};
  std::vector<std::string> channels;  ///< all channels of the file, also those not read
  /// Header entries that are text or numbers, in file order.
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<std::string> warnings;  ///< one line each
};

/// Reads a Radiance HDR (RGBE or XYZE) or OpenEXR image, told apart by content, as linear RGB with
/// Rec. 709 primaries.
///
/// Radiance HDR: every orientation, run-length encoding old and new or none. A pixel decodes to
/// mantissa · 2^(exponent − 136) as in Mitsuba, OpenCV, stb and HDRView; Radiance's own programs
/// add half a unit to the mantissa. RGB is taken as Rec. 709 whatever a PRIMARIES line says, as
/// those readers do.
///
/// OpenEXR: scanline or tiled; half, float or integer; channels R, G, B, else Y alone, else the
/// first layer that has them, of the first part that has any. The result is exactly the data window
/// (the display window neither crops nor pads). Other `chromaticities` are converted by way of XYZ
/// without white adaptation, as in Mitsuba.
///
/// Negative values become 0 with a warning. Throws InputError for a file that is neither format,
/// damaged, too large (65536 pixels a side, 2^28 in all) or has NaN or infinite pixels.
ImageFile readImage(const std::filesystem::path& path);

}  // namespace haarlight
