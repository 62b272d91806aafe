#include "accel/wedge/wedge_walk.h"

#include <cmath>

#include "core/geometry/predicates.h"

namespace arcway {

namespace {

bool is_tangent(const SightMap::Node& node, const Vec2& from) {
  return orientation(from, node.at, node.previous) * orientation(from, node.at, node.next) >= 0;
}

}  // namespace

void WedgeWalk::run(std::uint32_t index) {
  source_ = &map_.nodes()[index];
  const Node& node = *source_;
  follow_edges(node);
  // Directions are tangent from the previous vertex's counter-clockwise to the opposite of the next one's, and from
  // the opposite of the previous one's to the next one's; those to the right are the source's to look at.
  const Limit down{0.0, -1.0, kNone, Limit::Kind::kDown, false};
  const Limit up{0.0, 1.0, kNone, Limit::Kind::kUp, true};
  const auto look_right = [&](const Limit& low, const Limit& high) {
    const bool low_is_right = leads_right(low), high_is_right = leads_right(high);
    if (low_is_right || high_is_right)
      look_through_wedge(index, {low_is_right ? low : down, high_is_right ? high : up});
  };
  look_right(toward(node.previous_site, node.previous, true), away_from(node.next_site, node.next));
  look_right(away_from(node.previous_site, node.previous), toward(node.next_site, node.next, true));
}

// Along walls to the right, up to the first site with a node.
void WedgeWalk::follow_edges(const Node& node) {
  for (const PlanarMap::Edge& first : map_.edges_from(node.site)) {
    const PlanarMap::Edge* edge = &first;
    while (edge && !map_.is_covered(*edge) && map_.first_node_at(edge->high) == kNone) {
      const PlanarMap::Edge* straight_on = nullptr;
      for (const PlanarMap::Edge& next : map_.edges_from(edge->high))
        if (orientation(node.at, map_.sites()[edge->high], map_.sites()[next.high]) == 0) straight_on = &next;
      edge = straight_on;
    }
    if (!edge || map_.is_covered(*edge)) continue;
    const bool along_own = first.high == node.previous_site || first.high == node.next_site;
    for (std::uint32_t n = map_.first_node_at(edge->high);
         n < map_.nodes().size() && map_.nodes()[n].site == edge->high; ++n) {
      const Node& target = map_.nodes()[n];
      const bool along_its = edge->low == target.previous_site || edge->low == target.next_site;
      if ((along_own || is_tangent(node, target.at)) && (along_its || is_tangent(target, node.at))) add(target);
    }
  }
}

void WedgeWalk::look_through_wedge(std::uint32_t index, const Range& wedge) {
  for (const SightMap::Fan& fan : map_.fans(index)) {
    struct Spoke {
      std::uint32_t site;
      Vec2 at;
      int low, high;  // sides of the wedge's limits
    };
    const auto spoke_to = [&](std::uint32_t site, const Vec2& at) {
      const double x = at.x() - source_->at.x(), y = at.y() - source_->at.y();
      return Spoke{site, at, side(wedge.low, x, y, site), side(wedge.high, x, y, site)};
    };
    const auto in_wedge = [](const Spoke& s) { return s.low >= 0 && s.high <= 0; };
    Spoke from = spoke_to(fan.first_site, map_.sites()[fan.first_site]);
    std::uint32_t door = fan.door;
    do {
      const SightMap::Door& triangle = map_.doors()[door];
      const Spoke to = spoke_to(triangle.site, triangle.apex);
      const bool from_inside = from.low >= 0 && from.high < 0;
      const bool low_between = from.low <= 0 && to.low > 0;
      if (triangle.right != kNone && (from_inside || low_between)) {
        walk(triangle.right, {from_inside ? toward(from.site, from.at, false) : wedge.low,
                              in_wedge(to) ? toward(to.site, to.at, false) : wedge.high});
      }
      const bool is_diagonal = triangle.left != kNone;
      if (is_diagonal && in_wedge(to) && triangle.node != kNone) report(triangle.node);
      from = to;
      door = triangle.left;
    } while (door != kNone && door != fan.door);
  }
}

void WedgeWalk::walk(std::uint32_t first_door, const Range& first_range) {
  stack_.push_back({first_door, first_range});
  while (!stack_.empty()) {
    auto [door, range] = stack_.back();
    stack_.pop_back();
    while (door != kNone) {
      ++steps_;
      const SightMap::Door& triangle = map_.doors()[door];
      const double x = triangle.apex.x() - source_->at.x(), y = triangle.apex.y() - source_->at.y();
      const int low = side(range.low, x, y, triangle.site);
      if (low < 0) {
        door = triangle.left;
        continue;
      }
      const int high = side(range.high, x, y, triangle.site);
      if (high > 0) {
        door = triangle.right;
        continue;
      }
      const bool in_range = (low > 0 || range.low.closed) && (high < 0 || range.high.closed);
      if (in_range && triangle.node != kNone) report(triangle.node);
      const Limit middle{x, y, triangle.site, Limit::Kind::kToward, false};
      // A range from a limit to itself is empty.
      if (low > 0 && triangle.right != kNone) stack_.push_back({triangle.right, {range.low, middle}});
      if (high == 0) break;
      range.low = middle;
      door = triangle.left;
    }
  }
}

void WedgeWalk::report(std::uint32_t first_node) {
  const std::span<const Node> nodes = map_.nodes();
  for (std::uint32_t n = first_node; n < nodes.size() && nodes[n].site == nodes[first_node].site; ++n)
    if (is_tangent(nodes[n], source_->at)) add(nodes[n]);
}

void WedgeWalk::add(const Node& target) {
  if (!map_.is_whole()) {
    ++candidates_;
    if (map_.is_blocked_by_broken({source_->at, target.at})) return;
  }
  edges_.emplace_back(source_->vertex, target.vertex);
}

WedgeWalk::Limit WedgeWalk::toward(std::uint32_t site, const Vec2& at, bool closed) const {
  return {at.x() - source_->at.x(), at.y() - source_->at.y(), site, Limit::Kind::kToward, closed};
}

WedgeWalk::Limit WedgeWalk::away_from(std::uint32_t site, const Vec2& at) const {
  return {source_->at.x() - at.x(), source_->at.y() - at.y(), site, Limit::Kind::kAway, true};
}

bool WedgeWalk::leads_right(const Limit& limit) const {
  return (limit.kind == Limit::Kind::kToward) == (limit.site > source_->site);
}

// +1 if the site, at (x, y) from the source, lies to the left of the direction.
int WedgeWalk::side(const Limit& limit, double x, double y, std::uint32_t site) const {
  constexpr double kEpsilon = 0x1p-53;
  constexpr double kErrorBound = (3.0 + 16.0 * kEpsilon) * kEpsilon;  // [Shewchuk 1997, figure 21]
  const double left = limit.x * y;
  const double right = limit.y * x;
  const double determinant = left - right;
  const double error = kErrorBound * (std::abs(left) + std::abs(right));
  if (determinant > error) return 1;
  if (determinant < -error) return -1;
  return exact_side(limit, site);
}

int WedgeWalk::exact_side(const Limit& limit, std::uint32_t site) const {
  switch (limit.kind) {
    case Limit::Kind::kToward:
      return limit.site == site ? 0 : orientation(source_->at, map_.sites()[limit.site], map_.sites()[site]);
    case Limit::Kind::kAway:
      return -orientation(source_->at, map_.sites()[limit.site], map_.sites()[site]);
    case Limit::Kind::kDown:
      return site > source_->site ? 1 : -1;
    case Limit::Kind::kUp:
      return site > source_->site ? -1 : 1;
  }
  return 0;
}

}  // namespace arcway
