#pragma once

#include "core/base/team.h"

namespace arcway {

/// All processes that mpirun started, as a team. One object a process, on the thread that makes and destroys it; every
/// call but size and rank waits for the other processes. A process that ends without `~MpiTeam` takes all others with
/// it.
///
///     const MpiTeam team;
///     const Planner planner(world, vehicle, accel_backend(world, threads, {.team = &team}), {.graph_mode =
///     GraphMode::kEager, .team = &team});
class MpiTeam final : public Team {
 public:
  /// Starts MPI. @throws std::runtime_error if it has been started before.
  MpiTeam();
  /// Ends MPI, when all processes have come here.
  ~MpiTeam() override;
  MpiTeam(const MpiTeam&) = delete;
  MpiTeam& operator=(const MpiTeam&) = delete;

  [[nodiscard]] std::size_t size() const override { return size_; }
  [[nodiscard]] std::size_t rank() const override { return rank_; }
  [[nodiscard]] std::vector<std::string> gather(std::string bytes) const override;

  /// Ends all processes at once; their exit code is this one.
  [[noreturn]] void abort(int code) const;

 private:
  std::size_t size_ = 1;
  std::size_t rank_ = 0;
};

}  // namespace arcway
