#include <algorithm>

#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight::test;

namespace {

struct Help {
  std::string command;
  std::vector<std::string> options;
};

const std::vector<std::string> sceneOptions{
    "SCENE",         "--mesh",       "--light",    "--layout", "--light-rotate",
    "--light-scale", "--sun",        "--sun-disc", "--method", "--terms",
    "--levels",      "--visibility", "--engine",   "--device", "--spheres"};
const std::vector<std::string> generalOptions{"--json", "--quiet", "--threads", "--help"};

}  // namespace

TEST_CASE("the help of every command names its options and gives an example") {
  const std::vector<Help> helps{
      {"render", joined(sceneOptions, {"--output", "--size", "--samples", "--exposure",
                                       "--compare-to", "--frame-rate"})},
      {"bake",
       joined(sceneOptions, {"--output", "--object", "--size", "--compare-to", "--frame-rate"})},
      {"shadow",
       {"SCENE", "--mesh", "--point-light", "--directional-light", "--seconds", "--detail",
        "--interior", "--method", "--compare-to", "--output", "--sheet", "--plain", "--size",
        "--samples", "--exposure"}},
      {"fit", {"MESH", "--output", "--spheres", "--seed"}},
      {"prt", {"MESH", "--output", "--order", "--bounces", "--rays", "--albedo", "--seed"}},
      {"info", {"FILE"}},
      {"skies", {"--output", "--sun", "--sun-disc", "--side"}},
      {"devices", {}}};
  for (const auto& [command, options] : helps) {
    const Outcome help = runHaarlight({command, "--help"});
    CAPTURE(command);
    CHECK(help.exitCode == 0);
    CHECK(help.errors == "");
    CHECK(contains(help.output, "Usage: haarlight " + command));
    CHECK(contains(help.output, "Example"));
    CHECK(contains(help.output, "  haarlight " + command) !=
          contains(help.output, "Example: haarlight " + command));
    for (const std::string& option : joined(generalOptions, options)) {
      CAPTURE(option);
      CHECK(contains(help.output, option));
    }
  }
}

TEST_CASE("the program's help names the commands, and its version is one line") {
  const Outcome help = runHaarlight({"--help"});
  CHECK(help.exitCode == 0);
  for (const char* command : {"render", "bake", "shadow", "fit", "prt", "info", "skies", "devices"})
    CHECK(contains(help.output, std::string("\n  ") + command + " "));
  const Outcome version = runHaarlight({"--version"});
  CHECK(version.exitCode == 0);
  CHECK(version.errors == "");
  CHECK(version.output.starts_with("haarlight "));
  CHECK(std::ranges::count(version.output, '\n') == 1);
}

TEST_CASE("wrong usage is refused in one line that names what is wrong") {
  checkRefused({}, "give a command");
  checkRefused({"paint"}, "paint");
  checkRefused({"--paint"}, "--paint");
  checkRefused({"render"}, "--output");
  checkRefused({"render", "-o"}, "--output");
  checkRefused({"render", "--paint", "-o", "x.png"}, "--paint");
  checkRefused({"fit"}, "MESH");
  checkRefused({"fit", "builtin:sphere"}, "--output");
  checkRefused({"info"}, "FILE");
  checkRefused({"devices", "all"}, "all");
}

TEST_CASE("wrong usage of a command refers to that command's help") {
  checkRefused({"render"}, "haarlight render --help");
  checkRefused({"paint"}, "haarlight --help");
}

TEST_CASE("information goes to standard output, as text and as JSON") {
  const Outcome text = runHaarlight({"info", "builtin:sphere"});
  CHECK(text.exitCode == 0);
  CHECK(text.errors == "");
  CHECK(contains(text.output, "kind: mesh\n"));
  const auto mesh = resultsOf({"info", "builtin:sphere"});
  CHECK(mesh.at("closed") == true);
  CHECK(mesh.at("parts") == 1);
  // Euler: a closed surface of genus 0 has 2 V − 4 triangles.
  CHECK(mesh.at("triangles").get<int>() == 2 * mesh.at("vertices").get<int>() - 4);
  CHECK(resultsOf({"info", "builtin:default"}).at("kind") == "scene");
  CHECK(resultsOf({"info", "builtin:constant"}).at("kind") == "light");
  checkRefused({"info", "builtin:nothing"}, "builtin:nothing");
  CHECK(resultsOf({"devices"}).at("device").at(0).at("engine") == "reference");
}

TEST_CASE("messages are coloured on a terminal only, and not with NO_COLOR") {
  const Arguments wrong{"info", "missing.obj"};
  Surroundings surroundings;
  CHECK_FALSE(contains(runHaarlight(wrong).errors, "\x1b"));
  if (!haveTerminals()) return;
  surroundings.terminal = true;
  CHECK(contains(runHaarlight(wrong, surroundings).errors, "\x1b["));
  surroundings.environment.emplace("NO_COLOR", "1");
  const Outcome plain = runHaarlight(wrong, surroundings);
  CHECK(contains(plain.errors, "haarlight: error: "));
  CHECK_FALSE(contains(plain.errors, "\x1b"));
}
