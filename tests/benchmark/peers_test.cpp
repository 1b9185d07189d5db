#include "benchmark/peers.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "render/radiance_method.h"

using namespace haarlight;
using namespace haarlight::benchmark;

namespace {

/// A sphere above 8 × 8 samples.
SceneDescription ball() {
  SceneDescription scene;
  ObjectDescription object;
  object.name = "ball";
  object.mesh = "builtin:sphere";
  object.transform.translate = {0, 1.5, 0};
  scene.objects.push_back(object);
  scene.receiver.emplace().samples = {8, 8};
  scene.light.source = "builtin:constant";
  return scene;
}

Subject referenceSubject() {
  Subject subject;
  subject.device.engine = "reference";
  subject.path = FramePath::staged;
  return subject;
}

}  // namespace

TEST_CASE("the error is the root mean square over the mean of the reference") {
  const std::vector<glm::vec3> reference{{1, 2, 3}, {3, 2, 1}}, same = reference;
  const std::vector<glm::vec3> other{{1, 2, 4}, {3, 4, 1}};  // squares of differences: 1 + 4
  CHECK(relativeError(same, reference) == 0);
  CHECK(relativeError(other, reference) == doctest::Approx(std::sqrt(5.0 / 6) / 2));
}

TEST_CASE("rays to the spheres block the texels that their caps cover") {
  const std::vector<int> counts{1};
  const Inputs inputs = loadInputs(ball(), counts, {});
  const Scene& scene = inputs.scenes[0].scene;
  const auto rays = makePixelRayMethod(scene)->radiance(inputs.samples);
  const auto caps = makePixelMethod(scene, nullptr)->radiance(inputs.samples);
  // A texel whose centre lies within rounding of a cap's edge may count for one and not the other:
  // at most 4/1024 steradians (in the middle of a face) of constant light, over π.
  const float texel = inputs.light()[0].g * 4 / 1024 / 3.14f;
  bool isShadowed = false;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    CHECK(std::abs(rays[i].g - caps[i].g) < 3 * texel);
    isShadowed |= caps[i].g < 0.9f * inputs.light()[0].g;
  }
  CHECK(isShadowed);
}

TEST_CASE("peers agree with one another as far as their methods do") {
  const std::vector<int> counts{1}, terms{0, maximumTerms}, levels{2};
  const Inputs inputs = loadInputs(ball(), counts, {});
  const Effort effort{.frames = 2, .progress = {}};
  const std::vector<OpenSubject> subjects{openSubject(referenceSubject(), nullptr)};
  const auto rows = measureRows(subjects, inputs, settingsOf(counts, terms, levels), effort);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].frame.count == 2);
  const auto measured = measurePeers(subjects, rows, inputs, inputs.scenes[0], subjects[0], effort);
  REQUIRE(measured);
  const PeerComparison& comparison = *measured;
  const auto errorsOf = [&](const std::string& name) {
    const auto found = std::ranges::find(comparison.peers, name, &Peer::name);
    REQUIRE(found != comparison.peers.end());
    CHECK(found->frame.count == 2);
    return found->errors;
  };
  CHECK(errorsOf(embreePeer).againstMesh == 0);
  CHECK(errorsOf("pixel basis, spheres").againstSpheres == 0);
  // The plane's normal is a tabulated one, so that sums of all terms differ by rounding alone.
  CHECK(errorsOf("static light, all texels").againstSpheres < 1e-5);
  CHECK(errorsOf("double product; 6,144 terms").againstSpheres < 1e-5);
  REQUIRE(comparison.rowErrors.size() == 2);
  CHECK(comparison.rowErrors[1].errors.againstSpheres < 1e-4);
  CHECK(comparison.rowErrors[0].errors.againstSpheres >
        comparison.rowErrors[1].errors.againstSpheres);
}

TEST_CASE("an interruption leaves out rows without a frame") {
  const std::vector<int> counts{1}, terms{0, 50}, levels{1, 2};
  const Inputs inputs = loadInputs(ball(), counts, {});
  const std::vector<OpenSubject> subjects{openSubject(referenceSubject(), nullptr)};
  int asked = 0;
  Effort effort{.frames = 1, .progress = {}};
  effort.interrupted = [&] { return ++asked > 3; };  // asked before a row and before each frame
  const auto rows = measureRows(subjects, inputs, settingsOf(counts, terms, levels), effort);
  CHECK(rows.size() == 1);
  CHECK_FALSE(measurePeers(subjects, rows, inputs, inputs.scenes[0], subjects[0], effort));
}
