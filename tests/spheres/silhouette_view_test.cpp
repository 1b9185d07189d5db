#include "spheres/silhouette_view.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "mesh/builtin_meshes.h"
#include "spheres/random_spheres.h"
#include "spheres/view_pixels.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

using Disc = SilhouetteView::Disc;

SilhouetteView viewOf(const TriangleMesh& mesh, const glm::dvec3& eye, int pixels) {
  return {mesh, RayScene(mesh), eye, pixels};
}

/// Where a view of a mesh around the origin has its axes and pixels, told from balls with known
/// places in it.
struct Image {
  Image(const SilhouetteView& view, const glm::dvec3& eye) {
    glm::dmat3 columns;
    for (int i = 0; i < 3; ++i) {
      glm::dvec3 along(0);
      along[i] = 1;
      const Disc disc = view.discOf({eye + along, 0});
      columns[i] = {disc.x, disc.y, disc.z};
    }
    toWorld = glm::transpose(columns);
    const double radius = 0.25, distance = glm::length(eye);
    const Disc middle = view.discOf({glm::dvec3(0), radius});
    const double tangent = radius / std::sqrt(distance * distance - radius * radius);
    pixel = 2 * tangent / (double(middle.endRow) - middle.firstRow);
    top = -pixel * (double(middle.firstRow) + middle.endRow) / 2;
    const auto columnsOfMiddle = view.columnsOf(middle, view.height() / 2);
    left = -pixel * (double(columnsOfMiddle.begin) + columnsOfMiddle.end) / 2;
  }

  /// Through a pixel's centre, in the view's axes.
  glm::dvec3 ray(int column, int row) const {
    return {left + (column + 0.5) * pixel, top + (row + 0.5) * pixel, 1};
  }

  glm::dmat3 toWorld;
  double left, top, pixel;
};

/// The squared sine of the angle by which a ray passes beyond the rim of a ball, seen from the
/// origin; negative where the ball blocks the ray.
double beyondRim(const glm::dvec3& ray, const glm::dvec3& center, double radius) {
  const double square = glm::dot(center, center), tangent = square - radius * radius;
  if (tangent <= 0) return -1;
  const double along = glm::dot(ray, center);
  if (along <= 0) return 1;
  return tangent / square - along * along / (glm::dot(ray, ray) * square);
}

/// What a ball blocks of a view against a test of each ray.
struct Comparison {
  int blocked = 0, undecided = 0, wrong = 0;

  void add(const SilhouetteView& view, const Image& image, const glm::dvec3& eye,
           const Ball& ball) {
    const Disc disc = view.discOf(ball);
    const glm::dvec3 center = glm::transpose(image.toWorld) * (ball.center - eye);
    for (int row = 0; row < view.height(); ++row)
      for (int column = 0; column < view.width(); ++column) {
        const double beyond = beyondRim(image.ray(column, row), center, ball.radius);
        blocked += beyond <= 0;
        const bool close = std::abs(beyond) < 5e-6;
        undecided += close;
        wrong += !close && blocks(view, disc, column, row) != (beyond <= 0);
      }
  }
};

}  // namespace

TEST_CASE("the pixels of a silhouette view tell where the mesh blocks, in solid angles") {
  const TriangleMesh sphere = icosphere(5);
  double inner = 1;  // radius of the ball that lies in the mesh
  for (const glm::uvec3& t : sphere.triangles)
    inner = std::min(inner, double(glm::length(sphere.positions[t.x] + sphere.positions[t.y] +
                                               sphere.positions[t.z])) /
                                3);
  for (const glm::dvec3& eye : {glm::dvec3(1.5, 1, -0.5), glm::dvec3(0, 0, -5), glm::dvec3(0, 0, 2),
                                glm::dvec3(-4, 3, 2)}) {
    const SilhouetteView view = viewOf(sphere, eye, 100);
    REQUIRE(view.errors().size() == std::size_t(view.width()) * view.height());
    CHECK_FALSE(view.empty());
    const Image image(view, eye);
    CHECK(glm::determinant(image.toWorld) == doctest::Approx(1));
    const double distance = glm::length(eye);
    const double angle = 2 * std::numbers::pi * (1 - std::sqrt(1 - 1 / (distance * distance)));
    int wrong = 0;
    double summed = 0;
    for (int row = 0; row < view.height(); ++row)
      for (int column = 0; column < view.width(); ++column) {
        const glm::dvec3 ray = image.ray(column, row);
        const float error = view.errors()[std::size_t(row) * view.width() + column];
        if (error < 0) summed -= error;
        const double part = image.pixel * image.pixel / std::pow(glm::length(ray), 3) / angle;
        wrong += std::abs(std::abs(error) / part - 1) > 0.02;
        if (beyondRim(image.toWorld * ray, -eye, inner - 1e-6) < 0) wrong += error > 0;
        if (beyondRim(image.toWorld * ray, -eye, 1 + 1e-6) > 0) wrong += error < 0;
      }
    CHECK(wrong == 0);
    CHECK(summed == doctest::Approx(1).epsilon(1e-5));
  }
}

