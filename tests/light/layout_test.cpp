#include "light/layout.h"

#include <numbers>
#include <vector>

#include "light_test_support.h"

namespace haarlight::test {

namespace {

/// The direction that a place in the picture (fractions from the top left) shows.
glm::dvec3 shownAt(const Layout& layout, glm::ivec2 picture, glm::dvec2 fraction) {
  for (int patch = 0; patch < layout.patchCount(); ++patch) {
    const glm::dvec2 pixel = fraction * glm::dvec2(picture);
    const glm::dvec2 place = (pixel - glm::dvec2(layout.patchOrigin(patch, picture))) /
                             glm::dvec2(layout.patchSize(picture));
    if (layout.covers(place)) return layout.direction({patch, place});
  }
  return glm::dvec3(0.0);
}

void checkShown(const Layout& layout, glm::ivec2 picture, glm::dvec2 fraction,
                const glm::dvec3& direction) {
  CAPTURE(layout.name());
  CAPTURE(fraction.x);
  CAPTURE(fraction.y);
  CHECK(glm::distance(shownAt(layout, picture, fraction), glm::normalize(direction)) < 1e-12);
}

struct Sized {
  std::string name;
  glm::ivec2 picture;
};

const std::vector<Sized> allSized{
    {"latlong", {24, 12}}, {"vcross", {12, 16}}, {"hcross", {16, 12}}, {"angular", {20, 20}}};

}  // namespace

TEST_CASE("a layout is known by its aspect ratio or its name") {
  for (const Sized& sized : allSized) {
    CHECK(chooseLayout("", sized.picture).name() == sized.name);
    CHECK(chooseLayout(sized.name, sized.picture).name() == sized.name);
  }
  CHECK(contains(inputErrorOf([] {
                   chooseLayout("", {100, 70});
                 }),
                 "a light of 100×70 pixels has no known layout: latlong (twice as wide as high)"));
  CHECK(contains(inputErrorOf([] {
                   chooseLayout("vcross", {100, 50});
                 }),
                 "cannot have the layout vcross, which is 3 by 4 square faces"));
  CHECK(contains(inputErrorOf([] {
                   chooseLayout("dome", {100, 50});
                 }),
                 "there is no light layout \"dome\": latlong"));
}

TEST_CASE("latlong shows +Z in the centre and +X left of it") {
  const glm::ivec2 size(24, 12);
  const Layout& layout = chooseLayout("latlong", size);
  checkShown(layout, size, {0.5, 0.5}, {0, 0, 1});
  checkShown(layout, size, {0.25, 0.5}, {1, 0, 0});
  checkShown(layout, size, {0.75, 0.5}, {-1, 0, 0});
  checkShown(layout, size, {0, 0.5}, {0, 0, -1});
  checkShown(layout, size, {0.3, 0}, {0, 1, 0});
  checkShown(layout, size, {0.3, 1}, {0, -1, 0});
  checkShown(layout, size, {0.375, 0.25}, {1, std::sqrt(2), 1});
}

TEST_CASE("the crosses are a cube unfolded around -Z") {
  const glm::ivec2 tall(12, 16), wide(16, 12);
  const Layout& vertical = chooseLayout("vcross", tall);
  const Layout& horizontal = chooseLayout("hcross", wide);
  for (const auto& [layout, size] : {std::pair(&vertical, tall), std::pair(&horizontal, wide)}) {
    const auto at = [&](double column, double row) {
      return glm::dvec2(column, row) * glm::dvec2(layout->patchSize(size)) / glm::dvec2(size);
    };
    checkShown(*layout, size, at(1.5, 1.5), {0, 0, -1});
    checkShown(*layout, size, at(0.5, 1.5), {-1, 0, 0});
    checkShown(*layout, size, at(2.5, 1.5), {1, 0, 0});
    checkShown(*layout, size, at(1.5, 0.5), {0, 1, 0});
    checkShown(*layout, size, at(1.5, 2.5), {0, -1, 0});
    // Towards the top left corner within the front and the faces beside it.
    checkShown(*layout, size, at(1.25, 1.25), {-0.5, 0.5, -1});
    checkShown(*layout, size, at(0.25, 1.25), {-1, 0.5, 0.5});
    checkShown(*layout, size, at(2.25, 1.25), {1, 0.5, -0.5});
    checkShown(*layout, size, at(1.25, 0.25), {-0.5, 1, 0.5});
    checkShown(*layout, size, at(1.25, 2.25), {-0.5, -1, -0.5});
  }
  checkShown(vertical, tall, {0.5, 3.5 / 4}, {0, 0, 1});
  checkShown(vertical, tall, {1.25 / 3, 3.25 / 4}, {-0.5, -0.5, 1});  // upside down
  checkShown(horizontal, wide, {3.5 / 4, 0.5}, {0, 0, 1});
  checkShown(horizontal, wide, {3.25 / 4, 1.25 / 3}, {0.5, 0.5, 1});
}

TEST_CASE("angular shows -Z in the centre, +X on the right, +Z on the rim") {
  const glm::ivec2 size(20, 20);
  const Layout& layout = chooseLayout("angular", size);
  checkShown(layout, size, {0.5, 0.5}, {0, 0, -1});
  checkShown(layout, size, {0.75, 0.5}, {1, 0, 0});
  checkShown(layout, size, {0.25, 0.5}, {-1, 0, 0});
  checkShown(layout, size, {0.5, 0.25}, {0, 1, 0});
  checkShown(layout, size, {0.5, 0.75}, {0, -1, 0});
  checkShown(layout, size, {0.625, 0.5}, {1, 0, -1});
  CHECK(glm::distance(layout.direction({0, {1, 0.5}}), {0, 0, 1}) < 1e-12);
  CHECK(glm::distance(layout.direction({0, {0, 0}}), {0, 0, 1}) < 1e-12);
  CHECK_FALSE(layout.covers({0.1, 0.1}));
}

TEST_CASE("places and directions are inverse in every layout") {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (const Sized& sized : allSized) {
    const Layout& layout = chooseLayout(sized.name, sized.picture);
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 d =
          glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
      const PatchPoint place = layout.locate(3.0 * d);
      CHECK(layout.covers(place.position));
      CHECK(glm::distance(layout.direction(place), d) < 1e-9);
    }
    for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}})
      for (const double sign : {1.0, -1.0})
        CHECK(glm::distance(layout.direction(layout.locate(sign * axis)), sign * axis) < 1e-9);
  }
}

