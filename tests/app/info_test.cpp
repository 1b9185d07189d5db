#include "run_haarlight.h"
#include "spheres/sphere_set.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

SphereSet exampleSet() {
  SphereSet set;
  set.spheres = {{{0, 0, 0}, 0.5f}, {{1, 0, 0}, 2}};
  set.meshName = "ball.obj";
  set.meshHash = 0xabc;
  set.objective = FitObjective::shadow;
  set.measures = {0.75, 0.5, 0.25, 0.125, SilhouetteError{0.0625, 0.375, 0.05, 0.0125}};
  set.method = "by hand";
  set.seed = 11;
  return set;
}

}  // namespace

TEST_CASE("info tells what a sphere set says about itself") {
  const TemporaryFolder folder;
  writeSphereSet(folder / "set.json", exampleSet());
  nlohmann::json info = resultsOf({"info", folder / "set.json"});
  info.erase("file");
  CHECK(info ==
        nlohmann::json{{"kind", "sphere set"},
                       {"spheres", 2},
                       {"mesh", "ball.obj"},
                       {"mesh_hash", "0000000000000abc"},
                       {"objective", "shadow"},
                       {"method", "by hand"},
                       {"seed", 11},
                       {"covered_surface", 0.75},
                       {"outside_volume_ratio", 0.5},
                       {"union_outside_ratio", 0.25},
                       {"uncovered_volume_ratio", 0.125},
                       {"silhouette_error",
                        {{"mean", 0.0625}, {"worst", 0.375}, {"over", 0.05}, {"under", 0.0125}}},
                       {"smallest_radius", 0.5},
                       {"largest_radius", 2}});
}

TEST_CASE("info leaves out the measures that a sphere set has none of") {
  const TemporaryFolder folder;
  SphereSet set = exampleSet();
  set.measures = {0.75, std::nullopt, std::nullopt, std::nullopt, std::nullopt};
  writeSphereSet(folder / "set.json", set);
  const nlohmann::json info = resultsOf({"info", folder / "set.json"});
  CHECK(info.at("covered_surface") == 0.75);
  for (const char* name : {"outside_volume_ratio", "union_outside_ratio", "uncovered_volume_ratio",
                           "silhouette_error"})
    CHECK_FALSE(info.contains(name));
}

TEST_CASE("info tells what solids and lights with hard shadows a scene has") {
  const TemporaryFolder folder;
  writeFile(folder / "solids.json", R"({
    "objects": [{"solid": {"cone": {}}, "family": "hats"}, {"mesh": "builtin:sphere"}],
    "pointLights": [{"position": [1, 2, 3], "intensity": [4, 5, 6]}],
    "directionalLights": [{"towards": [0, 1, 0], "irradiance": [3, 2, 1]}]})");
  const nlohmann::json info = resultsOf({"info", folder / "solids.json"});
  CHECK(info.at("object") ==
        nlohmann::json::parse(R"([{"name": "cone", "solid": "cone", "family": "hats"},
                                  {"name": "sphere", "mesh": "builtin:sphere"}])"));
  CHECK(info.at("point_light") ==
        nlohmann::json::parse(R"([{"position": [1, 2, 3], "intensity": [4, 5, 6]}])"));
  CHECK(info.at("directional_light") ==
        nlohmann::json::parse(R"([{"towards": [0, 1, 0], "irradiance": [3, 2, 1]}])"));
  const nlohmann::json plain = resultsOf({"info", "builtin:default"});
  CHECK_FALSE(plain.contains("point_light"));
}
