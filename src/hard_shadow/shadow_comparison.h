#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hard_shadow/shadow_difference.h"
#include "hard_shadow/shadow_picture.h"

namespace haarlight {

/// One method's shadows of a view.
struct ShadowRun {
  std::string label;
  std::unique_ptr<HardShadowMethod> method;
  ShadowPicture picture;
  Image errors;                 ///< paintDifference's colours on black
  ShadowDifference difference;  ///< from the exact run's, if there is one; of all lights
};

/// What is drawn.
struct ShadowView {
  std::vector<glm::dvec3> albedos;  ///< of the participants
  std::vector<PunctualLight> lights;
  AxisBox bounds;  ///< of the scene
  int width = 0, height = 0, raysPerSide = 1;
  bool drawCells = true;  ///< of runs that have octrees
};

/// Draws one view by several methods, rows of at most about a million camera rays at a time.
class ShadowComparison {
 public:
  /// The viewer must be for the same size.
  ShadowComparison(const SurfaceViewer& viewer, ShadowView view);

  void add(std::string label, std::unique_ptr<HardShadowMethod> method);

  /// `progress` is told which part is done, 0 … 1.
  void run(const std::function<void(double)>& progress = {});

  std::span<const ShadowRun> runs() const { return runs_; }
  bool hasReference() const { return reference() != nullptr; }
  /// Seconds for finding what the camera sees.
  double viewSeconds() const { return viewSeconds_; }

 private:
  using Answers = std::vector<std::vector<std::uint8_t>>;  ///< by light

  const ShadowRun* reference() const;
  void runRows(int first, int count);
  Answers answersOf(ShadowRun& run, const SurfaceView& rows) const;

  const SurfaceViewer& viewer_;
  ShadowView view_;
  std::vector<ShadowRun> runs_;
  double viewSeconds_ = 0;
};

}  // namespace haarlight
