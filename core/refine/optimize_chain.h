#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>

#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/collision/clearance_cost.h"
#include "core/model/outlines.h"
#include "core/motion/end_speeds.h"
#include "core/refine/circle_chain.h"

namespace arcway::internal {

/// How far a chain is optimized.
struct ChainEffort {
  int parts;             ///< number of arcs that a turn is cut into; a large turn gets one more
  double least_turn;     ///< smallest turn that is cut [rad]
  int iterations;        ///< most steps; each takes some 2 us for each arc
  double first_barrier;  ///< weight of the barrier at first, as a share of the travel time
  /// With no more than so many steps.
  [[nodiscard]] ChainEffort within(std::uint64_t steps) const {
    ChainEffort effort = *this;
    effort.iterations = static_cast<int>(std::min(static_cast<std::uint64_t>(iterations), steps));
    return effort;
  }
};

/// Who drives a chain or a path that is to be optimized, and where. What is referred to must outlive the optimization.
struct ChainQuery {
  const Vehicle& vehicle;  ///< one that ChainOptimizer serves
  const World& world;
  const Outlines& outlines;  ///< of the world
  ChainEffort effort;
  StopClock clock = {};  ///< asked while contacts are found, and before each iteration
  EndSpeeds ends = {};   ///< of the path
  /// What driving close to obstacles costs; may be null. Parts that keep a preferred distance keep it.
  const ClearanceCost* clearance = nullptr;
};

/// Makes a chain of turns faster by a primal-dual interior-point method. Each turn is driven in several arcs, whose
/// centers and radii move, with the speeds at their ends, until the time falls no more. Contacts with obstacles are
/// constraints. It proposes: only the exact queries tell whether the result is free, and only its speed profile whether
/// it is faster. The order and the sides of turns stay. Deterministic unless stopped. Keeps its memory for the next
/// chain; one chain at a time.
///
/// Source: Nocedal and Wright, Numerical Optimization, chapter 19: slacks, a barrier, steps by Newton's method in a
/// trust region, and a merit function with second-order corrections.
class ChainOptimizer {
 public:
  ChainOptimizer();
  ~ChainOptimizer();
  ChainOptimizer(ChainOptimizer&&) noexcept;
  ChainOptimizer& operator=(ChainOptimizer&&) noexcept;

  /// Whether chains of a vehicle can be optimized. It must be the faster the wider it turns, up to its top speed, by
  /// its lateral acceleration or by a table that ascends so far or to its end. Contacts are those of the rectangle
  /// around its body.
  static bool serves_chains(const Vehicle& vehicle);
  /// Whether paths of a vehicle can be optimized: it may as well drive all turns at one speed.
  static bool serves(const Vehicle& vehicle);

  struct Result {
    bool is_optimized;  ///< false if nothing can give way, or the clock is over at once
    int iterations;
  };
  /// Optimizes the chain of a free path.
  /// @param lines  of the chain.
  /// Precondition: chains of the vehicle are served.
  Result optimize(const CircleChain& chain, std::span<const Bitangent> lines, const ChainQuery& query,
                  CircleChain& optimized);
  /// Optimizes a free path, in both gears too. The gears of its motions stay, and where it changes gear the vehicle
  /// stops. No line has to give way, which takes a few more solves in the end.
  /// Precondition: the vehicle is served.
  Result optimize(std::span<const PathSegment> path, const ChainQuery& query, Path& optimized);

  struct Memory;

 private:
  std::unique_ptr<Memory> memory_;
};

}  // namespace arcway::internal
