#include "benchmark/comparison.h"

#include <algorithm>

#include "base/file.h"
#include "base/text_format.h"
#include "scene/json_text.h"
#include "scene/json_value.h"

namespace haarlight::benchmark {

namespace {

constexpr std::uint64_t largestRecord = 64 << 20;
constexpr std::size_t mostRows = 100000;
constexpr Range anyCount{0, 1e9};
constexpr Range anySeconds{1e-12, 1e12};

JsonValue required(const JsonValue& object, const std::string& name) {
  object.requireObject();
  if (!object.json().contains(name)) object.fail("has no \"" + name + "\"");
  return object.member(name);
}

NamedTimes readRow(const JsonValue& row) {
  const auto count = [&](const char* name) { return required(row, name).integer(anyCount); };
  const JsonValue seconds = required(row, "frame_seconds");
  const auto time = [&](const char* name) { return required(seconds, name).number(anySeconds); };
  return {{required(row, "engine").text(),
           required(row, "device").text(),
           required(row, "visibility").text(),
           required(row, "path").text(),
           {count("spheres"), count("terms"), count("levels")}},
          {std::size_t(count("frames_measured")), time("minimum"), time("lower_quartile"),
           time("median"), time("upper_quartile")}};
}
const NamedTimes* find(const std::vector<NamedTimes>& rows, const RowName& name) {
  const auto found = std::ranges::find(rows, name, &NamedTimes::name);
  return found == rows.end() ? nullptr : &*found;
}

RowRatio ratioOf(const RowName& name, const Quartiles& now, const Quartiles& before) {
  return {name, now.median / before.median, now.lower / before.upper, now.upper / before.lower};
}

}  // namespace

std::string RowName::text() const {
  return joined({engine, device, visibility, path}, " · ") + ", " +
         countText(std::uint64_t(setting.spheres), "sphere") + ", " +
         countText(std::uint64_t(setting.terms), "term") + ", level " + numberText(setting.levels);
}

RowName nameOf(const Subject& subject) {
  return {
      subject.device.engine, subject.device.name, subject.visibilityName(), subject.pathName(), {}};
}

std::vector<NamedTimes> namedTimes(const Record& record) {
  std::vector<NamedTimes> rows;
  for (const Row& row : record.rows) {
    rows.push_back({nameOf(record.subjects[row.subject].subject), row.frame});
    rows.back().name.setting = row.setting;
  }
  return rows;
}

EarlierRecord readRecord(const std::filesystem::path& file) {
  const auto bytes = readWholeFile(file, "benchmark record", largestRecord);
  const auto json = parseJson(
      std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()), file.string());
  const JsonSource source{file.string(), file.parent_path()};
  const JsonValue root(json, "", source);
  EarlierRecord record{
      file.string(), required(root, "host").text(), required(root, "date_utc").text(), {}};
  const JsonValue rows = required(root, "rows");
  rows.requireArray(mostRows);
  for (std::size_t i = 0; i < rows.json().size(); ++i)
    record.rows.push_back(readRow(rows.element(i)));
  return record;
}

const char* RowRatio::verdict() const {
  return highest < 1 ? "faster" : lowest > 1 ? "slower" : "same";
}

Comparison compareRows(const std::vector<NamedTimes>& now, EarlierRecord before) {
  Comparison comparison;
  for (const NamedTimes& row : now)
    if (const NamedTimes* earlier = find(before.rows, row.name))
      comparison.ratios.push_back(ratioOf(row.name, row.frame, earlier->frame));
    else
      comparison.onlyNow.push_back(row.name);
  for (const NamedTimes& row : before.rows)
    if (!find(now, row.name)) comparison.onlyBefore.push_back(row.name);
  comparison.earlier = std::move(before);
  return comparison;
}

}  // namespace haarlight::benchmark
