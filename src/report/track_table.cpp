#include "report/track_table.h"

#include <algorithm>
#include <functional>

#include "base/text_format.h"

namespace haarlight {

namespace {

using Cell = std::function<std::string(const TrackFrame&, std::size_t object)>;

struct Column {
  std::string title;
  Cell cell;
};

/// A percentage without its sign, which is in the title.
std::string percent(const std::optional<double>& part, int decimals = 2) {
  return part ? fixedText(100 * *part, decimals) : "";
}

/// The columns of one set of measures of an object.
template <typename Measures>
void addMeasures(std::vector<Column>& columns, const std::string& prefix, const Measures& of) {
  const auto add = [&](const std::string& title, const auto& text) {
    columns.push_back({prefix + title, [of, text](const TrackFrame& frame, std::size_t object) {
                         const std::optional<SphereMeasures> measures = of(frame.objects[object]);
                         return measures ? text(*measures) : "";
                       }});
  };
  add("covered %", [](const SphereMeasures& m) { return percent(m.coveredFraction, 3); });
  add("E", [](const SphereMeasures& m) {
    return m.outsideVolumeRatio ? fixedText(*m.outsideVolumeRatio, 4) : "";
  });
  add("outside %", [](const SphereMeasures& m) { return percent(m.unionOutsideRatio); });
  add("uncovered %", [](const SphereMeasures& m) { return percent(m.uncoveredVolumeRatio); });
  add("silhouette %",
      [](const SphereMeasures& m) { return m.silhouette ? percent(m.silhouette->mean) : ""; });
}

void addRadii(std::vector<Column>& columns) {
  for (const auto& [title, ratio] : {std::pair("radius min", &RadiusRatios::smallest),
                                     {"mean", &RadiusRatios::mean},
                                     {"max", &RadiusRatios::largest}})
    columns.push_back({title, [ratio](const TrackFrame& frame, std::size_t object) {
                         return fixedText(frame.objects[object].radii.*ratio, 4);
                       }});
}

std::vector<Column> allColumns(const TrackReport& report) {
  std::vector<Column> columns{
      {"frame", [](const TrackFrame& frame, std::size_t) { return numberText(frame.frame); }},
      {"object", [&](const TrackFrame&, std::size_t object) {
         return report.objects.size() > 1 ? visible(report.objects[object]) : "";
       }}};
  addMeasures(columns, "", [](const ObjectFrame& object) { return std::optional(object.moved); });
  addRadii(columns);
  columns.push_back({"plane %", [](const TrackFrame& frame, std::size_t) {
                       return frame.plane ? percent(frame.plane->moved.relativeRootMeanSquare) : "";
                     }});
  addMeasures(columns, "refit ", [](const ObjectFrame& object) { return object.refitted; });
  columns.push_back({"refit plane %", [](const TrackFrame& frame, std::size_t) {
                       return frame.plane && frame.plane->refitted
                                  ? percent(frame.plane->refitted->relativeRootMeanSquare)
                                  : "";
                     }});
  return columns;
}

}  // namespace

TrackTable trackTable(const TrackReport& report) {
  TrackTable table;
  table.rows.resize(report.frames.size() * report.objects.size());
  for (const Column& column : allColumns(report)) {
    std::vector<std::string> cells;
    for (const TrackFrame& frame : report.frames)
      for (std::size_t object = 0; object < report.objects.size(); ++object)
        cells.push_back(column.cell(frame, object));
    if (std::ranges::all_of(cells, &std::string::empty)) continue;
    table.header.push_back(column.title);
    for (std::size_t i = 0; i < cells.size(); ++i)
      table.rows[i].push_back(cells[i].empty() ? "-" : cells[i]);
  }
  return table;
}

std::string trackText(const TrackReport& report) {
  const TrackTable table = trackTable(report);
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < table.header.size(); ++column) {
    widths.push_back(table.header[column].size());
    for (const auto& row : table.rows)
      widths[column] = std::max(widths[column], row[column].size());
  }
  std::string text;
  const auto append = [&](const std::vector<std::string>& row) {
    for (std::size_t column = 0; column < row.size(); ++column)
      text += std::string(widths[column] - row[column].size(), ' ') + row[column] +
              (column + 1 < row.size() ? "  " : "\n");
  };
  append(table.header);
  for (const auto& row : table.rows) append(row);
  return text;
}

}  // namespace haarlight
