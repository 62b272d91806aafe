#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "arcway/path.h"
#include "arcway/planner.h"
#include "arcway/stop_clock.h"
#include "core/base/stopwatch.h"
#include "core/motion/speed_profile.h"
#include "core/planner/plan_maps.h"
#include "core/planner/slim_maps.h"
#include "core/refine/refine_path.h"
#include "core/reversing/refine_reversing.h"
#include "core/search/find_path.h"
#include "core/search/tree_search.h"

namespace arcway::internal {

/// Memory of a query, kept for the next one.
struct PlanWorkspace {
  FindWorkspace find;
  RefineWorkspace refine;
  RefinedPath refined;
  Path best, second;
  SpeedProfile profile;
  std::vector<double> unrefined_times;  // of all paths found so far
};

/// One query on its way: paths are looked for on one map after another and refined, and the cheapest is kept. What that
/// took is added to the result's statistics.
class PlanRun {
 public:
  /// All arguments must outlive this.
  /// @param map    any of the world, with the vehicle that is to drive.
  /// @param limits  but for the time and the stop.
  /// @param clock   ends the run, with the cheapest path found by then.
  PlanRun(const PlannerOptions& options, const Roadmap& map, const PlanRequest& request, const PlanLimits& limits,
          const StopClock& clock, PlanWorkspace& workspace, PlanResult& result);

  [[nodiscard]] bool found() const { return found_; }
  /// So far.
  [[nodiscard]] const Path& best() const { return workspace_.best; }

  /// Looks for the fastest path of one set of maps, driven forwards, and refines it.
  /// @param effort  in trials of refinement, of what the options say.
  /// @returns what stands in the way, if anything does.
  Obstruction find_forwards(const PlanMaps& maps, double effort, const std::function<bool()>& no_passage);
  /// Whether trees of forward motions are wanted.
  [[nodiscard]] bool grows_trees() const { return tree_poses_ > 0; }
  /// Looks for a path by trees of forward motions, for what find_forwards finds none on these maps. Where those that
  /// tell poses apart roughly find none, looks for paths of slimmer bodies, and pushes them off what the real one
  /// touches; then for more by finer trees, unless a slimmer body has no path either.
  /// @returns how the trees of the real body ended.
  TreesEnd find_by_trees(const PlanMaps& maps, const SlimMaps& slim, double effort);
  /// Where the lower bound says that the path which was found forwards last may be far from the best one: looks
  /// for faster ones on the same maps with maneuvers at both ends, with circles in narrow places, and by other ways.
  /// @param thorough  sooner, and with more maneuvers.
  void improve_forwards(bool thorough);
  /// Looks for the fastest path of another map that takes a way of its own, unless the lower bound says that it is not
  /// worth it. The vehicle of that map need not be the real one.
  /// @param poses  of maneuvers at both ends.
  void find_other_route(const Roadmap& map, double effort, std::size_t poses = 0);
  /// Refines the best path further, and the second best if it is nearly as good: that one may become the best.
  void refine_best(double effort);
  /// Looks for a cheaper path in both gears.
  /// @param distance  that no path falls below [m].
  void find_in_both_gears(const Roadmap& map, double distance);

 private:
  struct Times {
    double unrefined;
    double cost;
  };
  // The fastest path of some maps.
  struct Fastest {
    Times times;
    const Roadmap* map;  // that it was found on
    std::size_t poses;   // of maneuvers at both ends
    std::uint32_t first_circle, last_circle;
  };

  template <class Find>
  FoundPath search(const Find& find);
  Times keep(Path&& path, double effort, bool reverse);
  void refine(const Path& path, double effort, bool reverse);
  TreesEnd grow_trees(const PlanMaps& maps, const TreeLimits& limits, double effort);
  // False if the slimmer body has no path either, as far as its trees tell.
  bool find_by_slimmer(const PlanMaps& maps, const Roadmap& slim, double effort);
  void keep_narrow(const PlanMaps& maps, Path&& path, double effort);
  [[nodiscard]] bool is_in_dead_end(const Pose& pose, Direction direction) const;
  void try_faster(const Roadmap& map, std::size_t poses);
  // Ways that join the graph, or leave it, by another circle than the fastest path.
  void try_other_ends();
  void find_other_route(const Roadmap& map, double effort, std::size_t poses, SearchOptions bounded);
  [[nodiscard]] double cost_of(const Path& path);
  [[nodiscard]] double travel_time(const Path& path);

  const Stopwatch total_;
  const PlannerOptions& options_;
  const Roadmap& map_;
  const PlanRequest& request_;
  SearchOptions search_options_;
  std::size_t tree_poses_;
  GearChanges gear_changes_;
  PlanWorkspace& workspace_;
  PlanResult& result_;
  bool found_ = false;
  double second_unrefined_ = 0.0;     // travel time [s]
  double best_cost_, second_cost_;    // infinite where there is none
  std::uint64_t first_expanded_ = 0;  // until the first path was found
  const PlanMaps* maps_ = nullptr;    // on which find_forwards found a path last
  Fastest fastest_{};                 // of these
};

}  // namespace arcway::internal
