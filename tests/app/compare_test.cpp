#include <doctest/doctest.h>

#include <algorithm>

#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight::test;

namespace {

const Arguments tiny{"--size", "32x18",   "--samples", "1",        "--spheres",
                     "8",      "--terms", "50",        "--engine", "reference"};

}  // namespace

TEST_CASE("compare renders every method and holds it against both references") {
  const TemporaryFolder folder;
  const auto results = resultsOf(joined({"compare", "-o", folder / "sheet.png"}, tiny));
  CHECK(readFile(folder / "sheet.png").starts_with("\x89PNG"));
  const auto& pictures = results.at("picture");
  const std::vector<std::string> expected{"pixel-mesh", "pixel", "haar", "shexp", "sh"};
  REQUIRE(pictures.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CAPTURE(expected[i]);
    CHECK(pictures[i].at("method") == expected[i]);
    CHECK(pictures[i].at("seconds") > 0);
    REQUIRE(pictures[i].at("error").size() == (i < 2 ? 1 : 2));
    CHECK(pictures[i].at("error")[0].at("reference") == (i == 0 ? "pixel" : "pixel-mesh"));
  }
  CHECK(pictures[3].at("order") == 4);
  CHECK(pictures[4].at("order") == 5);
  CHECK(pictures[4].at("transfer_seconds") > 0);
}

TEST_CASE("compare takes a mesh, and an order for both methods that have one") {
  const auto results =
      resultsOf(joined({"compare", "--mesh", "builtin:sphere", "--light", "builtin:sky", "--order",
                        "6", "--method", "pixel-mesh", "--method", "shexp", "--method", "sh"},
                       tiny));
  const auto& pictures = results.at("picture");
  REQUIRE(pictures.size() == 3);
  for (const std::size_t i : {1, 2}) {
    CHECK(pictures[i].at("order") == 6);
    CHECK(pictures[i].at("error")[0].at("rmse_relative_to_mean_percent") < 15);
  }
}

TEST_CASE("compare finds the errors that render finds") {
  const TemporaryFolder folder;
  const auto render =
      resultsOf(joined({"render", "--compare-to", "pixel", "-o", folder / "picture.png"}, tiny));
  const auto compare =
      resultsOf(joined({"compare", "--method", "haar", "--method", "pixel"}, tiny));
  REQUIRE(compare.at("picture").size() == 2);
  const auto& error = compare.at("picture")[1].at("error")[0];
  CHECK(error.at("rmse") > 0);
  for (const char* key : {"reference", "rmse", "mean", "largest_difference", "at_column"})
    CHECK(error.at(key) == render.at("comparison")[0].at(key));
}

TEST_CASE("compare refuses methods that are none and references that it does not render") {
  checkRefused({"compare", "--method", "raster"}, "--method");
  checkRefused({"compare", "--method", "haar", "--reference", "pixel"},
               "--reference pixel is not among the methods compared; add --method pixel");
  checkRefused({"compare", "-o", "sheet.exr"}, ".png");
  checkRefused({"compare", "--order", "7"}, "the method shexp takes an order from 4 to 6, not 7");
}

TEST_CASE("compare leaves out transfer where there are solids, unless it is asked for") {
  const TemporaryFolder folder;
  writeFile(folder / "solids.json", R"({"objects": [{"solid": {"sphere": {}}}], "receiver": {},
      "image": {"width": 16, "height": 9, "samplesPerPixel": 1},
      "shading": {"engine": "reference"}})");
  const auto results = resultsOf({"compare", folder / "solids.json"});
  std::vector<std::string> methods;
  for (const auto& picture : results.at("picture")) methods.push_back(picture.at("method"));
  CHECK(methods == std::vector<std::string>{"pixel-mesh", "pixel", "haar", "shexp"});
  checkRefused({"compare", folder / "solids.json", "--method", "sh", "--quiet"},
               "object 'sphere' is a solid, and transfer is for the vertices of meshes");
}
