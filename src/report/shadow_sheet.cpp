#include "report/shadow_sheet.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "image/contact_sheet.h"
#include "image/tonemap.h"

namespace haarlight {

namespace {

/// The picture in dark grey under the colours of the differences.
Image differencePicture(const Image& exposed, const Image& errors) {
  constexpr float dimmed = 0.25f;
  const glm::vec3 luminance(0.2126f, 0.7152f, 0.0722f);
  Image picture = errors;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    picture.pixels[i] += glm::vec3(dimmed * glm::dot(exposed.pixels[i], luminance));
  return picture;
}

std::string errorLabel(const ShadowRun& run) {
  if (run.method->name() == "exact") return "red: too dark, blue: too bright";
  return fmt::format("area {:+.2f} %, wrong {:.2f} %", 100 * run.difference.areaError(),
                     100 * run.difference.wrongPart());
}

}  // namespace

Image shadowSheet(const ShadowComparison& comparison, float stops) {
  std::vector<Image> pictures, differences;
  for (const ShadowRun& run : comparison.runs()) {
    pictures.push_back(tonemap(run.picture.image(), stops));
    differences.push_back(differencePicture(pictures.back(), run.errors));
  }
  std::vector<LabelledImage> upper, lower;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const ShadowRun& run = comparison.runs()[i];
    const double seconds = run.method->figures()["seconds"]["total"];
    upper.push_back({fmt::format("{}, {:.3f} s", run.label, seconds), pictures[i]});
    lower.push_back({errorLabel(run), differences[i]});
  }
  return comparison.hasReference() ? contactGrid({upper, lower}) : contactSheet(upper);
}

}  // namespace haarlight
