#include <algorithm>
#include <vector>

#include "base/text_format.h"
#include "verify/report/report_writers.h"

namespace haarlight::verify {

namespace {

enum class Outcome { passed, failure, error, skipped };

struct TestCase {
  std::string name;
  Outcome outcome;
  std::string message;
  /// What follows the message.
  std::vector<std::string> lines;
  double seconds = 0;
};

struct Suite {
  std::string name;
  std::vector<TestCase> cases;
};

std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + markup(value) + "\"";
}

TestCase caseOf(const Row& row) {
  TestCase test{row.name(), Outcome::passed, row.note(), {}, row.seconds};
  if (row.verdict() == Verdict::skipped) test.outcome = Outcome::skipped;
  if (row.verdict() != Verdict::differs) return test;
  test.outcome = Outcome::failure;
  test.message = countText(row.mismatches) + " of " + countText(row.compared, "value") + " differ";
  if (row.maximumUlp > 0) test.message += ", by up to " + countText(row.maximumUlp) + " ULP";
  test.lines = mismatchLines(row);
  if (!row.tolerance.empty()) test.lines.push_back("tolerance: " + visible(row.tolerance));
  return test;
}

Suite suiteOf(const RowGroup& group) {
  Suite suite{group.name, {}};
  for (const Row* row : group.rows) suite.cases.push_back(caseOf(*row));
  return suite;
}

/// What concerns no row: devices that were not run, and whether anything was compared at all.
Suite suiteOfRun(const Report& report) {
  Suite suite{"run", {}};
  const bool compared = report.comparedRows() > 0;
  suite.cases.push_back({"values were compared",
                         compared ? Outcome::passed : Outcome::failure,
                         compared ? casesText(report) : "nothing was compared",
                         {}});
  for (const Absent& absent : report.absent)
    suite.cases.push_back({joined({absent.engine, absent.device}, " · "),
                           absent.failed ? Outcome::error : Outcome::skipped,
                           absent.reason,
                           {}});
  return suite;
}

std::string caseText(const TestCase& test, const std::string& suite) {
  const std::string message = attribute("message", test.message);
  std::string content;
  if (test.outcome == Outcome::passed && !test.message.empty())
    content = "<system-out>" + markup(test.message) + "</system-out>";
  if (test.outcome == Outcome::skipped) content = "<skipped" + message + "/>";
  if (test.outcome == Outcome::error)
    content = "<error" + message + attribute("type", "device") + "/>";
  if (test.outcome == Outcome::failure) {
    content = "<failure" + message + attribute("type", "mismatch") + ">";
    for (const std::string& line : test.lines) content += "\n" + markup(line);
    content += "</failure>";
  }
  return "    <testcase" + attribute("name", test.name) + attribute("classname", suite) +
         attribute("time", fixedText(test.seconds, 6)) + ">" + content + "</testcase>\n";
}

std::size_t count(const Suite& suite, Outcome outcome) {
  return std::size_t(std::count_if(suite.cases.begin(), suite.cases.end(),
                                   [&](const TestCase& test) { return test.outcome == outcome; }));
}

/// The attributes that suites and the whole have in common.
std::string totals(const std::vector<Suite>& suites, double seconds) {
  std::size_t tests = 0, failures = 0, errors = 0;
  for (const Suite& suite : suites) {
    tests += suite.cases.size();
    failures += count(suite, Outcome::failure);
    errors += count(suite, Outcome::error);
  }
  return attribute("tests", numberText(tests)) + attribute("failures", numberText(failures)) +
         attribute("errors", numberText(errors)) + attribute("time", fixedText(seconds, 6));
}

std::string suiteText(const Suite& suite, const std::string& date) {
  double seconds = 0;
  std::string cases;
  for (const TestCase& test : suite.cases) {
    seconds += test.seconds;
    cases += caseText(test, suite.name);
  }
  return "  <testsuite" + attribute("name", suite.name) + totals({suite}, seconds) +
         attribute("skipped", numberText(count(suite, Outcome::skipped))) +
         attribute("timestamp", date) + ">\n" + cases + "  </testsuite>\n";
}

}  // namespace

std::string junitReport(const Report& report) {
  std::vector<Suite> suites{suiteOfRun(report)};
  for (const RowGroup& group : groupsOf(report)) suites.push_back(suiteOf(group));
  const std::string name = joined({report.program, "verify"}, " ");
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" +
                     attribute("name", name) + totals(suites, report.seconds) + ">\n";
  for (const Suite& suite : suites) text += suiteText(suite, report.date);
  return text + "</testsuites>\n";
}

}  // namespace haarlight::verify
