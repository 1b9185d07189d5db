#include "benchmark/comparison.h"

#include "base/error.h"
#include "benchmark/reports.h"
#include "example_record.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::benchmark;
using namespace haarlight::test;

namespace {

NamedTimes timesOf(int spheres, const Quartiles& frame) {
  return {{"opencl", "device", "exact", "fused", {spheres, 200, 2}}, frame};
}

EarlierRecord earlierWith(const std::vector<NamedTimes>& rows) {
  return {"old.json", "host", "date", rows};
}

/// minimum, lower quartile, median, upper quartile
Quartiles quartiles(double minimum, double lower, double median, double upper) {
  return {5, minimum, lower, median, upper};
}

}  // namespace

TEST_CASE("ratios are of medians, and their range of opposite quartiles") {
  const auto comparison = compareRows({timesOf(64, quartiles(1, 2, 3, 4))},
                                      earlierWith({timesOf(64, quartiles(4, 5, 6, 8))}));
  REQUIRE(comparison.ratios.size() == 1);
  CHECK(comparison.ratios[0].ratio == 0.5);
  CHECK(comparison.ratios[0].lowest == 0.25);
  CHECK(comparison.ratios[0].highest == 0.8);
  CHECK(comparison.ratios[0].verdict() == std::string("faster"));
}

TEST_CASE("a verdict needs quartiles that do not overlap") {
  const auto verdict = [](const Quartiles& now, const Quartiles& before) {
    const auto comparison = compareRows({timesOf(1, now)}, earlierWith({timesOf(1, before)}));
    return std::string(comparison.ratios.at(0).verdict());
  };
  CHECK(verdict(quartiles(1, 2, 3, 4), quartiles(1, 2, 3, 4)) == "same");
  CHECK(verdict(quartiles(1, 2, 3, 5), quartiles(1, 4, 6, 8)) == "same");
  CHECK(verdict(quartiles(1, 2, 3, 3.9), quartiles(1, 4, 6, 8)) == "faster");
  CHECK(verdict(quartiles(1, 4, 6, 8), quartiles(1, 2, 3, 3.9)) == "slower");
}

TEST_CASE("rows that only one record has are named") {
  const Quartiles frame = quartiles(1, 2, 3, 4);
  NamedTimes otherPath = timesOf(32, frame);
  otherPath.name.path = "staged";
  const auto comparison = compareRows({timesOf(32, frame), timesOf(64, frame)},
                                      earlierWith({timesOf(64, frame), otherPath}));
  CHECK(comparison.ratios.size() == 1);
  REQUIRE(comparison.onlyNow.size() == 1);
  CHECK(comparison.onlyNow[0].text() ==
        "opencl · device · exact · fused, 32 spheres, 200 terms, level 2");
  REQUIRE(comparison.onlyBefore.size() == 1);
  CHECK(comparison.onlyBefore[0] == otherPath.name);
}

TEST_CASE("a record is read as it was written") {
  const TemporaryFolder folder;
  const Record record = exampleRecord();
  writeFile(folder / "old.json", jsonReport(record, nullptr).dump());
  const EarlierRecord earlier = readRecord(folder / "old.json");
  CHECK(earlier.host == record.host);
  CHECK(earlier.date == record.date);
  const auto comparison = compareRows(namedTimes(record), earlier);
  CHECK(comparison.ratios.size() == record.rows.size());
  for (const RowRatio& ratio : comparison.ratios) CHECK(ratio.ratio == 1);
  CHECK(comparison.ratios[0].lowest == earlier.rows[0].frame.lower / earlier.rows[0].frame.upper);
  CHECK(comparison.onlyNow.empty());
  CHECK(comparison.onlyBefore.empty());
}

TEST_CASE("what is no record is refused with file and place") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& named) {
    writeFile(folder / "bad.json", text);
    CHECK_THROWS_WITH_AS(readRecord(folder / "bad.json"), doctest::Contains(named.c_str()),
                         InputError);
  };
  refused("{", "bad.json");
  refused("[]", "must be an object");
  refused("{}", "host");
  nlohmann::json json = jsonReport(exampleRecord(), nullptr);
  nlohmann::json missing = json;
  missing["rows"][1].erase("path");
  refused(missing.dump(), "rows[1]: has no \"path\"");
  json["rows"][2]["frame_seconds"]["median"] = 0;
  refused(json.dump(), "rows[2].frame_seconds.median");
  CHECK_THROWS_AS(readRecord(folder / "absent.json"), InputError);
}
