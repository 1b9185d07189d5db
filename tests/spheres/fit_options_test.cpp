#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.h"
#include "spheres/fit_shapes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

constexpr auto cover = FitObjective::cover, shadow = FitObjective::shadow;

double errorOf(const SphereSet& set) {
  return set.objective == cover ? *set.measures.outsideVolumeRatio : set.measures.silhouette->mean;
}

SphereFit fitWithin(FitObjective objective, const TriangleMesh& mesh, double maximumError,
                    std::size_t count) {
  SphereFitOptions options;
  options.objective = objective;
  options.maximumError = maximumError;
  return fitSpheres(mesh, count, options);
}

/// A set to work with, though it was not finished.
void checkUsable(const SphereFit& fit, const TriangleMesh& mesh, std::size_t count) {
  CHECK(fit.set.spheres.size() >= 1);
  CHECK(fit.set.spheres.size() <= count);
  if (fit.set.objective == cover) CHECK(uncovered(mesh, fit.set.spheres) == 0);
  // Without any sphere, all of the mesh is missed: an error of 1.
  if (fit.set.objective == shadow) CHECK(fit.set.measures.silhouette->mean < 1);
}

std::string refusal(const TriangleMesh& mesh, std::size_t count) {
  try {
    fitSpheres(mesh, count);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("progress goes up to the end, and the history gets better") {
  const TriangleMesh mesh = blob(1, 1);
  for (const FitObjective objective : {cover, shadow}) {
    std::vector<double> finished;
    SphereFitOptions options;
    options.objective = objective;
    options.progress = [&](const FitProgress& progress) { finished.push_back(progress.finished); };
    const SphereFit fit = fitSpheres(mesh, 2, options);
    REQUIRE(finished.size() > 3);
    CHECK(std::ranges::is_sorted(finished));
    CHECK(finished.front() < 0.2);
    CHECK(finished.back() > 0.9);
    CHECK(finished.back() <= 1);

    CHECK(fit.stop == FitStop::converged);
    CHECK(fit.history.size() == finished.size());
    CHECK(std::ranges::is_sorted(fit.history, {}, &FitStep::seconds));
    CHECK(fit.seconds >= fit.history.back().seconds);
    CHECK(fit.history.back().spheres == fit.set.spheres.size());
    for (const FitStep& step : fit.history) {
      CHECK(step.spheres >= 1);
      CHECK(step.spheres <= 2);
      CHECK_FALSE(step.phase.empty());
    }
    const auto least = std::ranges::min_element(fit.history, {}, &FitStep::error);
    // A cover has to hold more points in the end than while it is sought.
    CHECK(fit.history.back().error <= least->error * (objective == cover ? 1.1 : 1.0));
  }
}

TEST_CASE("about as few spheres are used as reach an error") {
  const struct {
    FitObjective objective;
    TriangleMesh mesh;
    double maximumError;
    std::size_t most;
  } cases[] = {{cover, smallKnot(), 5, 100}, {shadow, box({0, 0, 0}, {1, 2, 3}), 0.3, 2}};
  for (const auto& one : cases) {
    const SphereFit fit = fitWithin(one.objective, one.mesh, one.maximumError, one.most);
    CHECK(fit.stop == FitStop::errorReached);
    CHECK(errorOf(fit.set) <= one.maximumError);
    CHECK(fit.set.spheres.size() > 1);
    const std::size_t fewer = fit.set.spheres.size() * 3 / 4;
    CHECK(errorOf(fitFor(one.objective, one.mesh, fewer).set) > one.maximumError);
  }
}

TEST_CASE("an error that one sphere reaches takes one") {
  const SphereFit fit = fitWithin(cover, sphereAt({0, 0, 0}, 1, 3), 0.05, 3);
  CHECK(fit.stop == FitStop::errorReached);
  CHECK(fit.set.spheres.size() == 1);
}

TEST_CASE("an error that is out of reach takes the most spheres allowed") {
  for (const FitObjective objective : {cover, shadow}) {
    const std::size_t most = objective == cover ? 3 : 1;
    const SphereFit fit = fitWithin(objective, blob(1, 2), 0.001, most);
    CHECK(fit.stop == FitStop::converged);
    CHECK(fit.set.spheres.size() == most);
    CHECK(errorOf(fit.set) > 0.001);
  }
}

TEST_CASE("a fit without time still gives a set") {
  for (const FitObjective objective : {cover, shadow})
    for (const bool withError : {false, true}) {
      SphereFitOptions options;
      options.objective = objective;
      options.timeLimit = 0;
      if (withError) options.maximumError = 0.01;
      const SphereFit fit = fitSpheres(smallKnot(), 12, options);
      CHECK(fit.stop == FitStop::timeLimit);
      checkUsable(fit, smallKnot(), 12);
    }
}

TEST_CASE("a fit that is cancelled gives the best set so far") {
  for (const FitObjective objective : {cover, shadow}) {
    double last = 1e9;
    for (const int calls : {0, 3, 20}) {
      int asked = 0;
      SphereFitOptions options;
      options.objective = objective;
      options.cancelled = [&] { return ++asked > calls; };
      const SphereFit fit = fitSpheres(smallKnot(), 12, options);
      CHECK(fit.stop == FitStop::cancelled);
      CHECK(asked == calls + 1);
      checkUsable(fit, smallKnot(), 12);
      CHECK(errorOf(fit.set) <= last * 1.02);
      last = errorOf(fit.set);
    }
  }
}

TEST_CASE("requests that make no sense are refused with words") {
  const TriangleMesh solid = sphereAt({0, 0, 0}, 1, 1);
  CHECK(has(refusal(solid, 0), "from 1 to 4096, not 0"));
  CHECK(has(refusal(solid, 4097), "from 1 to 4096, not 4097"));
  CHECK(has(refusal({}, 4), "without triangles"));
  CHECK(has(refusal({{{1, 2, 3}}, {}, {}}, 4), "without triangles"));
  CHECK(has(refusal({{{1, 2, 3}}, {}, {{0, 0, 0}}}, 4), "without triangles"));

  const TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {{0, 1, 2}}};
  const glm::mat4 tilt = glm::rotate(glm::mat4(1), 1.0f, glm::vec3(1, 2, 3));
  for (const TriangleMesh& flat :
       {triangle, groundGrid(1, 8), transformed(groundGrid(100, 8), tilt),
        scaled(transformed(groundGrid(1, 8), tilt), 1e-6f, {1, 1, 1})})
    CHECK(has(refusal(flat, 4), "plane"));
}
