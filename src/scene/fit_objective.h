#pragma once

namespace haarlight {

/// What fitting spheres to a mesh makes small.
enum class FitObjective {
  /// Every point of the mesh lies in a sphere, and the summed volume outside it is least
  /// (Wang et al. 2006): the shadow is never too small, and always too large.
  cover,
  /// The silhouettes of spheres and mesh differ least as seen from around it: what is blocked too
  /// much weighs as much as what is blocked too little, and what spheres take of the sky of the
  /// mesh's own surface counts, too.
  shadow,
};

}  // namespace haarlight
