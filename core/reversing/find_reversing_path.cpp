#include "core/reversing/find_reversing_path.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/collision/motion_free.h"
#include "core/motion/speed_profile.h"
#include "core/motion/travel_time_lower_bound.h"
#include "core/reversing/gear_search.h"
#include "core/reversing/gear_tree.h"
#include "core/reversing/narrow_gear_search.h"

namespace arcway::internal {

namespace {

// Poses of both ends that are tried all the way: where a path is known, and where none is.
constexpr std::size_t kPosesBeside = 1500, kPosesAlone = 2000;
constexpr std::size_t kNarrowPoses = 24000;  // then, by trees for narrow places
// Then for a path that is cheaper than that of those trees, which knows little of cost. It is in 6 of 44 driven worlds.
constexpr std::size_t kPosesBehindNarrow = 16000;
// And last, where there is none: two of 144 driven worlds, seeds 7 and 8 of the benchmark, need more than 10,000.
constexpr std::size_t kPosesLast = 40000;

// Poses by which one end joins the graph, beside its own.
struct Attachments {
  double cells;  // of their grid, in a turning radius
  std::size_t most, most_expansions;
};
// The way out of a narrow place, and places to turn further away.
constexpr Attachments kDense{8.0, 24, 100}, kSparse{2.0, 99, 1000};
// Those are tried where a path may be dearer than the cheapest one by more than this share.
constexpr double kSparseGap = 0.2;

class Finder {
 public:
  Finder(const Roadmap& map, const ReversingQuery& query, const SearchOptions& options, SearchWorkspace& workspace,
         FoundPath& found)
      : map_(map),
        query_(query),
        options_(options),
        workspace_(workspace),
        found_(found),
        search_(found.search),
        cost_(query.cutoff) {}

  void run() {
    const Attachments none{};
    join_graph(none, Gear::kReverse);
    join_graph(kDense);
    search_all_the_way();
    if (cost_ > (1.0 + kSparseGap) * least_cost(query_.start, query_.goal, query_.distance)) join_graph(kSparse);
  }

 private:
  void join_graph(const Attachments& wanted) {
    for (const Gear gear : {Gear::kForward, Gear::kReverse}) join_graph(wanted, gear);
  }

  // By the graph, driven forwards or backwards, with motions in both gears at both ends. What is driven backwards from
  // one pose to another is driven forwards the other way.
  void join_graph(const Attachments& wanted, Gear gear) {
    if (search_.interrupted) return;
    const bool forward = gear == Gear::kForward;
    const auto starts = attachments(forward ? query_.start : query_.goal, Direction::kFromStart, wanted, gear);
    const auto goals = attachments(forward ? query_.goal : query_.start, Direction::kToGoal, wanted, gear);
    // The ends themselves have been joined before.
    if (wanted.most > 0 && starts.size() + goals.size() == 2) return;
    if (join(starts, goals, gear)) return;
    // Each end alone changes gear seldom enough.
    join(starts, std::span(goals).first(1), gear);
    join(std::span(starts).first(1), goals, gear);
  }

  // Whether the cheapest path, if any, changes gear seldom enough.
  bool join(std::span<const Attachment> starts, std::span<const Attachment> goals, Gear gear) {
    SearchOptions options = options_;
    options.gear = gear;
    options.faster_than = cost_;
    SearchResult joined = search_arrivals(map_, starts, goals, options, workspace_);
    search_.nodes_expanded += joined.nodes_expanded;
    search_.nodes_pushed += joined.nodes_pushed;
    count(joined.straights_checked, joined.turns_checked, starts.size() + goals.size(), joined.interrupted);
    return !joined.path || offer(gear == Gear::kForward ? *joined.path : reversed(*joined.path));
  }

