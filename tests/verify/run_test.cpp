#include "verify/run.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/error.h"
#include "base/file.h"
#include "verify/cases/random_cases.h"
#include "verify/comparison.h"
#include "verify/shrink.h"

using namespace haarlight;
using namespace haarlight::verify;

namespace {

std::shared_ptr<const SphereTable> sphereTable() {
  static const auto table = std::make_shared<const SphereTable>(SphereTable::load(cacheFolder()));
  return table;
}

RunOptions smallRun() {
  RunOptions options;
  options.engines = {"cuda-host"};
  options.knownCases = false;
  options.randomCases = 6;
  return options;
}

/// Rows of the stage that are expected to differ, and no others.
void checkDiffers(const Report& report, Stage stage) {
  for (const Row& row : report.rows) {
    CAPTURE(nameOf(row.stage));
    if (row.stage != stage) CHECK(row.mismatches == 0);
  }
  CHECK(std::ranges::any_of(report.rows, [&](const Row& row) { return row.mismatches > 0; }));
  CHECK(!report.agrees());
}

}  // namespace

TEST_CASE("reference, CUDA kernels and known answers agree") {
  RunOptions options = smallRun();
  options.knownCases = true;
  const RunResult result = run(options, sphereTable());
  CHECK(result.report.agrees());
  CHECK(!result.failingCase);
  CHECK(result.report.randomCases == 6);
  for (const VisibilityKind kind : {VisibilityKind::exact, VisibilityKind::table})
    for (const Stage stage :
         {Stage::movedSpheres, Stage::bitCubes, Stage::haar, Stage::tripleProduct, Stage::fused,
          Stage::frame, Stage::exponentiation, Stage::transfer})
      CHECK(std::ranges::any_of(result.report.rows, [&](const Row& row) {
        return row.engine == "cuda-host" && row.stage == stage && row.visibility == nameOf(kind) &&
               row.compared > 0 && row.maximumUlp == 0;
      }));
}

TEST_CASE("every kind of fault is found where it was put") {
  for (const auto& [kind, stage] : {std::pair(InjectionKind::sphere, Stage::movedSpheres),
                                    std::pair(InjectionKind::bit, Stage::bitCubes),
                                    std::pair(InjectionKind::coefficient, Stage::haar),
                                    std::pair(InjectionKind::ulp, Stage::tripleProduct),
                                    std::pair(InjectionKind::exponentiation, Stage::exponentiation),
                                    std::pair(InjectionKind::transfer, Stage::transfer)}) {
    CAPTURE(nameOf(kind));
    RunOptions options = smallRun();
    options.injection = Injection{kind, "cuda-host"};
    const RunResult result = run(options, sphereTable());
    checkDiffers(result.report, stage);
    REQUIRE(result.report.faults.size() == 2);  // exact and table
    for (const FaultSummary& faults : result.report.faults) {
      CHECK(faults.injected >= 6);
      CHECK(faults.located == faults.injected);
      CHECK(faults.unexplained == 0);
    }
  }
}

TEST_CASE("a mismatch of one ULP is reported as such, with both values") {
  RunOptions options = smallRun();
  options.injection = Injection{InjectionKind::ulp, "cuda-host"};
  const Report report = run(options, sphereTable()).report;
  for (const Row& row : report.rows) {
    if (row.stage != Stage::tripleProduct) continue;
    CHECK(row.maximumUlp == 1);
    CHECK(row.medianUlp == 0);
    REQUIRE(!row.firstMismatches.empty());
    const Mismatch& first = row.firstMismatches.front();
    CHECK(first.ulp == 1);
    CHECK(std::abs(std::int64_t(first.actualBits) - std::int64_t(first.expectedBits)) == 1);
  }
}

TEST_CASE("a failing case is cut down to one receiver and one sphere") {
  RunOptions options = smallRun();
  options.injection = Injection{InjectionKind::bit, "cuda-host"};
  options.shrinkFailure = true;
  const RunResult result = run(options, sphereTable());
  REQUIRE(result.failingCase);
  CHECK(result.failingCase->receivers.size() == 1);
  CHECK(result.failingCase->spheres.size() == 1);
  CHECK(result.failingCase->vertices.empty());
}

TEST_CASE("a case with a wrong moved sphere is cut down to one that follows one vertex") {
  RunOptions options = smallRun();
  options.injection = Injection{InjectionKind::sphere, "cuda-host"};
  options.shrinkFailure = true;
  const auto failing = run(options, sphereTable()).failingCase;
  REQUIRE(failing);
  CHECK(failing->receivers.size() == 1);
  CHECK(failing->binding.sphereCount() == 1);
  CHECK(failing->vertices.size() == 1);
}

TEST_CASE("cutting down keeps the vertices and weights that a failure needs") {
  Case whole;
  whole.receivers.add({0, 0, 0}, {0, 1, 0});
  whole.spheres = {{{0, 1, 0}, 1}};
  for (int i = 0; i < 100; ++i) whole.vertices.emplace_back(i, 0, 0, 0);
  std::vector<std::uint32_t> list;
  std::vector<glm::vec4> weights;
  for (std::uint32_t k = 0; k < 40; ++k) {
    list.push_back(2 * k);
    weights.emplace_back(k, 0, 1, 0);
  }
  for (const float factor : {1.0f, 2.0f, 3.0f}) whole.binding.add(list, weights, {0, factor});
  const auto entryOf = [](const Case& part, const glm::vec2& factors, float x, float weight) {
    const SphereBinding& binding = part.binding;
    for (std::size_t i = 0; i < binding.sphereCount(); ++i)
      for (std::size_t k = binding.listStarts[i]; k < binding.listStarts[i + 1]; ++k)
        if (binding.radiusFactors[i] == factors && binding.weights[k].x == weight &&
            part.vertices[binding.vertices[k]].x == x)
          return true;
    return false;
  };
  const Case small = shrunk(whole, [&](const Case& part) {
    return entryOf(part, {0, 2}, 10, 5) && entryOf(part, {0, 2}, 66, 33) &&
           entryOf(part, {0, 3}, 6, 3);
  });
  CHECK(small.binding.sphereCount() == 2);
  CHECK(small.vertices.size() == 3);
  CHECK(small.binding.listStarts == std::vector<std::uint32_t>{0, 32, 64});
}

TEST_CASE("cutting down keeps just what is needed to fail") {
  const Case whole = randomCase(1, 5);
  REQUIRE(whole.spheres.size() >= 3);
  REQUIRE(whole.receivers.size() >= 2);
  const glm::vec3 first = whole.spheres.front().center, last = whole.spheres.back().center;
  const glm::vec4 receiver = whole.receivers.positions[1];
  const auto has = [](const Case& part, const glm::vec3& center) {
    return std::ranges::any_of(part.spheres, [&](const Sphere& s) { return s.center == center; });
  };
  const Case small = shrunk(whole, [&](const Case& part) {
    return has(part, first) && has(part, last) &&
           std::ranges::find(part.receivers.positions, receiver) != part.receivers.positions.end();
  });
  CHECK(small.spheres.size() == 2);
  CHECK(small.receivers.size() == 1);
  CHECK(small.receivers.lobes.size() == 1);
}

TEST_CASE("engines that do not exist are refused") {
  RunOptions options = smallRun();
  options.engines = {"vulkan"};
  CHECK_THROWS_AS(run(options, sphereTable()), InputError);
  options.engines = {"cuda-host"};
  options.injection = Injection{InjectionKind::bit, "opencl"};
  CHECK_THROWS_AS(run(options, sphereTable()), InputError);
}
