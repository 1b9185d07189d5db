#include "report/sky_sheet.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace haarlight;

TEST_CASE("the sheet of skies shows the zenith in the middle and azimuth clockwise from the top") {
  constexpr int side = 200, gap = 12, line = 24;
  SkySettings settings;
  settings.sunAzimuthDegrees = 90;
  const Image sheet = skySheet(settings, side);
  CHECK(sheet.width == 5 * (side + gap) + gap);
  CHECK(sheet.height == 4 * (side + line + 2 * gap));
  // Of the picture in a row and column of the sheet, by pixels from its middle.
  const auto pixel = [&](int row, int column, int right, int down) {
    return sheet.at(gap + column * (side + gap) + side / 2 + right,
                    row * (side + line + 2 * gap) + gap + line + side / 2 + down);
  };
  // The uniform sky has radiance 1 all over, shown as 1 / (2 + 1).
  for (const int right : {-90, 0, 90})
    CHECK(pixel(1, 4, right, 20).g == doctest::Approx(1.0 / 3).epsilon(1e-6));
  CHECK(pixel(1, 4, 90, 90) == pixel(0, 0, -90, -90));  // beside the circles
  // The overcast sky has 9/7 (1 + 2 cos Z) / 3.
  CHECK(pixel(0, 0, 0, 0).g == doctest::Approx(9.0 / 7 / (2 + 9.0 / 7)).epsilon(1e-3));
  const double halfway = 9.0 / 7 * (1 + std::sqrt(2.0)) / 3;
  CHECK(pixel(0, 0, 0, 50).g == doctest::Approx(halfway / (2 + halfway)).epsilon(1e-2));
  // The sun of the clear sky stands at +X, on the right, halfway to the rim.
  for (const int row : {-50, 0, 50})
    for (const int column : {-50, 0, 50})
      if (row != 0 || column != 50) CHECK(pixel(0, 1, 50, 0).g > pixel(0, 1, column, row).g + 0.05);
}
