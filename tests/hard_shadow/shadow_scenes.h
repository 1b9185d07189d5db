#pragma once

/// Scenes for the tests of hard shadows.

#include <deque>

#include "hard_shadow/surface_view.h"
#include "mesh/triangle_mesh.h"
#include "solids/solid_samples.h"

namespace haarlight::test {

/// Owns the shapes of participants.
struct ShadowSetting {
  std::deque<Solid> solids;
  std::deque<TriangleMesh> meshes;
  std::vector<ShadowParticipant> participants;

  void add(const Solid& solid, bool castsShadow = true);
  void add(const TriangleMesh& mesh, bool castsShadow = true);
};

/// The square |x|, |z| ≤ half at a height, facing up, of two triangles.
TriangleMesh floorAt(double height, float half);

/// Solids and meshes at random on a floor.
ShadowSetting randomSetting(int objects, RandomNumbers& random);

/// Looking down the y axis from high above, so that the view's width is about `width`.
CameraDescription fromAbove(double width);

}  // namespace haarlight::test
