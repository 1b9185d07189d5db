#pragma once

#include <cmath>

#include "spheres/silhouette_view.h"

namespace haarlight::test {

/// Whether a view says that the ball of a disc blocks a pixel.
inline bool blocks(const SilhouetteView& view, const SilhouetteView::Disc& disc, int column,
                   int row) {
  if (float(row) < std::floor(disc.firstRow) || float(row) >= std::ceil(disc.endRow)) return false;
  const PixelRange pixels = pixelsIn(view.columnsOf(disc, row), view.width());
  return column >= pixels.begin && column < pixels.end;
}

}  // namespace haarlight::test
