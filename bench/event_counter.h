#pragma once

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>
#include <optional>

namespace arcway::internal::bench {

/// Counts an event of the calling thread, and of the threads that it starts from then on, outside of the kernel.
///
/// It asks the kernel itself (perf_event_open). Google Benchmark's own counters need libpfm, which Debian's and
/// Ubuntu's packages are built without.
class EventCounter {
 public:
  /// @param type, config  of perf_event_open: PERF_TYPE_HARDWARE and PERF_COUNT_HW_INSTRUCTIONS.
  EventCounter(std::uint32_t type, std::uint64_t config) {
    perf_event_attr event{};
    event.size = sizeof event;
    event.type = type;
    event.config = config;
    event.inherit = 1;
    event.exclude_kernel = 1;
    event.exclude_hv = 1;
    descriptor_ = static_cast<int>(syscall(SYS_perf_event_open, &event, 0, -1, -1, PERF_FLAG_FD_CLOEXEC));
  }
  EventCounter(const EventCounter&) = delete;
  EventCounter& operator=(const EventCounter&) = delete;
  ~EventCounter() {
    if (descriptor_ >= 0) close(descriptor_);
  }

  /// The count since it was made; nothing where the kernel or the processor does not count, as in many virtual
  /// machines.
  [[nodiscard]] std::optional<std::uint64_t> value() const {
    std::uint64_t count = 0;
    if (descriptor_ < 0 || read(descriptor_, &count, sizeof count) != sizeof count) return std::nullopt;
    return count;
  }

 private:
  int descriptor_ = -1;
};

}  // namespace arcway::internal::bench
