#include "render/scene_transfer.h"

#include "base/error.h"
#include "mesh/builtin_meshes.h"
#include "shading_by_transfer.h"
#include "test_support.h"
#include "transfer/transfer_file.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

std::filesystem::path storedTransfer(const TemporaryFolder& folder, const TriangleMesh& mesh,
                                     const TransferOptions& options) {
  const auto path = folder / "transfer.prt";
  writeTransfer(path, computeTransfer(mesh, options).transfer);
  return path;
}

}  // namespace

TEST_CASE(
    "transfer from a file is that of the mesh, wherever and however large the object stands") {
  const TemporaryFolder folder;
  const auto path = storedTransfer(folder, builtinMesh("builtin:torusknot"),
                                   {.kind = TransferKind::shadowed,
                                    .order = 4,
                                    .raysPerVertex = 1024,
                                    .albedo = {0.3f, 0.6f, 0.1f},
                                    .seed = 5});
  SceneDescription description = ballScene("builtin:sky", "builtin:torusknot");
  description.receiver.reset();
  description.objects[0].transform.rotateDegrees = {20, 130, 70};
  description.shading.order = 4;
  Shading computed(description), stored(description, ShadedPer::vertex, {path});
  CHECK(stored.transfer->rows.order == 4);
  CHECK(stored.transfer->rows.channels == 1);
  CHECK(relativeError(stored.ofObject(), computed.ofObject()) < 0.01);
  description.objects[0].transfer = path;
  description.shading.order.reset();
  Shading field(description);
  CHECK(field.transfer->rows.order == 4);
  for (const int order : {2, 6}) {
    description.shading.order = order;
    const TransferRows rows = Shading(description).transfer->rows;
    REQUIRE(rows.order == order);
    for (const std::size_t k : {0, 1, 2, 3, 16, 35})
      if (k < rows.coefficients())
        CHECK(rows.row(7, 0)[k] == (k < 16 ? field.transfer->rows.row(7, 0)[k] : 0));
  }
  CHECK(field.ofObject() == stored.ofObject());
}

TEST_CASE("light that is reflected on the mesh brings its albedo with it, and the object is told") {
  const TemporaryFolder folder;
  const TriangleMesh ball = builtinMesh("builtin:sphere");
  const auto path = storedTransfer(folder, ball,
                                   {.kind = TransferKind::interreflected,
                                    .order = 3,
                                    .bounces = 1,
                                    .raysPerVertex = 64,
                                    .albedo = {0.5f, 0.25f, 0.75f}});
  SceneDescription description = ballScene("builtin:constant");
  description.receiver.reset();
  Shading sh(description, ShadedPer::vertex, {path});
  CHECK(sh.transfer->rows.channels == 3);
  REQUIRE(sh.transfer->warnings.size() == 1);
  CHECK(sh.transfer->warnings[0].find("albedo of its transfer") != std::string::npos);
  for (const glm::vec3& radiance : sh.ofObject())
    checkColor(radiance, glm::vec3(0.5, 0.25, 0.75), 1e-4);
}

TEST_CASE("one file serves a whole scene") {
  const TemporaryFolder folder;
  const SceneDescription description = ballScene();
  Shading computed(description);
  const auto path = storedTransfer(
      folder, wholeSceneMesh(computed.scene()),
      {.kind = TransferKind::shadowed, .order = 5, .raysPerVertex = 1024, .albedo = glm::vec3(1)});
  Shading stored(description, ShadedPer::vertex, {path});
  CHECK(stored.ofPlane() == computed.ofPlane());
  CHECK(stored.ofObject() == computed.ofObject());
}

TEST_CASE("transfer for another mesh, and for one that is stretched or deformed, is refused") {
  const TemporaryFolder folder;
  const auto path = storedTransfer(folder, builtinMesh("builtin:torusknot"),
                                   {.kind = TransferKind::unshadowed, .order = 2});
  const auto complaint = [&](const SceneDescription& description) -> std::string {
    try {
      Shading(description, ShadedPer::vertex, {path});
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  CHECK(complaint(ballScene()) == "transfer " + path.string() +
                                      " was computed for no mesh of this scene; compute it with "
                                      "haarlight prt");
  SceneDescription knot = ballScene("builtin:sky", "builtin:torusknot");
  CHECK(complaint(knot).empty());
  SceneDescription stretched = knot, twisted = knot, other = ballScene();
  stretched.objects[0].transform.scale = {1, 2, 1};
  CHECK(complaint(stretched).starts_with("object 'ball' is stretched unevenly, so that transfer "));
  twisted.objects[0].deformation.emplace().twist.emplace().keys.resize(1);
  twisted.objects[0].deformation->twist->keys[0].degrees = 30;
  CHECK(complaint(twisted).starts_with("object 'ball' is deformed, so that transfer "));
  other.objects[0].transfer = path;
  CHECK_THROWS_WITH_AS(Shading{other}, doctest::Contains("another mesh than builtin:sphere"),
                       InputError);
}
