#include "accel/embree/device.h"

#include <tbb/task_arena.h>

#include <new>
#include <stdexcept>
#include <string>

#include "arcway/executor.h"

namespace arcway::internal::embree {

namespace {

const char* name_of(RTCError error) {
  switch (error) {
    case RTC_ERROR_NONE:
      return "no error";
    case RTC_ERROR_INVALID_ARGUMENT:
      return "invalid argument";
    case RTC_ERROR_INVALID_OPERATION:
      return "invalid operation";
    case RTC_ERROR_OUT_OF_MEMORY:
      return "out of memory";
    case RTC_ERROR_UNSUPPORTED_CPU:
      return "unsupported CPU";
    case RTC_ERROR_CANCELLED:
      return "canceled";
    default:
      return "unknown error";
  }
}

void throw_on(RTCError error) {
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (error == RTC_ERROR_CANCELLED) throw Canceled("canceled");
  throw std::runtime_error(std::string("Embree: ") + name_of(error));
}

}  // namespace

Device::Device(const char* config) : device_(rtcNewDevice(config)) {
  if (!device_) throw_on(rtcGetDeviceError(nullptr));
  check();
}

void Device::check() const { throw_on(rtcGetDeviceError(device_.get())); }

void Device::commit(RTCScene scene, const StopClock& clock) const {
  const auto goes_on = [](void* asked, double) { return !static_cast<const StopClock*>(asked)->is_over(); };
  rtcSetSceneProgressMonitorFunction(scene, goes_on, const_cast<StopClock*>(&clock));
  // A thread that waits for the build must not pick up the caller's tasks, because it flushes denormals meanwhile.
  tbb::this_task_arena::isolate([scene] { rtcCommitScene(scene); });
  rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
  check();
}

}  // namespace arcway::internal::embree