TEST_CASE("solid angles of a layout's rectangles add up to the sphere") {
  for (const Sized& sized : allSized) {
    const Layout& layout = chooseLayout(sized.name, sized.picture);
    constexpr int cells = 512;
    double sum = 0;
    for (int y = 0; y < cells; ++y)
      for (int x = 0; x < cells; ++x)
        sum += layout.solidAngle(glm::dvec2(x, y) / double(cells),
                                 glm::dvec2(x + 1, y + 1) / double(cells));
    const double tolerance = sized.name == "angular" ? 1e-5 : 1e-12;
    CHECK(sum * layout.patchCount() == doctest::Approx(4 * std::numbers::pi).epsilon(tolerance));
  }
}

TEST_CASE("the solid angle of an angular map is sin(pi r) pi / r times the area on the unit disc") {
  const Layout& layout = chooseLayout("angular", {10, 10});
  constexpr double side = 0.002, area = 4 * side * side;
  for (const double radius : {0.1, 0.5, 0.8, 0.97}) {
    const glm::dvec2 middle = 0.5 + 0.5 * radius * glm::dvec2(0.6, 0.8);
    CHECK(layout.solidAngle(middle - side / 2, middle + side / 2) ==
          doctest::Approx(std::numbers::pi * std::sin(std::numbers::pi * radius) / radius * area)
              .epsilon(1e-4));
  }
}

}  // namespace haarlight::test