TEST_CASE("the mesh fills the picture of a silhouette view but for a margin") {
  TriangleMesh tall = icosphere(3);
  for (glm::vec3& p : tall.positions) p.y *= 3;
  const SilhouetteView view = viewOf(tall, {0, 0, 20}, 90);
  CHECK(std::max(view.width(), view.height()) == 90);
  CHECK(std::min(view.width(), view.height()) < 60);
  int lower[2] = {90, 90}, upper[2] = {-1, -1};
  for (int row = 0; row < view.height(); ++row)
    for (int column = 0; column < view.width(); ++column) {
      if (view.errors()[std::size_t(row) * view.width() + column] > 0) continue;
      const int at[2] = {column, row};
      for (int i = 0; i < 2; ++i) {
        lower[i] = std::min(lower[i], at[i]);
        upper[i] = std::max(upper[i], at[i]);
      }
    }
  const int size[2] = {view.width(), view.height()};
  for (int i = 0; i < 2; ++i) {
    CHECK(lower[i] >= 5);
    CHECK(upper[i] < size[i] - 5);
    // As much margin before as behind, to a pixel at either end.
    CHECK(std::abs(lower[i] - (size[i] - 1 - upper[i])) <= 2);
  }
  CHECK(std::max(upper[0] - lower[0], upper[1] - lower[1]) > 70);
}

TEST_CASE("a sheet seen from beside is not seen at all") {
  const TriangleMesh sheet = groundGrid(1, 4);
  CHECK(viewOf(sheet, {3, 0, 0.1}, 64).empty());
  CHECK_FALSE(viewOf(sheet, {3, 1, 0.1}, 64).empty());
}

TEST_CASE("a silhouette view's rows of a ball are those of its tangent planes") {
  const glm::dvec3 eye(0.5, 1, 3);
  const SilhouetteView view = viewOf(icosphere(3), eye, 100);
  const Image image(view, eye);
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Ball ball{randomDirection(random) * (1.5 * random.uniform()), 0.01 + random.uniform()};
    const glm::dvec3 center = glm::transpose(image.toWorld) * (ball.center - eye);
    const double up = std::atan2(center.y, center.z);
    const double half = std::asin(ball.radius / std::hypot(center.y, center.z));
    if (std::abs(up) + half > 1.5) continue;
    const Disc disc = view.discOf(ball);
    CHECK(std::abs(disc.firstRow - (std::tan(up - half) - image.top) / image.pixel) < 0.01);
    CHECK(std::abs(disc.endRow - (std::tan(up + half) - image.top) / image.pixel) < 0.01);
  }
}

TEST_CASE("a silhouette view blocks for a ball what a test of each ray says") {
  Random random(4);
  const TriangleMesh sphere = icosphere(3);
  for (const double distance : {1.2, 2.0, 6.0}) {
    const glm::dvec3 eye = distance * randomDirection(random);
    const SilhouetteView view = viewOf(sphere, eye, 64);
    const Image image(view, eye);
    Comparison ahead, around;
    for (int i = 0; i < 150; ++i) {
      const double radius = std::pow(10.0, -1.7 + 2 * random.uniform());
      ahead.add(view, image, eye, {randomDirection(random) * random.uniform(), radius});
      // At all sides of the eye, and around it.
      const glm::dvec3 place = eye + randomDirection(random) * (2 * radius * random.uniform());
      around.add(view, image, eye, {place, radius});
    }
    for (const Comparison& comparison : {ahead, around}) {
      CHECK(comparison.wrong == 0);
      CHECK(comparison.blocked > 10000);
      CHECK(comparison.undecided < comparison.blocked / 100);
    }
  }
}

TEST_CASE("balls behind the eye block no pixel of a silhouette view, balls around it all") {
  const glm::dvec3 eye(0, 0, 3);
  const SilhouetteView view = viewOf(icosphere(3), eye, 64);
  const auto blockedPixels = [&](const Ball& ball) {
    const Disc disc = view.discOf(ball);
    int blocked = 0;
    for (int row = 0; row < view.height(); ++row)
      for (int column = 0; column < view.width(); ++column)
        blocked += blocks(view, disc, column, row);
    return blocked;
  };
  CHECK(blockedPixels({{0, 0, 5}, 1}) == 0);
  CHECK(blockedPixels({{0.5, 0.5, 5}, 1.9}) == 0);
  CHECK(blockedPixels({{0, 4, 3}, 1}) == 0);
  const int all = view.width() * view.height();
  CHECK(blockedPixels({{0, 0, 3}, 0.1}) == all);
  CHECK(blockedPixels({{0.1, 0.2, 2.9}, 0.5}) == all);
  CHECK(blockedPixels({{0.1, 0.2, 3.1}, 0.5}) == all);
}

TEST_CASE("pixels in an interval are those whose centres lie in it") {
  const auto check = [](float begin, float end, int first, int last) {
    const PixelRange range = pixelsIn({begin, end}, 10);
    CHECK(range.begin == first);
    CHECK(range.end == last);
  };
  constexpr float infinity = std::numeric_limits<float>::infinity();
  check(0.4f, 0.6f, 0, 1);
  check(0.6f, 1.4f, 1, 1);
  check(2.5f, 4.5f, 2, 4);
  check(-3, 100, 0, 10);
  check(-infinity, infinity, 0, 10);
  check(9.4f, 12, 9, 10);
  check(9.6f, 12, 10, 10);
  check(-8, -2, 0, 0);
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto begin = float(14 * random.uniform() - 2), end = begin + float(4 * random.uniform());
    const PixelRange range = pixelsIn({begin, end}, 10);
    for (int pixel = 0; pixel < 10; ++pixel) {
      const float center = float(pixel) + 0.5f;
      CHECK((pixel >= range.begin && pixel < range.end) == (center >= begin && center < end));
    }
  }
}
