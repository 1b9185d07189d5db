#include "report/method_sheet.h"

#include <doctest/doctest.h>

using namespace haarlight;

namespace {

constexpr int side = 400, gap = 12, line = 24;

Image filled(float radiance) {
  Image image(side, side);
  for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(radiance);
  return image;
}

/// Of the sheet's picture in a row and column, the pixel in its middle.
glm::vec3 middleOf(const Image& sheet, int row, int column) {
  return sheet.at(gap + column * (side + gap) + side / 2,
                  row * (side + line + 2 * gap) + gap + line + side / 2);
}

}  // namespace

TEST_CASE("a sheet of methods shows each picture exposed and its error against each reference") {
  const std::vector<MethodPicture> pictures{
      {"a", "", filled(0.125f)}, {"b", "2 s", filled(0.25f)}, {"c", "", filled(0.1875f)}};
  const std::vector<std::uint8_t> mask(side * side, 1);
  const std::vector<ErrorRow> rows{errorsAgainst(pictures, 0, mask),
                                   errorsAgainst(pictures, 1, mask)};
  CHECK(rows[0].errors[0].rootMeanSquare == 0);
  CHECK(rows[0].errors[1].relativeRootMeanSquare == doctest::Approx(1));
  CHECK(rows[0].errors[2].relativeRootMeanSquare == doctest::Approx(0.5));
  CHECK(rows[1].errors[2].relativeRootMeanSquare == doctest::Approx(0.25));

  const Image sheet = methodSheet(pictures, rows, 1);
  CHECK(sheet.width == 3 * (side + gap) + gap);
  CHECK(sheet.height == 3 * (side + line + 2 * gap));
  CHECK(middleOf(sheet, 0, 0).g == 0.25f);
  CHECK(middleOf(sheet, 0, 1).g == 0.5f);
  for (int reference = 0; reference < 2; ++reference)
    for (int i = 0; i < 3; ++i) {
      const float difference =
          std::abs(pictures[i].radiance.at(0, 0).g - pictures[reference].radiance.at(0, 0).g);
      CHECK(middleOf(sheet, 1 + reference, i) == infernoColor(2 * 4 * difference));
    }
}

TEST_CASE("errors on a sheet are those of the pixels in the mask") {
  Image spoiled = filled(0.5f);
  spoiled.at(3, 4) = glm::vec3(7);
  const std::vector<MethodPicture> pictures{{"a", "", filled(0.5f)}, {"b", "", spoiled}};
  std::vector<std::uint8_t> mask(side * side, 1);
  CHECK(errorsAgainst(pictures, 0, mask).errors[1].maximum == 6.5);
  mask[4 * side + 3] = 0;
  CHECK(errorsAgainst(pictures, 0, mask).errors[1].maximum == 0);
}
