#include "verify/comparison.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "verify/cases/random_cases.h"

using namespace haarlight;
using namespace haarlight::verify;

namespace {

/// A device that flushes denormal numbers: it says so, and its radiance is a little off.
class LimitedEngine final : public Engine {
 public:
  explicit LimitedEngine(float relativeError) : factor_(1 + relativeError) {}

  std::string name() const override { return "limited"; }
  std::string deviceName() const override { return "test"; }
  std::string numericLimitation() const override { return "it flushes denormal numbers to zero"; }
  void setShading(const ShadingTables& tables) override { reference_->setShading(tables); }
  std::vector<std::uint32_t> sphereTableEntries(std::span<const Sphere> spheres,
                                                ReceiverSpan receivers) override {
    return reference_->sphereTableEntries(spheres, receivers);
  }
  std::vector<BitCube> mergeBitCubes(std::span<const Sphere> spheres,
                                     ReceiverSpan receivers) override {
    return reference_->mergeBitCubes(spheres, receivers);
  }
  std::vector<OcclusionHaar> transformOcclusion(std::span<const BitCube> cubes) override {
    return reference_->transformOcclusion(cubes);
  }
  std::vector<glm::vec4> tripleProduct(std::span<const OcclusionHaar> occlusion,
                                       std::span<const LobeBlend> lobes) override {
    return scaled(reference_->tripleProduct(occlusion, lobes));
  }
  std::vector<glm::vec4> shade(std::span<const Sphere> spheres, ReceiverSpan receivers,
                               StageTimes* times) override {
    return scaled(reference_->shade(spheres, receivers, times));
  }

 private:
  std::vector<glm::vec4> scaled(std::vector<glm::vec4> radiance) const {
    for (glm::vec4& value : radiance) value *= factor_;
    return radiance;
  }

  std::unique_ptr<Engine> reference_ = makeReferenceEngine(nullptr);
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
  CHECK(rows.size() == 9);  // bit cubes, coefficients, six settings, frame
  for (const Row& row : rows) {
    CHECK(row.mismatches == 0);
    CHECK(!row.tolerance.empty());
    const bool radiance = row.stage == Stage::tripleProduct || row.stage == Stage::frame;
    CHECK((row.maximumUlp > 0) == radiance);
  }
}

TEST_CASE("a device with a limit that differs by more, such as twice the radiance, is a mismatch") {
  const std::vector<Row> rows = rowsOf(1, 0);
  CHECK(std::ranges::count_if(rows, [](const Row& row) { return row.mismatches > 0; }) == 7);
}

TEST_CASE("a device with a limit is not asked about denormal numbers") {
  const std::size_t denormal = 7;
  REQUIRE(randomCase(1, denormal).hasDenormals);
  CHECK(rowsOf(0, denormal).empty());
}
