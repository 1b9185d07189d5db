#include "verify/run.h"

#include <algorithm>
#include <chrono>

#include "base/error.h"
#include "verify/cases/known_cases.h"
#include "verify/cases/random_cases.h"
#include "verify/comparison.h"
#include "verify/known_answers.h"
#include "verify/shrink.h"

namespace haarlight::verify {

namespace {

/// The questions of a run, made one after the other.
class Questions {
 public:
  explicit Questions(const RunOptions& options) : options_(options) {
    if (options.knownCases)
      for (const KnownCase& known : knownCases()) cases_.push_back(known.question);
    knownCount_ = cases_.size();
    cases_.insert(cases_.end(), options.cases.begin(), options.cases.end());
  }

  std::size_t knownCount() const { return knownCount_; }
  /// Known and further cases, which come before the random ones.
  std::size_t fixedCount() const { return cases_.size(); }
  std::size_t count() const { return cases_.size() + options_.randomCases; }
  Case at(std::size_t index) const {
    return index < cases_.size() ? cases_[index] : randomCase(options_.seed, index - cases_.size());
  }

 private:
  const RunOptions& options_;
  std::vector<Case> cases_;
  std::size_t knownCount_ = 0;
};

/// A run in progress.
class Run {
 public:
  Run(const RunOptions& options, std::shared_ptr<const SphereTable> table)
      : options_(options), table_(std::move(table)), questions_(options) {}

  RunResult result() {
    const auto start = std::chrono::steady_clock::now();
    Subjects subjects = openSubjects(
        options_.engines, table_, [&](const std::string& what) { report("opening " + what, 0); });
    for (Subject& subject : subjects.list)
      comparisons_.emplace_back(std::move(subject), options_.injection);
    if (options_.injection) checkInjectedEngine();
    RunResult result;
    result.report = summary();
    result.report.absent = std::move(subjects.absent);
    if (options_.knownCases) result.report.rows = compareReferenceWithKnownAnswers(table_);
    for (std::size_t i = 0; i < questions_.count(); ++i) compareAll(questions_.at(i), i);
    for (const SubjectComparison& comparison : comparisons_)
      std::ranges::move(comparison.rows(), std::back_inserter(result.report.rows));
    collectFaults(result.report);
    if (options_.shrinkFailure) result.failingCase = smallestFailure();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    result.report.seconds = seconds.count();
    return result;
  }

 private:
  void report(const std::string& task, double finished) const {
    if (options_.progress) options_.progress(task, finished);
  }

  Report summary() const {
    Report summary;
    summary.seed = options_.seed;
    summary.knownCases = questions_.knownCount();
    summary.sceneCases = options_.cases.size();
    summary.randomCases = options_.randomCases;
    return summary;
  }

  void checkInjectedEngine() const {
    if (std::ranges::none_of(comparisons_, [](const auto& c) { return c.hasFaults(); }))
      throw InputError("no fault can be put into " + options_.injection->engine +
                       ": no such engine is among those that run here");
  }

  void compareAll(const Case& value, std::size_t index) {
    report("comparing", double(index) / double(questions_.count()));
    const auto settings = settingsFor(value, index, index < questions_.fixedCount());
    const auto orders = ordersFor(value, index, index < questions_.fixedCount());
    const auto transfers = transferSettingsFor(value, index, index < questions_.fixedCount());
    const Question question(value, settings, orders, transfers);
    for (const VisibilityKind visibility : {VisibilityKind::exact, VisibilityKind::table}) {
      const Answers answers =
          referenceAnswers(question, visibility == VisibilityKind::table ? table_ : nullptr);
      for (SubjectComparison& comparison : comparisons_) {
        if (comparison.visibility() != visibility) continue;
        const bool agreed = !comparison.disagrees();
        comparison.compare(question, answers);
        if (agreed && comparison.disagrees() && !failing_)
          failing_ = {value, &comparison, settings, orders, transfers};
      }
    }
  }

  void collectFaults(Report& report) const {
    for (const SubjectComparison& comparison : comparisons_)
      if (comparison.hasFaults()) report.faults.push_back(comparison.faultSummary());
  }

  std::optional<Case> smallestFailure() {
    if (!failing_) return std::nullopt;
    report("cutting down " + failing_->value.name, 0);
    SubjectComparison& comparison = *failing_->comparison;
    const auto table = comparison.visibility() == VisibilityKind::table ? table_ : nullptr;
    return shrunk(failing_->value, [&](const Case& part) {
      const Question question(part, failing_->settings, failing_->orders, failing_->transfers);
      return comparison.failsOn(question, referenceAnswers(question, table));
    });
  }

  struct Failure {
    Case value;
    SubjectComparison* comparison;
    std::span<const Setting> settings;
    std::span<const int> orders;
    std::span<const TransferSetting> transfers;
  };

  const RunOptions& options_;
  std::shared_ptr<const SphereTable> table_;
  Questions questions_;
  std::vector<SubjectComparison> comparisons_;
  std::optional<Failure> failing_;
};

}  // namespace

RunResult run(const RunOptions& options, std::shared_ptr<const SphereTable> table) {
  return Run(options, std::move(table)).result();
}

}  // namespace haarlight::verify
