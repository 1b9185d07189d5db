#include "run_haarlight.h"
#include "test_support.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

/// A machine on which no OpenCL driver is installed.
Surroundings withoutDrivers(const TemporaryFolder& emptyFolder) {
  Surroundings surroundings;
  surroundings.environment["OCL_ICD_VENDORS"] = emptyFolder.path();
  surroundings.environment["CUDA_VISIBLE_DEVICES"] = "";
  return surroundings;
}

const Arguments tiny{"--size", "4x4", "--samples", "1", "--spheres", "8", "--quiet"};

}  // namespace

TEST_CASE("without OpenCL, devices says what to install") {
  const TemporaryFolder noDrivers;
  const Outcome outcome = runHaarlight({"devices"}, withoutDrivers(noDrivers));
  CHECK(outcome.exitCode == 0);
  CHECK(contains(outcome.output, "engine: reference\n"));
  CHECK_FALSE(contains(outcome.output, "engine: opencl\n"));
  CHECK(outcome.errors.starts_with("haarlight: warning: "));
  CHECK(contains(outcome.errors, "install"));
  const auto results = resultsOf({"devices"}, withoutDrivers(noDrivers));
  for (const auto& device : results.at("device")) {
    CHECK(device.at("engine") != "opencl");
    if (device.at("engine") != "cuda") continue;
    CHECK(device.at("usable") == false);
    CHECK(contains(device.at("problem"), "no CUDA device"));
  }
}

TEST_CASE("without OpenCL, the engine auto is the reference engine, with a warning") {
  const TemporaryFolder noDrivers, folder;
  const Outcome outcome =
      runHaarlight(joined({"render", "-o", folder / "x.png"}, tiny), withoutDrivers(noDrivers));
  CHECK(outcome.exitCode == 0);
  CHECK(contains(outcome.output, "device: reference"));
  CHECK(outcome.errors.starts_with("haarlight: warning: "));
  CHECK(contains(outcome.errors, "using the scalar reference engine"));
  CHECK(std::filesystem::exists(folder / "x.png"));
}

TEST_CASE("without OpenCL, asking for it is refused with what to install") {
  const TemporaryFolder noDrivers, folder;
  checkRefused(joined({"render", "--engine", "opencl", "-o", folder / "x.png"}, tiny), "install",
               withoutDrivers(noDrivers));
  checkRefused(joined({"render", "--device", "0", "-o", folder / "x.png"}, tiny), "install",
               withoutDrivers(noDrivers));
  CHECK(std::filesystem::is_empty(folder.path()));
}
