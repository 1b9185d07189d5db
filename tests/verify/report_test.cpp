#include "verify/report/report.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "base/html.h"
#include "png_test_support.h"
#include "report_test_support.h"
#include "test_support.h"
#include "verify/report/json_writer.h"
#include "verify/report/picture.h"
#include "verify/report/report_writers.h"

using namespace haarlight;
using namespace haarlight::test;
using namespace haarlight::verify;

namespace {

const std::string odd = "a<&\"']]>\n\x01\xff\xed\xa0\x80\xef\xbf\xbfé";
/// `odd` as people see it: every byte that is no UTF-8 is one U+FFFD.
const std::string oddVisible = "a<&\"']]>\\n\\x1\uFFFD\uFFFD\uFFFD\uFFFD\\xffffé";

Row rowOf(Stage stage, const std::string& setting, std::uint64_t compared) {
  Row row;
  row.stage = stage;
  row.visibility = "exact";
  row.setting = setting;
  row.engine = "opencl";
  row.device = "Some CPU";
  row.shape = "1 lane";
  row.compared = compared;
  row.seconds = 0.25;
  return row;
}

Report agreeingReport() {
  Report report;
  report.program = "haarlight 0.1.0";
  report.host = "Some CPU";
  report.date = "2026-01-02T03:04:05Z";
  report.seed = 7;
  report.knownCases = 12;
  report.sceneCases = 3;
  report.randomCases = 1000;
  report.seconds = 61.25;
  report.rows = {rowOf(Stage::bitCubes, "", 6291456),
                 rowOf(Stage::frame, "50 terms, level I", 3000)};
  return report;
}

/// Adds: a float row of another shape that differs, a skipped and a tolerated row, two devices,
/// faults.
Report fullReport() {
  Report report = agreeingReport();
  Row differing = rowOf(Stage::tripleProduct, "200 terms, level II", 3000);
  differing.shape = "32 lanes";
  differing.mismatches = 3;
  differing.maximumUlp = 1;
  differing.firstMismatches = {{"random 17", 4, "green", true, 0x3F800000, 0x3F800001, 1},
                               {"random 18", 5, "red", true, 0x3F800000, 0x7FC00000, 4294967295}};
  differing.pictures = {bitCubePicture("random 17", {}, {{1}})};
  Row skipped = rowOf(Stage::tableEntries, "", 0);
  skipped.visibility = "table";
  skipped.skipReason = "no table";
  Row tolerated = rowOf(Stage::frame, "1 term, level I", 3000);
  tolerated.tolerance = "flushes denormals";
  tolerated.maximumUlp = 12345;
  tolerated.medianUlp = 0.5;
  report.rows.insert(report.rows.end(), {differing, skipped, tolerated});
  report.absent = {{"cuda", "", "no driver", false}, {"opencl", "Broken GPU", "no kernels", true}};
  report.faults = {{"ulp", "opencl", "Some CPU", "32 lanes", "exact", 2, 2, 0},
                   {"ulp", "opencl", "Some CPU", "1 lane", "exact", 2, 1, 0}};
  return report;
}

/// The one row in its own report.
Report reportOf(const Row& row) {
  Report report = agreeingReport();
  report.rows = {row};
  return report;
}

/// Every foreign text is `odd`.
Report oddReport() {
  Report report = fullReport();
  report.program = report.host = report.date = odd;
  for (Row& row : report.rows) {
    row.visibility = row.setting = row.engine = row.device = row.shape = odd;
    if (!row.tolerance.empty()) row.tolerance = odd;
    if (row.skipped()) row.skipReason = odd;
    for (Mismatch& mismatch : row.firstMismatches) mismatch.caseName = mismatch.place = odd;
    for (DifferencePicture& picture : row.pictures) picture.title = odd;
  }
  for (Absent& absent : report.absent) absent.engine = absent.device = absent.reason = odd;
  for (FaultSummary& faults : report.faults) faults.engine = faults.device = faults.shape = odd;
  return report;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("a report agrees when something was compared and nothing differs or failed") {
  const Row row = rowOf(Stage::frame, "", 10);
  Row differing = row, skipped = row, empty = row;
  differing.mismatches = 1;
  differing.tolerance = "mismatches lie beyond it";
  skipped.skipReason = "no table";
  empty.compared = 0;
  CHECK(reportOf(row).agrees());
  CHECK(!reportOf(differing).agrees());
  CHECK(!reportOf(skipped).agrees());
  CHECK(!reportOf(empty).agrees());
  CHECK(!Report().agrees());
  Report report = reportOf(row);
  report.rows.push_back(skipped);
  report.absent.push_back({"cuda", "", "no driver", false});
  CHECK(report.agrees());
  report.absent.back().failed = true;
  CHECK(!report.agrees());
}

TEST_CASE("verdicts") {
  Row row = rowOf(Stage::frame, "", 10);
  CHECK(row.verdict() == Verdict::agrees);
  CHECK(row.note().empty());
  row.tolerance = "flushes denormals";
  CHECK(row.verdict() == Verdict::withinTolerance);
  CHECK(row.note() == "flushes denormals");
  row.mismatches = 1;
  CHECK(row.verdict() == Verdict::differs);
  CHECK(row.note() == "flushes denormals");
  row.mismatches = 0;
  row.skipReason = "no table";
  CHECK(row.verdict() == Verdict::skipped);
  CHECK(row.note() == "no table");
}

TEST_CASE("conclusions") {
  CHECK(agreeingReport().conclusion() ==
        "AGREES: 6,294,456 values in 2 rows, all with the reference's bits");
  CHECK(fullReport().conclusion() == "DIFFERS: 3 values in 1 row; 1 device failed");
  CHECK(Report().conclusion() == "FAILED: nothing was compared");
  Report report = agreeingReport();
  report.absent = {{"opencl", "Broken GPU", "no kernels", true}};
  CHECK(report.conclusion() == "FAILED: 1 device failed");
}

TEST_CASE("the text report of a run that agrees") {
  CHECK(textReport(agreeingReport(), false) == R"(haarlight 0.1.0 · Some CPU · 2026-01-02T03:04:05Z
seed 7 · 12 known, 3 scene and 1,000 random cases · 61.2 s

  stage      visibility  setting             compared  differ  max ULP  median  verdict  seconds

opencl · Some CPU · 1 lane
  bit cubes  exact                          6,291,456       0        -       -  AGREES     0.250
  frame      exact       50 terms, level I      3,000       0        0     0.0  AGREES     0.250

AGREES: 6,294,456 values in 2 rows, all with the reference's bits
)");
}

TEST_CASE("the text report of a run that differs") {
  const std::string text = textReport(fullReport(), false);
  const std::string table = R"(
opencl · Some CPU · 1 lane
  bit cubes       exact                            6,291,456       0        -       -  AGREES                  0.250
  frame           exact       50 terms, level I        3,000       0        0     0.0  AGREES                  0.250
  table entries   table                                    -       -        -       -  skipped [1]                 -
  frame           exact       1 term, level I          3,000       0   12,345     0.5  within tolerance [2]    0.250

opencl · Some CPU · 32 lanes
  triple product  exact       200 terms, level II      3,000       3        1     0.0  DIFFERS                 0.250

Mismatches
  opencl · Some CPU · 32 lanes
  triple product, exact, 200 terms, level II
    random 17 · sample 4 · green
      expected 0x3f800000 = 1   actual 0x3f800001 = 1.00000012   1 ULP
    random 18 · sample 5 · red
      expected 0x3f800000 = 1   actual 0x7fc00000 = nan   4,294,967,295 ULP
    and 1 more

Notes
  [1] no table
  [2] flushes denormals

Not run
  not run  cuda: no driver
  FAILED   opencl · Broken GPU: no kernels

Injected faults
  located  ulp · opencl · Some CPU · 32 lanes · exact: 2 injected, 2 located, 0 mismatches elsewhere
  MISSED   ulp · opencl · Some CPU · 1 lane · exact: 2 injected, 1 located, 0 mismatches elsewhere

DIFFERS: 3 values in 1 row; 1 device failed
)";
  CHECK(text.find(table) != std::string::npos);
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1)
    CHECK(text.find('\n', begin) - begin <= 120);
}

