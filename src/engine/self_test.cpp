#include "engine/self_test.h"

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "base/file.h"
#include "cube/cube_map.h"

namespace haarlight {

namespace {

/// Checksums of the right answers.
constexpr std::uint64_t movedSpheresChecksum = 0xc393eaf25a040374;
constexpr std::uint64_t exactBitCubesChecksum = 0x7951fe34988acc2e;
constexpr std::uint64_t tableBitCubesChecksum = 0x6744c22f27f66085;
constexpr std::uint64_t exactHaarChecksum = 0xa0fe78214f9723e3;
constexpr std::uint64_t tableHaarChecksum = 0x2b3962363da100b2;

/// Numbers that are the same with every library.
class Sequence {
 public:
  float uniform(float low, float high) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (float(state_ >> 40) * 0x1p-24f);
  }
  glm::vec3 point(float extent) {
    const float x = uniform(-extent, extent), y = uniform(-extent, extent);
    return {x, y, uniform(-extent, extent)};
  }

 private:
  std::uint64_t state_ = 1;
};

/// A sphere whose rim passes through a texel's centre, seen from the origin, as nearly as float32
/// numbers can say. `face` is the texel's.
Sphere grazingSphere(Sequence& random, int face) {
  const int texel = face * texelsPerFace + int(random.uniform(0, texelsPerFace));
  const glm::dvec3 direction = texelDirection(texel);
  const glm::vec3 center = glm::vec3(2.0 * direction) + random.point(0.2f);
  const double along = glm::dot(glm::dvec3(center), direction);
  const double distanceSquared = glm::dot(glm::dvec3(center), glm::dvec3(center));
  return {center, float(std::sqrt(distanceSquared - along * along))};
}

/// A sphere at the lower bound of a radius bin, as nearly as float32 numbers can say.
Sphere sphereOnBinBound(Sequence& random, int bin) {
  const glm::vec3 center = random.point(3);
  const double distanceSquared = glm::dot(glm::dvec3(center), glm::dvec3(center));
  return {center, float(std::sqrt(radiusBinBound(bin) * distanceSquared))};
}

struct Question {
  SphereBinding binding;
  std::vector<glm::vec4> vertices;
  std::vector<Sphere> spheres;
  Receivers receivers;
  RadianceCube light;
};

/// Lists of 3, 16, 29 … 302 entries; radii from reaches, means and both in turn. Every other list
/// begins with the vertex at the origin: there no larger number hides how sums are rounded.
void bindSpheres(Sequence& random, Question& question) {
  constexpr int sphereCount = 24, vertexCount = 100;
  question.vertices.emplace_back(0);
  while (question.vertices.size() < vertexCount) question.vertices.emplace_back(random.point(2), 0);
  for (int sphere = 0; sphere < sphereCount; ++sphere) {
    const int size = 3 + 13 * sphere;
    std::vector<std::uint32_t> list;
    std::vector<glm::vec4> weights;
    for (int i = 0; i < size; ++i) {
      list.push_back(std::uint32_t(((7 + sphere) * i + sphere % 2) % vertexCount));
      const float forCenter = random.uniform(-1, 3) / float(size);
      weights.emplace_back(forCenter, random.uniform(0, 2) / float(size), 1, 0);
    }
    const float mean = random.uniform(0.5f, 1), reach = random.uniform(0.5f, 1);
    question.binding.add(list, weights, {sphere % 3 == 0 ? 0 : mean, sphere % 3 == 1 ? 0 : reach});
  }
}

Question makeQuestion() {
  Question question;
  Sequence random;
  const glm::vec3 normals[] = {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}, {0.48f, 0.64f, 0.6f}};
  for (const glm::vec3& normal : normals) question.receivers.add({0, 0, 0}, normal);
  for (int i = 0; i < 36; ++i) question.spheres.push_back(grazingSphere(random, i % faceCount));
  for (int i = 0; i < 24; ++i) question.spheres.push_back(sphereOnBinBound(random, 1 + i % 8));
  for (int texel = 0; texel < texelCount; ++texel)
    question.light[texel] = random.point(0.5f) + glm::vec3(texel % 97 ? 0.5f : 50.0f);
  bindSpheres(random, question);
  return question;
}

template <typename Element>
std::uint64_t checksumOf(const std::vector<Element>& elements) {
  const auto bytes = std::span(elements);
  return checksum({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size_bytes()});
}

}  // namespace

std::string selfTestFailure(Engine& engine, std::shared_ptr<const SphereTable> table) {
  static const Question question = makeQuestion();
  engine.setSphereBinding(question.binding);
  if (checksumOf(engine.moveSpheres(question.vertices)) != movedSpheresChecksum)
    return "its moved spheres are not the right ones";
  const auto cubes = engine.mergeBitCubes(question.spheres, question.receivers);
  if (checksumOf(cubes) != (table ? tableBitCubesChecksum : exactBitCubesChecksum))
    return "its bit cubes are not the right ones";
  const auto occlusion = engine.transformOcclusion(cubes);
  if (checksumOf(occlusion) != (table ? tableHaarChecksum : exactHaarChecksum))
    return "its Haar coefficients are not the right ones";

  const ShadingTables tables =
      buildShadingTables(question.light, {200, 2}, countLobes(question.receivers.lobes));
  const auto reference = makeReferenceEngine(table);
  engine.setShading(tables);
  reference->setShading(tables);
  const auto expected = reference->shade(question.spheres, question.receivers);
  const auto isExpected = [&](const std::vector<glm::vec4>& radiance) {
    return std::memcmp(radiance.data(), expected.data(), expected.size() * sizeof expected[0]) == 0;
  };
  if (!isExpected(engine.tripleProduct(occlusion, question.receivers.lobes)))
    return "its triple product is not the scalar engine's";
  if (!isExpected(engine.shade(question.spheres, question.receivers)))
    return "its radiance is not the scalar engine's";
  return {};
}

}  // namespace haarlight
