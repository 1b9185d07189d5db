#include "image/read_image.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/file.h"
#include "image/image_decoding.h"

namespace haarlight {

namespace {

constexpr std::int64_t maximumSide = 65536;
constexpr std::int64_t maximumPixels = std::int64_t(1) << 28;
/// Old Radiance runs and DWA-compressed constant OpenEXR images come closest to this.
constexpr std::int64_t maximumPixelsPerByte = 8192;

bool startsWith(std::span<const std::uint8_t> bytes, std::span<const std::uint8_t> magic) {
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

std::string pixelName(const Image& image, std::size_t index) {
  return "(column " + std::to_string(index % image.width) + ", row " +
         std::to_string(index / image.width) + ")";
}

void checkFinite(const Image& image, const std::filesystem::path& path) {
  const auto isBad = [](const glm::vec3& p) {
    return !std::isfinite(p.r) || !std::isfinite(p.g) || !std::isfinite(p.b);
  };
  const auto bad = std::find_if(image.pixels.begin(), image.pixels.end(), isBad);
  if (bad != image.pixels.end())
    cannotReadImage(path, "pixel " + pixelName(image, bad - image.pixels.begin()) +
                              " is not a finite number; repair the image first");
}

void clampNegatives(ImageFile& file) {
  std::size_t count = 0, first = 0;
  for (std::size_t i = 0; i < file.image.pixels.size(); ++i) {
    glm::vec3& pixel = file.image.pixels[i];
    const bool negative = pixel.r < 0 || pixel.g < 0 || pixel.b < 0;
    if (negative && count++ == 0) first = i;
    for (int channel = 0; channel < 3; ++channel) pixel[channel] = std::max(pixel[channel], 0.0f);
  }
  if (count > 0)
    file.warnings.push_back("negative values in " + std::to_string(count) + " of " +
                            std::to_string(file.image.pixels.size()) + " pixels, the first at " +
                            pixelName(file.image, first) + ", are set to 0");
}

ImageFile decode(std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
  constexpr std::array<std::uint8_t, 4> openExrMagic{0x76, 0x2f, 0x31, 0x01};
  constexpr std::array<std::uint8_t, 2> radianceMagic{'#', '?'};
  if (startsWith(bytes, openExrMagic)) return decodeOpenExr(bytes, path);
  if (startsWith(bytes, radianceMagic)) return decodeRadianceHdr(bytes, path);
  cannotReadImage(path, bytes.empty() ? "the file is empty"
                                      : "it is neither a Radiance HDR nor an OpenEXR image");
}

}  // namespace

void cannotReadImage(const std::filesystem::path& path, const std::string& reason) {
  throw InputError("cannot read image " + path.string() + ": " + reason);
}

void checkImageSize(std::int64_t width, std::int64_t height, std::size_t fileBytes,
                    const std::filesystem::path& path) {
  const std::string size = std::to_string(width) + "×" + std::to_string(height) + " pixels";
  if (width < 1 || height < 1) cannotReadImage(path, "its header says " + size);
  if (width > maximumSide || height > maximumSide || width * height > maximumPixels)
    cannotReadImage(path, "its header says " + size + "; at most " + std::to_string(maximumSide) +
                              " a side and " + std::to_string(maximumPixels) + " in all are read");
  if (width * height > maximumPixelsPerByte * std::int64_t(fileBytes))
    cannotReadImage(path, "its header says " + size + ", which cannot be in a file of " +
                              std::to_string(fileBytes) + " bytes");
}

ImageFile readImage(const std::filesystem::path& path) {
  ImageFile file = decode(readWholeFile(path, "image"), path);
  checkFinite(file.image, path);
  clampNegatives(file);
  return file;
}

}  // namespace haarlight
