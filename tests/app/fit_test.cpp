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
