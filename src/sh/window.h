#pragma once

#include <vector>

#include "sh/vector.h"

namespace haarlight {

/// Windows against ringing: a function cut off after n bands swings about its true value, below
/// zero where it should be dark. Factors that fall with the band damp this, at the price of a
/// softer function.
enum class ShWindow {
  hanning,  ///< (1 + cos(π l/width)) / 2
  lanczos,  ///< sin(π l/width) / (π l/width); milder
};

/// A window's factor for each band l < order: 1 for l = 0, falling to 0 at l = width, 0 beyond.
/// The smaller the width, the stronger the effect; width = order is the mildest that ends where
/// the bands end. Throws std::invalid_argument unless width > 0.
std::vector<double> windowFactors(ShWindow window, double width, int order);

/// A function with its bands windowed; width 0 stands for its order.
template <typename Value>
ShVector<Value> applyWindow(const ShVector<Value>& f, ShWindow window, double width = 0) {
  return scaleBands(f, windowFactors(window, width == 0 ? f.order() : width, f.order()));
}

}  // namespace haarlight
