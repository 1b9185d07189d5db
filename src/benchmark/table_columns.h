#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/record.h"

namespace haarlight::benchmark {

/// A figure of the rows, for all reports.
struct Column {
  /// Which of the tables that people read holds it; settings are in both.
  enum class Part { setting, frame, stages } part = Part::frame;
  /// As CSV has it, with the unit where it has one.
  std::string name;
  /// As people read it.
  std::string title;
  /// What people read is this many times the value, with so many decimals.
  double scale = 1;
  int decimals = 0;
  /// Nothing where a row does not have it.
  std::function<std::optional<double>(const Row&)> value;
};

/// Setting, frames per second, spread, stages, and the ratios to the paper's figures and to
/// Embree's pixel basis. The record has to outlive them.
std::vector<Column> tableColumns(const Record& record);

}  // namespace haarlight::benchmark
