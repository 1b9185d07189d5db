#include "mesh/builtin_meshes.h"
#include "mesh/mesh_measures.h"
#include "run_haarlight.h"
#include "spheres/sphere_set.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

TEST_CASE("a fitted set is described, and used by a scene file beside it") {
  const TemporaryFolder folder;
  const auto results =
      resultsOf({"fit", "builtin:torusknot", "--spheres", "8", "-o", folder / "set.json"});
  CHECK(results.at("spheres") == 8);
  const SphereSet set = readSphereSet(folder / "set.json");
  CHECK(set.spheres.size() == 8);
  CHECK(set.meshHash == meshHash(builtinMesh("builtin:torusknot")));
  const auto info = resultsOf({"info", folder / "set.json"});
  CHECK(info.at("kind") == "sphere set");
  CHECK(info.at("spheres") == 8);

  writeFile(folder / "scene.json",
            R"({"objects": [{"mesh": "builtin:torusknot", "spheres": "set.json"}]})");
  const Outcome outcome =
      runHaarlight({"render", folder / "scene.json", "-o", folder / "picture.png", "--size", "16x9",
                    "--samples", "1", "--engine", "reference", "--quiet"});
  CHECK(outcome.exitCode == 0);
  CHECK(outcome.errors == "");
  CHECK(contains(outcome.output, "spheres: 8\n"));
}

TEST_CASE("a set made for another mesh is used, with a warning") {
  const TemporaryFolder folder;
  resultsOf({"fit", "builtin:sphere", "--spheres", "1", "-o", folder / "set.json"});
  writeFile(folder / "scene.json",
            R"({"objects": [{"mesh": "builtin:torusknot", "spheres": "set.json"}]})");
  const Outcome outcome =
      runHaarlight({"render", folder / "scene.json", "-o", folder / "picture.png", "--size", "16x9",
                    "--samples", "1", "--engine", "reference", "--quiet"});
  CHECK(outcome.exitCode == 0);
  CHECK(contains(outcome.errors, "haarlight: warning: "));
  CHECK(contains(outcome.errors, "set.json was made for another mesh"));
}

TEST_CASE("the same seed fits the same spheres") {
  const TemporaryFolder folder;
  for (const char* name : {"first.json", "second.json"})
    resultsOf({"fit", "builtin:torusknot", "--spheres", "4", "--seed", "7", "-o", folder / name});
  CHECK(readFile(folder / "first.json") == readFile(folder / "second.json"));
}

TEST_CASE("both objectives report both measures, and a report is written") {
  const TemporaryFolder folder;
  const auto fitted = [&](const std::string& objective, const std::string& report) {
    return resultsOf({"fit", "builtin:torusknot", "--spheres", "16", "--objective", objective, "-o",
                      folder / (objective + ".json"), "--report", folder / report});
  };
  const auto cover = fitted("cover", "cover.html"), shadow = fitted("shadow", "shadow.json");
  CHECK(cover.at("objective") == "cover");
  CHECK(shadow.at("objective") == "shadow");
  CHECK(cover.at("covered_surface") > 0.999);
  CHECK(cover.at("outside_volume_ratio") > shadow.at("outside_volume_ratio"));
  CHECK(cover.at("silhouette_error").at("mean") > shadow.at("silhouette_error").at("mean"));
  CHECK(cover.at("silhouette_error").at("under") < 0.001);
  CHECK(readFile(folder / "cover.html").starts_with("<!DOCTYPE html>"));
  const auto report = nlohmann::json::parse(readFile(folder / "shadow.json"));
  CHECK_FALSE(report.at("history").empty());
}

TEST_CASE("an error is asked for instead of a number, and a time limit ends a fit") {
  const TemporaryFolder folder;
  const auto within = resultsOf({"fit", "builtin:sphere", "--max-error", "0.02", "--spheres", "2",
                                 "-o", folder / "set.json"});
  CHECK(within.at("stopped") == "error_reached");
  CHECK(within.at("spheres") == 1);
  CHECK(within.at("silhouette_error").at("mean") <= 0.02);
  const Outcome limited = runHaarlight({"fit", "builtin:torusknot", "--time-limit", "0.01",
                                        "--spheres", "12", "-o", folder / "set.json", "--json"});
  CHECK(limited.exitCode == 0);
  CHECK(contains(limited.errors, "this is the best set so far"));
  CHECK(nlohmann::json::parse(limited.output).at("stopped") == "time_limit");
  CHECK(readSphereSet(folder / "set.json").spheres.size() <= 12);
}

TEST_CASE("what cannot be fitted is refused in one line") {
  const TemporaryFolder folder;
  writeFile(folder / "plane.obj",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
            "f 1 2 3\nf 2 4 3\nf 1 4 2\nf 1 3 4\n");
  writeFile(folder / "none.obj", "v 0 0 0\n");
  writeFile(folder / "nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto refused = [&](Arguments arguments, const std::string& named) {
    arguments.insert(arguments.begin(), "fit");
    arguments.insert(arguments.end(), {"-o", folder / "set.json"});
    checkRefused(arguments, named);
    CHECK_FALSE(std::filesystem::exists(folder / "set.json"));
  };
  refused({folder / "plane.obj"}, "plane.obj: spheres cannot be fitted to a mesh that lies in one");
  refused({folder / "none.obj"}, "no triangle");
  refused({folder / "nan.obj"}, "finite");
  for (const char* count : {"0", "4097", "-1", "many"})
    refused({"builtin:sphere", "--spheres", count}, "--spheres");
  refused({"builtin:sphere", "--max-error", "0"}, "greater than zero");
  refused({"builtin:sphere", "--report", folder / "report.txt"}, ".html");
}
