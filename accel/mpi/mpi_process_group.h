#pragma once

#include "arcway/process_group.h"

namespace arcway::internal {

/// All processes that mpirun started, as a process group.
///
/// Use one object a process, on the thread that makes and destroys it. Every call but size and rank waits for the other
/// processes. A process that ends without `~MpiProcessGroup` ends all others.
///
///     const MpiProcessGroup processes;
///     const Backend backend = accel_backend(world, threads, {.process_group = &processes});
///     const Planner planner(world, vehicle, backend, {.graph_mode = GraphMode::kEager, .process_group = &processes});
class MpiProcessGroup final : public ProcessGroup {
 public:
  /// Starts MPI.
  /// @throws std::runtime_error if it has been started before.
  MpiProcessGroup();
  /// Ends MPI, once all processes have come here.
  ~MpiProcessGroup() override;
  MpiProcessGroup(const MpiProcessGroup&) = delete;
  MpiProcessGroup& operator=(const MpiProcessGroup&) = delete;

  [[nodiscard]] std::size_t size() const override { return size_; }
  [[nodiscard]] std::size_t rank() const override { return rank_; }
  [[nodiscard]] std::vector<std::string> gather(std::string bytes) const override;

  /// Ends all processes at once, with this exit code.
  [[noreturn]] void abort(int code) const;

 private:
  std::size_t size_ = 1;
  std::size_t rank_ = 0;
};

}  // namespace arcway::internal
