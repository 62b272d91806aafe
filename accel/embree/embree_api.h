#pragma once

/// \file
/// The differences between Embree 3.13 and Embree 4, and nothing else.

#if EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace arcway::internal::embree {

#if EMBREE_MAJOR >= 4
using RayContext = RTCRayQueryContext;
inline void init(RayContext& context) { rtcInitRayQueryContext(&context); }
inline void occluded(RTCScene scene, RayContext& context, RTCRay& ray) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &ray, &arguments);
}
#else
using RayContext = RTCIntersectContext;
inline void init(RayContext& context) { rtcInitIntersectContext(&context); }
inline void occluded(RTCScene scene, RayContext& context, RTCRay& ray) { rtcOccluded1(scene, &context, &ray); }
#endif

}  // namespace arcway::internal::embree
