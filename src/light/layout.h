#pragma once

/// How a picture of the whole sphere of directions lies in a rectangle.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

namespace haarlight {

/// A place in the picture: patch, and the place in the patch in [0, 1]² from its top-left corner.
struct PatchPoint {
  int patch;
  glm::dvec2 position;
};

/// A layout maps one or six rectangular patches of the picture to directions. World: y up, right
/// handed. Every picture shows the sphere from inside, upright and not mirrored.
///
/// `latlong` (width 2 : height 1): top row +Y, centre +Z, a quarter from the left +X, left and
/// right edge −Z: Mitsuba's envmap and OpenEXR's ENVMAP_LATLONG. (HDR Shop has −Z in the centre:
/// turn by 180°.)
///
/// `vcross` (3 : 4) and `hcross` (4 : 3): a cube unfolded around −Z with +X on its right, as HDR
/// Shop does: the column +Y, −Z, −Y and, upside down below, +Z; or the row −X, −Z, +X, +Z.
///
/// `angular` (1 : 1), P. Debevec's light probe: the inscribed circle's centre looks along −Z, +X is
/// on the right, the angle to −Z is proportional to the distance from the centre, the rim is +Z.
class Layout {
 public:
  virtual ~Layout() = default;

  virtual std::string name() const = 0;
  virtual bool fits(int width, int height) const = 0;
  virtual std::string requirement() const = 0;  ///< what fits, in words

  virtual int patchCount() const { return 1; }
  /// Size of every patch in a picture, in pixels, and a patch's top-left pixel.
  virtual glm::ivec2 patchSize(glm::ivec2 picture) const { return picture; }
  virtual glm::ivec2 patchOrigin(int /*patch*/, glm::ivec2 /*picture*/) const { return {0, 0}; }
  /// No less than the angles, in degrees, a patch spans along its two axes (where it is widest).
  virtual glm::dvec2 patchDegrees() const = 0;

  /// Unit direction of a place; places beside the patch continue it, except that those outside
  /// the circle of `angular` all have the rim's direction.
  virtual glm::dvec3 direction(const PatchPoint& point) const = 0;
  /// The place of a direction (any length > 0).
  virtual PatchPoint locate(const glm::dvec3& direction) const = 0;
  /// Whether the picture shows anything there.
  virtual bool covers(glm::dvec2 position) const;
  /// Solid angle in steradians of a rectangle of a patch, in closed form; for `angular` that of the
  /// spherical quadrilateral between its corners.
  virtual double solidAngle(glm::dvec2 lower, glm::dvec2 upper) const = 0;
};

/// The layout called `latlong`, `vcross`, `hcross` or `angular`; with an empty name the one whose
/// aspect ratio the picture has. Throws InputError when there is none or the picture does not fit.
const Layout& chooseLayout(const std::string& name, glm::ivec2 picture);

}  // namespace haarlight
