#include "app/bench_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/interrupt.h"
#include "app/version.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/peak_memory.h"
#include "benchmark/build.h"
#include "benchmark/peers.h"
#include "benchmark/scale.h"
#include "scene/names.h"
#include "verify/report/host.h"

namespace haarlight {

namespace {

using namespace benchmark;

constexpr int paperSpheres = 64;  // of peers and sweeps

SceneDescription describe(const BenchOptions& options) {
  SceneDescription scene = describeScene(options.scene);
  if (!scene.receiver)
    throw InputError("the scene has no receiver plane, whose samples are measured");
  if (!options.size.empty()) scene.receiver->samples = parseReceiverSize(options.size);
  if (options.scale) scene.objects.clear();  // sweeps have spheres of their own
  return scene;
}

std::vector<int> inOrder(std::vector<int> values) {
  std::ranges::sort(values);
  const auto repeated = std::ranges::unique(values);
  values.erase(repeated.begin(), repeated.end());
  return values;
}

SubjectFilter filterOf(const BenchOptions& options) {
  SubjectFilter filter = options.subjects;
  if (options.visibility != "both")
    filter.visibilities = {choiceOf(visibilityKindNames, options.visibility)};
  if (options.path != "both") filter.paths = {choiceOf(framePathNames, options.path)};
  return filter;
}

/// A run on the way to its record.
class Bench {
 public:
  Bench(const BenchOptions& options, Console& console)
      : options_(options), console_(console), description_(describe(options)) {
    selected_ = selectSubjects(listDevices(), filterOf(options), openClAdvice());
    if (options.scale) selected_.resize(1);
  }

  Record run();

 private:
  void loadTable();
  void openSubjects();
  void measureTable(const Effort& effort);
  void measureSizes(const Effort& effort);
  void describeRun(const Effort& effort);
  const FittedScene& peersScene() const;
  OpenSubject stagedSubject() const;

  const BenchOptions& options_;
  Console& console_;
  SceneDescription description_;
  std::vector<Subject> selected_;
  std::shared_ptr<const SphereTable> table_;
  std::vector<OpenSubject> subjects_;
  Inputs inputs_;
  Record record_;
};

void Bench::loadTable() {
  SceneDescription withTable = description_;
  withTable.shading.visibility = VisibilityKind::table;
  const auto needsTable = [](const Subject& s) { return s.visibility == VisibilityKind::table; };
  if (std::ranges::any_of(selected_, needsTable)) table_ = openSphereTable(withTable, console_);
}

void Bench::openSubjects() {
  for (const Subject& subject : selected_) {
    try {
      subjects_.push_back(openSubject(subject, table_));
    } catch (const std::exception& problem) {  // of this device; others may work
      console_.warning(subject.name() + ": " + problem.what());
      continue;
    }
    const OpenSubject& opened = subjects_.back();
    console_.message(fmt::format("{}: opened in {:.2f} s", subject.name(), opened.openSeconds));
    record_.subjects.push_back(
        {subject, opened.openSeconds, opened.engine->preparationSeconds(), 0});
  }
  if (subjects_.empty()) throw std::runtime_error("no engine could be opened; see above");
}

/// The scene with the paper's 64 spheres, else with the fewest.
const FittedScene& Bench::peersScene() const {
  const auto found = std::ranges::find(inputs_.scenes, paperSpheres, &FittedScene::spheres);
  return found == inputs_.scenes.end() ? inputs_.scenes.front() : *found;
}

/// Of peers that need a device: the first subject with exact visibility, if there is one.
OpenSubject Bench::stagedSubject() const {
  const auto exact = std::ranges::find_if(subjects_, [](const OpenSubject& opened) {
    return opened.subject.visibility == VisibilityKind::exact;
  });
  Subject chosen = exact == subjects_.end() ? subjects_.front().subject : exact->subject;
  chosen.path = FramePath::staged;  // so that merging is timed alone
  return openSubject(chosen, table_);
}

void Bench::measureTable(const Effort& effort) {
  const auto settings =
      settingsOf(inOrder(options_.spheres), inOrder(options_.terms), inOrder(options_.levels));
  record_.rows = measureRows(subjects_, inputs_, settings, effort);
  if (record_.rows.empty()) throw std::runtime_error("interrupted before the first frame");
  if (options_.peers && !effort.interrupted())
    record_.peers =
        measurePeers(subjects_, record_.rows, inputs_, peersScene(), stagedSubject(), effort);
}

void Bench::measureSizes(const Effort& effort) {
  ScalePlan plan = scalePlan(options_.scaleSamples);
  plan.fixedSamples = std::min(plan.fixedSamples, options_.scaleSamples);
  record_.scale = measureScale(*subjects_.front().engine, inputs_.light(), plan, effort);
}

void Bench::describeRun(const Effort& effort) {
  record_.program = "haarlight " HAARLIGHT_VERSION;
  record_.build = buildDescription;
  record_.host = verify::hostDescription();
  record_.date = verify::utcNow();
  record_.threads = threadCount();
  const SceneOptions& scene = options_.scene;
  record_.scene = !scene.mesh.empty()    ? scene.mesh
                  : !scene.scene.empty() ? scene.scene
                                         : "builtin:default";
  record_.light = description_.light.source;
  record_.samples = inputs_.samples.size();
  record_.frames = effort.frames;
  record_.rounds = effort.rounds();
  record_.warmUpFrames = effort.warmUpFrames;
  record_.interrupted = effort.interrupted();
  record_.peakMemoryMebibytes = peakMemoryMebibytes();
  for (std::size_t i = 0; i < subjects_.size(); ++i)
    record_.subjects[i].deviceBytes = subjects_[i].engine->deviceUse().memoryBytes;
}

Record Bench::run() {
  loadTable();
  openSubjects();
  const std::vector<int> fewest{1};
  inputs_ = loadInputs(description_, options_.scale ? fewest : inOrder(options_.spheres),
                       console_.progress());
  const InterruptWatch watch;
  Effort effort{.frames = options_.frames, .progress = console_.progress()};
  effort.interrupted = [&] { return watch.interrupted(); };
  if (options_.scale)
    measureSizes(effort);
  else
    measureTable(effort);
  describeRun(effort);
  if (options_.ceilings && !effort.interrupted())  // last, as it takes much memory
    record_.roofline = measureRoofline(record_, inputs_, table_.get(), ceilingPlan(threadCount()),
                                       console_.progress());
  return record_;
}

}  // namespace

benchmark::Record runBench(const BenchOptions& options, Console& console) {
  return Bench(options, console).run();
}

}  // namespace haarlight