TEST_CASE("the text report has colours only where wanted, and no other control characters") {
  for (const bool colored : {false, true}) {
    const std::string text = textReport(oddReport(), colored);
    CHECK((text.find("\x1b[1;31mDIFFERS") != std::string::npos) == colored);
    CHECK((occurrences(text, "\x1b[") > 0) == colored);
    CHECK(text.find('\x01') == std::string::npos);
    CHECK(text.find(oddVisible) != std::string::npos);
  }
}

TEST_CASE("the JSON report") {
  const Json json = readJson(jsonReport(fullReport()));
  CHECK(json.at("/agrees") == "false");
  CHECK(json.at("/seed") == "7");
  CHECK(json.at("/cases/random") == "1000");
  CHECK(json.at("/rows/0/stage") == "\"bit_cubes\"");
  CHECK(json.at("/rows/0/setting") == "null");
  CHECK(json.at("/rows/0/compared_values") == "6291456");
  CHECK(json.at("/rows/2/verdict") == "\"differs\"");
  CHECK(json.at("/rows/2/mismatched_values") == "3");
  CHECK(json.at("/rows/2/first_mismatches/0/actual_bits") == "\"0x3f800001\"");
  CHECK(std::stof(json.at("/rows/2/first_mismatches/0/actual")) ==
        std::bit_cast<float>(0x3F800001));
  CHECK(json.at("/rows/2/first_mismatches/1/actual") == "null");
  CHECK(json.at("/rows/3/skip_reason") == "\"no table\"");
  CHECK(json.at("/rows/4/verdict") == "\"within_tolerance\"");
  CHECK(json.at("/rows/4/median_ulp") == "0.5");
  CHECK(json.at("/absent/1/failed") == "true");
  CHECK(json.at("/injected/0/all_located") == "true");
  CHECK(json.at("/injected/1/located_faults") == "1");
  CHECK(readJson(jsonReport(oddReport())).at("/host") == R"("a<&\"']]>\n\u0001)"
                                                         "\uFFFD\uFFFD\uFFFD\uFFFD\uFFFFé\"");
}

