#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "arcway/path.h"
#include "arcway/planner.h"
#include "core/base/infinity.h"
#include "core/base/stopwatch.h"
#include "core/collision/path_cost.h"
#include "core/motion/speed_profile.h"
#include "core/planner/no_path.h"
#include "core/planner/query_context.h"
#include "core/planner/strategy_row.h"
#include "core/refine/join_arcs.h"
#include "core/refine/refine_path.h"
#include "core/reversing/refine_reversing.h"
#include "core/reversing/reversing_search.h"
#include "core/search/forward_search.h"
#include "core/search/point_distance.h"
#include "core/search/push_free.h"
#include "core/search/tree_search.h"

namespace arcway::internal {

/// A way on which a path has been refined.
struct RefinedWay {
  std::uint64_t way;       ///< see Way::number
  double unrefined, cost;  ///< cost of the path before refinement, without gear changes [s], and afterwards
};

/// Memory of a query, kept for the next one.
struct PlanWorkspace {
  FindWorkspace find;
  FindWorkspace find_without_zones;  // apart, as searches of `find` continue each other
  PathRefiner refiner;
  RefinedPath refined;
  Path best, second;
  ArcJoiner joiner;
  Path fewer;  // the best path in fewer arcs, refined
  SpeedProfile profile;
  std::vector<double> unrefined_costs;  // of all paths found so far, before refinement, without gear changes [s]
  std::vector<RefinedWay> ways;         // of paths whose turns were optimized
  PointDistance::Workspace point;
  HeadingSet headings;
  std::unique_ptr<PlanWorkspace> within;  // of a query for a part of the path or a slim body, once there was one
};

/// One query, from its first path to its best one: takes the rows of a strategy one by one, refines the paths that they
/// find, and keeps the cheapest. What that took is added to the result's statistics.
class PlanRun {
 public:
  /// What a query is for: see When::whole, When::quick_parts, When::slim_body.
  enum class Scope { kWhole, kPart, kQuickPart, kSlimBody };
  /// All arguments must outlive this.
  PlanRun(const QueryContext& query, PlanWorkspace& workspace, PlanResult& result, Scope scope = Scope::kWhole);

  /// Takes each row whose condition holds, until there is a proof that no path exists, or the clock is over.
  void follow(std::span<const StrategyRow> rows);
  /// Raises the result's lower bound by the way around the obstacles, once, if that is wanted. A clock that is over
  /// sooner leaves the largest bound that is proved by then.
  void raise_lower_bound();

  [[nodiscard]] bool found() const { return found_; }
  [[nodiscard]] const Path& best() const { return workspace_.best; }
  /// Whether there is a proof that no path exists.
  [[nodiscard]] bool has_proof() const { return has_proof_; }
  /// What searches and proofs found out about a query without a path.
  [[nodiscard]] const NoPath& why() const { return why_; }

 private:
  struct Times {
    double unrefined;  // cost before refinement, without that of gear changes [s]
    double cost;       // of the refined path [s]
  };
  // A path before refinement.
  struct Unrefined {
    double time = 0.0;  // of travel [s]
    double cost = 0.0;  // without that of gear changes [s]
  };
  // The fastest path on the roadmaps in use.
  struct Fastest {
    Times times;
    const Roadmap* map;  // on which it was found
    std::size_t poses;   // number of poses of maneuvers at each end
    std::uint32_t first_circle, last_circle;
  };

  // A query as if no zone limited the speed.
  struct WithoutZones {
    double lower_bound;  // [s]
    double saves;        // by how much less the fastest path costs then, before refinement [s]
  };

  enum class RefineMode { kForwards, kAtLength, kBothGears };

