#include "mesh/ray_scene.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mesh/embree_solid.h"
#include "mesh/embree_version.h"

namespace haarlight {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Calls `release` on an Embree handle at its end.
template <typename Handle, void (*release)(Handle)>
class Owned {
 public:
  explicit Owned(Handle handle) : handle_(handle) {}
  ~Owned() {
    if (handle_) release(handle_);
  }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  operator Handle() const { return handle_; }

 private:
  Handle handle_;
};
using Device = Owned<RTCDevice, rtcReleaseDevice>;
using Scene = Owned<RTCScene, rtcReleaseScene>;
using Geometry = Owned<RTCGeometry, rtcReleaseGeometry>;

void rememberError(void* message, RTCError, const char* text) {
  auto& first = *static_cast<std::string*>(message);
  if (first.empty()) first = text && *text ? text : "unknown error";
}

RTCRay newRay(const glm::vec3& origin, const glm::vec3& direction, float near) {
  RTCRay ray{};
  ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
  ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
  ray.tnear = near;
  ray.tfar = infinity;
  ray.mask = ~0u;
  return ray;
}

/// Ray i of sixteen.
void setRay(RTCRay16& rays, std::size_t i, const glm::vec3& origin, const glm::vec3& direction,
            float near) {
  rays.org_x[i] = origin.x, rays.org_y[i] = origin.y, rays.org_z[i] = origin.z;
  rays.dir_x[i] = direction.x, rays.dir_y[i] = direction.y, rays.dir_z[i] = direction.z;
  rays.tnear[i] = near;
  rays.tfar[i] = infinity;
  rays.mask[i] = ~0u;
}

/// Embree's −1 or 0 for each bit.
struct Active {
  explicit Active(std::uint16_t bits) {
    for (std::size_t i = 0; i < 16; ++i) lanes[i] = bits >> i & 1 ? -1 : 0;
  }
  alignas(64) int lanes[16];
};

}  // namespace

struct RayScene::Implementation {
  Implementation() : device(rtcNewDevice(nullptr)), scene(device ? rtcNewScene(device) : nullptr) {
    if (!device) throw std::runtime_error("Embree cannot start");
    rtcSetDeviceErrorFunction(device, rememberError, &message);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  }

  explicit Implementation(std::span<const TriangleMesh* const> meshes) : Implementation() {
    for (std::size_t i = 0; i < meshes.size(); ++i) attach(*meshes[i], static_cast<unsigned>(i));
    commit();
  }

  explicit Implementation(std::span<const Occluder> occluders) : Implementation() {
    for (std::size_t i = 0; i < occluders.size(); ++i)
      std::visit([&](const auto* object) { attach(*object, static_cast<unsigned>(i)); },
                 occluders[i]);
    commit();
  }

  explicit Implementation(std::span<const Sphere> spheres) : Implementation() {
    attach(spheres);
    commit();
  }

  void commit() {
    rtcCommitScene(scene);
    throwError();
  }

  void attach(std::span<const Sphere> spheres) {
    if (spheres.empty()) return;
    const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT));
    copyBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4,
               std::vector<Sphere>(spheres.begin(), spheres.end()));
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, 0);
  }

  void attach(const Solid& solid, unsigned object) {
    embree::attachSolid(device, scene, object, solids.emplace(object, solid).first->second);
  }

  void attach(const TriangleMesh& mesh, unsigned object) {
    normals.resize(object + 1);
    triangles.resize(object + 1);
    normals[object] = mesh.normals;
    triangles[object] = mesh.triangles;
    if (mesh.triangles.empty()) return;
    const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    copyBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
    copyBuffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, object);
  }

  template <typename Item>
  void copyBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                  const std::vector<Item>& items) {
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Item), items.size());
    throwError();
    std::copy(items.begin(), items.end(), static_cast<Item*>(buffer));
  }

  void throwError() const {
    if (!message.empty()) throw std::runtime_error("Embree cannot build the scene: " + message);
  }

  glm::vec3 interpolatedNormal(const RayHit& hit) const {
    if (solids.contains(hit.object)) return hit.geometricNormal;
    const glm::uvec3& t = triangles[hit.object][hit.triangle];
    const auto& n = normals[hit.object];
    if (n.empty()) return hit.geometricNormal;
    const glm::vec3 sum = (1 - hit.barycentric.x - hit.barycentric.y) * n[t.x] +
                          hit.barycentric.x * n[t.y] + hit.barycentric.y * n[t.z];
    const float length = glm::length(sum);
    return length > 0 ? sum / length : hit.geometricNormal;
  }

  std::string message;
  std::map<std::uint32_t, Solid> solids;  ///< by object; Embree keeps pointers to them
  Device device;
  Scene scene;
  std::vector<std::vector<glm::vec3>> normals;
  std::vector<std::vector<glm::uvec3>> triangles;
};

