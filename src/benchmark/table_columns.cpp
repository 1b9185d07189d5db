#include "benchmark/table_columns.h"

#include <algorithm>

#include "benchmark/paper_table.h"
#include "engine/stage_times.h"

namespace haarlight::benchmark {

namespace {

constexpr double milliseconds = 1e3;
using Part = Column::Part;

std::optional<double> paperFigure(const Row& row, double PaperFigures::*figure) {
  const Setting& at = row.setting;
  const auto figures = paperFigures(at.spheres, at.terms, at.levels);
  return figures ? std::optional((*figures).*figure) : std::nullopt;
}

void addSettings(std::vector<Column>& columns) {
  const auto add = [&](const char* name, int Setting::*setting) {
    columns.push_back({Part::setting, name, name, 1, 0,
                       [setting](const Row& row) { return row.setting.*setting; }});
  };
  add("spheres", &Setting::spheres);
  add("terms", &Setting::terms);
  add("levels", &Setting::levels);
}

void addTimes(std::vector<Column>& columns) {
  columns.push_back({Part::frame, "frames_measured", "frames", 1, 0,
                     [](const Row& row) { return double(row.frame.count); }});
  columns.push_back({Part::frame, "frames_per_second", "frames/s", 1, 1,
                     [](const Row& row) { return row.frame.perSecond(); }});
  const auto add = [&](const char* name, const char* title, double Quartiles::*seconds) {
    columns.push_back({Part::frame, name, title, milliseconds, 3,
                       [seconds](const Row& row) { return row.frame.*seconds; }});
  };
  add("median_seconds", "median", &Quartiles::median);
  add("minimum_seconds", "min", &Quartiles::minimum);
  add("lower_quartile_seconds", "quarter", &Quartiles::lower);
  add("upper_quartile_seconds", "3 quarters", &Quartiles::upper);
}

void addStages(std::vector<Column>& columns) {
  for (const NamedStage& stage : namedStages) {
    std::string title = stage.name;
    std::ranges::replace(title, '_', ' ');
    columns.push_back({Part::stages, stage.name + std::string("_seconds"), title, milliseconds, 3,
                       [stage](const Row& row) { return row.stageMedians.*stage.seconds; }});
  }
  columns.push_back({Part::stages, "light_upload_seconds", "light upload", milliseconds, 3,
                     [](const Row& row) { return row.lightUploadSeconds; }});
}

/// The paper's frames per second and how many times as many these are.
void addPaper(std::vector<Column>& columns, const std::string& name, const std::string& title,
              double PaperFigures::*figure) {
  columns.push_back({Part::frame, "paper_" + name + "_frames_per_second", "paper " + title, 1, 2,
                     [figure](const Row& row) { return paperFigure(row, figure); }});
  columns.push_back({Part::frame, "times_paper_" + name, "times", 1, 1, [figure](const Row& row) {
                       const auto paper = paperFigure(row, figure);
                       return paper ? std::optional(row.frame.perSecond() / *paper) : std::nullopt;
                     }});
}

}  // namespace

std::vector<Column> tableColumns(const Record& record) {
  std::vector<Column> columns;
  addSettings(columns);
  addTimes(columns);
  addStages(columns);
  addPaper(columns, "cpu", "CPU", &PaperFigures::cpu);
  addPaper(columns, "gpu", "GPU", &PaperFigures::gpu);
  columns.push_back({Part::frame, "times_embree", "times Embree", 1, 0, [&record](const Row& row) {
                       const auto embree = embreeSeconds(record);
                       return embree ? std::optional(*embree / row.frame.median) : std::nullopt;
                     }});
  return columns;
}

}  // namespace haarlight::benchmark
