#include "core/roadmap/circle_change.h"

#include <algorithm>

namespace arcway::internal {

namespace {

// How far a body reaches from the vertex of a circle on that circle. The body has the whole safety margin, half of
// which is more than what checks ask about, and more than rounding.
double largest_reach(const CircleChange::Circles& of, const Footprint& grown_body) {
  double largest = 0.0;
  for (const TurnCircle& circle : of.circles.all())
    largest = std::max(largest, (circle.center - of.world.vertex(circle.vertex)).norm() +
                                    swept_annulus(grown_body, circle.side, circle.radius).outer);
  return largest;
}

bool same_row(std::span<const VertexId> before, std::span<const VertexId> after, const VertexMap& map) {
  return std::ranges::equal(before, after, [&](VertexId v, VertexId now) { return map.after(v) == now; });
}

}  // namespace

NearBoxes places_of(const WorldChange& change, double reach) {
  std::vector<Box> boxes = change.removed_boxes;
  boxes.insert(boxes.end(), change.added_boxes.begin(), change.added_boxes.end());
  return NearBoxes(boxes, reach);
}

CircleChange::CircleChange(const Circles& before, const Circles& after, const WorldChange& change,
                           const Footprint& grown_body, std::uint32_t steps)
    : world_(after.world),
      before_(after.circles.all().size(), kNone),
      after_(before.circles.all().size(), kNone),
      places_(places_of(change, largest_reach(after, grown_body))),
      kept_(after.world.vertices().size(), Kept::kNothing),
      is_unchanged_around_(kept_.size(), 0) {
  const VertexMap map(change);
  match(before, after, map);
  for (const VertexId v : world_.convex_vertices())
    if (!places_.may_meet(world_.vertex(v), world_.vertex(v))) kept_[v] = Kept::kSurroundings;
  for (const VertexId v : before.world.convex_vertices()) {
    const VertexId now = map.after(v);
    if (now == kNone || kept_[now] == Kept::kNothing) continue;
    if (same_row(before.rows.of(v), after.rows.of(now), map)) kept_[now] = Kept::kRow;
  }
  find_unchanged_around(after.rows, steps);
}

void CircleChange::find_unchanged_around(const VisibilityRows& rows, std::uint32_t steps) {
  std::vector<Box> around(kept_.size());
  for (const VertexId v : world_.convex_vertices()) {
    around[v].extend(world_.vertex(v));
    is_unchanged_around_[v] = keeps_row(v) ? 1 : 0;
  }
  for (std::uint32_t step = 0; step < steps; ++step) {
    const std::vector<Box> nearer = around;
    const std::vector<std::uint8_t> nearer_unchanged = is_unchanged_around_;
    for (const VertexId v : world_.convex_vertices())
      for (const VertexId w : rows.of(v)) {
        around[v].extend(nearer[w]);
        is_unchanged_around_[v] &= nearer_unchanged[w];
      }
  }
  for (const VertexId v : world_.convex_vertices())
    if (is_unchanged_around_[v] && places_.may_meet(around[v])) is_unchanged_around_[v] = 0;
}

void CircleChange::match(const Circles& before, const Circles& after, const VertexMap& map) {
  const auto old = before.circles.all();
  const auto all = after.circles.all();
  for (std::uint32_t c = 0; c < old.size(); ++c) {
    if (!before.circles.is_used(c)) continue;
    const VertexId v = map.after(old[c].vertex);
    const VertexId second = old[c].second == kNone ? kNone : map.after(old[c].second);
    if (v == kNone || !after.circles.has(v) || (second == kNone) != (old[c].second == kNone)) continue;
    after.circles.visit_around(v, old[c].side, [&](std::uint32_t now) {
      const TurnCircle& circle = all[now];
      if (circle.vertex != v || circle.second != second || circle.radius != old[c].radius) return;
      before_[now] = c;
      after_[c] = now;
    });
  }
}

}  // namespace arcway::internal
