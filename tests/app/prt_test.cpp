#include <fmt/format.h>
#include <sys/stat.h>

#include <thread>

#include "mesh/builtin_meshes.h"
#include "mesh/mesh_measures.h"
#include "run_haarlight.h"
#include "test_support.h"
#include "transfer/transfer_file.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// An OBJ file of cells × cells squares.
std::string gridText(int cells) {
  std::string text;
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x) text += fmt::format("v {} {} 0\n", x, y);
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const int corner = y * (cells + 1) + x + 1, above = corner + cells + 1;
      text += fmt::format("f {} {} {} {}\n", corner, corner + 1, above + 1, above);
    }
  return text;
}

}  // namespace

TEST_CASE("prt computes what the library computes, and says so") {
  const TemporaryFolder folder;
  const auto path = folder / "knot.prt";
  const auto results =
      resultsOf({"prt", "builtin:torusknot", "-o", path, "--order", "3", "--bounces", "1", "--rays",
                 "64", "--albedo", "0.75,0.5,0.25", "--seed", "9", "--threads", "2"});
  const TriangleMesh knot = builtinMesh("builtin:torusknot");
  const TransferResult expected = computeTransfer(knot, {.kind = TransferKind::interreflected,
                                                         .order = 3,
                                                         .bounces = 1,
                                                         .raysPerVertex = 64,
                                                         .albedo = {0.75f, 0.5f, 0.25f},
                                                         .seed = 9});
  const DiffuseTransfer transfer = readTransfer(path);
  CHECK(transfer.values == expected.transfer.values);
  CHECK(transfer.meshHash == meshHash(knot));
  CHECK(results.at("transfer") == path.string());
  CHECK(results.at("transfer_kind") == "interreflected");
  CHECK(results.at("vertices") == knot.positions.size());
  CHECK(results.at("triangles") == knot.triangles.size());
  CHECK(results.at("rays") == 64 * knot.positions.size());
  CHECK(results.at("channels") == 3);
  CHECK(results.at("albedo") == nlohmann::json{0.75, 0.5, 0.25});
  CHECK(results.at("blocked_part").get<double>() == expected.blockedPart);
  REQUIRE(results.at("energy_by_bounce").size() == 2);
  for (std::size_t bounce = 0; bounce < 2; ++bounce)
    for (int c = 0; c < 3; ++c)
      CHECK(results.at("energy_by_bounce")[bounce][c].get<float>() ==
            expected.energyByBounce[bounce][c]);
  for (const char* stage : {"loading", "rays", "bounces", "writing", "total"})
    CHECK(results.at("seconds").at(stage) >= 0);
}

TEST_CASE("prt's options choose the kind of the transfer") {
  const TemporaryFolder folder;
  const auto path = folder / "ball.prt";
  const auto kind = [&](const Arguments& more) {
    return resultsOf(
        joined({"prt", "builtin:sphere", "-o", path, "--order", "2", "--albedo", ".5"}, more));
  };
  const auto unshadowed = kind({"--unshadowed"});
  CHECK(unshadowed.at("transfer_kind") == "unshadowed");
  CHECK(unshadowed.at("rays") == 0);
  CHECK(unshadowed.at("albedo") == 0.5);
  const std::string plain = readFile(path);
  CHECK(kind({"--bounces", "0", "--rays", "16"}).at("transfer_kind") == "shadowed");
  // The sphere is convex: but for the header and the checksum the file is the same.
  CHECK(readFile(path).substr(64, plain.size() - 68) == plain.substr(64, plain.size() - 68));
  const auto info = resultsOf({"info", path, "--mesh", "builtin:sphere"});
  CHECK(info.at("kind") == "transfer");
  CHECK(info.at("transfer_kind") == "shadowed");
  CHECK(info.at("rays_per_vertex") == 16);
}

