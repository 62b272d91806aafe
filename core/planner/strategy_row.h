#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "core/gaps/dead_end.h"
#include "core/reversing/gear_search.h"
#include "core/reversing/reversing_search.h"
#include "core/search/effort.h"
#include "core/search/forward_search.h"

namespace arcway::internal {

// What a row of the strategy says: a condition, and a step with the numbers that it takes. The rows are in strategy.h.
// A gap is by how much a plan may be slower than the fastest one: travel time over lower bound - 1.

/// What has been found by the time a row comes.
enum class Known {
  kAnything,
  kNoPath,       ///< no path at all
  kPath,         ///< some path
  kEasierPath,   ///< some path; not where narrow trees of the body found the first one, as those of slim bodies failed
  kForwardPath,  ///< some path that is driven forwards, not much costlier than one in both gears: kWorthForwards
  kByManeuvers,  ///< such a path, found on the roadmap in use by maneuvers at both ends
  kPathElsewhere,  ///< such a path, but none of the tightest radii alone
  kNarrowPath,     ///< only a path of trees for narrow places, which know little of cost
  kGearChanges     ///< only a path with changes of gear
};
/// What the request allows.
enum class Driving { kAny, kForwards, kBothGears };
/// How many turning radii the roadmap has beside those of tightest_radii: none, or some.
enum class Radii { kAny, kTightest, kSeveral };
/// Thorough: paths are refined, on a roadmap of the tightest radii alone. Quick: otherwise.
enum class Care { kAny, kThorough, kQuick };

/// When a row is taken: all members must hold.
struct When {
  Known known = Known::kAnything;
  Driving driving = Driving::kAny;
  Radii radii = Radii::kAny;
  Care care = Care::kAny;
  bool whole = false;             ///< the query is not one for a part of a path: PlanParts, PlanPartsQuickly
  bool quick_parts = false;       ///< taken for parts of PlanPartsQuickly too; other rows are not
  bool slim_body = false;         ///< taken for the body of PlanSlimBody too; other rows are not
  bool refines = false;           ///< paths are refined
  bool has_speed_limits = false;  ///< zones of the map limit the speed
  bool has_one_way = false;       ///< zones of the map limit directions
  bool grows_trees = false;       ///< trees are wanted: PlanLimits::tree_poses, PlannerOptions::maneuver_poses
  double gap = 0.0;       ///< least gap of the plan on the roadmap in use; of one in both gears before refinement
  double best_gap = 0.0;  ///< least gap of the best plan so far
  double most_gap = std::numeric_limits<double>::infinity();  ///< largest gap of the best plan so far
  /// Most poses of trees of forward motions so far: plans with many have taken seconds by then.
  std::uint64_t most_tree_poses = std::numeric_limits<std::uint64_t>::max();
  /// Most vertices of the map. What trees and slim bodies take grows with the map more than what they gain.
  std::size_t most_vertices = std::numeric_limits<std::size_t>::max();
  /// Whether what zones with speed limits add to the time counts as gap. Where it does not, the row can save little of
  /// it. Only on a roadmap of the tightest radii: it always counts where there are several.
  bool gap_counts_zones = false;
  /// At the start or the goal, obstacles end the tightest turns to both sides within this angle [rad]. 0: anywhere.
  double tight_end = 0.0;
};

/// The roadmaps on which a path is looked for.
enum class On {
  kAllRadii,  ///< those of PlannerOptions::radii
  kTightest   ///< those of tightest_radii
};

// What a row does: each with the numbers that it takes.

/// Joins both ends to the roadmap by their own turn circles: ForwardSearch::join_by_single_arcs.
struct JoinBySingleArcs {
  On on;
  std::size_t end_radii;  ///< number of radii of these circles, from the smallest on
};
/// Does so on the roadmap of the tightest radii, for a path that is there soon: it is the answer if the time is up
/// before another one is found, and is not refined.
struct FindSoon {
  std::size_t end_radii;
  double suboptimality;  ///< of the search, see SearchOptions
};
/// Joins both ends to the roadmap with circles in narrow gaps.
struct JoinByNarrowPlaces {
  On on;
};
/// Joins the end that is in trouble by short maneuvers.
struct JoinByManeuvers {
  On on;
  ManeuverEffort effort;
};
/// Joins the ends by maneuvers to the roadmap with circles in narrow gaps.
struct JoinByManeuversAndNarrowPlaces {
  On on;
  std::size_t poses;  ///< at each end
};
/// Looks for a proof that the widest route is too narrow for the body: BottleneckFinder.
struct ProveBottleneck {};
/// Looks for a proof that an end is a dead end without reversing: find_dead_end.
struct ProveDeadEnd {
  DeadEndEffort effort;
};
/// Looks for a proof that an end is enclosed, in both gears: find_enclosure.
struct ProveEnclosure {
  std::size_t boxes;
};
/// Grows trees of forward motions from both ends, on the roadmap of all radii: search_trees.
struct GrowTrees {
  double share;  ///< of PlanLimits::tree_poses
  std::span<const TreePass> passes;
  bool explores_surroundings = false;  ///< of the ends, where a tree runs dry: kSurroundingsEffort
  bool only_in_the_open = false;       ///< not if the trees before found an end in a dead end
  std::uint32_t shortenings = 10;      ///< trials of shortening the path, as a multiple of those of refinement
};
/// When trees of a slimmer body are worth it, as trees before found.
enum class WhenSlim {
  kUnlessClosed,    ///< unless an end of the real body is closed in
  kClosedOrRefused  ///< if an end is, or paths of a slimmer body could not be pushed free
};
/// Grows trees of a slimmer body, and pushes their paths off what the real body touches: SlimMaps, push_free.
struct GrowSlimTrees {
  std::size_t body = 0;  ///< of kSlimBodies
  std::span<const TreePass> passes;
  WhenSlim when = WhenSlim::kUnlessClosed;
  std::size_t shortening = 2000;   ///< trials of shortening a path before it is pushed
  std::uint32_t shortenings = 10;  ///< of the free path, as for GrowTrees
  /// A free path that is slower than the best one, at first, by more than this share is dropped.
  double slower = std::numeric_limits<double>::infinity();
};
/// Raises the lower bound by the length of the way around the obstacles.
struct RaiseLowerBound {};
/// Looks for a faster path along the fastest routes of a point through zones that limit the speed: ZoneRoutes. The
/// vehicle passes the places at which a route bends, and refinement moves them.
struct FollowZoneRoutes {
  std::span<const double> slower;  ///< routes to try: factors by which the zones count as slower, from 1 on
  double least_gain;               ///< of a route's time, as a share of that of the best path
  double unrefined;                ///< a path that takes longer than the best one by this share is not refined
};
/// Looks for a path through and around one-way zones in the open: OneWayRoutes. The vehicle passes the places of a
/// route, and refinement moves them.
struct FollowOneWayRoutes {
  std::uint32_t most;         ///< routes to try; each but the first leaves out a line along which no path was found
  std::uint32_t shortenings;  ///< as for GrowTrees
};
/// Looks for a faster path with maneuvers at both ends, on the roadmap in use.
struct TryManeuvers {
  std::uint32_t poses;  ///< at each end, sparse
  double least_gain;    ///< in a share of the travel time
};
/// Looks for a faster path on the roadmap in use with circles in narrow gaps.
struct TryNarrowPlaces {
  double least_gain;
};
/// Looks for a path that leaves the roadmap for the goal by another circle than the fastest one.
struct TryOtherLastCircle {
  double slower;  ///< before refinement, by at most this share
};
/// Looks for a path that joins the roadmap by another circle than the fastest one.
struct TryOtherFirstCircle {
  double slower;  ///< before refinement, by at most this share
};
/// Looks for the fastest path, on the roadmap in use, of a vehicle with other turning speeds: it may be the faster one
/// once refined.
struct TryOtherTurns {
  double factor;  ///< of the lateral acceleration
};
/// Looks for the fastest path, on a roadmap of its own, of a vehicle with other turning speeds and fewer radii. Turns
/// that are refined take about as long as those of that vehicle.
struct TryOtherRadii {
  std::size_t radii;  ///< the first so many, at most all
  double factor;      ///< of the lateral acceleration
  double slower;      ///< than the best path so far, at most this share, for that vehicle
};
/// Looks for paths that pass an obstacle of the best one on its other side: each search leaves out one of its turns.
/// Where a path of another way becomes the best one, its turns follow.
struct TryOtherSides {
  std::size_t radii;   ///< as for TryOtherRadii, with a map of one of these
  double factor;       ///< of the lateral acceleration
  double slower;       ///< than the best path so far, at most this share, for that vehicle
  std::uint32_t most;  ///< number of searches
};
/// Refines the best path further, once. So is the second best one if it costs more by at most a share: it may be the
/// cheaper one then.
struct RefineBest {
  double close;
  /// Gap from which on the best path of a whole query is driven in fewer arcs before that: see JoinArcs.
  double fewer_arcs_gap = std::numeric_limits<double>::infinity();
};
/// Drives the best path in fewer arcs, and refines it then, at length too: ArcJoiner.
struct JoinArcs {};
/// Looks for a path on the roadmap that is driven backwards all the way.
struct JoinBackwards {};
/// Fewer attachments, where trees in both gears have found the only path, and on maps of more vertices.
struct FewGearAttachments {
  GearAttachments attachments;
  std::size_t vertices;
};
/// Looks for a path on the roadmap with changes of gear near both ends.
struct JoinBetweenGears {
  GearAttachments attachments;
  std::optional<FewGearAttachments> few = {};
};
/// Grows trees of motions in both gears: search_gears.
struct GrowGearTrees {
  std::size_t poses;  ///< of both ends together
};
/// Grows trees in both gears for narrow places: search_narrow_gears.
struct GrowNarrowGearTrees {
  std::size_t poses;
};
/// Grows trees in both gears for narrow places, of slimmer bodies one after the other: SlimMaps. Their paths are
/// refined for the slim body, where words are free more often, and pushed off what the real body touches: push_free.
/// Ends with the first one that gets free.
struct GrowSlimGearTrees {
  std::size_t poses;  ///< of both ends together, for each body
  double slower;      ///< than the best path, at most this share; before refinement, or `again` behind it
  /// Where they were grown before and found none, or the first path is one of a narrow place: for one that costs less
  /// than the refined one does. Nowhere else.
  bool again = false;
  double rest_weight = kRestWeight;  ///< see GearSearchOptions
};
/// Looks for paths of other ways, driven forwards: trees keep off those so far, see RouteQuery. In each round, trees of
/// the first slim body and of the body grow as those of GrowSlimTrees and GrowTrees do. A kind that found no path of a
/// new cost in the round before is left out.
struct TryOtherWays {
  std::span<const TreePass> passes;
  std::size_t rounds;         ///< the best path is avoided once more in each
  std::uint32_t shortenings;  ///< as for GrowTrees
  double slower;              ///< as for GrowSlimTrees
};
/// Looks for paths of other ways in both gears: narrow trees of a slim body keep off those so far. As TryOtherWays.
struct TryOtherWaysInBothGears {
  std::size_t poses;   ///< of both ends together, in each round
  std::size_t rounds;  ///< as for TryOtherWays
  double slower;       ///< than the best path, at most this share, before refinement
};
/// Plans for a body that is narrower by kSlimPlan, by the rows of When::slim_body alone, and pushes its path off what
/// the real body touches: SlimPlannerMaps, push_free. The real body may fit through gaps where no circle of its roadmap
/// does.
struct PlanSlimBody {
  double slower;  ///< before refinement, than the best path, at most this share
  /// Share of the poses of trees of forward motions where there are several radii and no trees have grown before. These
  /// trees do not join the roadmap.
  double first_tree_share = 1.0;
};
/// Refines the cheapest path of the rows in both gears. That is done at the end of the strategy in any case.
struct RefineBothGears {};
/// A part of a path, in shares of its travel time.
struct PathPart {
  double begin, end;
};
/// Plans parts of the best path again, each between the joints next to its ends, with the speeds there: short ways are
/// found more easily. It does so where a path was found by trees of a slim body, or by those in both gears for narrow
/// places, as such paths are seldom the fastest. It also does so far from the lower bound, where single arcs of few
/// radii did not find the first path.
struct PlanParts {
  std::span<const PathPart> parts;  ///< in order; each is one of the best path by then
  std::size_t forward_parts;        ///< so many of them, the first ones, where the vehicle may not reverse
  double gap;                       ///< least gap of a part, and of the best path
  double forwards_gap;              ///< least gap of the best path elsewhere, driven forwards
  double both_gears_gap;            ///< the same where the vehicle may reverse
  double tree_share;                ///< of PlanLimits::tree_poses
  std::size_t most_failed;          ///< number of parts in a row that bring nothing
};
/// Plans parts of the best path again, by the rows of When::quick_parts alone: some milliseconds for each part. Turns
/// that were optimized join the roadmap at other places than those around vertices, and so other ways are found. None
/// on maps of more than PlanMaps::kNarrowVertices vertices.
struct PlanPartsQuickly {
  std::span<const PathPart> parts;  ///< in order; each is one of the best path by then
  double gap;                       ///< least gap of a part
  std::size_t most_failed;          ///< number of parts in a row that bring nothing
  double slower = 0.2;              ///< before refinement, than the part so far, at most this share
  double worth_length = 0.02;       ///< refined at length if it is slower by at most this share
};

using Step =
    std::variant<JoinBySingleArcs, FindSoon, JoinByNarrowPlaces, JoinByManeuvers, JoinByManeuversAndNarrowPlaces,
                 ProveBottleneck, ProveDeadEnd, ProveEnclosure, GrowTrees, GrowSlimTrees, RaiseLowerBound,
                 FollowZoneRoutes, FollowOneWayRoutes, TryManeuvers, TryNarrowPlaces, TryOtherLastCircle,
                 TryOtherFirstCircle, TryOtherTurns, TryOtherRadii, TryOtherSides, RefineBest, JoinArcs, JoinBackwards,
                 JoinBetweenGears, GrowGearTrees, GrowNarrowGearTrees, GrowSlimGearTrees, TryOtherWays,
                 TryOtherWaysInBothGears, PlanSlimBody, RefineBothGears, PlanParts, PlanPartsQuickly>;

/// Trials of refinement for a path that a row finds, as a multiple of RefineOptions::max_trials.
struct Trials {
  double tightest = 1.0;  ///< on a roadmap of the tightest radii
  double several = 1.0;   ///< where there are more
};

struct StrategyRow {
  std::string_view name;  ///< rows of one name are left out together
  When when;
  Step step;
  Trials trials = {};
};

}  // namespace arcway::internal
