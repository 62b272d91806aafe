#include "core/reversing/reversing_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/attach/fast_attachments.h"
#include "core/collision/motion_free.h"
#include "core/collision/path_cost.h"
#include "core/motion/speed_profile.h"
#include "core/motion/travel_time_lower_bound.h"
#include "core/reversing/gear_tree.h"
#include "core/reversing/narrow_gear_search.h"

namespace arcway::internal {

namespace {

// The way between an end and a stop, in the gear of its speed.
// @param map  for that gear.
std::optional<Attachment> way_to_stop_of(const Roadmap& map, const Pose& end, Direction direction, double speed) {
  if (speed >= 0.0) return way_to_stop({map, map.vehicle, end, direction, speed});
  // Backwards from a start as forwards to a goal.
  const Vehicle swapped = map.vehicle.with_gears_swapped();
  const Direction other = direction == Direction::kFromStart ? Direction::kToGoal : Direction::kFromStart;
  std::optional<Attachment> way = way_to_stop({map, swapped, end, other, -speed});
  if (way) way->connection = reversed(way->connection);
  return way;
}

}  // namespace

ReversingSearch::ReversingSearch(const Roadmap& map, const Roadmap& backwards, const ReversingQuery& query,
                                 const SearchOptions& options, ArrivalSearch& arrivals)
    : map_(map),
      backwards_(backwards),
      query_(query),
      options_(options),
      ends_(options.ends),
      start_(query.start),
      goal_(query.goal),
      arrivals_(arrivals),
      cost_(query.cutoff) {
  if (!ends_.is_moving()) return;
  options_.ends = {};
  const auto map_at = [&](double speed) -> const Roadmap& {
    return map_in(speed >= 0.0 ? Gear::kForward : Gear::kReverse);
  };
  const auto from = way_to_stop_of(map_at(ends_.start), start_, Direction::kFromStart, ends_.start);
  const auto to = way_to_stop_of(map_at(ends_.goal), goal_, Direction::kToGoal, ends_.goal);
  has_stops_ = from && to && from->pose != to->pose;
  if (!has_stops_) return;
  query_.start = from->pose;
  query_.goal = to->pose;
  before_ = from->connection;
  after_ = to->connection;
  query_.distance = std::max(0.0, query.distance - length_of(before_) - length_of(after_));
}

FoundPath ReversingSearch::join_backwards() {
  FoundPath found;
  if (ends_.start > 0.0 || ends_.goal > 0.0) return found;
  SearchOptions options = options_;
  options.ends = ends_.reversed();
  options.gear = Gear::kReverse;
  options.faster_than = cost_;
  const auto starts = end_alone(Direction::kFromStart), goals = end_alone(Direction::kToGoal);
  if (const std::optional<Path> path = search(starts, goals, options, found)) offer(*path);
  return found;
}

// The tree of one end, for the paths of both gears: the poses that it expanded, in their order.
class ReversingSearch::EndTree {
 public:
  EndTree(const Pose& end, const Vehicle& vehicle, const Outlines& outlines, const GearTreeOptions& options)
      : tree_(end, vehicle, outlines, options, [](const Pose&) { return 0.0; }) {}

  // The i-th pose that is expanded; nothing if there are fewer. Asked for one after the other.
  std::optional<std::uint32_t> expanded(std::size_t i) {
    if (i == expanded_.size()) expanded_.push_back(tree_.expand());
    return expanded_[i];
  }
  [[nodiscard]] const GearTree& tree() const { return tree_; }

