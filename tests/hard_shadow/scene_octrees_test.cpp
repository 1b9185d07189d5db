#include "hard_shadow/scene_octrees.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "shadow_scenes.h"

using namespace haarlight;
using namespace haarlight::test;

namespace {

void checkSame(const SceneOctrees& kept, const SceneOctrees& anew) {
  REQUIRE(kept.octrees().size() == anew.octrees().size());
  for (std::size_t i = 0; i < kept.octrees().size(); ++i) {
    CAPTURE(i);
    CHECK(kept.octrees()[i].leaves() == anew.octrees()[i].leaves());
  }
}

std::vector<bool> only(std::size_t object, std::size_t count) {
  std::vector<bool> moved(count, false);
  moved[object] = true;
  return moved;
}

}  // namespace

TEST_CASE("what is kept of a scene that moves is what building it anew gives") {
  RandomNumbers random(81);
  const ShadowLight light = PointLight{{3, 7, 2}};
  ShadowSetting setting = randomSetting(14, random);
  const std::size_t count = setting.participants.size();
  SceneOctrees kept({6, 0});
  kept.show(setting.participants, light);
  CHECK(kept.work().builtOctrees == count);
  CHECK(kept.work().preparedObjects == count);
  std::size_t built = 0;
  for (int step = 0; step < 8; ++step) {
    const auto object = std::size_t(1 + step);
    if (auto* solid = std::get_if<const Solid*>(&setting.participants[object].shape))
      *solid = &setting.solids.emplace_back(randomSolid(step % shapeKinds, 3, random));
    else
      for (glm::vec3& position :
           setting
               .meshes[std::get<const TriangleMesh*>(setting.participants[object].shape) ==
                               &setting.meshes[1]
                           ? 1
                           : 2]
               .positions)
        position += glm::vec3(0.3f, 0, -0.2f);
    kept.show(setting.participants, light, only(object, count));
    CHECK(kept.work().preparedObjects == 1);
    built += kept.work().builtOctrees;
    SceneOctrees anew({6, 0});
    anew.show(setting.participants, light);
    checkSame(kept, anew);
  }
  CHECK(built < 8 * count / 2);
}

TEST_CASE("nothing is built while nothing moves, and all when the light does") {
  RandomNumbers random(82);
  const ShadowSetting setting = randomSetting(6, random);
  const std::size_t count = setting.participants.size();
  SceneOctrees octrees({5, 0});
  octrees.show(setting.participants, DirectionalLight{{0.2, 1, 0.1}});
  octrees.show(setting.participants, DirectionalLight{{0.2, 1, 0.1}},
               std::vector<bool>(count, false));
  CHECK(octrees.work().builtOctrees == 0);
  CHECK(octrees.work().preparedObjects == 0);
  octrees.show(setting.participants, PointLight{{1, 9, 1}}, std::vector<bool>(count, false));
  CHECK(octrees.work().builtOctrees == count);
  SceneOctrees anew({5, 0});
  anew.show(setting.participants, PointLight{{1, 9, 1}});
  checkSame(octrees, anew);
}

TEST_CASE("what casts no shadow leaves others in light") {
  for (const bool castsShadow : {false, true}) {
    ShadowSetting setting;
    setting.add(floorAt(0, 2));
    setting.add(Solid(SphereShape{0.5}, Placement({0, 2, 0})), castsShadow);
    SceneOctrees octrees({4, 0});
    octrees.show(setting.participants, DirectionalLight{{0, 1, 0}});
    CHECK(octrees.octrees()[0].isInShadow({0.1, 0, 0.1}) == castsShadow);
    CHECK(octrees.octrees()[0].isInShadow({1, 0, 0.1}) == false);
  }
}

TEST_CASE("an empty scene, and objects that come and go") {
  SceneOctrees octrees({4, 0});
  octrees.show({}, PointLight{{0, 1, 0}});
  CHECK(octrees.octrees().empty());
  CHECK(octrees.memory() == 0);
  ShadowSetting setting;
  setting.add(floorAt(0, 1));
  octrees.show(setting.participants, PointLight{{0, 1, 0}}, {false});
  CHECK(octrees.work().builtOctrees == 1);
  CHECK(octrees.memory() > 0);
  CHECK(octrees.cellEdge() == doctest::Approx(2.0 / 16).epsilon(1e-3));
  octrees.show({}, PointLight{{0, 1, 0}});
  CHECK(octrees.octrees().empty());
  CHECK_THROWS_AS(octrees.show({}, DirectionalLight{{0, 0, 0}}), InputError);
}
