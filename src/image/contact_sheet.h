#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace haarlight {

/// Around the pictures of a sheet: dark grey.
inline constexpr glm::vec3 sheetBackground(0.03f);

/// One picture of a sheet.
struct LabelledImage {
  std::string label;  ///< ASCII; other bytes show as "?"
  const Image& image;
};

/// The pictures side by side from left to right, each with its label above, on dark grey with
/// `gap` pixels between and around them. Linear, ready for writePng; the pictures' values are not
/// changed (expose them by tonemap first).
Image contactSheet(const std::vector<LabelledImage>& pictures, int gap = 12);

/// Several such rows below each other, columns aligned.
Image contactGrid(const std::vector<std::vector<LabelledImage>>& rows, int gap = 12);

/// One sheet below another, at the left; the narrower one is filled up with dark grey.
Image stackSheets(const Image& upper, const Image& lower);

}  // namespace haarlight