  [[nodiscard]] bool holds(const When& when);
  [[nodiscard]] bool holds(Known known) const;
  [[nodiscard]] bool holds(WhenSlim when) const;
  // Whether a path is known, refined or not.
  [[nodiscard]] bool has_path() const { return found_ || soon_ || (reversing_ && reversing_->path()); }
  // Whether a path that is driven forwards is known and worth improving.
  [[nodiscard]] bool has_forward_path() const;
  [[nodiscard]] bool is_thorough() const { return refines() && !query_.maps.tightest; }
  [[nodiscard]] bool refines() const { return query_.options.refinement.max_trials > 0; }
  // What is not refined joins by all radii: it is the fastest path of the graph.
  [[nodiscard]] std::size_t end_radii(std::size_t refined) const { return refines() ? refined : kEveryRadius; }
  // A lower bound of the cost of all paths, beside gear changes.
  [[nodiscard]] double least_cost() const { return result_.lower_bound + close_ends_; }
  // Whether a cost exceeds the lower bound by more than a share, with and, unless zones count, also without zones.
  [[nodiscard]] bool has_gap(double cost, double gap, bool counts_zones);
  [[nodiscard]] bool is_tight(const Pose& pose, Direction direction, double angle) const;

  void take(const JoinBySingleArcs& step, double trials);
  void take(const FindSoon& step, double trials);
  void take(const JoinByNarrowPlaces& step, double trials);
  void take(const JoinByManeuvers& step, double trials);
  void take(const JoinByManeuversAndNarrowPlaces& step, double trials);
  void take(const ProveBottleneck& step, double trials);
  void take(const ProveDeadEnd& step, double trials);
  void take(const ProveEnclosure& step, double trials);
  void take(const GrowTrees& step, double trials);
  void take(const GrowSlimTrees& step, double trials);
  void take(const RaiseLowerBound& step, double trials);
  void take(const FollowZoneRoutes& step, double trials);
  void take(const FollowOneWayRoutes& step, double trials);
  void take(const TryManeuvers& step, double trials);
  void take(const TryNarrowPlaces& step, double trials);
  void take(const TryOtherLastCircle& step, double trials);
  void take(const TryOtherFirstCircle& step, double trials);
  void take(const TryOtherTurns& step, double trials);
  void take(const TryOtherRadii& step, double trials);
  void take(const TryOtherSides& step, double trials);
  void take(const RefineBest& step, double trials);
  void take(const JoinArcs& step, double trials);
  void take(const JoinBackwards& step, double trials);
  void take(const JoinBetweenGears& step, double trials);
  void take(const GrowGearTrees& step, double trials);
  void take(const GrowNarrowGearTrees& step, double trials);
  void take(const GrowSlimGearTrees& step, double trials);
  void take(const TryOtherWays& step, double trials);
  void take(const TryOtherWaysInBothGears& step, double trials);
  void take(const PlanSlimBody& step, double trials);
  void take(const RefineBothGears& step, double trials);
  void take(const PlanParts& step, double trials);
  void take(const PlanPartsQuickly& step, double trials);

