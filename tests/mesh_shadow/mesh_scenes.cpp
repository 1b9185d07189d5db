#include "mesh_shadow/mesh_scenes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "mesh/builtin_meshes.h"
#include "mesh_shadow/embree_occlusion.h"
#include "mesh_shadow/mesh_object.h"
#include "mesh_shadow/triangle_box.h"
#include "shadow/solid_object.h"
#include "shadow/solid_occlusion.h"

namespace haarlight::test {

namespace {

TriangleMesh triangleSoup(RandomNumbers& random) {
  TriangleMesh mesh;
  for (glm::uint i = 0; i < 40; ++i) {
    const glm::dvec3 middle = randomPoint(random, 0.7);
    for (int corner = 0; corner < 3; ++corner)
      mesh.positions.push_back(glm::vec3(middle + randomPoint(random, 0.3)));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

TriangleMesh openBowl() {
  TriangleMesh mesh = icosphere(2);
  std::erase_if(mesh.triangles, [&](const glm::uvec3& t) { return mesh.positions[t.x].y > 0.3f; });
  return mesh;
}

TriangleMesh meshOfKind(int kind, RandomNumbers& random) {
  switch (kind) {
    case 0:
      return icosphere(2);
    case 1:
      return torusKnot({2, 3, 48, 8, 0.5});
    case 2:
      return openBowl();
    case 3:
      return groundGrid(1, 4);
    default:
      return triangleSoup(random);
  }
}

TriangleCorners cornersOf(const TriangleMesh& mesh, std::size_t triangle) {
  const glm::uvec3 t = mesh.triangles[triangle];
  return {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
}

glm::dvec3 normalOf(const TriangleMesh& mesh, std::size_t triangle) {
  const TriangleCorners t = cornersOf(mesh, triangle);
  return glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
}

ObjectSample sampleOf(const TriangleMesh& mesh, RandomNumbers& random) {
  const std::size_t triangle = random() % mesh.triangles.size();
  const TriangleCorners t = cornersOf(mesh, triangle);
  double v = uniform(random, 0, 1), w = uniform(random, 0, 1);
  if (v + w > 1) v = 1 - v, w = 1 - w;
  return {t[0] + v * (t[1] - t[0]) + w * (t[2] - t[0]), normalOf(mesh, triangle), triangle};
}

bool meetsMesh(const Ray& ray, const TriangleMesh& mesh, std::size_t except) {
  // A segment long enough to leave every scene stands for a ray without an end.
  const glm::dvec3 way = (std::isfinite(ray.far) ? 1.0 : 1e3) * ray.direction;
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
    if (triangle != except && meets(ray.origin, way, mesh, triangle)) return true;
  return false;
}

std::optional<ObjectSample> firstHit(const SceneObject& object, const glm::dvec3& from,
                                     const glm::dvec3& way) {
  if (const auto* solid = std::get_if<Solid>(&object)) {
    const auto hit = solid->intersect({from, way, 0, 1});
    if (!hit) return std::nullopt;
    return ObjectSample{from + hit->t * way, hit->normal};
  }
  const auto& mesh = std::get<TriangleMesh>(object);
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
    if (const auto t = meets(from, way, mesh, triangle))
      return ObjectSample{from + *t * way, normalOf(mesh, triangle), triangle};
  return std::nullopt;
}

}  // namespace

TriangleMesh randomMesh(int kind, double reach, RandomNumbers& random) {
  TriangleMesh mesh = meshOfKind(kind, random);
  const glm::dmat3 rotation = randomRotation(random);
  const glm::dvec3 translation = randomPoint(random, reach);
  for (glm::vec3& p : mesh.positions) p = glm::vec3(rotation * glm::dvec3(p) + translation);
  return mesh;
}

void add(TriangleMesh& mesh, const TriangleMesh& other, float scale, const glm::vec3& place,
         bool turned) {
  const auto offset = std::uint32_t(mesh.positions.size());
  for (const glm::vec3& p : other.positions) mesh.positions.push_back(scale * p + place);
  for (glm::uvec3 t : other.triangles) {
    if (turned) std::swap(t.x, t.y);
    mesh.triangles.push_back(t + offset);
  }
}

TriangleMesh randomClosedMesh(RandomNumbers& random) {
  TriangleMesh mesh;
  const int count = 1 + int(random() % 3);
  for (int i = 0; i < count; ++i) {
    TriangleMesh part = random() % 3 ? icosphere(2) : torusKnot({2, 3, 48, 8, 0.5});
    if (random() % 3 == 0)
      for (glm::vec3& p : part.positions) p += glm::vec3(randomPoint(random, 0.3));
    const auto scale = float(uniform(random, 0.2, 1));
    add(mesh, part, scale, glm::vec3(randomPoint(random, 0.8)), random() % 3 == 0);
  }
  return mesh;
}

ObjectSample randomSample(const SceneObject& object, RandomNumbers& random) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&object)) return sampleOf(*mesh, random);
  const SurfaceSample sample = randomSurfaceSample(std::get<Solid>(object), random);
  return {sample.position, sample.normal};
}

std::optional<ObjectSample> sampleNear(const SceneObject& object, const glm::dvec3& place,
                                       double reach, RandomNumbers& random) {
  const glm::dvec3 from = place + randomPoint(random, reach);
  const auto hit = firstHit(object, from, 2 * reach * randomDirection(random));
  if (!hit) return std::nullopt;
  const glm::dvec3 away = glm::abs(hit->position - place);
  if (std::max({away.x, away.y, away.z}) > reach) return std::nullopt;
  return hit;
}

std::optional<double> meets(const glm::dvec3& from, const glm::dvec3& way, const TriangleMesh& mesh,
                            std::size_t triangle) {
  const TriangleCorners t = cornersOf(mesh, triangle);
  const auto volume = [&](const glm::dvec3& a, const glm::dvec3& b) {
    return glm::dot(glm::cross(a - from, b - from), way);
  };
  const double u = volume(t[0], t[1]), v = volume(t[1], t[2]), w = volume(t[2], t[0]);
  if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) return std::nullopt;
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double at = glm::dot(normal, t[0] - from) / glm::dot(normal, way);
  if (!(at >= 0 && at <= 1)) return std::nullopt;
  return at;
}

