#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "image/image.h"

namespace haarlight {

/// A picture to write: the main layer has an empty name, any other becomes the channels
/// `name.R`, `name.G`, `name.B`.
struct ImageLayer {
  std::string name;
  const Image& image;
};

using ImageAttributes = std::map<std::string, std::variant<std::string, int, float>>;

/// Writes layers of equal size as OpenEXR: float32, scanlines, ZIP, chromaticities Rec. 709, and
/// the attributes in the header. Throws InputError when the file cannot be written or an
/// attribute's name cannot be used; nothing of it stays then.
void writeExr(const std::filesystem::path& path, const std::vector<ImageLayer>& layers,
              const ImageAttributes& attributes = {});

/// A linear image as 8-bit sRGB PNG, in memory. Throws InputError when it is too large for PNG.
std::vector<std::uint8_t> encodePng(const Image& image);

/// Writes a linear image as 8-bit sRGB PNG: srgbByte (image/tonemap.h) of every value, without any
/// exposure. Throws InputError when the file cannot be written; nothing of it stays then.
void writePng(const std::filesystem::path& path, const Image& image);

}  // namespace haarlight
