#include "image/contact_sheet.h"

#include <algorithm>

#include "image_test_support.h"

namespace haarlight::test {

TEST_CASE("a sheet holds its pictures side by side") {
  const Image left = randomImage(60, 20, 1), right = randomImage(50, 30, 2);
  const Image sheet = contactSheet({{"ab", left}, {"c", right}}, 10);
  CHECK(sheet.width == 10 + 60 + 10 + 50 + 10);
  CHECK(sheet.height == 10 + 24 + 30 + 10);
  for (int x = 0; x < 60; ++x) CHECK(sheet.at(10 + x, 34 + 19) == left.at(x, 19));
  for (int x = 0; x < 50; ++x) CHECK(sheet.at(80 + x, 34 + 29) == right.at(x, 29));
}

TEST_CASE("labels are drawn above their picture and widen it when they must") {
  const Image picture(4, 4);
  const Image sheet = contactSheet({{"a long label", picture}}, 10);
  CHECK(sheet.width > 100);
  const glm::vec3 paper = sheet.at(0, 0);
  int ink = 0;
  for (int y = 10; y < 34; ++y)
    for (int x = 0; x < sheet.width; ++x) ink += sheet.at(x, y) != paper;
  CHECK(ink > 300);
  const auto inkOf = [](const std::string& label) {
    const Image one(4, 4);
    const Image all = contactSheet({{label, one}}, 10);
    return std::count(all.pixels.begin(), all.pixels.end(), all.at(0, 0));
  };
  CHECK(inkOf("\xc3\n") == inkOf("??"));
}

TEST_CASE("every printable character fits the text buffer") {
  std::string all;
  for (char c = ' '; c <= '~'; ++c) all += c;
  const Image picture(4, 4);
  const Image sheet = contactSheet({{all, picture}});
  CHECK(sheet.width > 500);
  CHECK(contactSheet({}).height == 24 + 24);
}

TEST_CASE("columns of a grid are as wide as their widest picture or label") {
  const Image small = randomImage(20, 10, 5), wide = randomImage(60, 12, 6);
  const Image grid =
      contactGrid({{{"a", small}, {"b", wide}}, {{"a long label", small}, {"c", small}}}, 10);
  const int column = grid.width - 60 - 30;  // the first one's width
  CHECK(column > 100);
  CHECK(grid.height == (10 + 24 + 12 + 10) + (10 + 24 + 10 + 10));
  CHECK(grid.at(10, 34) == small.at(0, 0));
  CHECK(grid.at(20 + column, 34) == wide.at(0, 0));
  CHECK(grid.at(10, 56 + 34) == small.at(0, 0));
  CHECK(grid.at(20 + column, 56 + 34) == small.at(0, 0));
}

TEST_CASE("sheets are stacked and the narrower one is filled up") {
  const Image upper = randomImage(30, 10, 3), lower = randomImage(20, 5, 4);
  const Image sheet = stackSheets(upper, lower);
  CHECK(sheet.width == 30);
  CHECK(sheet.height == 15);
  CHECK(sheet.at(29, 9) == upper.at(29, 9));
  CHECK(sheet.at(19, 14) == lower.at(19, 4));
  CHECK(sheet.at(29, 14) == contactSheet({}).at(0, 0));
}

}  // namespace haarlight::test
