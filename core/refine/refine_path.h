#pragma once

#include <cstdint>
#include <memory>

#include "arcway/path.h"
#include "arcway/refine_options.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/base/infinity.h"
#include "core/collision/clearance_cost.h"
#include "core/model/outlines.h"
#include "core/motion/end_speeds.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

/// @throws std::invalid_argument if the smallest step is not positive and finite, naming it.
void require_refinement(const RefineOptions& options);

/// A refined path, and what refinement took.
struct RefinedPath {
  Path path;
  double travel_time = 0.0;             ///< of `path`, by speed_profile [s]
  std::uint64_t trials = 0;             ///< paths whose travel time was computed
  std::uint64_t improvements = 0;       ///< trials that were accepted: cheaper and free
  std::uint64_t straights_checked = 0;  ///< swept rectangles decided
  std::uint64_t turns_checked = 0;      ///< heading sets computed
  bool interrupted = false;             ///< the clock ended it: more trials might have made the path faster
};

/// A path to refine, and what its changes are checked with. What is referred to must outlive the refinement.
struct RefineQuery {
  const Path& path;
  Pose start, goal;  ///< of the path, with the headings asked for
  const Vehicle& vehicle;
  const SweepQuery& sweep;  ///< of the world
  RefineOptions options = {};
  /// Asked before each trial, and while pairs are told apart. Once it is over, refinement ends with the best path so
  /// far.
  StopClock clock = {};
  /// The world and its outlines. Without them no turns are optimized.
  const World* world = nullptr;
  const Outlines* outlines = nullptr;
  bool at_length = false;    ///< whether the path is the best one, refined before: Stage::kOptimizeAtLength
  EndSpeeds ends = {};       ///< of the path, which stay as they are
  double lower_bound = 0.0;  ///< on the cost of all paths between the poses, as far as it is known [s]
  const SpeedZones* speed_zones = nullptr;        ///< of the world; null: none
  const ClearanceCost* clearance_cost = nullptr;  ///< of driving close to obstacles; null: time alone counts
  /// As `sweep`, where motions that are described as driven forwards are driven backwards; null: gears do not differ.
  const SweepQuery* sweep_backwards = nullptr;
};

/// Makes a free path faster by local changes, as long as time falls:
/// - turns between two circles are left out where their bitangent is free;
/// - start or goal joins a later circle by an arc to either side;
/// - two turns to the same side become one, tangent to the lines before and behind;
/// - two arcs join places on two lines of the path by a Dubins word of the smallest radius;
/// - where wider turns are faster, parts of a turn become wider ones, step by step, and the ends tighter ones;
/// - centers and radii slide, by steps that are halved down to the smallest.
/// For vehicles that ChainOptimizer serves, the first three and rough slides are tried first, then all turns are
/// optimized at once. The other changes follow only where that fails, or for a best path: far from its bound, or where
/// turns stay slower than lines however wide they are.
/// A change is accepted only if the cost falls, and the swept area of the body grown by half of the safety margin is
/// free by `sweep`. The cost is the travel time under the speed profile, plus that of driving close to obstacles. The
/// result is therefore as free as the input and never costs more. It is a local optimum of these changes, not the
/// cheapest path. A path that turns on fewer than two circles is returned as it
/// is. So is one that cannot be driven between its end speeds.
/// Deterministic unless stopped. Keeps its memory for the next path, and that of `result`; one path at a time.
class PathRefiner {
 public:
  PathRefiner();
  ~PathRefiner();
  PathRefiner(PathRefiner&&) noexcept;
  PathRefiner& operator=(PathRefiner&&) noexcept;

  /// @throws std::invalid_argument as require_refinement does.
  void refine(const RefineQuery& query, RefinedPath& result);

  struct Memory;

 private:
  std::unique_ptr<Memory> memory_;
};

/// Refines one path with memory of its own, see PathRefiner.
/// @throws std::invalid_argument as require_refinement does.
RefinedPath refine_path(const RefineQuery& query);

/// Whether refinement optimizes turns: ChainOptimizer serves the vehicle, and the move is not left out.
bool optimizes_turns(const Vehicle& vehicle, const RefineOptions& options);

}  // namespace arcway::internal
