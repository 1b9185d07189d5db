#include "base/text_format.h"
#include "benchmark/comparison.h"
#include "benchmark/reports.h"
#include "benchmark/table_columns.h"

namespace haarlight::benchmark {

namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

std::string lineOf(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) line += (line.empty() ? "" : ",") + quoted(field);
  return line + "\r\n";
}

}  // namespace

std::string csvReport(const Record& record) {
  const std::vector<Column> columns = tableColumns(record);
  std::vector<std::string> names{"engine", "device", "visibility", "path"};
  for (const Column& column : columns) names.push_back(column.name);
  std::string text = lineOf(names);
  const std::vector<NamedTimes> rows = namedTimes(record);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const RowName& name = rows[i].name;
    std::vector<std::string> fields{name.engine, name.device, name.visibility, name.path};
    for (const Column& column : columns) {
      const auto value = column.value(record.rows[i]);
      fields.push_back(value ? numberText(*value) : "");
    }
    text += lineOf(fields);
  }
  return text;
}

}  // namespace haarlight::benchmark