bool isInShadow(const std::vector<SceneObject>& objects, std::size_t receiver,
                const ObjectSample& sample, const ShadowLight& light) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const bool isItself = i == receiver;
    if (const auto* solid = std::get_if<Solid>(&objects[i])) {
      if (isItself && solid->isConvex()) continue;
      if (blocksLight(*solid, sample.position, light, isItself)) return true;
    } else if (meetsMesh(segmentToLight(sample.position, light), std::get<TriangleMesh>(objects[i]),
                         isItself ? sample.triangle : std::size_t(-1))) {
      return true;
    }
  }
  return false;
}

SceneShadows::SceneShadows(const std::vector<SceneObject>& objects, const ShadowLight& light,
                           const OctreeDepths& depths) {
  std::vector<std::unique_ptr<ShadowObject>> owned;
  std::vector<const ShadowObject*> pointers;
  std::vector<Occluder> occluders;
  std::vector<AxisBox> boxes;
  for (const SceneObject& object : objects) {
    if (const auto* solid = std::get_if<Solid>(&object)) {
      owned.push_back(makeShadowObject(*solid));
      occluders.emplace_back(solid);
    } else {
      owned.push_back(makeShadowObject(std::get<TriangleMesh>(object), light));
      occluders.emplace_back(&std::get<TriangleMesh>(object));
    }
    pointers.push_back(owned.back().get());
    boxes.push_back(owned.back()->bounds());
  }
  const EmbreeOcclusion rays(occluders, light);
  const auto casters =
      castersByReceiver(findShadowPairs(BoxTree(boxes), light).kept, objects.size());
  for (std::uint32_t i = 0; i < objects.size(); ++i)
    octrees.push_back(buildShadowOctree({pointers, light, rays}, i, casters[i], depths, counts));
}

}  // namespace haarlight::test
