#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "benchmark/comparison.h"
#include "benchmark/record.h"

namespace haarlight::benchmark {

/// For people: a table per subject, then peers, sweeps, the roofline and the comparison with an
/// earlier record, where there are any.
std::string textReport(const Record& record, const Comparison* comparison);

/// One JSON object; docs/benchmark.schema.json describes it.
nlohmann::ordered_json jsonReport(const Record& record, const Comparison* comparison);

/// What a row is found by, as that object has it.
nlohmann::ordered_json nameJson(const RowName& name);

/// One line per row, below the names of the columns. Times are in seconds, numbers as exact as
/// double is. Texts are quoted where they have to be (RFC 4180).
std::string csvReport(const Record& record);

/// Fig. 8 of the paper drawn again, linear and logarithmic, with the paper's own lines; error over
/// time where there are peers; the sweeps with logarithmic axes, and rooflines, where there are
/// any.
std::string svgReport(const Record& record);

}  // namespace haarlight::benchmark
