#pragma once

#include <span>
#include <string>

#include "report/line_plot.h"

namespace haarlight {

/// Plots as one SVG picture that stands by itself, in rows of two, each with its title and the
/// names of its series in their colours, for light and dark screens. Plots without a point are left
/// out.
std::string plotSheetSvg(const std::string& title, std::span<const LinePlot> plots);

}  // namespace haarlight
