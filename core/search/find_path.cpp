#include "core/search/find_path.h"

#include <algorithm>
#include <span>
#include <utility>

#include "arcway/angle.h"
#include "core/attach/maneuvers.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kFirstPoses = 100;
constexpr std::size_t kSparseFactor = 4;

// One end of a path and the poses by which it may join the graph.
class End {
 public:
  End(const Roadmap& map, const Pose& pose, Direction direction, std::size_t max_poses, ManeuverWorkspace& workspace,
      const StopClock& clock)
      : map_(map),
        direction_(direction),
        max_poses_(max_poses),
        workspace_(workspace),
        clock_(clock),
        plain_{pose, {}},
        attachments_(&plain_, 1) {}

  [[nodiscard]] std::span<const Attachment> attachments() const { return attachments_; }
  // More poses than before; false if there are no more.
  bool extend() {
    if (attachments_.size() < asked_ || asked_ >= max_poses_) return false;
    find(asked_ == 0 ? std::min(max_poses_, kFirstPoses) : max_poses_, Spread::kDense);
    return attachments_.size() > 1;
  }
  // More poses, in the end sparse ones.
  bool extend_far() {
    if (extend()) return true;
    if (attachments_.size() < asked_ || asked_ > max_poses_ || max_poses_ == 0) return false;
    find(kSparseFactor * max_poses_, Spread::kSparse);
    return attachments_.size() > 1;
  }

 private:
  void find(std::size_t poses, Spread spread) {
    asked_ = poses;
    attachments_ = find_maneuvers(plain_.pose, direction_, map_.vehicle, map_.radii[0], *map_.queries.sweep, poses,
                                  spread, workspace_, clock_);
  }

  const Roadmap& map_;
  Direction direction_;
  std::size_t max_poses_;
  std::size_t asked_ = 0;
  ManeuverWorkspace& workspace_;
  const StopClock& clock_;
  Attachment plain_;
  std::span<const Attachment> attachments_;
};

}  // namespace

FoundPath find_path(const Roadmap& map, const NarrowPlaces* places, const Pose& start, const Pose& goal,
                    std::size_t max_poses, const std::function<bool()>& no_passage, const SearchOptions& options,
                    FindWorkspace& workspace) {
  FoundPath found;
  if ((start.position() - goal.position()).isZero(0.0) && wrap_signed(start.heading - goal.heading) == 0.0) {
    found.search.path = Path{};
    return found;
  }
  SearchOptions asked = options;
  // True if that ends it.
  const auto search = [&](const Roadmap& on, const End& from, const End& to) {
    SearchResult result = search_arrivals(on, from.attachments(), to.attachments(), asked, workspace.search);
    asked.warm_start = true;
    result.nodes_expanded += found.search.nodes_expanded;
    result.nodes_pushed += found.search.nodes_pushed;
    result.straights_checked += found.search.straights_checked;
    result.turns_checked += found.search.turns_checked;
    if (&on != &map) {  // what stands in the way does so in the plain map
      result.start_connected = found.search.start_connected;
      result.goal_connected = found.search.goal_connected;
      result.start_is_open = found.search.start_is_open;
    }
    found.search = std::move(result);
    found.by_narrow_places = found.search.path && &on != &map;
    return found.search.path || found.search.interrupted;
  };
  End from(map, start, Direction::kFromStart, max_poses, workspace.from, options.clock);
  End to(map, goal, Direction::kToGoal, max_poses, workspace.to, options.clock);
  // More poses for the end that is in trouble; false if there are no more.
  const auto extend = [&] {
    if (!found.search.goal_connected) {
      found.obstruction = Obstruction::kGoal;
      const bool more = to.extend();
      found.maneuver_poses += to.attachments().size();
      return more;
    }
    if (!found.search.start_connected) {
      found.obstruction = Obstruction::kStart;
      const bool more = from.extend();
      found.maneuver_poses += from.attachments().size();
      return more;
    }
    found.obstruction = Obstruction::kBetween;
    // Who gets everywhere but to the goal is not helped by other ways to set out.
    const bool more_starts = !found.search.start_is_open && from.extend_far();
    const bool more_goals = to.extend_far();
    found.maneuver_poses += from.attachments().size() + to.attachments().size();
    return more_starts || more_goals;
  };

  if (search(map, from, to)) return found;
  if (no_passage()) {
    found.obstruction = Obstruction::kPassage;
    return found;
  }
  const Roadmap& narrow = places ? places->map(options.clock) : map;
  const bool has_places = &narrow != &map;
  if (has_places && search(narrow, from, to)) return found;
  while (extend())
    if (search(map, from, to)) return found;
  if (has_places && max_poses > 0) {
    End few_from(map, start, Direction::kFromStart, std::min(max_poses, kFirstPoses), workspace.from, options.clock);
    End few_to(map, goal, Direction::kToGoal, std::min(max_poses, kFirstPoses), workspace.to, options.clock);
    if (found.obstruction != Obstruction::kGoal) few_from.extend();
    if (found.obstruction != Obstruction::kStart) few_to.extend();
    found.maneuver_poses += few_from.attachments().size() + few_to.attachments().size();
    search(narrow, few_from, few_to);
  }
  return found;
}

FoundPath find_path_with_maneuvers(const Roadmap& map, const Pose& start, const Pose& goal, std::size_t poses,
                                   const SearchOptions& options, FindWorkspace& workspace) {
  const auto attachments = [&](const Pose& pose, Direction direction, ManeuverWorkspace& memory) {
    return find_maneuvers(pose, direction, map.vehicle, map.radii[0], *map.queries.sweep, poses, Spread::kSparse,
                          memory, options.clock);
  };
  const auto from = attachments(start, Direction::kFromStart, workspace.from);
  const auto to = attachments(goal, Direction::kToGoal, workspace.to);
  FoundPath found;
  found.search = search_arrivals(map, from, to, options, workspace.search);
  found.maneuver_poses = from.size() + to.size();
  return found;
}

}  // namespace arcway::internal
