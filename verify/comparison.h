#pragma once

#include <optional>
#include <vector>

#include "verify/expected.h"
#include "verify/injection.h"
#include "verify/subjects.h"
#include "verify/tally.h"

namespace haarlight::verify {

/// Asks one subject the questions of every stage and tallies how its answers compare with the
/// reference's.
class SubjectComparison {
 public:
  /// With an injection for the subject's engine its results are falsified.
  SubjectComparison(Subject subject, const std::optional<Injection>& injection);

  /// `answers` are the reference's, with the subject's kind of visibility.
  void compare(const Question& question, const Answers& answers);

  VisibilityKind visibility() const { return visibility_; }
  /// One row per stage and setting that was compared, stage by stage.
  std::vector<Row> rows() const;
  bool disagrees() const;
  /// Whether the subject gets this question wrong; leaves the rows as they are.
  bool failsOn(const Question& question, const Answers& answers);

  bool hasFaults() const { return faulty_ != nullptr; }
  /// How many of the faults put in the mismatches name. Only with faults.
  FaultSummary faultSummary() const;

 private:
  Tally& tallyOf(Stage stage, const std::string& setting);
  void compareMovedSpheres(const Case& value, const Answers& answers);
  void compareEntries(const Case& value, const Answers& answers);
  void compareOcclusion(const Case& value, const Answers& answers);
  void compareSums(const Case& value, const ShadingTables& tables, const Answers& answers,
                   std::span<const glm::vec4> expected);
  void compareFused(const Case& value, const ShadingTables& tables,
                    std::span<const glm::vec4> expected);
  void compareFrame(const Case& value, const ShadingTables& tables, const Answers& answers);
  void compareExponentiation(const Case& value, const ExponentiationTables& tables,
                             std::span<const glm::vec4> expected);
  void compareTransfer(const Case& value, const TransferQuestion& question,
                       std::span<const glm::vec4> expected);
  template <typename Action>
  auto timed(Tally& tally, const Action& action);

  std::string engineName_, device_, shape_;
  VisibilityKind visibility_;
  std::unique_ptr<Engine> engine_;
  /// `engine_`, when it is falsified.
  FaultyEngine* faulty_ = nullptr;
  InjectionKind faultKind_ = InjectionKind::bit;
  /// By stage and setting, in the order of the first comparison.
  std::vector<std::pair<std::pair<Stage, std::string>, Tally>> tallies_;
};

}  // namespace haarlight::verify
