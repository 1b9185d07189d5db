#include "../verify/report_test_support.h"
#include "run_haarlight.h"
#include "scene/json_schema.h"
#include "test_support.h"

using namespace haarlight::test;
using Document = nlohmann::json;

namespace {

/// A few cases, so that a run takes seconds. The known answers are always asked.
const Arguments small{"verify", "--cases", "3", "--without-scenes"};
const Arguments smallOnHost = joined(small, {"--engine", "cuda-host"});

const std::vector<std::string> stages{
    "moved_spheres", "table_entries", "bit_cubes",      "haar_coefficients", "triple_product",
    "fused",         "frame",         "exponentiation", "transfer"};
const std::vector<std::string> faults{"sphere",         "bit",     "coefficient", "ulp",
                                      "exponentiation", "transfer"};

/// The report of a run with --json that ends with this exit code.
Document reportOf(const Arguments& arguments, int exitCode) {
  const Outcome outcome = runHaarlight(joined(arguments, {"--json"}));
  CAPTURE(arguments);
  CAPTURE(outcome.errors);
  CHECK(outcome.exitCode == exitCode);
  auto report = Document::parse(outcome.output, nullptr, false);
  REQUIRE(report.is_object());
  CHECK(report.at("agrees") == (exitCode == 0));
  return report;
}

/// Engines that `verify` compares here; "cuda-host" needs no device.
std::vector<std::string> enginesHere() {
  std::vector<std::string> engines;
  const Document results = resultsOf({"devices"});
  for (const auto& device : results.at("device"))
    if (const std::string name = device.at("engine");
        device.at("usable") == true && name != "reference" &&
        std::ranges::find(engines, name) == engines.end())
      engines.push_back(name);
  REQUIRE_FALSE(engines.empty());
  return engines;
}

bool hasRow(const Document& report, const std::string& engine, const std::string& stage,
            const std::string& visibility) {
  return std::ranges::any_of(report.at("rows"), [&](const Document& row) {
    return row.at("engine") == engine && row.at("stage") == stage &&
           row.at("visibility") == visibility && row.at("verdict") == "agrees" &&
           row.at("compared_values") > 0;
  });
}

/// Rows of the stage differ and no others, and every fault is named by a mismatch.
void checkFaultsFound(const Document& report, const std::string& engine, const std::string& stage) {
  bool differs = false;
  for (const auto& row : report.at("rows")) {
    if (row.at("verdict") == "agrees") continue;
    differs = true;
    CHECK(row.at("engine") == engine);
    CHECK(row.at("stage") == stage);
  }
  CHECK(differs);
  CHECK_FALSE(report.at("injected").empty());
  for (const auto& injected : report.at("injected")) {
    CAPTURE(injected.dump());
    CHECK(injected.at("injected_faults") > 0);
    CHECK(injected.at("all_located") == true);
  }
}

void checkOneError(const Outcome& outcome, int exitCode, const std::string& named) {
  CAPTURE(outcome.errors);
  CHECK(outcome.exitCode == exitCode);
  CHECK(outcome.errors.starts_with("haarlight: error: "));
  CHECK(std::ranges::count(outcome.errors, '\n') == 1);
  CHECK(contains(outcome.errors, named));
}

}  // namespace

TEST_CASE("all engines agree, in a table with every stage and visibility") {
  const Outcome outcome = runHaarlight(joined(small, {"--quiet"}));
  CHECK(outcome.exitCode == 0);
  CHECK(outcome.errors == "");
  const auto hasLine = [&](const std::string& stage, const std::string& visibility) {
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("  " + stage) && contains(line, "  " + visibility + "  ") &&
          contains(line, "AGREES"))
        return true;
    return false;
  };
  for (const char* visibility : {"exact", "table"})
    for (const char* stage : {"bit cubes", "Haar coefficients", "triple product", "fused", "frame"})
      CHECK(hasLine(stage, visibility));
  CHECK(hasLine("table entries", "table"));
  CHECK_FALSE(contains(outcome.output, "DIFFERS"));
  CHECK_FALSE(contains(outcome.output, "\x1b"));
  CHECK(contains(outcome.output, "\nAGREES: "));
}

