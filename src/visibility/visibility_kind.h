#pragma once

namespace haarlight {

/// How the bit cube of one sphere is found.
enum class VisibilityKind {
  /// By testing the texels of the rows it may reach (visibility/exact_visibility.h).
  exact,
  /// By the paper's table of quantised directions and radii (visibility/sphere_table.h).
  table
};

}  // namespace haarlight