  // Poses from which the graph is entered forwards behind a motion backwards, or the other way round for the goal; the
  // end itself first.
  std::vector<Attachment> attachments(const Pose& end, Direction direction, const Attachments& wanted,
                                      Gear gear) const {
    std::vector<Attachment> found{{end, {}}};
    if (wanted.most == 0) return found;
    const bool from_start = direction == Direction::kFromStart;
    const bool swapped = from_start != (gear == Gear::kForward);  // a goal's tree is driven the other way
    const Vehicle& vehicle = map_.vehicle;
    GearTree tree(end, swapped ? vehicle.with_gears_swapped() : vehicle, *map_.outlines, options_.cusp_cost,
                  {wanted.cells, true}, [](const Pose&) { return 0.0; });
    const Pose& other = from_start == (gear == Gear::kForward) ? query_.goal : query_.start;
    for (std::size_t i = 0; i < wanted.most_expansions && found.size() <= wanted.most; ++i) {
      if (options_.interrupted()) break;
      const auto node = tree.expand();
      if (!node) break;
      const GearTree::Node& reached = tree[*node];
      if (*node == GearTree::kRoot || reached.motion.gear != (from_start ? Gear::kReverse : Gear::kForward)) continue;
      Path connection = from_start ? tree.path_from_root(*node) : tree.path_to_root(*node);
      if (cusps_of(connection) >= query_.max_cusps) continue;  // where it ends the gear changes once more
      // The vehicle stops there, and what it has come is all that the way on is shorter by.
      const double way = query_.distance - length_of(connection);
      if (reached.cost + options_.cusp_cost + least_cost(reached.pose, other, way) >= cost_) continue;
      if (!motion_free(*map_.queries.sweep, map_.body, connection)) continue;
      found.push_back({reached.pose, std::move(connection)});
    }
    return found;
  }

  // From rest to rest by a way of at least this length.
  [[nodiscard]] double least_cost(const Pose& from, const Pose& to, double way) const {
    const double straight = (to.position() - from.position()).norm();
    return travel_time_lower_bound(from, to, std::max(way, straight), map_.vehicle, true);
  }

  void search_all_the_way() {
    if (std::isfinite(cost_)) return search_gears_with(kPosesBeside);
    search_gears_with(kPosesAlone);
    if (search_.path || search_.interrupted) return;
    offer(search_narrow_gears(map_, query_.start, query_.goal, gear_options(kNarrowPoses)));
    search_gears_with(search_.path ? kPosesBehindNarrow : kPosesLast);
  }

  void search_gears_with(std::size_t poses) {
    if (search_.interrupted) return;
    offer(search_gears(query_.start, query_.goal, map_.vehicle, *map_.queries.sweep, *map_.outlines,
                       gear_options(poses)));
  }

  [[nodiscard]] GearSearchOptions gear_options(std::size_t poses) const {
    return {.cusp_cost = options_.cusp_cost,
            .max_poses = poses,
            .cutoff = cost_,
            .max_cusps = query_.max_cusps,
            .clock = options_.clock};
  }

  void offer(const GearSearchResult& gears) {
    count(gears.straights_checked, gears.turns_checked, gears.poses, gears.interrupted);
    if (gears.path) offer(*gears.path);
  }

  void count(std::uint64_t straights, std::uint64_t turns, std::size_t poses, bool interrupted) {
    search_.straights_checked += straights;
    search_.turns_checked += turns;
    search_.interrupted = interrupted;
    found_.maneuver_poses += poses;
  }

  // Keeps the path if it is the cheapest. Returns whether it changes gear seldom enough.
  bool offer(const Path& path) {
    if (cusps_of(path) > query_.max_cusps) return false;
    const double cost = travel_cost(path, map_.vehicle, options_.cusp_cost);
    if (cost >= cost_) return true;
    search_.path = merged(path);
    cost_ = cost;
    return true;
  }

  const Roadmap& map_;
  const ReversingQuery& query_;
  const SearchOptions& options_;
  SearchWorkspace& workspace_;
  FoundPath& found_;
  SearchResult& search_;
  double cost_;  // of the best path so far
};

}  // namespace

FoundPath find_reversing_path(const Roadmap& map, const ReversingQuery& query, const SearchOptions& options,
                              SearchWorkspace& workspace) {
  FoundPath found;
  Finder(map, query, options, workspace, found).run();
  return found;
}

}  // namespace arcway::internal
