#pragma once

#include <string>

#include "verify/report/json_writer.h"
#include "verify/report/report.h"

namespace haarlight::verify {

/// The table for a terminal, one line per row, then the first mismatches of every row, then what
/// was skipped and why, then the verdict. `colored`: verdicts in ANSI colours.
std::string textReport(const Report& report, bool colored);

/// One JSON object; docs/verification.schema.json describes it.
std::string jsonReport(const Report& report);
/// The same object as a part of a longer text.
void writeReport(JsonWriter& json, const Report& report);

/// JUnit XML: one test case per row, skipped and failed ones marked.
std::string junitReport(const Report& report);

/// A page of its own, without links to anything: table, mismatches, difference pictures.
std::string htmlReport(const Report& report);

}  // namespace haarlight::verify
