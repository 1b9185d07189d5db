#include "shadow/shadow_scenes.h"

#include "shadow/solid_object.h"
#include "shadow/solid_occlusion.h"

namespace haarlight::test {

std::vector<AxisBox> boundsOf(const std::vector<Solid>& solids) {
  std::vector<AxisBox> result;
  for (const Solid& solid : solids) result.push_back(solid.bounds());
  return result;
}

std::vector<Solid> randomScene(RandomNumbers& random) {
  const int count = 2 + int(random() % 39);
  const double reach = uniform(random, 0.5, 6);
  std::vector<Solid> result;
  for (int i = 0; i < count; ++i)
    result.push_back(randomSolid(int(random() % shapeKinds), reach, random));
  return result;
}

ShadowLight lightFor(const std::vector<Solid>& solids, int i, RandomNumbers& random) {
  const Solid& solid = solids[random() % solids.size()];
  switch (i % 6) {
    case 0:
      return PointLight{randomPoint(random, 8)};
    case 1:
      return PointLight{solid.placement().translation()};
    case 2:
      return PointLight{randomSurfaceSample(solid, random).position};
    case 3:
      return PointLight{solid.placement().translation() + glm::dvec3(0, 8, 0)};
    case 4:
      return DirectionalLight{{0, 1, 0}};
    default:
      return DirectionalLight{randomDirection(random)};
  }
}

bool isInShadow(const std::vector<Solid>& solids, std::size_t receiver, const glm::dvec3& point,
                const ShadowLight& light) {
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const bool isItself = i == receiver;
    if (isItself && solids[i].isConvex()) continue;
    if (blocksLight(solids[i], point, light, isItself)) return true;
  }
  return false;
}

SolidShadows::SolidShadows(const std::vector<Solid>& solids, const ShadowLight& light,
                           const OctreeDepths& depths) {
  std::vector<std::unique_ptr<ShadowObject>> objects;
  std::vector<const ShadowObject*> pointers;
  for (const Solid& solid : solids) {
    objects.push_back(makeShadowObject(solid));
    pointers.push_back(objects.back().get());
  }
  const SolidOcclusion rays(solids, light);
  const ShadowPairs pairs = findShadowPairs(BoxTree(boundsOf(solids)), light);
  const auto casters = castersByReceiver(pairs.kept, solids.size());
  for (std::uint32_t i = 0; i < solids.size(); ++i)
    octrees.push_back(buildShadowOctree({pointers, light, rays}, i, casters[i], depths, counts));
}

}  // namespace haarlight::test
