#include "verify/comparison.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/forwarding_engine.h"
#include "verify/cases/random_cases.h"

using namespace haarlight;
using namespace haarlight::verify;

namespace {

/// A device that flushes denormal numbers: it says so, and its radiance is a little off.
class LimitedEngine final : public ForwardingEngine {
 public:
  explicit LimitedEngine(float relativeError)
      : ForwardingEngine(makeReferenceEngine(nullptr)), factor_(1 + relativeError) {}

  std::string name() const override { return "limited"; }
  std::string numericLimitation() const override { return "it flushes denormal numbers to zero"; }
  std::vector<glm::vec4> tripleProduct(std::span<const OcclusionHaar> occlusion,
                                       std::span<const LobeBlend> lobes) override {
    return scaled(engine_->tripleProduct(occlusion, lobes));
  }
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                               StageTimes* times) override {
    return scaled(engine_->shade(spheres, receivers, times));
  }
  std::vector<glm::vec4> shadeByExponentiation(std::span<const Sphere> spheres,
                                               ReceiverSpan receivers, StageTimes* times) override {
    return scaled(engine_->shadeByExponentiation(spheres, receivers, times));
  }
  std::vector<glm::vec4> shadeByTransfer(const TransferReceivers& receivers,
                                         StageTimes* times) override {
    return scaled(engine_->shadeByTransfer(receivers, times));
  }

 private:
  std::vector<glm::vec4> scaled(std::vector<glm::vec4> radiance) const {
    for (glm::vec4& value : radiance) value *= factor_;
    return radiance;
  }

  float factor_;
};

std::vector<Row> rowsOf(float relativeError, std::size_t caseIndex) {
  Subject subject{"limited", "test", "", VisibilityKind::exact,
                  std::make_unique<LimitedEngine>(relativeError)};
  SubjectComparison comparison(std::move(subject), std::nullopt);
  const Question question(randomCase(1, caseIndex), allSettings);
  comparison.compare(question, referenceAnswers(question, nullptr));
  return comparison.rows();
}

}  // namespace

TEST_CASE("a device that says it has a limit may differ by 1e-5 in radiance, and in nothing else") {
  const std::vector<Row> rows = rowsOf(1e-6f, 0);
  // moved spheres, bit cubes, coefficients, six settings of sums and of fused frames, frame, three
  // orders of exponentiation, six settings of transfer
  CHECK(rows.size() == 25);
  for (const Row& row : rows) {
    CHECK(row.mismatches == 0);
    CHECK(!row.tolerance.empty());
    const bool radiance = row.stage == Stage::tripleProduct || row.stage == Stage::fused ||
                          row.stage == Stage::frame || row.stage == Stage::exponentiation ||
                          row.stage == Stage::transfer;
    CHECK((row.maximumUlp > 0) == radiance);
  }
}

TEST_CASE("a device with a limit that differs by more, such as twice the radiance, is a mismatch") {
  const std::vector<Row> rows = rowsOf(1, 0);
  CHECK(std::ranges::count_if(rows, [](const Row& row) { return row.mismatches > 0; }) == 22);
}

TEST_CASE("a device with a limit is not asked about denormal numbers") {
  const std::size_t denormal = 7;
  REQUIRE(randomCase(1, denormal).hasDenormals);
  CHECK(rowsOf(0, denormal).empty());
}

TEST_CASE("moved spheres are compared where a case has some, number by number") {
  const std::vector<Sphere> expected{{{0, 1, 2}, 3}, {{4, 5, 6}, 7}};
  std::vector<Sphere> actual = expected;
  actual[0].center.x = -0.0f;
  actual[1].center.y = std::nextafter(5.0f, 6.0f);
  actual[1].radius = 8;
  Tally tally{Row{}};
  tally.compareMovedSpheres({}, expected, actual);
  const Row row = tally.finish();
  CHECK(row.compared == 8);
  REQUIRE(row.mismatches == 3);
  CHECK(row.firstMismatches[0].place == "sphere 0: centre x");
  CHECK(row.firstMismatches[1].place == "sphere 1: centre y");
  CHECK(row.firstMismatches[1].ulp == 1);
  CHECK(row.firstMismatches[2].place == "sphere 1: radius");
  CHECK(row.firstMismatches[2].sample == 1);

  Case without = randomCase(1, 0);
  without.binding = {};
  Subject subject{"limited", "test", "", VisibilityKind::exact, makeReferenceEngine(nullptr)};
  SubjectComparison comparison(std::move(subject), std::nullopt);
  const Question question(without, allSettings);
  comparison.compare(question, referenceAnswers(question, nullptr));
  for (const Row& compared : comparison.rows()) CHECK(compared.stage != Stage::movedSpheres);
}
