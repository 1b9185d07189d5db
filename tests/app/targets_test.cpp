#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;
namespace fs = std::filesystem;

namespace {

const Arguments small{"--mesh", "builtin:sphere", "--spheres", "1",      "--size",
                      "4x4",    "--engine",       "reference", "--quiet"};

/// A command that writes to `target`, by its extension.
Arguments commandFor(const fs::path& target) {
  if (target.extension() == ".json")
    return {"fit", "builtin:sphere", "--spheres", "1", "--quiet", "-o", target};
  if (target.extension() == ".ply")
    return joined({"bake", "--object", "sphere", "-o", target}, small);
  return joined({"render", "--samples", "1", "-o", target}, small);
}

const std::vector<std::string> names{"x.png", "x.exr", "x.json", "x.ply"};

}  // namespace

TEST_CASE("a target that cannot be written is refused") {
  const TemporaryFolder folder;
  for (const std::string& name : names) {
    checkRefused(commandFor(folder / ("nofolder/" + name)), folder / ("nofolder/" + name));
    // Nobody may make a file there, not even root.
    checkRefused(commandFor("/proc/" + name), "/proc/" + name);
    fs::create_directory(folder / name);
    checkRefused(commandFor(folder / name), folder / name);
    CHECK(fs::is_empty(folder / name));
  }
  checkRefused({"bake", "--quiet", "-o", "/proc/x.exr", "--spheres", "1", "--size", "2x2",
                "--engine", "reference"},
               "/proc/x.exr");
}

TEST_CASE("a target of a kind that is not written is refused before any work") {
  const TemporaryFolder folder;
  checkRefused({"render", "-o", folder / "x.jpg"}, ".png or .exr");
  checkRefused({"render", "-o", folder / "x"}, ".png or .exr");
  checkRefused({"bake", "-o", folder / "x.png"}, ".exr");
  checkRefused({"bake", "--object", "knot", "-o", folder / "x.exr"}, ".ply");
  checkRefused({"fit", "builtin:sphere", "-o", folder / "x.txt"}, ".json");
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("a full disk is reported, and the target stays the link it is") {
  const TemporaryFolder folder;
  for (const std::string& name : names) {
    fs::create_symlink("/dev/full", folder / name);
    checkRefused(commandFor(folder / name), folder / name);
    CHECK(fs::is_symlink(folder / name));
  }
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == std::ptrdiff_t(names.size()));
}

TEST_CASE("a write that fails half way leaves the earlier file as it was, and nothing else") {
  const TemporaryFolder folder;
  Surroundings surroundings;
  surroundings.fileSizeLimit = 100;
  for (const std::string& name : names) {
    writeFile(folder / name, "earlier");
    Surroundings limited = surroundings;
    limited.environment["HAARLIGHT_CACHE_DIR"] = "/dev/null";
    checkRefused(commandFor(folder / name), folder / name, limited);
    CHECK(readFile(folder / name) == "earlier");
  }
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == std::ptrdiff_t(names.size()));
}

TEST_CASE("an earlier picture stays when rendering fails, and is replaced when it succeeds") {
  const TemporaryFolder folder;
  writeFile(folder / "x.png", "earlier");
  checkRefused({"render", "--mesh", folder / "missing.obj", "-o", folder / "x.png"}, "missing.obj");
  CHECK(readFile(folder / "x.png") == "earlier");
  CHECK(runHaarlight(commandFor(folder / "x.png")).exitCode == 0);
  CHECK(readFile(folder / "x.png").starts_with("\x89PNG"));
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("results that cannot be printed are an error") {
  const TemporaryFolder folder;
  Surroundings full;
  full.standardOutput = "/dev/full";
  const std::vector<Arguments> commands{{"--help"},
                                        {"--version"},
                                        {"render", "--help"},
                                        {"devices"},
                                        {"devices", "--json"},
                                        {"info", "builtin:sphere"},
                                        commandFor(folder / "x.png"),
                                        commandFor(folder / "x.json"),
                                        commandFor(folder / "x.ply")};
  for (const Arguments& command : commands)
    checkRefused(command, "cannot write to standard output", full);
}