TEST_CASE("the same seed gives the same file on any number of threads, another one another") {
  const TemporaryFolder folder;
  const auto file = [&](const std::string& seed, const std::string& threads) {
    resultsOf({"prt", "builtin:torusknot", "--order", "2", "--rays", "32", "--bounces", "1",
               "--seed", seed, "--threads", threads, "-o", folder / "x.prt"});
    return readFile(folder / "x.prt");
  };
  const std::string first = file("5", "1");
  CHECK(file("5", "3") == first);
  CHECK(file("6", "3") != first);
}

TEST_CASE("prt refuses wrong arguments in one line") {
  const TemporaryFolder folder;
  const Arguments prt{"prt", "builtin:sphere", "-o", folder / "x.prt"};
  checkRefused({"prt"}, "MESH");
  checkRefused({"prt", "builtin:sphere"}, "--output");
  checkRefused({"prt", "builtin:nothing", "-o", folder / "x.prt"}, "builtin:nothing");
  checkRefused({"prt", folder / "none.obj", "-o", folder / "x.prt"}, "none.obj");
  checkRefused({"prt", "builtin:sphere", "-o", folder / "x.txt"}, ".prt");
  checkRefused({"prt", "builtin:sphere", "-o", folder / "no/x.prt"}, "no folder");
  for (const char* order : {"0", "21", "-1", "five"})
    checkRefused(joined(prt, {"--order", order}), "--order");
  for (const char* bounces : {"-1", "65", "two"})
    checkRefused(joined(prt, {"--bounces", bounces}), "--bounces");
  for (const char* rays : {"0", "65537", "-5", "many"})
    checkRefused(joined(prt, {"--rays", rays}), "--rays");
  for (const char* albedo :
       {"", "2", "-0.1", "red", "0.5,0.5", "1,1,1,1", "0.5,,0.5", "nan", "1,1,"})
    checkRefused(joined(prt, {"--albedo", albedo}), "--albedo");
  checkRefused(joined(prt, {"--seed", "-1"}), "--seed");
  checkRefused(joined(prt, {"--unshadowed", "--bounces", "1"}), "--unshadowed");
  checkRefused(joined(prt, {"--unshadowed", "--rays", "8"}), "--unshadowed");
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("transfer files that cannot be used are refused, and a transfer of another mesh") {
  const TemporaryFolder folder;
  const auto path = folder / "ball.prt";
  resultsOf({"prt", "builtin:sphere", "--unshadowed", "--order", "2", "-o", path});
  checkRefused({"info", path, "--mesh", "builtin:torusknot"}, "another mesh");
  const std::string whole = readFile(path);
  const auto refused = [&](const std::string& bytes, const std::string& problem) {
    writeFile(folder / "bad.prt", bytes);
    checkRefused({"info", folder / "bad.prt"}, "bad.prt: " + problem);
  };
  refused("", "it is empty");
  refused("something else", "it is no transfer file");
  refused(whole.substr(0, whole.size() / 2), "it is cut off");
  std::string changed = whole;
  changed[whole.size() / 2] ^= 1;
  refused(changed, "it has been changed");
  std::string newer = whole;
  newer[8] = 2;
  refused(newer, "it is of version 2");
  checkRefused({"info", folder / "missing.prt"}, "missing.prt");
}

TEST_CASE("Ctrl-C ends prt without a file") {
  // The mesh comes through a pipe: once the program has read it, it is at work.
  const TemporaryFolder folder;
  const auto mesh = folder / "grid.obj";
  REQUIRE(mkfifo(mesh.c_str(), 0600) == 0);
  std::thread writer([&] {
    writeFile(mesh, gridText(60));
    writeFile(folder / "read", "");
  });
  Surroundings interrupted;
  interrupted.interruptAfter = folder / "read";
  const Outcome outcome = runHaarlight(
      {"prt", mesh, "--rays", "65536", "-o", folder / "x.prt", "--quiet"}, interrupted);
  writer.join();
  CHECK(outcome.exitCode == 1);
  CHECK(outcome.output == "");
  CHECK(contains(outcome.errors, "haarlight: error: interrupted; no transfer was written\n"));
  CHECK_FALSE(std::filesystem::exists(folder / "x.prt"));
}
