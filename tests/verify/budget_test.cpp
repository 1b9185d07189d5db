#include <doctest/doctest.h>

#include <cstdio>

#include "base/file.h"
#include "engine/devices.h"
#include "verify/cases/paper_frame.h"

using namespace haarlight;
using namespace haarlight::verify;

namespace {

/// Null, after a line "SKIPPED: …", when the engine has no device here.
std::shared_ptr<const SphereTable> sphereTable() {
  static const auto table = std::make_shared<SphereTable>(SphereTable::load(cacheFolder()));
  return table;
}

std::unique_ptr<Engine> openInGpuShape(const char* name) {
  EngineOptions options;
  options.engine = name;
  options.lanesPerItem = 1;
  for (const DeviceDescription& device : listDevices())
    if (device.engine == name && device.problem.empty()) return makeEngine(options, sphereTable());
  std::printf("SKIPPED: no device for the engine %s\n", name);
  return nullptr;
}

void checkBudget(const char* name, bool tellsLocalMemory) {
  const auto engine = openInGpuShape(name);
  if (!engine) return;
  const Budget budget = budgetOf(*engine);
  CHECK(budget.memoryBytes >
        sphereTable()->entries().size_bytes() + sphereTable()->groups().size_bytes());
  CHECK(budget.memoryBytes <= 768'000'000);
  CHECK(budget.itemsPerGroup % 32 == 0);
  CHECK(budget.itemsPerGroup <= 256);
  CHECK((budget.largestLocalBytes > 0) == tellsLocalMemory);
  CHECK(budget.largestLocalBytes <= 16384);
  CHECK(budget.isKept());
}

}  // namespace

TEST_CASE("the paper's frame has 16,384 receivers and finite spheres above its plane") {
  const Case frame = paperFrame(128);
  CHECK(frame.receivers.size() == 16384);
  REQUIRE(frame.spheres.size() == 128);
  for (const Sphere& sphere : frame.spheres) CHECK(sphere.center.y > sphere.radius / 2);
}

TEST_CASE("OpenCL keeps the budget of a GeForce 8800") {
  checkBudget("opencl", true);
}

TEST_CASE("CUDA keeps the budget of a GeForce 8800") {
  checkBudget("cuda", true);
}

TEST_CASE("the CUDA kernels on the host keep the budget of a GeForce 8800") {
  checkBudget("cuda-host", false);
}
