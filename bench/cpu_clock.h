#pragma once

#include <ctime>

namespace arcway::internal::bench {

/// Processor time since it was made [s]: what other programs on the machine take is nobody's.
class CpuClock {
 public:
  enum class Of { kThread, kProcess };
  explicit CpuClock(Of of)
      : id_(of == Of::kThread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID), start_(now()) {}

  [[nodiscard]] double seconds() const { return now() - start_; }

 private:
  [[nodiscard]] double now() const {
    timespec time{};
    clock_gettime(id_, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  clockid_t id_;
  double start_;
};

}  // namespace arcway::internal::bench