  [[nodiscard]] const PlanMaps& maps_on(On on) const;
  [[nodiscard]] ForwardSearch& forward_search(On on);
  [[nodiscard]] ReversingSearch& reversing_search();
  // As known when first asked for.
  [[nodiscard]] const WithoutZones& without_zones();
  // Grows trees, and keeps the path that they find unless it is too slow. Returns its cost, refined; infinite if it was
  // not kept, nothing if they have found none.
  std::optional<double> grow(const GrowTrees& step, double trials);
  std::optional<double> grow(const GrowSlimTrees& step, double trials);
  // Runs a search, and counts what it did.
  template <class Find>
  FoundPath search(const Find& find);
  // Grows trees in both gears, and remembers the path that they have found.
  template <class Grow>
  void grow_in_both_gears(const Grow& grow);
  // See ReversingSearch::grow_slim_gear_trees, for each slim body until a path is pushed free or none is found.
  void grow_slim_gear_trees(const GrowSlimGearTrees& step, double trials, double most);
  void keep_forwards(On on, FoundPath&& found, double trials);
  // Notes a path as the first one, unless one is noted.
  void note_first(const Path& path, double time);
  // Keeps a path that is driven forwards, but not on circles of the roadmap. Those of all radii are in use then.
  Times keep_beside_roadmap(Path&& path, double trials);
  // As keep_beside_roadmap, of many motions: shortens it first.
  Times keep_shortened(Path&& path, std::uint32_t shortenings, double trials);
  // Keeps the first path, if no other one was kept, and the cheapest one in both gears.
  void keep_all();
  // Keeps the cheapest path of the search in both gears, unless it was kept.
  void keep_in_both_gears();
  void keep_from_both_gears(const Path& path);
  // Refines a path further, and keeps it if it is the cheapest one then.
  // `unrefined`: of the path.
  void refine_at_length(const Path& path, const Unrefined& unrefined, double trials);
  // Drives the best path in fewer arcs, and refines it then, at length too.
  void drive_in_fewer_arcs(double trials);
  // Keeps a path as the second best one if it is driven forwards. Takes its memory and leaves that of the one before.
  void keep_second(Path& path, double cost, const Unrefined& unrefined);
  [[nodiscard]] static bool is_driven_forwards(const Path& path);
  // How parts are planned again.
  struct PartEffort {
    Scope scope;
    double gap;               // least gap of a part
    std::size_t most_failed;  // number of parts in a row that bring nothing
    double best_gap = 0.0;    // least gap of the best path
    double tree_share = 0.0;  // of PlanLimits::tree_poses
    // See PlanPartsQuickly; infinite for PlanParts.
    double slower = kInfinity, worth_length = kInfinity;
  };
  void plan_parts(std::span<const PathPart> parts, const PartEffort& effort, double trials);
  // Plans a part of the best path again, and keeps the path with what is found.
  // @return whether that was tried and brought nothing.
  bool plan_in_vain(const PathPart& part, const PartEffort& effort, double trials);
  // Memory of a query within this one, one at a time.
  [[nodiscard]] PlanWorkspace& workspace_within();
  // Takes the rows of this query for one within it, and counts what that took.
  void follow_within(PlanRun& run);
  // The request for what lies between two joints of the best path, with the speeds of the profile there.
  [[nodiscard]] PlanRequest request_between(std::size_t from, std::size_t to) const;
  // Refines a path, unless that promises nothing, and keeps it if it is the cheapest one.
  // `way`: that the path takes.
  Times keep(Path&& path, const Way& way, double trials, RefineMode mode);
  // What is known of another path of its way, if refining this one promises nothing better.
  [[nodiscard]] const RefinedWay* refined_before(std::uint64_t way, double unrefined) const;
  // Refines a path into the workspace.
  void refine(const Path& path, double trials, RefineMode mode);
  // How a path of a vehicle is refined.
  [[nodiscard]] RefineQuery refine_query(const Path& path, const Vehicle& vehicle, double trials) const;
  // What a path of a slimmer body is pushed off.
  [[nodiscard]] PushSpace push_space() const { return {map_.vehicle, map_.body, *map_.outlines, *map_.queries.sweep}; }
  // Counts what a refinement did.
  void count(const RefinedPath& refined, double seconds);
  // A free path in both gears, from rest to rest, near one of a slim body; nothing if none is found.
  [[nodiscard]] std::optional<Path> pushed_free(const Path& path, const Pose& goal, const Vehicle& slim, double trials);
  // Whether the map is so small that looking for a faster path may take memory of its own.
  [[nodiscard]] bool is_worth_memory() const { return map_.world.vertices().size() <= PlanMaps::kNarrowVertices; }
  // The roadmap of a slim body: see SlimMaps. Null as well where a path is known and the map is large: it takes memory.
  [[nodiscard]] const Roadmap* slim_map(std::size_t body) const;
  // Appends a path from pose to pose.
  // @return the number of legs that were found until one was not.
  std::size_t drive_over(std::span<const Pose> poses, Path& path);
  void try_faster(const Roadmap& map, std::size_t poses, double least_gain, double trials);
  void try_other_route(const Roadmap& map, std::size_t poses, SearchOptions options, double trials);
  // What the cost of a path depends on, but for gear changes.
  [[nodiscard]] PathCosts costs() const { return {query_.ends(), map_.speed_zones.get(), map_.clearance_cost.get()}; }
  // Infinite if a path cannot be driven between the speeds at its ends.
  [[nodiscard]] double cost_of(const Path& path);
  [[nodiscard]] double travel_time(const Path& path);
  // The cost of driving close to obstacles.
  [[nodiscard]] double clearance_cost(const Path& path) const {
    return internal::clearance_cost(map_.clearance_cost.get(), path);
  }

