#include "accel/wedge/wedge_walk.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/predicates.h"

namespace arcway {

namespace {

// Sign of the cross product of two differences of coordinates that have been rounded once; 0 if it is not sure.
inline int filtered_sign(double ux, double uy, double vx, double vy) {
  constexpr double kEpsilon = 0x1p-53;
  constexpr double kErrorBound = (3.0 + 16.0 * kEpsilon) * kEpsilon;  // [Shewchuk 1997, figure 21]
  const double left = ux * vy;
  const double right = uy * vx;
  const double determinant = left - right;
  const double error = kErrorBound * (std::abs(left) + std::abs(right));
  return (determinant > error) - (determinant < -error);
}

inline void prefetch(const void* address) { __builtin_prefetch(address); }

bool is_tangent(const SightMap::Node& node, const Vec2& from) {
  const double x = node.at.x() - from.x(), y = node.at.y() - from.y();
  int previous = filtered_sign(x, y, node.previous.x() - node.at.x(), node.previous.y() - node.at.y());
  int next = filtered_sign(x, y, node.next.x() - node.at.x(), node.next.y() - node.at.y());
  if (previous == 0) previous = orientation(from, node.at, node.previous);
  if (next == 0) next = orientation(from, node.at, node.next);
  return previous * next >= 0;
}

}  // namespace

// +1 if the site, at (x, y) from the source, lies to the left of the direction.
inline int WedgeWalk::side(const Limit& limit, double x, double y, std::uint32_t site) const {
  const int sign = filtered_sign(limit.x, limit.y, x, y);
  return sign != 0 ? sign : exact_side(limit.id, site);
}

// Directions are tangent from the previous vertex's counter-clockwise to the opposite of the next one's, and from the
// opposite of the previous one's to the next one's.
void WedgeWalk::look_around(std::uint32_t index) {
  using Kind = WedgeLimit::Kind;
  source_ = &map_.nodes()[index];
  const Node& node = *source_;
  follow_edges_right();
  follow_edges_left();
  const Vec2 to_previous = node.previous - node.at, to_next = node.next - node.at;
  wedge_low_ = {to_previous, node.previous_site, Kind::kToward};
  wedge_high_ = {-to_next, node.next_site, Kind::kAway};
  look_through_wedge(index);
  wedge_low_ = {-to_previous, node.previous_site, Kind::kAway};
  wedge_high_ = {to_next, node.next_site, Kind::kToward};
  look_through_wedge(index);
}

void WedgeWalk::look_right(std::uint32_t index) {
  using Kind = WedgeLimit::Kind;
  source_ = &map_.nodes()[index];
  const Node& node = *source_;
  follow_edges_right();
  const auto look = [&](const WedgeLimit& low, const WedgeLimit& high) {
    const bool low_is_right = leads_right(low), high_is_right = leads_right(high);
    if (!low_is_right && !high_is_right) return;
    wedge_low_ = low_is_right ? low : WedgeLimit{{0.0, -1.0}, kNone, Kind::kDown};
    wedge_high_ = high_is_right ? high : WedgeLimit{{0.0, 1.0}, kNone, Kind::kUp};
    look_through_wedge(index);
  };
  const Vec2 to_previous = node.previous - node.at, to_next = node.next - node.at;
  look({to_previous, node.previous_site, Kind::kToward}, {-to_next, node.next_site, Kind::kAway});
  look({-to_previous, node.previous_site, Kind::kAway}, {to_next, node.next_site, Kind::kToward});
}

// Along walls that leave the source, straight on to the first site with a node.
void WedgeWalk::follow_edges_right() {
  for (const PlanarMap::Edge& first : map_.edges_from(source_->site)) {
    const PlanarMap::Edge* edge = &first;
    while (edge && !map_.is_covered(*edge) && map_.first_node_at(edge->high) == kNone) {
      const PlanarMap::Edge* straight_on = nullptr;
      for (const PlanarMap::Edge& next : map_.edges_from(edge->high))
        if (orientation(source_->at, map_.sites()[edge->high], map_.sites()[next.high]) == 0) straight_on = &next;
      edge = straight_on;
    }
    if (edge && !map_.is_covered(*edge)) report_along_wall(first.high, edge->low, edge->high);
  }
}

void WedgeWalk::follow_edges_left() {
  for (const std::uint32_t first : map_.edges_to(source_->site)) {
    const PlanarMap::Edge* edge = &map_.edge(first);
    while (edge && !map_.is_covered(*edge) && map_.first_node_at(edge->low) == kNone) {
      const PlanarMap::Edge* straight_on = nullptr;
      for (const std::uint32_t next : map_.edges_to(edge->low))
        if (orientation(source_->at, map_.sites()[edge->low], map_.sites()[map_.edge(next).low]) == 0)
          straight_on = &map_.edge(next);
      edge = straight_on;
    }
    if (edge && !map_.is_covered(*edge)) report_along_wall(map_.edge(first).low, edge->high, edge->low);
  }
}

void WedgeWalk::report_along_wall(std::uint32_t first, std::uint32_t before_end, std::uint32_t end) {
  const std::span<const Node> nodes = map_.nodes();
  const bool along_own = first == source_->previous_site || first == source_->next_site;
  for (std::uint32_t n = map_.first_node_at(end); n < nodes.size() && nodes[n].site == end; ++n) {
    const bool along_its = before_end == nodes[n].previous_site || before_end == nodes[n].next_site;
    if ((along_own || is_tangent(*source_, nodes[n].at)) && (along_its || is_tangent(nodes[n], source_->at)))
      add(nodes[n]);
  }
}

void WedgeWalk::look_through_wedge(std::uint32_t index) {
  struct Spoke {
    Limit direction;
    int low, high;  // sides of the wedge's limits
  };
  const Limit wedge_low{wedge_low_.direction.x(), wedge_low_.direction.y(), kWedgeLow};
  const Limit wedge_high{wedge_high_.direction.x(), wedge_high_.direction.y(), kWedgeHigh};
  const auto spoke_to = [&](std::uint32_t site, const Vec2& at) {
    const double x = at.x() - source_->at.x(), y = at.y() - source_->at.y();
    return Spoke{{x, y, site}, side(wedge_low, x, y, site), side(wedge_high, x, y, site)};
  };
  for (const SightMap::Fan& fan : map_.fans(index)) {
    Spoke from = spoke_to(fan.first_site, map_.sites()[fan.first_site]);
    std::uint32_t door = fan.door;
    do {
      const SightMap::Door& triangle = map_.doors()[door];
      const Spoke to = spoke_to(triangle.site, triangle.apex);
      const bool from_inside = from.low >= 0 && from.high < 0;
      const bool to_inside = to.low >= 0 && to.high <= 0;
      const bool low_between = from.low <= 0 && to.low > 0;
      if (triangle.right != kNone && (from_inside || low_between))
        walk(triangle.right, from_inside ? from.direction : wedge_low, to_inside ? to.direction : wedge_high);
      const bool is_diagonal = triangle.left != kNone;
      if (is_diagonal && to_inside && triangle.node != kNone) report(triangle.node);
      from = to;
      door = triangle.left;
    } while (door != kNone && door != fan.door);
  }
}

void WedgeWalk::walk(std::uint32_t door, Limit low, Limit high) {
  const SightMap::Door* const doors = map_.doors().data();
  const double source_x = source_->at.x(), source_y = source_->at.y();
  std::uint64_t steps = 0;
  while (true) {
    ++steps;
    const SightMap::Door& triangle = doors[door];
    prefetch(doors + triangle.left);
    prefetch(doors + triangle.right);
    const double x = triangle.apex.x() - source_x, y = triangle.apex.y() - source_y;
    const int low_side = side(low, x, y, triangle.site);
    if (low_side < 0) {
      door = triangle.left;
    } else {
      const int high_side = side(high, x, y, triangle.site);
      if (high_side > 0) {
        door = triangle.right;
      } else {
        const bool in_range = (low_side > 0 || is_closed(low)) && (high_side < 0 || is_closed(high));
        if (in_range && triangle.node != kNone) report(triangle.node);
        // A range from a limit to itself is empty.
        const Limit middle{x, y, triangle.site};
        const bool look_left = high_side < 0 && triangle.left != kNone;
        const bool look_right = low_side > 0 && triangle.right != kNone;
        if (look_left && look_right) stack_.push_back({triangle.right, low, middle});
        if (look_left) {
          door = triangle.left;
          low = middle;
        } else {
          door = look_right ? triangle.right : kNone;
          high = middle;
        }
      }
    }
    if (door != kNone) continue;
    if (stack_.empty()) break;
    const Postponed& next = stack_.back();
    door = next.door;
    low = next.low;
    high = next.high;
    stack_.pop_back();
  }
  steps_ += steps;
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

bool WedgeWalk::leads_right(const WedgeLimit& limit) const {
  return (limit.kind == WedgeLimit::Kind::kToward) == (limit.site > source_->site);
}

int WedgeWalk::exact_side(std::uint32_t limit, std::uint32_t site) const {
  const auto turn = [&](std::uint32_t other) {
    return other == site ? 0 : orientation(source_->at, map_.sites()[other], map_.sites()[site]);
  };
  if (limit < kWedgeLow) return turn(limit);
  const WedgeLimit& wedge = limit == kWedgeLow ? wedge_low_ : wedge_high_;
  switch (wedge.kind) {
    case WedgeLimit::Kind::kToward:
      return turn(wedge.site);
    case WedgeLimit::Kind::kAway:
      return -turn(wedge.site);
    case WedgeLimit::Kind::kDown:
      return site > source_->site ? 1 : -1;
    case WedgeLimit::Kind::kUp:
      return site > source_->site ? -1 : 1;
  }
  return 0;
}

std::vector<VertexId> tangent_neighbours(const SightMap& map, std::uint32_t node) {
  if (node == kNone) return {};
  WedgeWalk walk(map);
  walk.look_around(node);
  std::vector<VertexId> row;
  for (const auto& [u, v] : walk.take_edges()) row.push_back(v);
  std::sort(row.begin(), row.end());
  return row;
}

}  // namespace arcway
