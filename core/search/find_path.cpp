#include "core/search/find_path.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/geometry/angle.h"
#include "core/search/manoeuvres.h"

namespace arcway {

namespace {

constexpr std::size_t kFirstPoses = 100;
constexpr std::size_t kSparseFactor = 4;

// One end of a path and the poses by which it may join the graph.
class End {
 public:
  End(const SearchMap& map, const Pose& pose, Direction direction, std::size_t max_poses)
      : map_(map), pose_(pose), direction_(direction), max_poses_(max_poses), terminals_{{pose, {}}} {}

  [[nodiscard]] std::span<const Terminal> terminals() const { return terminals_; }
  // More poses than before; false if there are no more.
  bool extend() {
    if (terminals_.size() < asked_ || asked_ >= max_poses_) return false;
    find(asked_ == 0 ? std::min(max_poses_, kFirstPoses) : max_poses_, Spread::kDense);
    return terminals_.size() > 1;
  }
  // More poses, in the end sparse ones.
  bool extend_far() {
    if (extend()) return true;
    if (terminals_.size() < asked_ || asked_ > max_poses_ || max_poses_ == 0) return false;
    find(kSparseFactor * max_poses_, Spread::kSparse);
    return terminals_.size() > 1;
  }

 private:
  void find(std::size_t poses, Spread spread) {
    asked_ = poses;
    terminals_ = find_manoeuvres(pose_, direction_, map_.vehicle, map_.radii[0], *map_.queries.sweep, poses, spread);
  }

  const SearchMap& map_;
  Pose pose_;
  Direction direction_;
  std::size_t max_poses_;
  std::size_t asked_ = 0;
  std::vector<Terminal> terminals_;
};

}  // namespace

FoundPath find_path(const SearchMap& map, const Pose& start, const Pose& goal, std::size_t max_poses,
                    const std::function<bool()>& no_passage, const SearchOptions& options, SearchWorkspace& workspace) {
  FoundPath found;
  if ((start.position() - goal.position()).isZero(0.0) && wrap_signed(start.heading - goal.heading) == 0.0) {
    found.search.path = Path{};
    return found;
  }
  End from(map, start, Direction::kFromStart, max_poses);
  End to(map, goal, Direction::kToGoal, max_poses);
  for (bool more = true; more;) {
    SearchResult result = search_arrivals(map, from.terminals(), to.terminals(), options, workspace);
    result.nodes_expanded += found.search.nodes_expanded;
    result.nodes_pushed += found.search.nodes_pushed;
    result.straights_checked += found.search.straights_checked;
    result.turns_checked += found.search.turns_checked;
    found.search = std::move(result);
    if (found.search.path || found.search.interrupted) return found;
    if (found.obstruction == Obstruction::kNothing && no_passage()) {
      found.obstruction = Obstruction::kPassage;
      return found;
    }
    if (!found.search.goal_connected) {
      found.obstruction = Obstruction::kGoal;
      more = to.extend();
      found.manoeuvre_poses += to.terminals().size();
    } else if (!found.search.start_connected) {
      found.obstruction = Obstruction::kStart;
      more = from.extend();
      found.manoeuvre_poses += from.terminals().size();
    } else {
      found.obstruction = Obstruction::kBetween;
      // Who gets everywhere but to the goal is not helped by other ways to set out.
      const bool more_starts = !found.search.start_is_open && from.extend_far();
      const bool more_goals = to.extend_far();
      more = more_starts || more_goals;
      found.manoeuvre_poses += from.terminals().size() + to.terminals().size();
    }
  }
  return found;
}

FoundPath find_path_with_manoeuvres(const SearchMap& map, const Pose& start, const Pose& goal, std::size_t poses,
                                    const SearchOptions& options, SearchWorkspace& workspace) {
  const auto terminals = [&](const Pose& pose, Direction direction) {
    return find_manoeuvres(pose, direction, map.vehicle, map.radii[0], *map.queries.sweep, poses, Spread::kSparse);
  };
  const std::vector<Terminal> from = terminals(start, Direction::kFromStart);
  const std::vector<Terminal> to = terminals(goal, Direction::kToGoal);
  FoundPath found;
  found.search = search_arrivals(map, from, to, options, workspace);
  found.manoeuvre_poses = from.size() + to.size();
  return found;
}

}  // namespace arcway
