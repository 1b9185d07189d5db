#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "benchmark/record.h"
#include "report/line_plot.h"

namespace haarlight::benchmark {

/// The record's roofline as an object of its JSON; null without one.
nlohmann::ordered_json rooflineJson(const Record& record);

/// For people: the ceilings, then a table per row; empty without a roofline.
std::string rooflineText(const Record& record);

/// Operations a second over operations a byte, both logarithmic: the ceilings as lines, stages as
/// points; a plot for each device and kind of visibility.
std::vector<LinePlot> rooflinePlots(const Record& record);

}  // namespace haarlight::benchmark
