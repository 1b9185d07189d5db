#include "hard_shadow/shadow_comparison.h"

#include <algorithm>
#include <utility>

#include "base/stopwatch.h"

namespace haarlight {

ShadowComparison::ShadowComparison(const SurfaceViewer& viewer, ShadowView view)
    : viewer_(viewer), view_(std::move(view)) {}

void ShadowComparison::add(std::string label, std::unique_ptr<HardShadowMethod> method) {
  runs_.push_back({std::move(label),
                   std::move(method),
                   ShadowPicture(view_.width, view_.height, view_.raysPerSide, view_.albedos,
                                 view_.lights, view_.bounds),
                   Image(view_.width, view_.height),
                   {}});
}

const ShadowRun* ShadowComparison::reference() const {
  const auto found = std::ranges::find_if(
      runs_, [](const ShadowRun& run) { return run.method->name() == "exact"; });
  return found == runs_.end() ? nullptr : &*found;
}

void ShadowComparison::run(const std::function<void(double)>& progress) {
  constexpr int raysAtATime = 1 << 20;
  const int side = view_.raysPerSide, rows = view_.height * side;
  const int step = std::max(1, raysAtATime / (view_.width * side * side)) * side;
  for (int first = 0; first < rows; first += step) {
    runRows(first, std::min(step, rows - first));
    if (progress) progress(std::min(1.0, double(first + step) / rows));
  }
}

ShadowComparison::Answers ShadowComparison::answersOf(ShadowRun& run,
                                                      const SurfaceView& rows) const {
  Answers answers(view_.lights.size());
  for (std::size_t light = 0; light < answers.size(); ++light) {
    answers[light].resize(rows.points.size());
    run.method->answer(light, rows, answers[light]);
  }
  return answers;
}

void ShadowComparison::runRows(int first, int count) {
  Stopwatch watch;
  const SurfaceView rows = viewer_.rows(first, count);
  viewSeconds_ += watch.lap();
  std::vector<Answers> answers;
  for (ShadowRun& run : runs_) {
    answers.push_back(answersOf(run, rows));
    run.picture.addRows(first, rows, answers.back(), view_.drawCells ? run.method.get() : nullptr);
  }
  if (!hasReference()) return;
  const Answers& exact = answers[std::size_t(reference() - runs_.data())];
  for (std::size_t i = 0; i < runs_.size(); ++i)
    for (std::size_t light = 0; light < view_.lights.size(); ++light) {
      const ShadowLight& place = view_.lights[light].light;
      runs_[i].difference.add(rows, place, answers[i][light], exact[light]);
      paintDifference(runs_[i].errors, first, view_.raysPerSide, rows, place, answers[i][light],
                      exact[light]);
    }
}

}  // namespace haarlight
