#include "benchmark/reports.h"

#include <algorithm>
#include <sstream>

#include "benchmark/paper_table.h"
#include "benchmark/text_table.h"
#include "example_record.h"
#include "scene/json_schema.h"
#include "test_support.h"
#include "verify/report_test_support.h"

using namespace haarlight;
using namespace haarlight::benchmark;
using namespace haarlight::test;

namespace {

using Document = nlohmann::json;

Comparison withItself(const Record& record) {
  Comparison comparison =
      compareRows(namedTimes(record), {"old.json", "host", "date", namedTimes(record)});
  comparison.onlyNow = {comparison.ratios.at(0).name};
  comparison.onlyBefore = {comparison.ratios.at(1).name};
  return comparison;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> textsOf(const std::vector<Element>& elements, const std::string& name) {
  std::vector<std::string> texts;
  for (const Element& element : named(elements, name)) texts.push_back(element.text);
  return texts;
}

}  // namespace

TEST_CASE("the paper's figures") {
  CHECK(paperFigures(64, 200, 2)->gpu == 17.87);
  CHECK(paperFigures(64, 200, 1)->gpu == 21.01);
  CHECK(paperFigures(64, 200, 2)->cpu == 1.20);
  CHECK(paperFigures(128, 50, 2)->gpu == 15.07);
  CHECK(!paperFigures(64, 100, 2));
  CHECK(!paperFigures(65, 200, 2));
}

TEST_CASE("JSON keeps to its schema, with every part and without") {
  const JsonSchema schema(
      Document::parse(readFile(HAARLIGHT_SOURCE_FOLDER "/docs/benchmark.schema.json")));
  const Comparison comparison = withItself(exampleRecord());
  for (const Record& record :
       {exampleRecord(), recordWithPeers(), recordWithScale(), recordWithRoofline()}) {
    const Document plain = jsonReport(record, nullptr), compared = jsonReport(record, &comparison);
    CHECK(schema.allows(plain));
    CHECK(schema.allows(compared));
    for (const auto& [name, ignored] : plain.items()) {  // every member is needed, no other allowed
      Document changed = plain;
      changed.erase(name);
      CHECK_FALSE(schema.allows(changed));
    }
    Document more = plain;
    more["more"] = 1;
    CHECK_FALSE(schema.allows(more));
  }
}

TEST_CASE("JSON has ratios to the paper and to Embree") {
  const Document json = jsonReport(recordWithPeers(), nullptr);
  const Document& row = json.at("rows").at(0);
  CHECK(row.at("frames_per_second").get<double>() == doctest::Approx(250));
  CHECK(row.at("frame_seconds").at("minimum") == 0.002);
  CHECK(row.at("stage_seconds_median").at("merge").get<double>() == doctest::Approx(0.003));
  CHECK(row.at("paper").at("times_gpu").get<double>() == doctest::Approx(250 / 17.87));
  CHECK(row.at("paper").at("times_cpu").get<double>() == doctest::Approx(250 / 1.2));
  CHECK(row.at("times_embree").get<double>() == doctest::Approx(500));
  CHECK(json.at("rows").at(1).at("paper").is_null());
  CHECK(json.at("peers").at("methods").at(1).at("times_embree").get<double>() ==
        doctest::Approx(400));
  CHECK(json.at("peers").at("rows").at(1).at("error").at("against_mesh_percent") == 2.5);
  CHECK(jsonReport(exampleRecord(), nullptr).at("rows").at(0).at("times_embree").is_null());
}

TEST_CASE("JSON and text have the ceilings and the share of them that is reached") {
  const Record record = recordWithRoofline();
  const Document json = jsonReport(record, nullptr).at("roofline");
  const Document& ceilings = json.at("ceilings");
  CHECK(ceilings.at("memory").at(0).at("copy_bytes_per_second") == 4e11);
  CHECK(ceilings.at("memory").at(1).at("read_bytes_per_second") == 1e11);
  CHECK(ceilings.at("memory").at(3).at("holds_bytes").is_null());
  const Document& row = json.at("rows").at(0);
  CHECK(row.at("visibility") == "table");
  CHECK(row.at("counts").at("mask_groups") == 1.5e6);
  const Document& stage = row.at("stages").at(0);
  CHECK(stage.at("stage") == "merge");
  // 16,384 · 64 spheres of 128 operations, and 16 for each group.
  const double operations = 16384.0 * 64 * 128 + 16 * 1.5e6;
  CHECK(stage.at("operations") == operations);
  // 10⁶ entries of 4 bytes and groups of 64 come from RAM, at 5e10 bytes a second.
  CHECK(stage.at("bound_by") == "RAM");
  CHECK(stage.at("least_seconds").get<double>() == doctest::Approx(100e6 / 5e10));
  CHECK(stage.at("share").get<double>() == doctest::Approx(100e6 / 5e10 / 0.006));
  const std::string text = textReport(record, nullptr);
  for (const char* part : {"2 threads, some vectors", "OR of 32-bit words: 200.0 G/s", "bound by",
                           "100.0 GFLOP/s", "Ceilings are measured last"})
    CHECK_MESSAGE(contains(text, part), part);
  CHECK_FALSE(contains(textReport(exampleRecord(), nullptr), "Ceilings"));
}

TEST_CASE("CSV has a line per row, with as many fields as the first, quoted where need be") {
  const auto lines = linesOf(csvReport(recordWithPeers()));
  REQUIRE(lines.size() == 4);
  CHECK(lines[0].starts_with("engine,device,visibility,path,spheres,terms,levels,"));
  CHECK(lines[0].ends_with(",times_embree\r"));
  CHECK(
      lines[1].starts_with("opencl,\"Some \"\"CPU\"\", fast\",exact,staged,64,200,2,5,250,0.004,"));
  CHECK(lines[1].ends_with(",500\r"));
  CHECK(contains(lines[2], ",,,,"));  // no figures of the paper for 7 spheres
  const auto fields = std::ranges::count(lines[0], ',');
  CHECK(std::ranges::count(lines[2], ',') == fields + 1);  // one within quotes
}

TEST_CASE("the text says what is timed and has the tables") {
  const Comparison comparison = withItself(exampleRecord());
  const std::string text = textReport(recordWithPeers(), &comparison);
  for (const char* part :
       {"A frame is one call of Engine::shade", "5 rounds", "2 frames before each part",
        "opened in 1.50 s, kernels of it 0.50 s", "opencl · Some \"CPU\", fast · table · staged",
        "times Embree", "double product; 200 terms", "Time now over time in old.json",
        "only before: opencl"})
    CHECK_MESSAGE(contains(text, part), part);
  CHECK_FALSE(contains(textReport(exampleRecord(), nullptr), "Embree"));
  const auto scale = textReport(recordWithScale(), nullptr);
  CHECK(contains(scale, "exponent 1.000, of the upper half 1.000"));
}

TEST_CASE("the plots have a panel per device and setting, twice, and the paper's lines") {
  const auto elements = readXml(svgReport(exampleRecord()));
  const auto titles = textsOf(elements, "text"), names = textsOf(elements, "tspan");
  CHECK(std::ranges::count(titles, "opencl · Some \"CPU\", fast, 200 terms, level II") == 2);
  for (const char* name : {"exact, staged", "table, staged", "paper, GPU-II", "paper, CPU"})
    CHECK(std::ranges::count(names, std::string("\u2015 ") + name) == 2);
  const auto withPeers = textsOf(readXml(svgReport(recordWithPeers())), "tspan");
  CHECK(std::ranges::count(withPeers, "\u25A0 double product") == 2);  // one error, one kind
  const auto roofline = readXml(svgReport(recordWithRoofline()));
  CHECK(std::ranges::count(textsOf(roofline, "text"), "opencl · Some \"CPU\", fast · table") == 1);
  const auto ceilings = textsOf(roofline, "tspan");
  for (const char* name : {"L1", "RAM", "OR", "multiply-add"})
    CHECK(std::ranges::count(ceilings, std::string("\u2015 ") + name) == 1);
  const auto scale = textsOf(readXml(svgReport(recordWithScale())), "text");
  CHECK(std::ranges::count(scale, "Time over spheres: exponent 1.00 in the upper half") == 1);
}

TEST_CASE("columns of a text stand below one another, by characters and not bytes") {
  CHECK(alignedText({{"a·b", "x", "1"}, {"a", "long", "22"}}, 1, " ") ==
        " a·b     x   1\n"
        " a    long  22\n");
}