  const Stopwatch total_;
  const Scope scope_;
  std::span<const StrategyRow> rows_;
  const QueryContext& query_;
  const Roadmap& map_;
  SearchOptions search_options_;
  std::size_t tree_poses_;
  TreeEffort tree_effort_;  // of trees of forward motions of the body
  GearChanges gear_changes_;
  PlanWorkspace& workspace_;
  PlanResult& result_;
  NoPath why_;
  bool has_proof_ = false;
  bool found_ = false;
  bool is_forward_found_ = false;  // a path was kept that is not one of the search in both gears
  double distance_;                // lower bound of the length of all paths [m]
  double close_ends_ = 0.0;        // lower bound of what driving close to obstacles costs on all paths [s]
  bool is_bound_raised_ = false;
  bool are_turns_optimized_;  // by refinement, where a path is driven forwards
  Unrefined best_unrefined_;
  Way best_way_;        // of the best path before refinement
  double best_cost_;    // infinite where there is none
  double second_cost_;  // of the cheapest path of another cost, not refined at length; infinite where there is none
  Unrefined second_unrefined_;
  bool is_first_noted_ = false;
  std::uint64_t first_expanded_ = 0;  // number of expansions until the first refined path was found
  std::optional<ForwardSearch> forward_all_radii_, forward_tightest_;
  std::optional<Path> soon_;         // of FindSoon, until another one is kept
  std::uint64_t soon_expanded_ = 0;  // number of expansions of FindSoon
  const PlanMaps* maps_ = nullptr;   // roadmaps in use: those of the last path that was found forwards
  Fastest fastest_{};                // the fastest path on the roadmaps in use
  std::optional<WithoutZones> without_zones_;
  Surroundings surroundings_ = Surroundings::kOpen;  // of the ends, as trees found them
  bool is_path_refused_ = false;                     // a path of a slimmer body could not be pushed free
  bool are_trees_vain_ = false;                      // trees of a slimmer body found no path either
  std::optional<ReversingSearch> reversing_;
  bool is_refined_at_length_ = false;  // the best path, by RefineBest
  double worth_length_ = kInfinity;    // a path that costs more is not refined at length [s]
  std::vector<Path> avoided_;          // paths off which trees keep, if any
  std::size_t kept_ = 0;               // number of paths that the search in both gears had found when its path was kept
  std::size_t grown_ = 0;              // number of paths that it had found when trees had found the last one
  bool are_slim_gears_grown_ = false;  // trees in both gears of slim bodies
  bool is_narrow_ = false;     // a path was found by trees of a slim body, or by those in both gears for narrow places
  bool is_easy_ = false;       // the first path that was refined joins the roadmap by single arcs of few radii
  bool is_narrowest_ = false;  // a path was first found by narrow trees of the body, in both gears
  bool only_narrow_gears_ = false;  // the path in both gears is one of trees for narrow places
};

template <class Find>
FoundPath PlanRun::search(const Find& find) {
  const Stopwatch searching;
  FoundPath found = find();
  PlanStatistics& s = result_.statistics;
  const SearchCounts& counts = found.search.counts;
  s.nodes_expanded += counts.nodes_expanded;
  s.nodes_pushed += counts.nodes_pushed;
  s.straights_checked += counts.straights_checked;
  s.turns_checked += counts.turns_checked;
  s.maneuver_poses += found.maneuver_poses;
  s.search_seconds += searching.seconds();
  result_.interrupted = result_.interrupted || found.search.interrupted;
  return found;
}

}  // namespace arcway::internal
