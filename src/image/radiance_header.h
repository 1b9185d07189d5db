#pragma once

/// The text header of a Radiance picture (Radiance file formats, "Picture File Format").

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace haarlight {

/// How scanlines lie in the picture: the resolution line's two axes.
struct RadianceOrientation {
  bool scanlinesAreColumns = false;  ///< X comes first
  bool bottomToTop = false;          ///< +Y
  bool rightToLeft = false;          ///< −X
};

struct RadianceHeader {
  int width = 0;
  int height = 0;
  RadianceOrientation orientation;
  bool isXyz = false;
  glm::dvec3 exposure{1.0};  ///< product of all EXPOSURE and COLORCORR lines
  std::vector<std::pair<std::string, std::string>> variables;
  std::size_t dataOffset = 0;  ///< first byte after the resolution line

  int scanlineCount() const { return orientation.scanlinesAreColumns ? width : height; }
  int scanlineLength() const { return orientation.scanlinesAreColumns ? height : width; }

  /// Column and row, from the top left, of a pixel of a scanline.
  glm::ivec2 pixelPosition(int scanline, int index) const;
};

/// Parses the header of `bytes`, which start with "#?". A file that calls itself RADIANCE or RGBE
/// may leave out FORMAT. Throws InputError naming the line that is wrong.
RadianceHeader parseRadianceHeader(std::span<const std::uint8_t> bytes,
                                   const std::filesystem::path& path);

}  // namespace haarlight
