#include "mesh/embree_solid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace haarlight::embree {

namespace {

Ray rayOf(RTCRayN* rays, unsigned count, unsigned i) {
  return {
      {RTCRayN_org_x(rays, count, i), RTCRayN_org_y(rays, count, i), RTCRayN_org_z(rays, count, i)},
      {RTCRayN_dir_x(rays, count, i), RTCRayN_dir_y(rays, count, i), RTCRayN_dir_z(rays, count, i)},
      RTCRayN_tnear(rays, count, i),
      RTCRayN_tfar(rays, count, i)};
}

/// Grown by more than single precision rounds.
void boundsOf(const RTCBoundsFunctionArguments* arguments) {
  const AxisBox box = static_cast<const Solid*>(arguments->geometryUserPtr)->bounds();
  const glm::dvec3 furthest = glm::max(glm::abs(box.lower), glm::abs(box.upper));
  const double margin =
      4 * std::numeric_limits<float>::epsilon() * std::max({furthest.x, furthest.y, furthest.z});
  const glm::vec3 lower(box.lower - margin), upper(box.upper + margin);
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = lower.x, bounds.lower_y = lower.y, bounds.lower_z = lower.z;
  bounds.upper_x = upper.x, bounds.upper_y = upper.y, bounds.upper_z = upper.z;
}

void intersect(const RTCIntersectFunctionNArguments* arguments) {
  const Solid& solid = *static_cast<const Solid*>(arguments->geometryUserPtr);
  const unsigned count = arguments->N;
  RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, count);
  RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, count);
  for (unsigned i = 0; i < count; ++i) {
    if (!arguments->valid[i]) continue;
    const auto hit = solid.intersect(rayOf(rays, count, i));
    if (!hit) continue;
    RTCRayN_tfar(rays, count, i) = float(hit->t);
    RTCHitN_Ng_x(hits, count, i) = float(hit->normal.x);
    RTCHitN_Ng_y(hits, count, i) = float(hit->normal.y);
    RTCHitN_Ng_z(hits, count, i) = float(hit->normal.z);
    RTCHitN_u(hits, count, i) = RTCHitN_v(hits, count, i) = 0;
    RTCHitN_primID(hits, count, i) = arguments->primID;
    RTCHitN_geomID(hits, count, i) = arguments->geomID;
    RTCHitN_instID(hits, count, i, 0) = arguments->context->instID[0];
  }
}

void occlude(const RTCOccludedFunctionNArguments* arguments) {
  const Solid& solid = *static_cast<const Solid*>(arguments->geometryUserPtr);
  const unsigned count = arguments->N;
  for (unsigned i = 0; i < count; ++i)
    if (arguments->valid[i] && solid.blocks(rayOf(arguments->ray, count, i)))
      RTCRayN_tfar(arguments->ray, count, i) = -std::numeric_limits<float>::infinity();
}

}  // namespace

void attachSolid(RTCDevice device, RTCScene scene, unsigned object, const Solid& solid) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, 1);
  rtcSetGeometryUserData(geometry, const_cast<Solid*>(&solid));
  rtcSetGeometryBoundsFunction(geometry, boundsOf, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect);
  rtcSetGeometryOccludedFunction(geometry, occlude);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, object);
  rtcReleaseGeometry(geometry);
}

}  // namespace haarlight::embree
