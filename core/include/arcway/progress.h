#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <utility>

#include "arcway/executor.h"
#include "arcway/export.h"

namespace arcway {

/// How far a build or a batch of queries is.
struct Progress {
  const char* stage;    ///< "turn circles", "bitangents", ...
  std::uint64_t done;   ///< items; never falls within one loop of a stage
  std::uint64_t total;  ///< items, > 0
};

/// Receives progress. It is called by the threads that do the work, one at a time: it should return at once and must
/// not throw.
using ProgressCallback = std::function<void(const Progress&)>;

/// Runs loops on another executor and reports their progress. A loop of any length makes about 250 calls, the last one
/// with `done` equal to `total`.
///
///     const TbbExecutor threads;
///     const ReportingExecutor watched(threads, [](const Progress& p) { bar.show(p.stage, p.done, p.total); });
///     const Planner planner(world, vehicle, accel_backend(world, watched));
///
/// For one build at a time. It may wrap a StoppableExecutor, or be wrapped by one.
class ARCWAY_API ReportingExecutor final : public Executor {
 public:
  /// @param executor  must outlive this one.
  ReportingExecutor(const Executor& executor, ProgressCallback report)
      : executor_(executor), report_(std::move(report)) {}

  void begin_stage(const char* name) const override { stage_ = name; }
  [[nodiscard]] StopClock clock() const override { return executor_.clock(); }

  void for_ranges(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) const override {
    if (count == 0) return;
    const char* const stage = stage_;
    const std::size_t step = std::max<std::size_t>(count / kReports, 1);
    const std::size_t piece = std::max(step, grain);
    std::atomic<std::size_t> done = 0;
    std::size_t reported = 0;  // guarded by mutex_
    executor_.for_ranges(count, grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t first = begin; first < end;) {
        const std::size_t last = first + std::min(piece, end - first);
        body(first, last);
        done += last - first;
        first = last;
        // A thread that finds another one here leaves the report to it, or to a later one.
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (!lock) continue;
        const std::size_t now = done;
        if (now < reported + step || now == count) continue;
        reported = now;
        report_({stage, now, count});
      }
    });
    const std::lock_guard lock(mutex_);
    report_({stage, count, count});
  }

 private:
  static constexpr std::size_t kReports = 250;
  const Executor& executor_;
  ProgressCallback report_;
  mutable std::atomic<const char*> stage_ = "";
  mutable std::mutex mutex_;  // of all loops: they may run at the same time, within each other
};

}  // namespace arcway
