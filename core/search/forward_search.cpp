#include "core/search/forward_search.h"

#include <algorithm>
#include <utility>

#include "arcway/angle.h"

namespace arcway::internal {

namespace {

MovingEnd start_of(const Roadmap& map, const ForwardSearch::Query& query, const SearchOptions& options) {
  return {map, map.vehicle, query.start, Direction::kFromStart, options.ends.start};
}
MovingEnd goal_of(const Roadmap& map, const ForwardSearch::Query& query, const SearchOptions& options) {
  return {map, map.vehicle, query.goal, Direction::kToGoal, options.ends.goal};
}

}  // namespace

EndAttachments::EndAttachments(const MovingEnd& end, ManeuverSearch& maneuvers, const StopClock& clock)
    : map_(end.map),
      direction_(end.direction),
      maneuvers_(maneuvers),
      clock_(clock),
      plain_{end.pose, {}},
      all_(&plain_, 1) {
  if (end.speed > 0.0) fast_ = fast_attachments(end);
  if (!fast_.empty()) all_ = fast_;
}

std::size_t EndAttachments::find(const ManeuverPoses& poses) {
  const ManeuveringBody body(map_.vehicle, map_.radii[0], *map_.queries.sweep);
  const std::span<const Attachment> found = maneuvers_.find(plain_.pose, direction_, body, poses, clock_);
  all_ = found;
  if (!fast_.empty()) {
    joined_ = fast_;
    joined_.insert(joined_.end(), found.begin() + 1, found.end());
    all_ = joined_;
  }
  return found.size();
}

bool ForwardSearch::End::extend(std::size_t first, std::size_t most) {
  if (found_ < asked_ || asked_ >= most) return false;
  find(asked_ == 0 ? std::min(most, first) : most, Spread::kDense);
  return found_ > 1;
}

bool ForwardSearch::End::extend_far(const ManeuverEffort& effort, std::size_t most) {
  if (extend(effort.first, most)) return true;
  if (found_ < asked_ || asked_ > most || most == 0) return false;
  find(effort.sparse_factor * most, Spread::kSparse);
  return found_ > 1;
}

void ForwardSearch::End::find(std::size_t poses, Spread spread) {
  asked_ = poses;
  found_ = all_.find({poses, spread});
}

ForwardSearch::ForwardSearch(const Roadmap& map, const NarrowPlaces* places, const Query& query,
                             const SearchOptions& options, FindWorkspace& workspace)
    : map_(map),
      places_(places),
      query_(query),
      options_(options),
      workspace_(workspace),
      from_(start_of(map, query, options_), workspace.from, options_.clock),
      to_(goal_of(map, query, options_), workspace.to, options_.clock) {}

bool ForwardSearch::search(const Roadmap& on, const End& from, const End& to, FoundPath& found) {
  SearchResult result = workspace_.search.find(on, from.attachments(), to.attachments(), options_);
  options_.warm_start = true;
  const bool is_plain = &on == &map_;
  if (is_plain) {
    start_connected_ = result.start_connected;
    goal_connected_ = result.goal_connected;
    start_is_open_ = result.start_is_open;
  }
  used_narrow_places_ = !is_plain;
  result.counts += found.search.counts;
  found.search = std::move(result);
  return found.search.path || found.search.interrupted;
}

const Roadmap* ForwardSearch::narrow_map() const {
  if (!places_) return nullptr;
  const Roadmap& narrow = places_->map(options_.clock);
  return &narrow == &map_ ? nullptr : &narrow;
}

FoundPath ForwardSearch::join_by_single_arcs(std::size_t radii, double suboptimality) {
  FoundPath found;
  const bool is_there = (query_.start.position() - query_.goal.position()).isZero(0.0) &&
                        wrap_signed(query_.start.heading - query_.goal.heading) == 0.0 &&
                        options_.ends.start == options_.ends.goal;
  if (is_there) {
    found.search.path = Path{};
  } else {
    options_.warm_start = false;  // fewer circles may have been reached before
    const double usual = std::exchange(options_.suboptimality, suboptimality);
    options_.end_radii = radii;
    search(map_, from_, to_, found);
    options_.end_radii = kEveryRadius;
    options_.suboptimality = usual;
  }
  return found;
}

FoundPath ForwardSearch::join_by_narrow_places() {
  FoundPath found;
  if (const Roadmap* narrow = narrow_map()) search(*narrow, from_, to_, found);
  return found;
}

bool ForwardSearch::extend(const ManeuverEffort& effort, FoundPath& found) {
  switch (obstruction()) {
    case Obstruction::kGoal: {
      const bool more = to_.extend(effort.first, query_.most_poses);
      found.maneuver_poses += to_.attachments().size();
      return more;
    }
    case Obstruction::kStart: {
      const bool more = from_.extend(effort.first, query_.most_poses);
      found.maneuver_poses += from_.attachments().size();
      return more;
    }
    default: {
      // If the start already reaches thousands of arcs, more start poses cannot help.
      const bool more_starts = !start_is_open_ && from_.extend_far(effort, query_.most_poses);
      const bool more_goals = to_.extend_far(effort, query_.most_poses);
      found.maneuver_poses += from_.attachments().size() + to_.attachments().size();
      return more_starts || more_goals;
    }
  }
}

FoundPath ForwardSearch::join_by_maneuvers(const ManeuverEffort& effort) {
  FoundPath found;
  while (extend(effort, found))
    if (search(map_, from_, to_, found)) break;
  return found;
}

FoundPath ForwardSearch::join_by_maneuvers_and_narrow_places(std::size_t poses) {
  FoundPath found;
  const Roadmap* narrow = query_.most_poses > 0 ? narrow_map() : nullptr;
  if (!narrow) return found;
  End from(start_of(map_, query_, options_), workspace_.from, options_.clock);
  End to(goal_of(map_, query_, options_), workspace_.to, options_.clock);
  const std::size_t most = std::min(query_.most_poses, poses);
  if (obstruction() != Obstruction::kGoal) from.extend(most, most);
  if (obstruction() != Obstruction::kStart) to.extend(most, most);
  found.maneuver_poses = from.attachments().size() + to.attachments().size();
  search(*narrow, from, to, found);
  return found;
}

Obstruction ForwardSearch::obstruction() const {
  if (!goal_connected_) return Obstruction::kGoal;
  return start_connected_ ? Obstruction::kBetween : Obstruction::kStart;
}

FoundPath find_path_with_maneuvers(const Roadmap& map, const ForwardSearch::Query& query, const SearchOptions& options,
                                   FindWorkspace& workspace) {
  const ManeuverPoses sparse{query.most_poses, Spread::kSparse};
  EndAttachments from(start_of(map, query, options), workspace.from, options.clock);
  EndAttachments to(goal_of(map, query, options), workspace.to, options.clock);
  FoundPath found;
  found.maneuver_poses = from.find(sparse) + to.find(sparse);
  found.search = workspace.search.find(map, from.all(), to.all(), options);
  return found;
}

}  // namespace arcway::internal
