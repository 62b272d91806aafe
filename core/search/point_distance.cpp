#include "core/search/point_distance.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "arcway/angle.h"
#include "arcway/visibility_graph.h"
#include "core/attach/occlusion_horizon.h"
#include "core/base/prefetch.h"
#include "core/geometry/predicates.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kNextPoints = 5;  // number of entries at the top of the open list: of its first two levels
// Number of visibility queries to the goal after which an occlusion horizon of the goal pays.
constexpr std::size_t kManyAsked = 64;

// A shortest path is taut: where it turns at a vertex, it turns around the obstacle there. Edges that leave a vertex
// otherwise are on no shortest path.
class TautTurn {
 public:
  /// @param from  a place that `vertex` is tangent to.
  TautTurn(const World& world, VertexId vertex, const Vec2& from) : from_(from), at_(world.vertex(vertex)) {
    const Vec2& next = world.vertex(world.next(vertex));
    const Vec2& previous = world.vertex(world.previous(vertex));
    const int side = from == previous ? 0 : orientation(from, at_, previous);  // 0 is the slow answer
    left_ = (side != 0 ? side : orientation(from, at_, next)) > 0;
    last_ = left_ ? &next : &previous;
  }

  // Whether a path may go on to a place that the vertex is tangent to.
  [[nodiscard]] bool leads_to(const Vec2& to) const {
    const int wrong = left_ ? -1 : 1;
    return orientation(from_, at_, to) != wrong && (to == *last_ || orientation(at_, to, *last_) != wrong);
  }

 private:
  const Vec2& from_;
  const Vec2& at_;
  bool left_;         // the obstacle's side
  const Vec2* last_;  // its vertex that a turn gets to at most
};

}  // namespace

void PointDistance::Workspace::reset(std::size_t vertices) {
  open_.clear();
  reached_.make_room(vertices);
  search_ += 2;
  if (search_ == 0) {
    reached_.clear();
    search_ = 2;
  }
}

PointDistance::Workspace::Reached& PointDistance::Workspace::at(VertexId vertex) {
  Reached& reached = reached_[vertex];
  if (reached.mark < search_) reached = {std::numeric_limits<double>::infinity(), kNone, search_};
  return reached;
}

PointDistance::PointDistance(const World& world, std::shared_ptr<const VisibilityRows> rows,
                             std::shared_ptr<const Outlines> outlines)
    : world_(world), rows_(std::move(rows)), outlines_(std::move(outlines)) {}

OcclusionHorizon PointDistance::horizon_of(const Vec2& place) const {
  OcclusionHorizon horizon({place, 0.0, Side::kLeft, kNone}, 0.0, kTwoPi);
  horizon.shorten(*outlines_);
  return horizon;
}

void PointDistance::push_from_start(const Vec2& start, const Vec2& goal, Workspace& w) const {
  const std::span<const Vec2> places = world_.vertices();
  const OcclusionHorizon horizon = horizon_of(start);
  outlines_->visit_if([&](const Box& box) { return !horizon.hides(box); },
                      [&](const Outlines::Piece& piece) {
                        for (std::size_t i = 0; i < piece.edge_count(); ++i) {
                          const auto v = static_cast<VertexId>(piece.first + i);
                          if (!world_.is_graph_vertex(v)) continue;
                          const double estimate = (places[v] - start).norm() + (goal - places[v]).norm();
                          w.open_.push({estimate, v, Workspace::Step::kFromStart});
                        }
                        return true;
                      });
}

void PointDistance::prefetch_next(const Workspace& w) const {
  for (const Workspace::Entry& next : w.open_.first_few(kNextPoints)) {
    if (next.vertex == kNone) continue;
    will_need(&world_.vertices()[next.vertex]);
    if (const Workspace::Reached* const reached = w.reached_.find(next.vertex)) will_need(reached);
    rows_->prefetch(next.vertex);
  }
}

double PointDistance::operator()(const Vec2& start, const Vec2& goal, const VisibilityQuery& visibility, Workspace& w,
                                 const StopClock& clock) const {
  using Step = Workspace::Step;
  w.reset(world_.vertices().size());
  const auto to_goal = [&](const Vec2& p) { return (goal - p).norm(); };
  const std::span<const Vec2> places = world_.vertices();
  double proved = to_goal(start);  // of the path's length, whatever comes
  if (clock.is_over()) return proved;
  std::optional<OcclusionHorizon> from_goal;
  std::size_t asked = 0;
  const auto goal_may_see = [&](const Vec2& p) {
    if (++asked == kManyAsked) from_goal = horizon_of(goal);
    return !from_goal || !from_goal->hides(Box{p, p});
  };
  w.open_.push({to_goal(start), kNone, Step::kToGoal});
  push_from_start(start, goal, w);

  while (!w.open_.empty()) {
    const Workspace::Entry entry = w.open_.pop();
    proved = std::max(proved, entry.estimate);
    if (clock.is_over()) return proved;
    prefetch_next(w);
    const Vec2& here = entry.vertex == kNone ? start : places[entry.vertex];
    if (entry.step == Step::kToGoal) {
      if (visibility.visible({here, goal})) return entry.estimate;
      continue;
    }
    Workspace::Reached& reached = w.at(entry.vertex);
    if (reached.mark != w.search_) continue;
    if (entry.step == Step::kFromStart) {
      if (!(is_tangent(world_, entry.vertex, start) && visibility.visible({start, here}))) continue;
      reached = {(here - start).norm(), kNone, w.search_};
    }
    ++reached.mark;
    const double length = reached.length;
    const TautTurn turn(world_, entry.vertex, reached.parent == kNone ? start : places[reached.parent]);
    if (turn.leads_to(goal) && is_tangent(world_, entry.vertex, goal) && goal_may_see(here))
      w.open_.push({length + to_goal(here), entry.vertex, Step::kToGoal});
    const std::span<const VertexId> row = rows_->of(entry.vertex);
    for (const VertexId v : row) will_need(&places[v]);
    for (const VertexId v : row) {
      const Vec2& there = places[v];
      if (!turn.leads_to(there)) continue;
      const double length_there = length + (there - here).norm();
      Workspace::Reached& next = w.at(v);
      if (next.length <= length_there) continue;
      next.length = length_there;
      next.parent = entry.vertex;
      w.open_.push({length_there + to_goal(there), v, Step::kEdge});
    }
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace arcway::internal
