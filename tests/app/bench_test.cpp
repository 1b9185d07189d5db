#include <algorithm>
#include <sstream>

#include "run_haarlight.h"
#include "scene/json_schema.h"
#include "test_support.h"

using namespace haarlight::test;

namespace {

const Arguments small{
    "bench",  "--mesh", "builtin:sphere", "--engine", "reference", "--visibility", "exact",
    "--size", "8x8",    "--frames",       "3",        "--spheres", "4,2,2",        "--terms",
    "8",      "--quiet"};

JsonSchema benchSchema() {
  return JsonSchema(
      nlohmann::json::parse(readFile(HAARLIGHT_SOURCE_FOLDER "/docs/benchmark.schema.json")));
}

}  // namespace

TEST_CASE("bench measures every setting asked for") {
  const auto record = resultsOf(small);
  CHECK(benchSchema().allows(record));
  CHECK(record.at("samples") == 64);
  CHECK(record.at("scene") == "builtin:sphere");
  std::vector<std::vector<int>> settings;
  for (const auto& row : record.at("rows")) {
    settings.push_back({row.at("spheres"), row.at("terms"), row.at("levels")});
    CHECK(row.at("frames_measured") == 3);
    const auto& seconds = row.at("frame_seconds");
    CHECK(seconds.at("minimum") <= seconds.at("median"));
    CHECK(seconds.at("lower_quartile") <= seconds.at("median"));
    CHECK(seconds.at("median") <= seconds.at("upper_quartile"));
  }
  CHECK(settings == std::vector<std::vector<int>>{{2, 8, 1}, {2, 8, 2}, {4, 8, 1}, {4, 8, 2}});
}

TEST_CASE("bench compares with its own record, and writes table and plots") {
  const TemporaryFolder folder;
  const Outcome first = runHaarlight(joined(
      small, {"-o", folder / "old.json", "--csv", folder / "t.csv", "--svg", folder / "t.svg"}));
  CHECK(first.exitCode == 0);
  CHECK(first.errors == "");
  CHECK(contains(first.output, "reference · scalar C++, one thread · exact · staged\n"));
  CHECK(contains(first.output, "A frame is one call of Engine::shade"));
  const std::string csv = readFile(folder / "t.csv");
  CHECK(std::ranges::count(csv, '\n') == 5);
  CHECK(readFile(folder / "t.svg").starts_with("<?xml"));

  const auto second = resultsOf(
      joined(small, {"--levels", "2", "--terms", "8,9", "--compare", folder / "old.json"}));
  CHECK(benchSchema().allows(second));
  const auto& comparison = second.at("comparison");
  CHECK(comparison.at("rows").size() == 2);
  CHECK(comparison.at("only_now").size() == 2);
  CHECK(comparison.at("only_before").size() == 2);
  for (const auto& row : comparison.at("rows")) {
    CHECK(row.at("lowest") <= row.at("ratio"));
    CHECK(row.at("ratio") <= row.at("highest"));
  }
}

TEST_CASE("bench sets peers beside the rows, and sweeps sizes") {
  const auto peers = resultsOf(joined(small, {"--peers"}));
  CHECK(benchSchema().allows(peers));
  CHECK(peers.at("peers").at("methods").size() == 8);
  CHECK(peers.at("peers").at("spheres") == 2);  // no 64 among them
  CHECK(peers.at("peers").at("rows").size() == 2);
  const auto& row = peers.at("rows").at(0);
  CHECK(row.at("times_embree").get<double>() ==
        doctest::Approx(
            peers.at("peers").at("methods").at(0).at("frame_seconds").at("median").get<double>() /
            row.at("frame_seconds").at("median").get<double>()));
}

TEST_CASE("bench measures the processor's ceilings") {
  const auto record = resultsOf(joined(small, {"--ceilings", "--levels", "2"}));
  CHECK(benchSchema().allows(record));
  const auto& roofline = record.at("roofline");
  CHECK(roofline.at("ceilings").at("memory").size() == 4);
  REQUIRE(roofline.at("rows").size() == 1);  // the last setting
  const auto& row = roofline.at("rows").at(0);
  CHECK(row.at("spheres") == 4);
  CHECK(row.at("counts").at("samples") == 64);
  CHECK(row.at("counts").at("reached_rows") > 0);
  for (const auto& stage : row.at("stages")) {
    CHECK(stage.at("operations") > 0);  // the reference neither uploads nor reads back
    CHECK(stage.at("least_seconds") > 0);
    CHECK(stage.at("share").get<double>() ==
          doctest::Approx(stage.at("least_seconds").get<double>() /
                          stage.at("measured_seconds").get<double>()));
  }
}

TEST_CASE("bench refuses what it cannot measure in one line") {
  const TemporaryFolder folder;
  for (const auto& [option, value] :
       std::vector<std::pair<std::string, std::string>>{{"--spheres", "0"},
                                                        {"--spheres", "8,many"},
                                                        {"--terms", "6145"},
                                                        {"--terms", "-1"},
                                                        {"--levels", "3"},
                                                        {"--frames", "0"},
                                                        {"--engine", "magic"},
                                                        {"--device", "nosuch"},
                                                        {"--visibility", "fuzzy"},
                                                        {"--path", "long"},
                                                        {"--size", "0x5"},
                                                        {"--size", "5000x5"},
                                                        {"--scale-samples", "5"}})
    checkRefused({"bench", "--quiet", option, value}, option == "--device" ? "nosuch" : option);
  checkRefused({"bench", "--quiet", "--svg", folder / "x.png"}, ".svg");
  checkRefused({"bench", "--quiet", "--csv", folder / "x.txt"}, ".csv");
  checkRefused({"bench", "--quiet", "-o", folder / "x.txt"}, ".json");
  checkRefused({"bench", "--quiet", "--compare", folder / "absent.json"}, "absent.json");
  checkRefused({"bench", "--scale", "--peers"}, "--scale");
  checkRefused({"bench", "--scale", "--ceilings"}, "--scale");
  writeFile(folder / "old.json", R"({"host": "h", "date_utc": "d"})");
  checkRefused({"bench", "--quiet", "--compare", folder / "old.json"}, "rows");
  writeFile(folder / "scene.json", R"({"objects": [{"mesh": "builtin:sphere", "spheres": 2}]})");
  checkRefused({"bench", "--quiet", "--spheres", "2", folder / "scene.json"}, "receiver");
  CHECK_FALSE(std::filesystem::exists(folder / "x.png"));
}
