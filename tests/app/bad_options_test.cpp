#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight::test;

namespace {

struct BadOption {
  std::string option;
  std::string value;
};

void checkAllRefused(const Arguments& command, const std::vector<BadOption>& options) {
  const TemporaryFolder target;
  for (const auto& [option, value] : options) {
    checkRefused(joined(command, {"--quiet", "-o", target / "x.png", option, value}), option);
    CHECK(std::filesystem::is_empty(target.path()));
  }
}

}  // namespace

TEST_CASE("numbers out of range and no numbers are refused") {
  checkAllRefused(
      {"render"},
      {{"--spheres", "0"},         {"--spheres", "-1"},        {"--spheres", "100000"},
       {"--spheres", "3.5"},       {"--terms", "-1"},          {"--terms", "6145"},
       {"--terms", "abc"},         {"--terms", "99999999999"}, {"--levels", "0"},
       {"--levels", "3"},          {"--order", "0"},           {"--order", "21"},
       {"--order", "4.5"},         {"--samples", "0"},         {"--samples", "100000"},
       {"--threads", "-1"},        {"--threads", "100000"},    {"--light-rotate", "nan"},
       {"--light-rotate", "1e30"}, {"--light-rotate", "up"},   {"--light-scale", "-1"},
       {"--light-scale", "nan"},   {"--light-scale", "inf"},   {"--sun", "0,45"},
       {"--exposure", "nan"},      {"--exposure", "1e9"},      {"--exposure", "bright"}});
}

TEST_CASE("orders that exponentiation does not have are refused before any work") {
  const TemporaryFolder target;
  for (const char* order : {"1", "3", "7", "20"})
    for (const auto& [command, output] :
         {std::pair("render", target / "x.png"), std::pair("bake", target / "x.exr")})
      for (const char* option : {"--method", "--compare-to"})
        checkRefused({command, "-o", output, option, "shexp", "--order", order, "--quiet"},
                     "the method shexp takes an order from 4 to 6, not " + std::string(order));
  CHECK(std::filesystem::is_empty(target.path()));
}

TEST_CASE("suns that stand nowhere are refused") {
  const Arguments clear{"render", "--light", "builtin:cie-clear", "--spheres", "8"};
  for (const char* sun : {"0", "0,", ",45", "0,45,3", "east,45", "nan,45", "0,nan", "0,-1", "0,91",
                          "400,45", "1e999,0", "0;45"})
    checkAllRefused(clear, {{"--sun", sun}});
  for (const char* disc : {"-1", "nan", "101", "bright"})
    checkAllRefused(clear, {{"--sun-disc", disc}});
}

TEST_CASE("sizes that are none, or that no memory holds, are refused") {
  for (const char* command : {"render", "bake"})
    for (const char* size : {"100000x10000", "0x5", "5x0", "axb", "5", "x", "5x", "-3x3", "3x-3",
                             "4x4x4", "99999999999x1", "4 x 4"}) {
      const TemporaryFolder target;
      const std::string name = std::string(command) == "bake" ? "x.exr" : "x.png";
      checkRefused({command, "--quiet", "-o", target / name, "--size", size}, "--size");
      CHECK(std::filesystem::is_empty(target.path()));
    }
}

TEST_CASE("names that do not exist are refused") {
  checkAllRefused({"render"}, {{"--method", "radiosity"},
                               {"--layout", "cube"},
                               {"--engine", "magic"},
                               {"--visibility", "fuzzy"},
                               {"--compare-to", "nothing"},
                               {"--per", "triangle"},
                               {"--transfer", ""},
                               {"--mesh", ""},
                               {"--light", ""}});
  checkRefused({"render", "-o", "x.png", "--mesh", "builtin:teapot"}, "builtin:teapot");
  checkRefused({"render", "-o", "x.png", "builtin:teapot"}, "builtin:teapot");
  checkRefused({"render", "-o", "x.png", "--quiet", "--spheres", "8", "--light", "builtin:moon"},
               "builtin:moon");
}

TEST_CASE("options that contradict each other are refused") {
  const TemporaryFolder folder;
  checkRefused({"render", "builtin:default", "--mesh", "builtin:sphere", "-o", folder / "x.png"},
               "--mesh");
  checkRefused({"render", "--engine", "reference", "--device", "0", "-o", folder / "x.png"},
               "--device");
  checkRefused(
      {"render", "--spheres", "8", "--layout", "latlong", "--quiet", "-o", folder / "x.png"},
      "latlong");
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("an OpenCL device that is not there is refused") {
  if (!haveOpenCl()) return;
  const TemporaryFolder folder;
  for (const char* device : {"nosuch", "99", "-1"})
    checkRefused({"render", "--spheres", "8", "--size", "4x4", "--samples", "1", "--quiet",
                  "--device", device, "-o", folder / "x.png"},
                 device);
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("fit refuses wrong counts and seeds") {
  const TemporaryFolder folder;
  const Arguments fit{"fit", "builtin:sphere", "-o", folder / "x.json"};
  for (const char* count : {"0", "-1", "65537", "many"})
    checkRefused(joined(fit, {"--spheres", count}), "--spheres");
  for (const char* seed : {"-1", "1.5", "dice"})
    checkRefused(joined(fit, {"--seed", seed}), "--seed");
  CHECK(std::filesystem::is_empty(folder.path()));
}
