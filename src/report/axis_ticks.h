#pragma once

#include <string>
#include <vector>

namespace haarlight {

/// Numbers of the form {1, 2, 5} · 10^k · i (i, k whole), evenly spaced and ascending, about
/// `wanted` of them, of which the first is at most `lower` and the last at least `upper`. Needs
/// finite lower <= upper and wanted > 0; has two ticks or more.
std::vector<double> linearTicks(double lower, double upper, int wanted = 5);

/// The same in powers of ten, with 2 · 10^k and 5 · 10^k between them as long as the range is
/// below three decades. Needs finite 0 < lower <= upper.
std::vector<double> logarithmicTicks(double lower, double upper);

/// A tick's number as it is written beside an axis.
std::string tickLabel(double tick);

}  // namespace haarlight
