#include "spheres/fit_monitor.h"

#include <doctest/doctest.h>

#include <vector>

using namespace haarlight;

TEST_CASE("a fit's monitor tells the progress of the whole and keeps the steps") {
  std::vector<FitProgress> told;
  SphereFitOptions options;
  options.progress = [&](const FitProgress& progress) { told.push_back(progress); };
  FitMonitor monitor(options);
  monitor.beginPhase("start", 0, 0.25);
  monitor.report(0, 1, 0.9);
  monitor.report(0.5, 2, 0.5);
  monitor.beginPhase("refine", 0.25, 1);
  monitor.report(1.0 / 3, 3, 0.4);
  monitor.report(1, 4, 0.3);

  REQUIRE(told.size() == 4);
  const double finished[] = {0, 0.125, 0.5, 1}, errors[] = {0.9, 0.5, 0.4, 0.3};
  const std::vector<FitStep> history = monitor.takeHistory();
  REQUIRE(history.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(told[i].finished == doctest::Approx(finished[i]));
    CHECK(told[i].error == errors[i]);
    CHECK(history[i].phase == (i < 2 ? "start" : "refine"));
    CHECK(history[i].spheres == i + 1);
    CHECK(history[i].error == errors[i]);
    CHECK(history[i].seconds >= (i == 0 ? 0 : history[i - 1].seconds));
  }
  CHECK(monitor.seconds() >= history.back().seconds);
  CHECK(monitor.takeHistory().empty());
}

TEST_CASE("a fit's monitor without callbacks or limits never stops") {
  const SphereFitOptions options;
  FitMonitor monitor(options);
  monitor.report(1, 1, 0);
  CHECK_FALSE(monitor.mustStop());
  CHECK(monitor.stop() == FitStop::converged);
}

TEST_CASE("a cancelled fit stays cancelled") {
  int asked = 0;
  SphereFitOptions options;
  options.cancelled = [&] { return ++asked == 2; };
  FitMonitor monitor(options);
  CHECK_FALSE(monitor.mustStop());
  for (int i = 0; i < 3; ++i) {
    CHECK(monitor.mustStop());
    CHECK(monitor.stop() == FitStop::cancelled);
  }
  CHECK(asked == 2);
}

TEST_CASE("a fit stops when its time is over") {
  SphereFitOptions options;
  options.timeLimit = 3600;
  CHECK_FALSE(FitMonitor(options).mustStop());
  options.timeLimit = 0.002;
  FitMonitor monitor(options);
  while (!monitor.mustStop() && monitor.seconds() < 60) continue;
  CHECK(monitor.seconds() >= 0.002);
  CHECK(monitor.stop() == FitStop::timeLimit);
  options.timeLimit = 3600;
  CHECK(monitor.mustStop());
}