 private:
  GearTree tree_;
  std::vector<std::optional<std::uint32_t>> expanded_;
};

struct ReversingSearch::EndTrees {
  EndTree start, goal;
};

FoundPath ReversingSearch::join_between(const GearAttachments& wanted) {
  FoundPath found;
  if (!has_stops_) return found;
  EndTrees trees{end_tree(true, wanted), end_tree(false, wanted)};
  for (const Gear gear : {Gear::kForward, Gear::kReverse}) join(wanted, gear, trees, found);
  return found;
}

// Motions of a goal's tree are driven in the opposite sense.
ReversingSearch::EndTree ReversingSearch::end_tree(bool at_start, const GearAttachments& wanted) const {
  const Vehicle& vehicle = map_.vehicle;
  return {at_start ? query_.start : query_.goal,
          at_start ? vehicle : vehicle.with_gears_swapped(),
          *map_.outlines,
          {.cells = wanted.cells,
           .halves = true,
           .cusp_cost = options_.cusp_cost,
           .one_way_zones = map_.one_way_zones.get(),
           .forwards = at_start ? Gear::kForward : Gear::kReverse}};
}

// A path driven backwards is searched as one driven forwards from goal to start.
void ReversingSearch::join(const GearAttachments& wanted, Gear gear, EndTrees& trees, FoundPath& found) {
  if (found.search.interrupted) return;
  const bool is_forward = gear == Gear::kForward;
  const auto starts = attachments(Direction::kFromStart, wanted, gear, is_forward ? trees.start : trees.goal);
  const auto goals = attachments(Direction::kToGoal, wanted, gear, is_forward ? trees.goal : trees.start);
  const bool are_ends = starts.size() + goals.size() == 2;  // the ends alone have been joined before
  if (wanted.most > 0 && are_ends) return;
  if (join(starts, goals, gear, found)) return;
  // Each end alone changes gear seldom enough.
  join(starts, std::span(goals).first(1), gear, found);
  join(std::span(starts).first(1), goals, gear, found);
}

bool ReversingSearch::join(std::span<const Attachment> starts, std::span<const Attachment> goals, Gear gear,
                           FoundPath& found) {
  SearchOptions options = options_;
  options.gear = gear;
  options.faster_than = cost_;
  const std::optional<Path> path = search(starts, goals, options, found);
  return !path || offer(between_stops(*path));
}

std::optional<Path> ReversingSearch::search(std::span<const Attachment> starts, std::span<const Attachment> goals,
                                            const SearchOptions& options, FoundPath& found) {
  SearchResult joined = arrivals_.find(map_in(options.gear), starts, goals, options);
  found.search.counts += joined.counts;
  found.search.interrupted = joined.interrupted;
  found.maneuver_poses += starts.size() + goals.size();
  if (joined.path && options.gear == Gear::kReverse) *joined.path = reversed(*joined.path);
  return joined.path;
}

std::vector<Attachment> ReversingSearch::end_alone(Direction direction) const {
  const bool from_start = direction == Direction::kFromStart;
  const Pose& end = from_start ? goal_ : start_;
  const EndSpeeds ends = ends_.reversed();
  const Vehicle vehicle = map_.vehicle.with_gears_swapped();
  std::vector<Attachment> fast =
      fast_attachments({backwards_, vehicle, end, direction, from_start ? ends.start : ends.goal});
  if (fast.empty()) fast.push_back({end, {}});
  return fast;
}

Path ReversingSearch::between_stops(const Path& path) const {
  Path whole = before_;
  whole.insert(whole.end(), path.begin(), path.end());
  whole.insert(whole.end(), after_.begin(), after_.end());
  return whole;
}

// The end itself, then poses that a motion in the other gear reaches from it.
std::vector<Attachment> ReversingSearch::attachments(Direction direction, const GearAttachments& wanted, Gear gear,
                                                     EndTree& trees) const {
  const bool from_start = direction == Direction::kFromStart;
  const bool at_start = from_start == (gear == Gear::kForward);
  const Pose& other = at_start ? query_.goal : query_.start;
  std::vector<Attachment> found{{at_start ? query_.start : query_.goal, {}}};
  if (wanted.most == 0) return found;
  const GearTree& tree = trees.tree();
  for (std::size_t i = 0; i < wanted.most_expansions && found.size() <= wanted.most; ++i) {
    if (options_.interrupted()) break;
    const auto node = trees.expanded(i);
    if (!node) break;
    const GearTree::Node& reached = tree[*node];
    if (*node == GearTree::kRoot || reached.motion.gear != (from_start ? Gear::kReverse : Gear::kForward)) continue;
    Path connection = from_start ? tree.path_from_root(*node) : tree.path_to_root(*node);
    if (cusps_of(connection) >= query_.max_cusps) continue;  // the gear changes once more at its end
    // The vehicle stops at its end. The rest of the path is shorter by the length of the connection at most.
    const double rest = query_.distance - length_of(connection);
    if (reached.cost + options_.cusp_cost + least_cost(reached.pose, other, rest) >= cost_) continue;
    if (!motion_free(*map_in(gear).queries.sweep, map_.body, connection)) continue;
    found.push_back({reached.pose, std::move(connection)});
  }
  return found;
}

double ReversingSearch::least_cost(const Pose& from, const Pose& to, double length) const {
  const double straight = (to.position() - from.position()).norm();
  return travel_time_lower_bound(from, to, std::max(length, straight), map_.vehicle, true);
}

FoundPath ReversingSearch::grow_gear_trees(std::size_t poses) {
  if (!has_stops_) return {};
  return taken(search_gears(
      {query_.start, query_.goal, map_.vehicle, *map_.queries.sweep, *map_.outlines, map_.one_way_zones.get()},
      gear_options(poses)));
}

FoundPath ReversingSearch::grow_narrow_gear_trees(std::size_t poses) {
  if (!has_stops_) return {};
  return taken(search_narrow_gears(map_, query_.start, query_.goal, gear_options(poses)));
}

FoundPath ReversingSearch::grow_slim_gear_trees(const SlimTrees& slim, const Widen& widened) {
  if (!has_stops_) return {};
  GearSearchOptions options = gear_options(slim.poses);
  options.cutoff = slim.most;
  options.rest_weight = slim.rest_weight;
  options.avoided = slim.avoided;
  GearSearchResult grown = search_narrow_gears(slim.map, query_.start, query_.goal, options);
  if (grown.path) grown.path = widened(*grown.path, query_.goal);
  return taken(grown);
}

GearSearchOptions ReversingSearch::gear_options(std::size_t poses) const {
  return {.cusp_cost = options_.cusp_cost,
          .max_poses = poses,
          .cutoff = cost_,
          .max_cusps = query_.max_cusps,
          .clock = options_.clock,
          .speed_zones = map_.speed_zones.get(),
          .clearance_cost = map_.clearance_cost.get()};
}

FoundPath ReversingSearch::taken(const GearSearchResult& gears) {
  FoundPath found;
  found.search.counts.straights_checked = gears.straights_checked;
  found.search.counts.turns_checked = gears.turns_checked;
  found.search.interrupted = gears.interrupted;
  found.maneuver_poses = gears.poses;
  if (gears.path) offer(between_stops(*gears.path));
  return found;
}

bool ReversingSearch::offer(const Path& path) {
  if (cusps_of(path) > query_.max_cusps) return false;
  SpeedProfile profile;
  const double cost = path_cost(
      path, map_.vehicle, {ends_, map_.speed_zones.get(), map_.clearance_cost.get(), options_.cusp_cost}, profile);
  if (cost >= cost_) return true;
  path_ = merged(path);
  ++found_;
  cost_ = cost;
  return true;
}

}  // namespace arcway::internal
