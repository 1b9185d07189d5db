#include "benchmark/scale.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "verify/cases/paper_frame.h"

using namespace haarlight;
using namespace haarlight::benchmark;

TEST_CASE("the sweeps run over the sizes asked for") {
  const ScalePlan plan = scalePlan(std::size_t(1) << 21);
  CHECK(plan.samples.size() == 12);
  CHECK(plan.samples.front() == 1 << 10);
  CHECK(plan.samples.back() == 1 << 21);
  CHECK(plan.spheres.front() == 8);
  CHECK(plan.spheres.back() == 1024);
  CHECK(plan.terms.front() == 0);
  CHECK(plan.terms.back() == 6144);
  for (const auto& sizes : {plan.spheres, plan.terms}) CHECK(std::ranges::is_sorted(sizes));
  CHECK(scalePlan(5000).samples == std::vector<std::size_t>{1024, 2048, 4096});
}

TEST_CASE("as many receivers as asked for cover the plane of the paper's frame") {
  for (const std::size_t count : {1024, 2048, 16384}) {
    const Receivers receivers = planeReceivers(count);
    CHECK(receivers.size() == count);
    float lowest = 0, highest = 0;
    for (const glm::vec4& position : receivers.positions) {
      lowest = std::min({lowest, position.x, position.z});
      highest = std::max({highest, position.x, position.z});
    }
    CHECK(highest - lowest > 7.5f);
    CHECK(highest - lowest < 8.0f);
  }
  CHECK(planeReceivers(16384).positions == verify::paperFrame(1).receivers.positions);
}

TEST_CASE("each size of each sweep is measured") {
  ScalePlan plan;
  plan.samples = {1, 2, 4, 8};
  plan.spheres = {1, 2};
  plan.terms = {0, 8};
  plan.fixedSamples = 4;
  plan.fixed = {2, 8, 1};
  const auto engine = makeReferenceEngine(nullptr);
  int asked = 0;
  Effort effort{.frames = 2, .warmUpFrames = 0, .progress = {}};
  effort.interrupted = [&] {
    ++asked;
    return false;
  };
  const Scale scale = measureScale(*engine, verify::paperFrame(1).light, plan, effort);
  REQUIRE(scale.sweeps.size() == 3);
  CHECK(scale.sweeps[0].parameter == "samples");
  REQUIRE(scale.sweeps[0].points.size() == 4);
  CHECK(scale.sweeps[0].points[3].size == 8);
  CHECK(scale.sweeps[0].points[3].frame.count == 2);
  CHECK(scale.sweeps[0].law);
  CHECK(scale.sweeps[1].points.size() == 2);
  CHECK_FALSE(scale.sweeps[1].law);
  CHECK(asked > 0);
  effort.interrupted = [] { return true; };
  for (const Sweep& sweep : measureScale(*engine, verify::paperFrame(1).light, plan, effort).sweeps)
    CHECK(sweep.points.empty());
}
