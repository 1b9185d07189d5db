#pragma once

/// The only place that knows what differs between Embree 3 and 4: the folder of the headers, and
/// the context argument of version 3. For ray_scene.cpp and
/// embree_solid.h alone.

#if HAARLIGHT_EMBREE_VERSION == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

namespace haarlight::embree {

#if HAARLIGHT_EMBREE_VERSION == 3

inline RTCIntersectContext newContext() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  return context;
}

inline void intersect(RTCScene scene, RTCRayHit& rayHit) {
  RTCIntersectContext context = newContext();
  rtcIntersect1(scene, &context, &rayHit);
}

inline void intersect16(const int* valid, RTCScene scene, RTCRayHit16& rayHits) {
  RTCIntersectContext context = newContext();
  rtcIntersect16(valid, scene, &context, &rayHits);
}

inline void occlude(RTCScene scene, RTCRay& ray) {
  RTCIntersectContext context = newContext();
  rtcOccluded1(scene, &context, &ray);
}

inline void occlude16(const int* valid, RTCScene scene, RTCRay16& rays) {
  RTCIntersectContext context = newContext();
  rtcOccluded16(valid, scene, &context, &rays);
}

#else

inline void intersect(RTCScene scene, RTCRayHit& rayHit) {
  rtcIntersect1(scene, &rayHit, nullptr);
}

inline void intersect16(const int* valid, RTCScene scene, RTCRayHit16& rayHits) {
  rtcIntersect16(valid, scene, &rayHits, nullptr);
}

inline void occlude(RTCScene scene, RTCRay& ray) {
  rtcOccluded1(scene, &ray, nullptr);
}

inline void occlude16(const int* valid, RTCScene scene, RTCRay16& rays) {
  rtcOccluded16(valid, scene, &rays, nullptr);
}

#endif

}  // namespace haarlight::embree
