#include "benchmark/measure.h"

#include <algorithm>

#include "base/stopwatch.h"
#include "engine/stage_times.h"

namespace haarlight::benchmark {

namespace {

struct Task {
  std::size_t subject = 0;
  Setting setting;
  std::vector<Sphere> spheres;
  ShadingTables tables;
  std::vector<double> lightUploads;
  std::vector<StageTimes> frames;
};

std::vector<Task> tasksOf(std::size_t subjects, const Inputs& inputs,
                          std::span<const Setting> settings) {
  const std::vector<double> lobes = countLobes(inputs.receivers.lobes);
  std::vector<Task> tasks;
  for (const Setting& setting : settings) {
    const auto fitted = std::ranges::find(inputs.scenes, setting.spheres, &FittedScene::spheres);
    const ShadingSettings shading{.terms = setting.terms, .levels = setting.levels};
    tasks.push_back({0,
                     setting,
                     fitted->scene.blockerSpheres(),
                     buildShadingTables(inputs.light(), shading, lobes),
                     {},
                     {}});
  }
  for (std::size_t subject = 1; subject < subjects; ++subject)
    for (std::size_t i = 0; i < settings.size(); ++i) {
      tasks.push_back(tasks[i]);
      tasks.back().subject = subject;
    }
  return tasks;
}

/// Measures some frames of a row, after bringing its light to the device and warming up.
void measurePart(Task& task, Engine& engine, ReceiverSpan receivers, std::size_t frames,
                 const Effort& effort) {
  const Stopwatch watch;
  engine.setShading(task.tables);
  task.lightUploads.push_back(watch.total());
  for (std::size_t i = 0; i < effort.warmUpFrames; ++i) engine.shade(task.spheres, receivers);
  for (std::size_t i = 0; i < frames && !effort.interrupted(); ++i) {
    StageTimes times;
    engine.shade(task.spheres, receivers, &times);
    task.frames.push_back(times);
  }
}

Row rowOf(const Task& task) {
  std::vector<double> seconds;
  for (const StageTimes& frame : task.frames) seconds.push_back(frame.total);
  return {.subject = task.subject,
          .setting = task.setting,
          .blockers = task.spheres.size(),
          .frame = quartilesOf(seconds),
          .stageMedians = stageMedians(task.frames),
          .lightUploadSeconds = median(task.lightUploads)};
}

}  // namespace

std::vector<Setting> settingsOf(std::span<const int> spheres, std::span<const int> terms,
                                std::span<const int> levels) {
  std::vector<Setting> settings;
  for (const int sphereCount : spheres)
    for (const int termCount : terms)
      for (const int level : levels) settings.push_back({sphereCount, termCount, level});
  return settings;
}

std::vector<Row> measureRows(std::span<const OpenSubject> subjects, const Inputs& inputs,
                             std::span<const Setting> settings, const Effort& effort) {
  std::vector<Task> tasks = tasksOf(subjects.size(), inputs, settings);
  const std::size_t rounds = effort.rounds();
  for (std::size_t round = 0; round < rounds; ++round) {
    const std::size_t frames =
        effort.frames * (round + 1) / rounds - effort.frames * round / rounds;
    for (std::size_t i = 0; i < tasks.size() && !effort.interrupted(); ++i) {
      measurePart(tasks[i], *subjects[tasks[i].subject].engine, inputs.receivers, frames, effort);
      if (effort.progress)
        effort.progress("measuring frames",
                        (double(round) + double(i + 1) / double(tasks.size())) / double(rounds));
    }
  }
  std::vector<Row> rows;
  for (const Task& task : tasks)
    if (!task.frames.empty()) rows.push_back(rowOf(task));
  return rows;
}

}  // namespace haarlight::benchmark