RayScene::RayScene(std::span<const TriangleMesh* const> meshes)
    : implementation_(std::make_unique<Implementation>(meshes)) {}
RayScene::RayScene(std::span<const Occluder> occluders)
    : implementation_(std::make_unique<Implementation>(occluders)) {}
RayScene::RayScene(const TriangleMesh& mesh) : RayScene(std::array{&mesh}) {}
RayScene::RayScene(std::span<const Sphere> spheres)
    : implementation_(std::make_unique<Implementation>(spheres)) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

std::optional<RayHit> RayScene::closestHit(const glm::vec3& origin, const glm::vec3& direction,
                                           float near) const {
  RTCRayHit query{};
  query.ray = newRay(origin, direction, near);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(implementation_->scene, query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  RayHit hit;
  hit.object = query.hit.geomID;
  hit.triangle = query.hit.primID;
  hit.barycentric = {query.hit.u, query.hit.v};
  hit.distance = query.ray.tfar;
  hit.position = origin + hit.distance * direction;
  // The length of Embree's normal, twice the area, can lie outside the range of float squares.
  hit.geometricNormal =
      glm::vec3(glm::normalize(glm::dvec3(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z)));
  hit.shadingNormal = implementation_->interpolatedNormal(hit);
  return hit;
}

std::uint16_t RayScene::closestHits16(const glm::vec3& origin,
                                      std::span<const glm::vec3, 16> directions,
                                      std::span<TriangleHit, 16> hits, std::uint16_t valid,
                                      float near) const {
  RTCRayHit16 query{};
  const Active active(valid);
  for (std::size_t i = 0; i < 16; ++i) {
    setRay(query.ray, i, origin, directions[i], near);
    query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
  embree::intersect16(active.lanes, implementation_->scene, query);
  unsigned met = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    if (!active.lanes[i] || query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    met |= 1u << i;
    hits[i] = {query.hit.geomID[i],
               query.hit.primID[i],
               {query.hit.u[i], query.hit.v[i]},
               query.ray.tfar[i]};
  }
  return static_cast<std::uint16_t>(met);
}

bool RayScene::occluded(const glm::vec3& origin, const glm::vec3& direction, float near) const {
  RTCRay ray = newRay(origin, direction, near);
  embree::occlude(implementation_->scene, ray);
  return ray.tfar < 0;
}

std::uint16_t RayScene::occluded16(std::span<const glm::vec3, 16> origins,
                                   std::span<const glm::vec3, 16> directions, std::uint16_t valid,
                                   float near, float far) const {
  RTCRay16 rays{};
  const Active active(valid);
  for (std::size_t i = 0; i < 16; ++i) {
    setRay(rays, i, origins[i], directions[i], near);
    rays.tfar[i] = far;
  }
  embree::occlude16(active.lanes, implementation_->scene, rays);
  unsigned hits = 0;
  for (unsigned i = 0; i < 16; ++i) hits |= unsigned(active.lanes[i] && rays.tfar[i] < 0) << i;
  return static_cast<std::uint16_t>(hits);
}

}  // namespace haarlight
