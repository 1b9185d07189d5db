#include "report/fit_pictures.h"

#include <array>
#include <glm/ext/scalar_constants.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "image/tonemap.h"
#include "mesh/builtin_meshes.h"
#include "test_support.h"

using namespace haarlight;

namespace {

glm::dvec3 linearColor(Silhouette silhouette) {
  glm::dvec3 color;
  for (int c = 0; c < 3; ++c)
    color[c] = linearFromSrgb(float(silhouetteColor(silhouette)[c]) / 255);
  return color;
}

/// How many pixels three kinds of places take up in a picture without the fourth.
glm::dvec3 areasOf(const std::array<Silhouette, 3>& kinds, const Image& image) {
  glm::dmat3 colors;
  for (int i = 0; i < 3; ++i) colors[i] = linearColor(kinds[i]);
  glm::dvec3 sum(0);
  for (const glm::vec3& pixel : image.pixels) sum += glm::dvec3(pixel);
  return glm::inverse(colors) * sum;
}

/// The middle of all that is not background, in pixels to the right of and above the middle.
glm::dvec2 centroid(const Image& image) {
  const glm::vec3 background(linearColor(Silhouette::neither));
  glm::dvec2 sum(0);
  double count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (glm::distance(image.at(x, y), background) > 1e-4f) {
        sum += glm::dvec2(x + 0.5 - image.width / 2.0, image.height / 2.0 - (y + 0.5));
        ++count;
      }
  return sum / count;
}

double discArea(double radius, double pixelsPerUnit) {
  return glm::pi<double>() * radius * radius * pixelsPerUnit * pixelsPerUnit;
}

}  // namespace

TEST_CASE("a unit sphere is a disc of area pi from every side") {
  const auto pictures = drawFit(icosphere(5), std::vector<Sphere>{{{0, 0, 0}, 1}});
  REQUIRE(pictures.views.size() == 3);
  CHECK(pictures.pixelsPerUnit > 150);
  for (const FitView& view : pictures.views) {
    CAPTURE(view.name);
    const glm::dvec3 areas =
        areasOf({Silhouette::neither, Silhouette::both, Silhouette::spheresOnly}, view.silhouettes);
    const double disc = discArea(1, pictures.pixelsPerUnit);
    CHECK(areas[1] + areas[2] == doctest::Approx(disc).epsilon(0.002));
    // An icosphere lies in its sphere, 0.1 % below it.
    CHECK(areas[1] == doctest::Approx(disc).epsilon(0.004));
    CHECK(view.over >= 0);
    CHECK(view.over < 0.004);
    CHECK(view.under < 1e-4);
  }
}

TEST_CASE("a sphere that is too large or too small differs by a ring") {
  for (const float radius : {1.25f, 0.8f}) {
    const bool large = radius > 1;
    const auto pictures = drawFit(icosphere(5), std::vector<Sphere>{{{0, 0, 0}, radius}});
    const double disc = discArea(1, pictures.pixelsPerUnit);
    for (const FitView& view : pictures.views) {
      const Silhouette ring = large ? Silhouette::spheresOnly : Silhouette::meshOnly;
      const glm::dvec3 areas =
          areasOf({Silhouette::neither, Silhouette::both, ring}, view.silhouettes);
      // 1.25² − 1 = 0.5625, 1 − 0.8² = 0.36
      CHECK(areas[1] == doctest::Approx(disc * (large ? 1 : 0.64)).epsilon(0.005));
      CHECK(areas[2] == doctest::Approx(disc * (large ? 0.5625 : 0.36)).epsilon(0.01));
      CHECK(view.over == doctest::Approx(large ? 0.5625 : 0).epsilon(0.01));
      CHECK(view.under == doctest::Approx(large ? 0 : 0.36).epsilon(0.01));
    }
  }
}

TEST_CASE("the three sides show what lies where") {
  struct Expected {
    glm::vec3 place;
    std::array<glm::dvec2, 3> inView;  // to the right and up: front, side, top
  };
  for (const Expected& expected :
       {Expected{{3, 0, 0}, {glm::dvec2(3, 0), glm::dvec2(0, 0), glm::dvec2(3, 0)}},
        Expected{{0, 3, 0}, {glm::dvec2(0, 3), glm::dvec2(0, 3), glm::dvec2(0, 0)}},
        Expected{{0, 0, 3}, {glm::dvec2(0, 0), glm::dvec2(-3, 0), glm::dvec2(0, -3)}}}) {
    const auto pictures = drawFit(icosphere(3), std::vector<Sphere>{{expected.place, 1}});
    for (int i = 0; i < 3; ++i) {
      const FitView& view = pictures.views[i];
      CAPTURE(view.name);
      const glm::dvec2 offset = centroid(view.spheres) - centroid(view.mesh);
      CHECK(glm::distance(offset, pictures.pixelsPerUnit * expected.inView[i]) < 1);
    }
  }
  CHECK(drawFit(icosphere(1), {}, 8).views[2].name == "top");
}

TEST_CASE("a nearer sphere hides another") {
  const Sphere large{{0, 0, 0}, 1}, hidden{{0.2f, 0.1f, 0}, 0.5f};
  const auto alone = drawFit(icosphere(2), std::vector{large}, 64);
  const auto both = drawFit(icosphere(2), std::vector{large, hidden}, 64);
  const auto apart = drawFit(icosphere(2), std::vector{large, Sphere{{0.7f, 0, 0}, 0.5f}}, 64);
  for (int i = 0; i < 3; ++i) CHECK(alone.views[i].spheres.pixels == both.views[i].spheres.pixels);
  CHECK(apart.views[0].spheres.pixels != alone.views[0].spheres.pixels);
}

TEST_CASE("pictures do not depend on the mesh's scale") {
  TriangleMesh mesh = torusKnot();
  std::vector<Sphere> spheres{{{0.5f, 0.25f, 0}, 0.5f}};
  const auto before = drawFit(mesh, spheres, 64);
  constexpr float factor = 1 << 20;
  for (glm::vec3& position : mesh.positions) position *= factor;
  for (Sphere& sphere : spheres) sphere = {factor * sphere.center, factor * sphere.radius};
  const auto after = drawFit(mesh, spheres, 64);
  CHECK(after.pixelsPerUnit * factor == before.pixelsPerUnit);
  for (int i = 0; i < 3; ++i) {
    CHECK(after.views[i].mesh.pixels == before.views[i].mesh.pixels);
    CHECK(after.views[i].spheres.pixels == before.views[i].spheres.pixels);
    CHECK(after.views[i].silhouettes.pixels == before.views[i].silhouettes.pixels);
  }
}

TEST_CASE("the lit side of a mesh does not depend on its winding") {
  TriangleMesh mesh = icosphere(3);
  const auto before = drawFit(mesh, {}, 64);
  for (glm::uvec3& triangle : mesh.triangles) std::swap(triangle.x, triangle.y);
  for (glm::vec3& normal : mesh.normals) normal = -normal;
  const auto after = drawFit(mesh, {}, 64);
  double sum = 0;
  for (std::size_t i = 0; i < before.views[0].mesh.pixels.size(); ++i)
    sum += glm::distance(before.views[0].mesh.pixels[i], after.views[0].mesh.pixels[i]);
  CHECK(sum / double(before.views[0].mesh.pixels.size()) < 1e-3);
}
