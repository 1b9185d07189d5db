#pragma once

/// The table of results, as the terminal and the page show it.

#include <array>
#include <string>
#include <vector>

#include "base/text_format.h"
#include "verify/report/report.h"

namespace haarlight::verify {

struct TableColumn {
  const char* title;
  /// Numbers stand to the right.
  bool number;
};
inline constexpr std::array tableColumns{
    TableColumn{"stage", false},   TableColumn{"visibility", false}, TableColumn{"setting", false},
    TableColumn{"compared", true}, TableColumn{"differ", true},      TableColumn{"max ULP", true},
    TableColumn{"median", true},   TableColumn{"verdict", false},    TableColumn{"seconds", true}};
inline constexpr std::size_t verdictColumn = 7;

using TableCells = std::array<std::string, tableColumns.size()>;

/// A row's cells; `notes` as of notesOf(). What was not measured is "-".
inline TableCells tableCells(const Row& row, const std::vector<std::string>& notes) {
  const bool compared = row.verdict() != Verdict::skipped;
  const bool hasUlp = compared && givesFloats(row.stage);
  const auto shown = [](bool present, const std::string& text) { return present ? text : "-"; };
  return {nameOf(row.stage),
          visible(row.visibility),
          visible(row.setting),
          shown(compared, countText(row.compared)),
          shown(compared, countText(row.mismatches)),
          shown(hasUlp, countText(row.maximumUlp)),
          shown(hasUlp, fixedText(row.medianUlp, 1)),
          joined({nameOf(row.verdict()), noteMark(notes, row)}, " "),
          shown(compared, fixedText(row.seconds, 3))};
}

}  // namespace haarlight::verify
