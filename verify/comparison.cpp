#include "verify/comparison.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

namespace haarlight::verify {

namespace {

std::string nameOf(const ShadingSettings& settings) {
  return std::to_string(settings.terms) + " terms, level " + (settings.levels == 1 ? "I" : "II");
}

float brightest(const ShadingTables& tables) {
  float maximum = 0;
  for (std::size_t slot = 0; slot < tables.slotCount(); ++slot) {
    const glm::vec3 radiance = tables.unshadowedRadiance(slot);
    maximum = std::max({maximum, radiance.x, radiance.y, radiance.z});
  }
  return maximum;
}

float brightest(const ExponentiationTables& tables) {
  constexpr float sphereRoot = 3.5449077f;  // √4π: without shadow V is this and zeros
  float maximum = 0;
  for (std::size_t slot = 0; slot < tables.slotCount(); ++slot)
    for (int channel = 0; channel < 3; ++channel)
      maximum = std::max(maximum, sphereRoot * tables.lightLobe(slot, channel)[0]);
  return maximum;
}

float brightest(std::span<const glm::vec4> radiance) {
  float maximum = 0;
  for (const glm::vec4& value : radiance) maximum = std::max({maximum, value.x, value.y, value.z});
  return maximum;
}

}  // namespace

SubjectComparison::SubjectComparison(Subject subject, const std::optional<Injection>& injection)
    : engineName_(std::move(subject.engineName)),
      device_(std::move(subject.device)),
      shape_(std::move(subject.shape)),
      visibility_(subject.visibility),
      engine_(std::move(subject.engine)) {
  if (!injection || injection->engine != engineName_) return;
  auto faulty = std::make_unique<FaultyEngine>(std::move(engine_), injection->kind);
  faulty_ = faulty.get();
  faultKind_ = injection->kind;
  engine_ = std::move(faulty);
}

Tally& SubjectComparison::tallyOf(Stage stage, const std::string& setting) {
  const std::pair key(stage, setting);
  for (auto& [labels, tally] : tallies_)
    if (labels == key) return tally;
  Row row;
  row.stage = stage;
  row.visibility = verify::nameOf(visibility_);
  row.setting = setting;
  row.engine = engineName_;
  row.device = device_;
  row.shape = shape_;
  if (const std::string limitation = engine_->numericLimitation(); !limitation.empty())
    row.tolerance = "the device has a limit: " + limitation +
                    "; cases with denormal numbers are left out, radiance may differ by 1e-5";
  tallies_.emplace_back(key, Tally(std::move(row)));
  Tally& tally = tallies_.back().second;
  if (faulty_) tally.keepPlaces();
  return tally;
}

template <typename Action>
auto SubjectComparison::timed(Tally& tally, const Action& action) {
  const auto start = std::chrono::steady_clock::now();
  auto result = action();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  tally.addSeconds(seconds.count());
  return result;
}

void SubjectComparison::compare(const Question& question, const Answers& answers) {
  const Case& value = question.value;
  if (value.hasDenormals && !engine_->numericLimitation().empty()) return;
  if (faulty_) faulty_->beginCase(value.name);
  if (value.binding.sphereCount() > 0) compareMovedSpheres(value, answers);
  if (visibility_ == VisibilityKind::table) compareEntries(value, answers);
  compareOcclusion(value, answers);
  for (std::size_t i = 0; i < question.tables.size(); ++i) {
    compareSums(value, question.tables[i], answers, answers.radiance[i]);
    compareFused(value, question.tables[i], answers.radiance[i]);
  }
  compareFrame(value, question.tables[question.frameTables], answers);
  for (std::size_t i = 0; i < question.exponentiation.size(); ++i)
    compareExponentiation(value, question.exponentiation[i], answers.exponentiation[i]);
  for (std::size_t i = 0; i < question.transfer.size(); ++i)
    compareTransfer(value, question.transfer[i], answers.transfer[i]);
}

void SubjectComparison::compareMovedSpheres(const Case& value, const Answers& answers) {
  Tally& moved = tallyOf(Stage::movedSpheres, "");
  engine_->setSphereBinding(value.binding);
  moved.compareMovedSpheres(value, answers.movedSpheres,
                            timed(moved, [&] { return engine_->moveSpheres(value.vertices); }));
}

void SubjectComparison::compareEntries(const Case& value, const Answers& answers) {
  Tally& entries = tallyOf(Stage::tableEntries, "");
  entries.compareEntries(value, answers.tableEntries, timed(entries, [&] {
                           return engine_->sphereTableEntries(value.spheres, value.receivers);
                         }));
}

void SubjectComparison::compareOcclusion(const Case& value, const Answers& answers) {
  Tally& cubes = tallyOf(Stage::bitCubes, "");
  cubes.compareBitCubes(value, answers.bitCubes, timed(cubes, [&] {
                          return engine_->mergeBitCubes(value.spheres, value.receivers);
                        }));
  Tally& haar = tallyOf(Stage::haar, "");
  haar.compareOcclusion(value, answers.occlusion,
                        timed(haar, [&] { return engine_->transformOcclusion(answers.bitCubes); }));
}

void SubjectComparison::compareSums(const Case& value, const ShadingTables& tables,
                                    const Answers& answers, std::span<const glm::vec4> expected) {
  Tally& sums = tallyOf(Stage::tripleProduct, nameOf(tables.settings));
  engine_->setShading(tables);
  const auto radiance =
      timed(sums, [&] { return engine_->tripleProduct(answers.occlusion, value.receivers.lobes); });
  sums.compareRadiance(value, expected, radiance, brightest(tables));
}

void SubjectComparison::compareFused(const Case& value, const ShadingTables& tables,
                                     std::span<const glm::vec4> expected) {
  Tally& fused = tallyOf(Stage::fused, nameOf(tables.settings));
  engine_->setShading(tables);
  engine_->setFramePath(FramePath::fused);
  const auto radiance =
      timed(fused, [&] { return engine_->shade(value.spheres, value.receivers); });
  fused.compareRadiance(value, expected, radiance, brightest(tables));
}

void SubjectComparison::compareFrame(const Case& value, const ShadingTables& tables,
                                     const Answers& answers) {
  Tally& frame = tallyOf(Stage::frame, "");
  engine_->setShading(tables);
  engine_->setFramePath(FramePath::staged);
  const auto radiance =
      timed(frame, [&] { return engine_->shade(value.spheres, value.receivers); });
  frame.compareRadiance(value, answers.frame, radiance, brightest(tables));
}

void SubjectComparison::compareExponentiation(const Case& value, const ExponentiationTables& tables,
                                              std::span<const glm::vec4> expected) {
  Tally& exponentiation =
      tallyOf(Stage::exponentiation, "order " + std::to_string(tables.visibility.order));
  engine_->setExponentiation(tables);
  const auto radiance = timed(exponentiation, [&] {
    return engine_->shadeByExponentiation(value.spheres, value.receivers);
  });
  exponentiation.compareRadiance(value, expected, radiance, brightest(tables));
}

void SubjectComparison::compareTransfer(const Case& value, const TransferQuestion& question,
                                        std::span<const glm::vec4> expected) {
  Tally& transfer = tallyOf(Stage::transfer, nameOf(question.setting));
  engine_->setTransferRows(question.rows);
  engine_->setTransferLights(question.lights);
  const auto radiance =
      timed(transfer, [&] { return engine_->shadeByTransfer(question.receivers); });
  transfer.compareRadiance(value, expected, radiance, brightest(expected));
}

std::vector<Row> SubjectComparison::rows() const {
  std::vector<Row> rows;
  for (const auto& [labels, tally] : tallies_) rows.push_back(tally.finish());
  std::ranges::stable_sort(rows, {}, &Row::stage);
  return rows;
}

bool SubjectComparison::disagrees() const {
  return std::ranges::any_of(tallies_,
                             [](const auto& entry) { return entry.second.mismatches() > 0; });
}

bool SubjectComparison::failsOn(const Question& question, const Answers& answers) {
  auto kept = std::exchange(tallies_, {});
  compare(question, answers);
  const bool fails = disagrees();
  tallies_ = std::move(kept);
  return fails;
}

FaultSummary SubjectComparison::faultSummary() const {
  std::vector<InjectedFault> injected = faulty_->faults(), found, both;
  for (const auto& [labels, tally] : tallies_)
    found.insert(found.end(), tally.places().begin(), tally.places().end());
  std::ranges::sort(injected);
  std::ranges::sort(found);
  std::ranges::set_intersection(injected, found, std::back_inserter(both));
  return {verify::nameOf(faultKind_),  engineName_,     device_,     shape_,
          verify::nameOf(visibility_), injected.size(), both.size(), found.size() - both.size()};
}

}  // namespace haarlight::verify
