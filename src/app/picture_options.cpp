#include "app/picture_options.h"

#include <cmath>

#include "app/options.h"
#include "base/error.h"

namespace haarlight {

namespace {

void applyExposure(const std::string& text, ImageDescription& image) {
  if (text.empty()) return;
  image.exposure.reset();
  if (text == "auto") return;
  std::size_t used = 0;
  try {
    image.exposure = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used != text.size() || !(std::abs(*image.exposure) <= 32))
    throw InputError("--exposure takes a number of stops from -32 to 32 or auto, not '" + text +
                     "'");
}

}  // namespace

void addPictureOptions(CLI::App& command, PictureOptions& options, const std::string& defaultSize) {
  command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels [" + defaultSize + "]")
      ->group("Output");
  command.add_option("--samples", options.samples, "Camera rays per pixel [4]")
      ->group("Computation")
      ->check(CLI::Range(1, 4096));
  command.add_option("--exposure", options.exposure, "Stops, or auto, for PNG [auto]")
      ->group("Output");
}

void applyPictureOptions(const PictureOptions& options, ImageDescription& image) {
  if (!options.size.empty()) {
    const glm::ivec2 size = parseSize(options.size, "--size");
    image.width = size.x;
    image.height = size.y;
  }
  if (options.samples) image.samplesPerPixel = *options.samples;
  applyExposure(options.exposure, image);
}

}  // namespace haarlight
