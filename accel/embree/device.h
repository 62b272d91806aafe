#pragma once

#include <memory>
#include <type_traits>

#include "accel/embree/embree_api.h"
#include "arcway/stop_clock.h"

namespace arcway::internal::embree {

/// Deleter of one of Embree's objects.
template <class Object, void (*release)(Object)>
struct Release {
  void operator()(std::remove_pointer_t<Object>* object) const { release(object); }
};
using SceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release<RTCScene, rtcReleaseScene>>;
using GeometryHandle = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Release<RTCGeometry, rtcReleaseGeometry>>;

/// An Embree device whose errors become exceptions. It changes no process-wide setting: no thread count, no
/// floating-point mode.
class Device {
 public:
  /// @param config  Embree's configuration, such as "isa=sse2" for tests; empty: what suits the machine.
  /// @throws std::runtime_error with Embree's message.
  explicit Device(const char* config = "");

  [[nodiscard]] RTCDevice get() const { return device_.get(); }
  /// Throws the error of this thread since the last call, if any: std::bad_alloc or std::runtime_error.
  void check() const;
  /// Builds a scene in the caller's arena, apart from the caller's other tasks.
  /// @throws Canceled if the clock is over before it is built.
  void commit(RTCScene scene, const StopClock& clock) const;

 private:
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release<RTCDevice, rtcReleaseDevice>> device_;
};

}  // namespace arcway::internal::embree
