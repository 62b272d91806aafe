#include "core/bound/point_distance.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/geometry/angle.h"
#include "core/search/horizon.h"

namespace arcway {

void PointDistance::Workspace::reset(std::size_t vertices) {
  open_.clear();
  if (reached_.size() < vertices) reached_.resize(vertices, {0.0, 0, false});
  if (++search_ == 0) {
    std::fill(reached_.begin(), reached_.end(), Reached{0.0, 0, false});
    search_ = 1;
  }
}

PointDistance::Workspace::Reached& PointDistance::Workspace::at(VertexId vertex) {
  Reached& reached = reached_[vertex];
  if (reached.search != search_) reached = {std::numeric_limits<double>::infinity(), search_, false};
  return reached;
}

PointDistance::PointDistance(const World& world, std::shared_ptr<const VisibilityRows> rows,
                             std::shared_ptr<const Outlines> outlines)
    : world_(world), rows_(std::move(rows)), outlines_(std::move(outlines)) {}

double PointDistance::operator()(const Vec2& start, const Vec2& goal, const VisibilityQuery& visibility,
                                 Workspace& w) const {
  using Step = Workspace::Step;
  w.reset(world_.vertices().size());
  const auto to_goal = [&](const Vec2& p) { return (goal - p).norm(); };
  w.open_.push({to_goal(start), to_goal(start), kNone, Step::kToGoal});
  Horizon horizon({start, 0.0, Side::kLeft, kNone}, 0.0, kTwoPi);
  horizon.shorten(*outlines_);
  outlines_->visit_if([&](const Box& box) { return !horizon.hides(box); },
                      [&](const Outlines::Piece& piece) {
                        for (std::size_t i = 0; i < piece.edge_count(); ++i) {
                          const auto v = static_cast<VertexId>(piece.first + i);
                          if (!world_.is_convex(v) || world_.is_covered(v)) continue;
                          const double length = (piece.points[i] - start).norm();
                          w.open_.push({length + to_goal(piece.points[i]), length, v, Step::kFromStart});
                        }
                        return true;
                      });

  while (!w.open_.empty()) {
    const Workspace::Entry entry = w.open_.pop();
    const Vec2& here = entry.vertex == kNone ? start : world_.vertex(entry.vertex);
    if (entry.step == Step::kToGoal) {
      if (visibility.visible({here, goal})) return entry.length;
      continue;
    }
    Workspace::Reached& reached = w.at(entry.vertex);
    if (reached.closed) continue;
    if (entry.step == Step::kFromStart &&
        !(is_tangent(world_, entry.vertex, start) && visibility.visible({start, here})))
      continue;
    reached.closed = true;
    if (is_tangent(world_, entry.vertex, goal))
      w.open_.push({entry.length + to_goal(here), entry.length + to_goal(here), entry.vertex, Step::kToGoal});
    for (const VertexId v : rows_->of(entry.vertex)) {
      const double length = entry.length + (world_.vertex(v) - here).norm();
      Workspace::Reached& next = w.at(v);
      if (next.length <= length) continue;
      next.length = length;
      w.open_.push({length + to_goal(world_.vertex(v)), length, v, Step::kEdge});
    }
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace arcway
