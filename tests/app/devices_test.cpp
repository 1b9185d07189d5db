#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight::test;

namespace {

/// A cache folder of its own.
struct OwnCache {
  OwnCache() { surroundings.environment["HAARLIGHT_CACHE_DIR"] = folder.path(); }

  std::filesystem::path shapes() const { return folder / "work-shapes.txt"; }

  TemporaryFolder folder;
  Surroundings surroundings;
};

const Arguments tuneEmulation{"devices",  "--tune", "--engine",  "cuda-host",
                              "--frames", "2",      "--samples", "64"};

/// The shape of the emulation, as `haarlight devices` says it.
nlohmann::json emulationShape(const Surroundings& surroundings) {
  const auto results = resultsOf({"devices"}, surroundings);
  for (const auto& device : results.at("device"))
    if (device.at("engine") == "cuda-host") return device.at("shape");
  return {};
}

}  // namespace

TEST_CASE("devices --budget sets what the paper's frame takes against a GeForce 8800") {
  const auto devices = resultsOf({"devices", "--budget"}).at("device");
  bool any = false;
  for (const auto& device : devices) {
    CAPTURE(device.dump());
    const bool computes = device.at("usable") == true && device.at("engine") != "reference";
    REQUIRE(device.contains("budget") == computes);
    if (!computes) continue;
    any = true;
    const auto& budget = device.at("budget");
    CHECK(budget.at("device_memory_limit_bytes") == 768'000'000);
    CHECK(budget.at("work_items_limit") == 256);
    CHECK(budget.at("local_memory_limit_bytes") == 16384);
    CHECK(budget.at("kept") == true);
    // At least the sphere table: for 6144 texels times 32 radii an entry of 4 bytes and 3.3 groups
    // of 64.
    CHECK(budget.at("device_memory_bytes") > 6144 * 32 * (4 + 3 * 64));
    CHECK(budget.at("device_memory_bytes") <= 768'000'000);
    CHECK(budget.at("work_items_per_group") <= 256);
    if (device.at("engine") != "opencl") continue;
    for (const char* kernel :
         {"mergeBitCubes", "mergeBitCubesExactly", "transformOcclusion", "tripleProduct"}) {
      CHECK(budget.at("local_memory_bytes").at(kernel) > 0);
      CHECK(budget.at("local_memory_bytes").at(kernel) <= 16384);
    }
  }
  CHECK(any);
}

TEST_CASE("devices --tune measures every shape and keeps one") {
  const OwnCache cache;
  writeFile(cache.shapes(), "damaged");
  const nlohmann::json standard{
      {"lanes_per_item", 1}, {"samples_per_group", 4}, {"from", "default"}};
  CHECK(emulationShape(cache.surroundings) == standard);

  const auto results = resultsOf(tuneEmulation, cache.surroundings);
  CHECK(results.at("kept_in") == cache.shapes().string());
  REQUIRE(results.at("device").size() == 1);
  const auto& device = results.at("device")[0];
  CHECK(device.at("engine") == "cuda-host");
  REQUIRE(device.at("timings").size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& row = device.at("timings")[i];
    CHECK(row.at("lanes_per_item") == 1);
    CHECK(row.at("samples_per_group") == 1 << i);
    CHECK(row.at("exact_milliseconds") > 0);
    CHECK(row.at("table_milliseconds") > 0);
  }
  nlohmann::json chosen = device.at("chosen");
  CHECK(chosen.at("lanes_per_item") == 1);
  chosen["from"] = "tuning";
  CHECK(emulationShape(cache.surroundings) == chosen);
  Surroundings overruled = cache.surroundings;
  overruled.environment["HAARLIGHT_WORK_SHAPE"] = "default";
  CHECK(emulationShape(overruled) == standard);
}

TEST_CASE("devices tells of a file of tuned shapes that it ignores") {
  const OwnCache cache;
  writeFile(cache.shapes(), "haarlight work shapes 2\n");
  const Outcome outcome = runHaarlight({"devices"}, cache.surroundings);
  CHECK(outcome.exitCode == 0);
  CHECK(contains(outcome.errors, "haarlight: warning: " + cache.shapes().string()));
  CHECK(contains(outcome.errors, "newer haarlight"));
}

TEST_CASE("devices --tune that is interrupted leaves what was kept as it was") {
  OwnCache cache;
  const std::string kept = "haarlight work shapes 1\ncuda-host\tanother host\t\t1\t2\nend\n";
  writeFile(cache.shapes(), kept);
  // Written when the sphere table is there, before anything is measured.
  cache.surroundings.interruptAfter = cache.folder / "sphere-table-2.bin";
  const Outcome outcome = runHaarlight(tuneEmulation, cache.surroundings);
  CHECK(outcome.exitCode == 0);
  CHECK(contains(outcome.errors, "interrupted"));
  CHECK(readFile(cache.shapes()) == kept);
}

TEST_CASE("devices --tune refuses what it cannot measure or keep") {
  checkRefused({"devices", "--tune", "--engine", "reference"}, "--engine");
  checkRefused({"devices", "--tune", "--device", "no such device"}, "no such device to tune");
  checkRefused({"devices", "--engine", "opencl"}, "--tune");
  checkRefused({"devices", "--tune", "--budget"}, "--budget");
  Surroundings nowhere;
  nowhere.environment["HAARLIGHT_CACHE_DIR"] = "/dev/null";
  checkRefused(tuneEmulation, "/dev/null", nowhere);
}