TEST_CASE("the JSON report has the names of its schema") {
  const Json schema =
      readJson(readFile(HAARLIGHT_KNOWN_ANSWERS "/../../docs/verification.schema.json"));
  const Json json = readJson(jsonReport(fullReport()));
  for (const auto& [place, definition] :
       std::map<std::string, std::string>{{"", ""},
                                          {"/cases", "/properties/cases"},
                                          {"/rows/2", "/$defs/row"},
                                          {"/rows/2/first_mismatches/0", "/$defs/mismatch"},
                                          {"/absent/0", "/$defs/absent"},
                                          {"/injected/0", "/$defs/injected"}}) {
    CAPTURE(definition);
    std::set<std::string> required;
    for (const std::string& index : namesBelow(schema, definition + "/required")) {
      const std::string& name = schema.at(definition + "/required/" + index);
      required.insert(name.substr(1, name.size() - 2));
    }
    CHECK(namesBelow(json, place) == required);
    CHECK(namesBelow(schema, definition + "/properties") == required);
    CHECK(schema.at(definition + "/additionalProperties") == "false");
  }
}

TEST_CASE("the JUnit report") {
  const std::vector<Element> elements = readXml(junitReport(fullReport()));
  const std::vector<Element> suites = named(elements, "testsuite");
  REQUIRE(suites.size() == 3);
  CHECK(suites[1].attributes.at("name") == "opencl · Some CPU · 1 lane");
  CHECK(suites[1].attributes.at("tests") == "4");
  CHECK(suites[1].attributes.at("skipped") == "1");
  CHECK(suites[1].attributes.at("time") == "1.000000");
  CHECK(elements[0].attributes.at("tests") == "8");
  CHECK(elements[0].attributes.at("failures") == "1");
  CHECK(elements[0].attributes.at("errors") == "1");
  CHECK(named(elements, "testcase").size() == 8);
  const Element failure = named(elements, "failure").at(0);
  CHECK(failure.attributes.at("message") == "3 of 3,000 values differ, by up to 1 ULP");
  CHECK(failure.text.find("actual 0x3f800001 = 1.00000012   1 ULP\n") != std::string::npos);
  CHECK(named(elements, "error").at(0).attributes.at("message") == "no kernels");
  CHECK(named(elements, "skipped").at(1).attributes.at("message") == "no table");
}

TEST_CASE("the JUnit report fails exactly when the report does not agree") {
  const auto fails = [](const Report& report) {
    const Element all = readXml(junitReport(report)).at(0);
    return all.attributes.at("failures") != "0" || all.attributes.at("errors") != "0";
  };
  Report skipped = agreeingReport(), broken = agreeingReport();
  for (Row& row : skipped.rows) row.skipReason = "no table";
  broken.absent = {{"opencl", "Broken GPU", "no kernels", true}};
  for (const Report& report : {agreeingReport(), skipped, broken, fullReport(), Report()})
    CHECK(fails(report) == !report.agrees());
}

TEST_CASE("odd characters in XML and HTML") {
  const std::vector<Element> junit = readXml(junitReport(oddReport()));
  CHECK(named(junit, "error").at(0).attributes.at("message") == oddVisible);
  CHECK(named(junit, "failure").at(0).text.find(oddVisible) != std::string::npos);
  const std::vector<Element> html = readXml(htmlReport(oddReport()));
  CHECK(named(html, "dd").at(0).text == oddVisible);
  CHECK(named(html, "figcaption").at(0).text == oddVisible);
}

TEST_CASE("the HTML report is one page of its own") {
  const std::string page = htmlReport(fullReport());
  const std::vector<Element> elements = readXml(page);
  for (const char* outside : {"http:", "https:", "url(", "@import", "<script", "<link"})
    CHECK(page.find(outside) == std::string::npos);
  CHECK(page.find("prefers-color-scheme: dark") != std::string::npos);
  std::vector<std::string> verdicts;
  for (const Element& cell : named(elements, "td"))
    if (cell.attributes.contains("class") && cell.attributes.at("class").starts_with("verdict"))
      verdicts.push_back(cell.attributes.at("class") + ": " + cell.text);
  CHECK(verdicts == std::vector<std::string>{"verdict agrees: AGREES", "verdict agrees: AGREES",
                                             "verdict skipped: skipped [1]",
                                             "verdict within: within tolerance [2]",
                                             "verdict differs: DIFFERS", "verdict skipped: not run",
                                             "verdict differs: FAILED", "verdict agrees: located",
                                             "verdict differs: MISSED"});
  const DifferencePicture picture = fullReport().rows[2].pictures[0];
  const std::vector<Element> images = named(elements, "img");
  REQUIRE(images.size() == 3);
  CHECK(images[1].attributes.at("src") ==
        "data:image/png;base64," + base64(encodePng(192, 32, picture.actual)));
}
