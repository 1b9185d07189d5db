#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "benchmark/record.h"

namespace haarlight::benchmark {

/// By which rows of two records are found to be the same.
struct RowName {
  std::string engine, device, visibility, path;
  Setting setting;

  bool operator==(const RowName&) const = default;
  /// "opencl · Some CPU · exact · fused, 64 spheres, 200 terms, level 2".
  std::string text() const;
};

/// Of a subject's rows; the setting is still to be filled in.
RowName nameOf(const Subject& subject);

struct NamedTimes {
  RowName name;
  Quartiles frame;
};

std::vector<NamedTimes> namedTimes(const Record& record);

/// An earlier record.
struct EarlierRecord {
  std::string file, host, date;
  std::vector<NamedTimes> rows;
};

/// Reads a record that jsonReport has written. Throws InputError with file and place.
EarlierRecord readRecord(const std::filesystem::path& file);

/// Time now over time before; below 1 is faster.
struct RowRatio {
  RowName name;
  double ratio = 1;  ///< of the medians
  /// Of the lower quartile now over the upper one before, and of the upper one now over the lower
  /// one before: how far the ratio is sure.
  double lowest = 1, highest = 1;

  /// "faster" or "slower" where the quartiles do not overlap, else "same".
  const char* verdict() const;
};

struct Comparison {
  EarlierRecord earlier;
  std::vector<RowRatio> ratios;
  /// Rows that the other record does not have.
  std::vector<RowName> onlyNow, onlyBefore;
};

Comparison compareRows(const std::vector<NamedTimes>& now, EarlierRecord before);

}  // namespace haarlight::benchmark
