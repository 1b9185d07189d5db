#include "test_scenes.h"

#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>

#include "base/file.h"

namespace haarlight::test {

namespace {

class SceneMaker {
 public:
  explicit SceneMaker(unsigned seed) : random_(seed) {}

  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  int below(int count) { return int(random_() % unsigned(count)); }
  glm::vec3 point(float extent) {
    return {uniform(-extent, extent), uniform(-extent, extent), uniform(-extent, extent)};
  }
  glm::vec3 direction() {
    glm::vec3 d = point(1);
    while (glm::length(d) < 0.1f || glm::length(d) > 1) d = point(1);
    return glm::normalize(d);
  }

  Sphere sphere(const std::vector<glm::vec4>& positions) {
    const glm::vec3 sample = positions[below(int(positions.size()))];
    const float distance = uniform(0.01f, 5);
    switch (below(9)) {
      case 0:
        return {sample + distance * direction(), distance * uniform(0.9999f, 1.0001f)};
      case 1:
        return {point(100), uniform(50, 200)};
      case 2:
        return {point(3), 1e-6f};
      case 3:
        return {sample, uniform(0.1f, 2)};
      case 4:
        return {point(1e6f), uniform(1, 1e5f)};
      case 5:
        return {sample + glm::vec3(0, distance, 0), distance / 2};
      case 6:
        return {sample + glm::vec3(distance, -distance, distance), distance / 3};
      default:
        return {point(4), uniform(0.05f, 1.5f)};
    }
  }

 private:
  std::mt19937 random_;
};

void addBoundSphere(SceneMaker& make, TestBinding& bound) {
  const int size = 1 + make.below(100);
  std::vector<std::uint32_t> list;
  std::vector<glm::vec4> weights;
  for (int i = 0; i < size; ++i) {
    list.push_back(std::uint32_t(make.below(int(bound.vertices.size()))));
    const float forCenter = make.uniform(-1, 3) / float(size);
    weights.emplace_back(forCenter, make.uniform(0, 2) / float(size), make.below(2), 0);
  }
  const int kind = make.below(3);
  const float mean = make.uniform(0.5f, 2), reach = make.uniform(0.5f, 2);
  bound.binding.add(list, weights, {kind == 0 ? 0 : mean, kind == 1 ? 0 : reach});
}

}  // namespace

TestBinding randomBinding(unsigned seed, int sphereCount) {
  SceneMaker make(seed);
  TestBinding bound;
  const glm::vec3 offset = make.point(seed % 2 ? 1000.0f : 1.0f);
  for (int i = 0; i < 200; ++i) bound.vertices.emplace_back(offset + make.point(1), 0);
  for (int i = 0; i < sphereCount; ++i) addBoundSphere(make, bound);
  return bound;
}

TestScene randomScene(unsigned seed, int receiverCount) {
  SceneMaker make(seed);
  TestScene scene;
  for (int i = 0; i < receiverCount; ++i)
    scene.receivers.add(make.point(2), i % 2 ? make.direction() : glm::vec3(0, 1, 0));
  const int count = 1 + make.below(seed % 10 == 0 ? 256 : 80);
  for (int i = 0; i < count; ++i)
    scene.spheres.push_back(i > 0 && make.below(10) == 0 ? scene.spheres.back()
                                                         : make.sphere(scene.receivers.positions));
  for (int texel = 0; texel < texelCount; ++texel) {
    const glm::vec3 sky(make.uniform(0, 0.2f), make.uniform(0, 0.3f), make.uniform(0, 0.4f));
    scene.light[texel] = make.below(300) ? sky : sky * make.uniform(10, 10000);
  }
  return scene;
}

std::shared_ptr<const SphereTable> sharedSphereTable() {
  static const auto table = std::make_shared<const SphereTable>(SphereTable::load(cacheFolder()));
  return table;
}

std::shared_ptr<const SphereTable> tableFor(VisibilityKind visibility) {
  return visibility == VisibilityKind::table ? sharedSphereTable() : nullptr;
}

std::unique_ptr<Engine> referenceEngine(VisibilityKind visibility) {
  return makeReferenceEngine(tableFor(visibility));
}

bool haveDevice(const std::string& engine) {
  const bool found = std::ranges::any_of(listDevices(), [&](const DeviceDescription& d) {
    return d.engine == engine && d.problem.empty();
  });
  if (!found) std::printf("SKIPPED: no device for the engine %s\n", engine.c_str());
  return found;
}

std::unique_ptr<Engine> testEngine(const std::string& name, VisibilityKind visibility,
                                   const KernelShape& shape) {
  if (!haveDevice(name)) return nullptr;
  EngineOptions options;
  options.engine = name;
  options.lanesPerItem = shape.lanesPerItem;
  options.samplesPerGroup = shape.samplesPerGroup;
  return makeEngine(options, tableFor(visibility));
}

ShadingTables tablesFor(const TestScene& scene, int terms, int levels) {
  ShadingSettings settings;
  settings.terms = terms;
  settings.levels = levels;
  return buildShadingTables(scene.light, settings, countLobes(scene.receivers.lobes));
}

}  // namespace haarlight::test