TEST_CASE("the JSON report keeps to its schema, with faults and without") {
  const JsonSchema schema(
      Document::parse(readFile(HAARLIGHT_SOURCE_FOLDER "/docs/verification.schema.json")));
  const Document report = reportOf(small, 0);
  CHECK(schema.allows(report));
  for (const std::string& engine : enginesHere()) {
    for (const std::string& stage : stages) CHECK(hasRow(report, engine, stage, "table"));
    for (const std::string& stage : stages)
      CHECK(hasRow(report, engine, stage, "exact") == (stage != "table_entries"));
  }
  CHECK(hasRow(report, "reference", "frame", "exact"));  // the known answers
  CHECK(report.at("cases").at("random") == 3);
  CHECK(schema.allows(reportOf(joined(smallOnHost, {"--inject", "ulp", "cuda-host"}), 1)));
}

TEST_CASE("JUnit and HTML reports are written, and need nothing from outside") {
  const TemporaryFolder folder;
  const Outcome outcome =
      runHaarlight(joined(smallOnHost, {"--inject", "bit", "cuda-host", "--junit",
                                        folder / "report.xml", "--html", folder / "report.html"}));
  checkOneError(outcome, 1, "do not agree");

  const auto suites = readXml(readFile(folder / "report.xml"));
  CHECK(suites.front().name == "testsuites");
  CHECK(suites.front().attributes.at("failures") == "2");  // exact and table bit cubes
  CHECK(suites.front().attributes.at("errors") == "0");
  CHECK(named(suites, "failure").size() == 2);

  const auto page = readXml(readFile(folder / "report.html"));
  CHECK_FALSE(named(page, "img").empty());
  CHECK(named(page, "script").empty());
  CHECK(named(page, "link").empty());
  for (const Element& element : page) {
    for (const char* reference : {"src", "href"})
      if (element.attributes.contains(reference))
        CHECK(element.attributes.at(reference).starts_with("data:"));
    CHECK_FALSE(contains(element.text, "url("));
    CHECK_FALSE(contains(element.text, "@import"));
  }
}

TEST_CASE("faults put into any engine's results are all found where they are") {
  const std::map<std::string, std::string> stageOfFault{
      {"sphere", "moved_spheres"},          {"bit", "bit_cubes"},
      {"coefficient", "haar_coefficients"}, {"ulp", "triple_product"},
      {"exponentiation", "exponentiation"}, {"transfer", "transfer"}};
  for (const std::string& engine : enginesHere())
    for (const std::string& fault : faults) {
      CAPTURE(engine);
      CAPTURE(fault);
      const Arguments inject{"--engine", engine, "--inject", fault, engine};
      checkFaultsFound(reportOf(joined(small, inject), 1), engine, stageOfFault.at(fault));
    }
}

TEST_CASE("a failing case is saved, cut down, and replayed") {
  for (const std::string& fault : faults) {
    CAPTURE(fault);
    const TemporaryFolder folder;
    const std::string file = folder / "failing.case";
    const Arguments inject{"--engine", "cuda-host", "--inject", fault, "cuda-host"};
    const Outcome saved = runHaarlight(joined(small, joined(inject, {"--save-case", file})));
    CHECK(saved.exitCode == 1);
    CHECK(contains(saved.errors, "smallest failing case: " + file));
    CHECK(contains(readFile(file), "\nreceiver "));

    const Arguments replay{"verify", "--replay", file};
    const Document again = reportOf(joined(replay, inject), 1);
    CHECK(again.at("cases") == Document{{"known", 0}, {"scene", 1}, {"random", 0}});
    CHECK(again.at("injected").at(0).at("all_located") == true);
    reportOf(joined(replay, {"--engine", "cuda-host"}), 0);
  }
}

