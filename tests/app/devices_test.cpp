#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight::test;

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
    // At least the sphere table: for 6144 texels times 32 radii an entry of 4 bytes and 3.3 groups of
    // 64.
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
