#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight::test;
namespace fs = std::filesystem;

namespace {

void checkShadowRefused(const Arguments& arguments, const std::string& named) {
  checkRefused(joined({"shadow", "--quiet", "--size", "32x18", "--samples", "1"}, arguments),
               named);
}

}  // namespace

TEST_CASE("details that are none are refused") {
  for (const char* detail : {"0", "-1", "nan", "inf", "1e999", "0,1", "0.1 ", "fine", ""})
    checkShadowRefused({"--detail", detail},
                       "--detail takes the largest edge of the smallest cells, such as 0.02, or "
                       "depth=N, not '" +
                           std::string(detail) + "'");
  for (const char* detail : {"depth=11", "depth=-1", "depth=x", "depth=", "depth=1.5", "depth=1e1"})
    checkShadowRefused({"--detail", detail},
                       "--detail takes depth=0 to depth=10, not '" + std::string(detail) + "'");
  checkShadowRefused({"--interior", "11"}, "--interior");
  checkShadowRefused({"--interior", "8", "--detail", "depth=4"}, "8 and 4");
}

TEST_CASE("details are for octrees") {
  for (const char* method : {"classic", "classic-triangles", "exact"}) {
    checkShadowRefused({"--method", method, "--detail", "0.1"}, "add --compare-to octree");
    checkShadowRefused({"--method", method, "--interior", "2"}, "add --compare-to octree");
  }
  checkShadowRefused({"--method", "stencil"}, "--method");
  checkShadowRefused({"--compare-to", "stencil"}, "--compare-to");
}

TEST_CASE("lights that stand nowhere are refused") {
  for (const char* option : {"--point-light", "--directional-light"})
    for (const char* vector :
         {"", "1,2", "1,2,3,4", "1;2;3", "a,b,c", "nan,0,0", "1,2,inf", "1e7,0,0", "1, 2, 3"})
      checkShadowRefused({option, vector}, option + std::string(" takes X,Y,Z such as 2.5,5,2"));
  checkShadowRefused({"--directional-light", "0,0,0"}, "--directional-light 0,0,0 points nowhere");
  checkShadowRefused({"--seconds", "nan"}, "--seconds");
}

TEST_CASE("a scene without lights that cast hard shadows is refused, until it is given one") {
  checkShadowRefused({"builtin:default"}, "try --point-light X,Y,Z or --directional-light X,Y,Z");
  const auto results = resultsOf({"shadow", "builtin:default", "--directional-light", "0,1,0",
                                  "--size", "32x18", "--samples", "1", "--quiet"});
  CHECK(results.at("lights") == 1);
  checkShadowRefused({"builtin:nothing"}, "builtin:nothing");
  checkShadowRefused({"missing.json"}, "missing.json");
  checkShadowRefused({"--mesh", "missing.obj"}, "missing.obj");
  checkShadowRefused({"builtin:lamp-knot", "--mesh", "builtin:sphere"}, "not both");
}

TEST_CASE("shadow refuses targets that it cannot write, and leaves nothing") {
  const TemporaryFolder folder;
  checkShadowRefused({"-o", folder / "x.jpg"}, ".png or .exr");
  checkShadowRefused({"-o", folder / "x.png", "--sheet", folder / "x.exr"}, ".png");
  for (const std::string name : {"x.png", "x.exr"}) {
    checkShadowRefused({"-o", "/proc/" + name}, "/proc/" + name);
    checkShadowRefused({"-o", folder / ("nofolder/" + name)}, folder / ("nofolder/" + name));
  }
  checkShadowRefused({"--sheet", "/proc/x.png"}, "/proc/x.png");
  CHECK(fs::is_empty(folder.path()));
}