TEST_CASE("nothing is saved where nothing fails") {
  const TemporaryFolder folder;
  CHECK(runHaarlight(joined(smallOnHost, {"--save-case", folder / "x.case"})).exitCode == 0);
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("verify refuses what it cannot do") {
  const TemporaryFolder folder;
  const std::string missing = folder / "missing.case", nowhere = folder / "none";
  checkRefused({"verify", "--engine", "magic"}, "unknown engine 'magic'");
  checkRefused({"verify", "--inject", "rust", "cuda-host"}, "unknown fault 'rust'");
  checkRefused({"verify", "--inject", "bit"}, "--inject");
  checkRefused({"verify", "--inject", "bit", "cuda-host", "ulp", "cuda-host"}, "--inject");
  for (const char* engine : {"opencl", "magic"})
    checkRefused(joined(smallOnHost, {"--inject", "bit", engine}),
                 std::string("no fault can be put into ") + engine);
  for (const char* cases : {"-1", "2.5", "many", "1000001"})
    checkRefused({"verify", "--cases", cases}, "--cases");
  checkRefused({"verify", "--seed", "-1"}, "--seed");
  checkRefused({"verify", "--replay", missing}, missing);
  checkRefused({"verify", "--html", folder / "report.txt"}, ".html");
  checkRefused({"verify", "--junit", folder / "report.html"}, ".xml");
  checkRefused({"verify", "--save-case", folder / "x.json"}, ".case");
  for (const auto& [option, name] :
       {std::pair("--save-case", "x.case"), {"--html", "x.html"}, {"--junit", "x.xml"}})
    checkRefused({"verify", option, nowhere + "/" + name}, nowhere);
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a broken case file is refused with its line") {
  const TemporaryFolder folder;
  const std::string file = folder / "broken.case";
  const std::string head = "haarlight-case 1\nname broken\n";
  for (const auto& [text, line] : {std::pair<std::string, std::string>("", ":"),
                                   {"{}", ":1: "},
                                   {head + "sphere 0 1 0 -1\n", ":3: "},
                                   {head + "receiver 0 0 0 0 2 0\n", ":3: "},
                                   {head + "sphere 0 1 0 nan\n", ":3: "},
                                   {head + "\nring 1\n", ":4: "}}) {
    writeFile(file, text);
    checkRefused({"verify", "--replay", file}, file + line);
  }
}

TEST_CASE("options that say nothing beside --replay are refused") {
  const TemporaryFolder folder;
  writeFile(folder / "one.case", "haarlight-case 1\nname one\nreceiver 0 0 0 0 1 0\n");
  const Arguments replay{"verify", "--replay", folder / "one.case"};
  for (const Arguments& other :
       {Arguments{"--cases", "3"}, Arguments{"--seed", "2"}, Arguments{"--without-scenes"}})
    checkRefused(joined(replay, other), other.front());
}

TEST_CASE("an engine without a device is shown as not run, with the reason") {
  const TemporaryFolder noDrivers;
  Surroundings surroundings;
  surroundings.environment["OCL_ICD_VENDORS"] = noDrivers.path();
  surroundings.environment["CUDA_VISIBLE_DEVICES"] = "";
  const Arguments none{"--engine", "opencl", "--engine", "cuda"};
  const Outcome outcome = runHaarlight(joined(small, none), surroundings);
  CHECK(outcome.exitCode == 0);  // the reference gives the known answers
  CHECK(contains(outcome.output, "not run  opencl: no OpenCL device was found: install"));
  CHECK(contains(outcome.output, "not run  cuda"));
  CHECK(contains(outcome.output, "no CUDA device"));
  checkRefused(joined(small, joined(none, {"--inject", "bit", "opencl"})),
               "no fault can be put into opencl", surroundings);
}
