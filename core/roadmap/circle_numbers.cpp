#include "core/roadmap/circle_numbers.h"

#include <algorithm>
#include <span>
#include <utility>

namespace arcway::internal {

CircleNumbers::CircleNumbers(const World& world, const TurnCircles& circles)
    : convex_(world.convex_vertices().begin(), world.convex_vertices().end()) {
  const std::span<const TurnCircle> base = circles.all().first(circles.base_count());
  const auto first_pair = std::ranges::partition_point(base, [](const TurnCircle& c) { return c.second == kNone; });
  pairs_.assign(first_pair, base.end());
  if (!convex_.empty()) around_ = static_cast<std::size_t>(first_pair - base.begin()) / convex_.size();
}

std::uint32_t CircleNumbers::before(std::uint32_t circle, const TurnCircles& after, const VertexMap& map) const {
  const TurnCircle& c = after.all()[circle];
  const VertexId vertex = map.before(c.vertex);
  if (vertex == kNone) return kNone;
  if (c.second == kNone) {
    const auto at = std::ranges::lower_bound(convex_, vertex);
    if (at == convex_.end() || *at != vertex) return kNone;
    const auto index = static_cast<std::size_t>(at - convex_.begin());
    return static_cast<std::uint32_t>(index * around_) + circle - after.first_around(c.vertex, Side::kLeft);
  }
  const VertexId second = map.before(c.second);
  const std::pair vertices(vertex, second);
  const auto vertices_of = [](const TurnCircle& pair) { return std::pair(pair.vertex, pair.second); };
  for (auto at = std::ranges::lower_bound(pairs_, vertices, {}, vertices_of);
       at != pairs_.end() && vertices_of(*at) == vertices; ++at)
    if (at->side == c.side && at->radius == c.radius)
      return static_cast<std::uint32_t>(convex_.size() * around_ + static_cast<std::size_t>(at - pairs_.begin()));
  return kNone;
}

std::uint32_t CircleNumbers::after(std::uint32_t circle, const TurnCircles& after, const VertexMap& map) const {
  const std::size_t own = convex_.size() * around_;
  if (circle < own) {
    const VertexId vertex = map.after(convex_[circle / around_]);
    if (vertex == kNone || !after.has(vertex)) return kNone;
    return after.first_around(vertex, Side::kLeft) + static_cast<std::uint32_t>(circle % around_);
  }
  const TurnCircle& pair = pairs_[circle - own];
  const VertexId vertex = map.after(pair.vertex), second = map.after(pair.second);
  std::uint32_t found = kNone;
  if (vertex == kNone || second == kNone || !after.has(vertex)) return found;
  after.visit_around(vertex, pair.side, [&](std::uint32_t other) {
    const TurnCircle& o = after.all()[other];
    if (o.vertex == vertex && o.second == second && o.radius == pair.radius) found = other;
  });
  return found;
}

}  // namespace arcway::internal
