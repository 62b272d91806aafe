#include "accel/expansion/wedge_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/prefetch.h"
#include "core/geometry/expansion.h"
#include "core/geometry/predicates.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

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

// Sign of the cross product of the ways from a to b and from p to q. Exact.
int cross_sign(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q) {
  FixedExpansion<16> sum;
  for (const auto& [end, sign] : {std::pair<const Vec2&, double>(b, 1.0), {a, -1.0}}) {
    sum.add_product(sign * end.x(), q.y());
    sum.add_product(-sign * end.x(), p.y());
    sum.add_product(-sign * end.y(), q.x());
    sum.add_product(sign * end.y(), p.x());
  }
  return sum.sign();
}

// Who looks from a run looks at all of its nodes, not at the first ones first.
constexpr std::size_t kNodesAhead = 256;

bool is_tangent(const SightMap::Node& node, const Vec2& from) {
  const double x = node.at.x() - from.x(), y = node.at.y() - from.y();
  int previous = filtered_sign(x, y, node.previous.x() - node.at.x(), node.previous.y() - node.at.y());
  int next = filtered_sign(x, y, node.next.x() - node.at.x(), node.next.y() - node.at.y());
  if (previous == 0) previous = orientation(from, node.at, node.previous);
  if (next == 0) next = orientation(from, node.at, node.next);
  return previous * next >= 0;
}

}  // namespace

WedgeWalk::WedgeWalk(const SightMap& map, const Sleeves* sleeves, const LongFans* fans)
    : map_(map),
      sleeves_(sleeves && !sleeves->empty() ? sleeves : nullptr),
      fans_(fans && !fans->empty() ? fans : nullptr),
      sure_(map.sure_cross_product()) {}

inline WedgeWalk::Limit WedgeWalk::limit(Kind kind, std::uint32_t from, std::uint32_t site, const Vec2& at) const {
  const Vec2& origin = node(from).at;
  Vec2 direction = at - origin;
  if (kind == Kind::kAway) direction = -direction;
  return {origin, direction, from, site | static_cast<std::uint32_t>(kind) << kSiteBits};
}

WedgeWalk::Limit WedgeWalk::straight(Kind kind, std::uint32_t from) const {
  return {node(from).at, {0.0, kind == Kind::kUp ? 1.0 : -1.0}, from, static_cast<std::uint32_t>(kind) << kSiteBits};
}

// +1 if the site, at p, lies to the left of the limit's ray.
inline int WedgeWalk::side(const Limit& limit, const Vec2& p, std::uint32_t site) const {
  const double determinant =
      limit.direction.x() * (p.y() - limit.origin.y()) - limit.direction.y() * (p.x() - limit.origin.x());
  if (determinant > sure_) return 1;
  if (determinant < -sure_) return -1;
  return exact_side(limit, site);
}

int WedgeWalk::exact_side(const Limit& limit, std::uint32_t site) const {
  const Node& source = node(limit.from);
  const auto turn = [&] {
    return limit.site() == site ? 0 : orientation(source.at, map_.sites()[limit.site()], map_.sites()[site]);
  };
  switch (limit.kind()) {
    case Kind::kMet:
    case Kind::kToward:
      return turn();
    case Kind::kAway:
      return -turn();
    case Kind::kDown:
      return site > source.site ? 1 : -1;
    case Kind::kUp:
      return site > source.site ? -1 : 1;
  }
  return 0;
}

// Directions are tangent from the previous vertex's counter-clockwise to the opposite of the next one's, and from the
// opposite of the previous one's to the next one's.
void WedgeWalk::look_around(std::uint32_t index) {
  alias_ = kNone;
  const Node& source = map_.nodes()[index];
  follow_edges_right(source);
  follow_edges_left(source);
  look_through_wedge(index, limit(Kind::kToward, index, source.previous_site, source.previous),
                     limit(Kind::kAway, index, source.next_site, source.next));
  look_through_wedge(index, limit(Kind::kAway, index, source.previous_site, source.previous),
                     limit(Kind::kToward, index, source.next_site, source.next));
  take_tangent();
}

void WedgeWalk::look_right(std::uint32_t index) {
  alias_ = kNone;
  const Node& source = map_.nodes()[index];
  if (index + kNodesAhead < map_.nodes().size()) {
    const Node& ahead = map_.nodes()[index + kNodesAhead];
    will_need(&ahead);
    will_need(&ahead.last_door);
  }
  const bool from_left = source.previous_site < source.site, to_left = source.next_site < source.site;
  if (source.is_plain()) {
    if ((from_left || source.before != kNone) && (to_left || source.after != kNone)) {
      if (!from_left) add(source, map_.nodes()[source.before]);
      if (!to_left) add(source, map_.nodes()[source.after]);
    } else {
      follow_edges_right(source);
    }
    // Unless it is within a run, or its rays lead left.
    if (from_left ? source.before == kNone : !to_left) look_from_run<Hand::kLeft>(index);
    if (to_left ? source.after == kNone : !from_left) look_from_run<Hand::kRight>(index);
  } else {
    follow_edges_right(source);
    look_right_from(index);
  }
  take_tangent();
}

void WedgeWalk::look_right_from(std::uint32_t index) {
  const Node& source = node(index);
  const auto leads_right = [&](const Limit& limit) {
    return (limit.kind() == Kind::kToward) == (limit.site() > source.site);
  };
  const auto look = [&](const Limit& low, const Limit& high) {
    const bool low_is_right = leads_right(low), high_is_right = leads_right(high);
    if (!low_is_right && !high_is_right) return;
    look_through_wedge(index, low_is_right ? low : straight(Kind::kDown, index),
                       high_is_right ? high : straight(Kind::kUp, index));
  };
  look(limit(Kind::kToward, index, source.previous_site, source.previous),
       limit(Kind::kAway, index, source.next_site, source.next));
  look(limit(Kind::kAway, index, source.previous_site, source.previous),
       limit(Kind::kToward, index, source.next_site, source.next));
}

// Along walls that leave the source, straight on to the first site with a node.
void WedgeWalk::follow_edges_right(const Node& source) {
  for (const PlanarMap::Edge& first : map_.edges_from(source.site)) {
    const PlanarMap::Edge* edge = &first;
    while (edge && !map_.is_covered(*edge) && map_.first_node_at(edge->high) == kNone) {
      const PlanarMap::Edge* straight_on = nullptr;
      for (const PlanarMap::Edge& next : map_.edges_from(edge->high))
        if (orientation(source.at, map_.sites()[edge->high], map_.sites()[next.high]) == 0) straight_on = &next;
      edge = straight_on;
    }
    if (edge && !map_.is_covered(*edge)) report_along_wall(source, first.high, edge->low, edge->high);
  }
}

void WedgeWalk::follow_edges_left(const Node& source) {
  for (const std::uint32_t first : map_.edges_to(source.site)) {
    const PlanarMap::Edge* edge = &map_.edge(first);
    while (edge && !map_.is_covered(*edge) && map_.first_node_at(edge->low) == kNone) {
      const PlanarMap::Edge* straight_on = nullptr;
      for (const std::uint32_t next : map_.edges_to(edge->low))
        if (orientation(source.at, map_.sites()[edge->low], map_.sites()[map_.edge(next).low]) == 0)
          straight_on = &map_.edge(next);
      edge = straight_on;
    }
    if (edge && !map_.is_covered(*edge)) report_along_wall(source, map_.edge(first).low, edge->high, edge->low);
  }
}

void WedgeWalk::report_along_wall(const Node& source, std::uint32_t first, std::uint32_t before_end,
                                  std::uint32_t end) {
  const std::span<const Node> nodes = map_.nodes();
  const bool along_own = first == source.previous_site || first == source.next_site;
  for (std::uint32_t n = map_.first_node_at(end); n != kNone; n = nodes[n].sibling) {
    const bool along_its = before_end == nodes[n].previous_site || before_end == nodes[n].next_site;
    if ((along_own || is_tangent(source, nodes[n].at)) && (along_its || is_tangent(nodes[n], source.at)))
      add(source, nodes[n]);
  }
}

void WedgeWalk::look_through_wedge(std::uint32_t index, const Limit& wedge_low, const Limit& wedge_high) {
  const Node& source = map_.nodes()[index];
  struct Spoke {
    Limit ray;
    int low, high;  // sides of the wedge's limits
  };
  const auto spoke_to = [&](std::uint32_t site, const Vec2& at) {
    return Spoke{limit(Kind::kMet, index, site, at), side(wedge_low, at, site), side(wedge_high, at, site)};
  };
  const SightMap::Fan own{source.first_door, source.previous_site};
  for (const SightMap::Fan& fan : source.is_plain() ? std::span(&own, 1) : map_.fans(index)) {
    Spoke from = spoke_to(fan.first_site, map_.sites()[fan.first_site]);
    std::uint32_t door = fan.door;
    do {
      const SightMap::Door& triangle = map_.doors()[door];
      const Spoke to = spoke_to(triangle.site, triangle.apex);
      const bool from_inside = from.low >= 0 && from.high < 0;
      const bool to_inside = to.low >= 0 && to.high <= 0;
      const bool low_between = from.low <= 0 && to.low > 0;
      if (triangle.right != kNone && (from_inside || low_between))
        walk(triangle.right, from_inside ? from.ray : wedge_low, to_inside ? to.ray : wedge_high);
      const bool is_diagonal = triangle.left != kNone;
      if (is_diagonal && to_inside && triangle.node != kNone) report(index, triangle.node);
      from = to;
      door = triangle.left;
    } while (door != kNone && door != fan.door);
  }
}

// Around the obstacle from node to node, and in the triangles around each from spoke to spoke: all rays of the run
// beyond the near limit pass the current spoke, or begin at the current node behind it.
template <WedgeWalk::Hand kHand>
void WedgeWalk::look_from_run(std::uint32_t first) {
  constexpr bool kLeft = kHand == Hand::kLeft;
  constexpr Kind kStart = kLeft ? Kind::kDown : Kind::kUp, kEnd = kLeft ? Kind::kUp : Kind::kDown;
  const SightMap::Door* const doors = map_.doors().data();
  const auto onward = [&](std::uint32_t door) { return kLeft ? doors[door].left : doors[door].right; };
  const auto outward = [&](std::uint32_t door) { return kLeft ? doors[door].right : doors[door].left; };
  const auto look_out = [&](std::uint32_t door, const Limit& near, const Limit& far) {
    if (door != kNone) walk(door, kLeft ? near : far, kLeft ? far : near);
  };

  hand_ = kHand;
  alias_ = kNone;
  std::uint32_t place = first;
  if (!kLeft && map_.nodes()[first].before != kNone && map_.nodes()[first].before > first) {
    alias_ = place = map_.nodes()[first].before + 1;
    alias_of_ = first;
  }
  const Node* source = &node(place);
  std::uint32_t door = kLeft ? source->first_door : source->last_door;
  Limit near = straight(kStart, place);
  const std::uint32_t behind = kLeft ? source->previous_site : source->next_site;
  if (behind < source->site) {
    near = limit(Kind::kAway, place, behind, kLeft ? source->previous : source->next);
  } else {
    while (doors[door].site > source->site) door = onward(door);
  }
  const auto move_on = [&](std::uint32_t nodes) {
    place = kLeft ? place + nodes : place - nodes;
    source = &node(place);
  };
  while (true) {
    ++steps_;
    const std::uint32_t ahead = kLeft ? source->next_site : source->previous_site;
    const bool leads_right = ahead > source->site;
    const bool runs_on = leads_right && (kLeft ? source->after : source->before) != kNone;
    const Sleeves::Sleeve* const sleeve = sleeves_ ? sleeves_->behind(door) : nullptr;
    if (sleeve) {
      const std::uint32_t count = kLeft ? sleeve->left.count : sleeve->right.count;
      if (!pass_along<kHand>(*sleeve, runs_on ? count : 0, place, near)) return;
      if (runs_on || count == 0) {
        move_on(count);
        door = sleeve->exit;
        continue;
      }
    }
    const bool is_last = sleeve || onward(door) == kNone;
    if (is_last && runs_on) {
      move_on(1);
      door = outward(door);
      continue;
    }
    if (is_last) {
      const std::uint32_t wall = kLeft ? source->last_door : source->first_door;
      look_out(onward(wall), near,
               leads_right ? limit(Kind::kMet, place, ahead, kLeft ? source->next : source->previous)
                           : straight(kEnd, place));
      return;
    }
    const SightMap::Door& triangle = doors[door];
    const int near_side = (kLeft ? 1 : -1) * side(near, triangle.apex, triangle.site);
    if (near_side >= 0) {
      const std::uint32_t from = kLeft ? touch(near.from, place, End::kLow, triangle.apex)
                                       : touch(place, near.from, End::kHigh, triangle.apex);
      if (from == place && triangle.site < source->site) {
        look_out(outward(door), near, straight(kEnd, place));
        return;
      }
      if (triangle.node != kNone && (near_side > 0 || is_closed(near))) report(from, triangle.node);
      const Limit middle = limit(Kind::kMet, from, triangle.site, triangle.apex);
      if (near_side > 0) look_out(outward(door), near, middle);
      near = middle;
    }
    door = onward(door);
  }
}

// The place in [low, high] from which the run's tangent ray passes p, which none of the others hides. Looked for from
// one end in longer and longer steps: what follows each other along a wall is mostly seen from places near by.
std::uint32_t WedgeWalk::touch(std::uint32_t low, std::uint32_t high, End from, const Vec2& p) const {
  for (std::uint32_t step = 1; low < high; step *= 2) {
    const std::uint32_t half = (high - low + 1) / 2;
    const std::uint32_t middle = from == End::kLow ? low + std::min(step, half) : high + 1 - std::min(step, half);
    const Node& place = node(middle);
    if ((orientation(place.previous, place.at, p) >= 0) == (hand_ == Hand::kLeft)) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  return low;
}

void WedgeWalk::walk(std::uint32_t door, const Limit& low, const Limit& high) {
  if (sleeves_) {
    fans_ ? walk_on<true, true>(door, low, high) : walk_on<true, false>(door, low, high);
  } else {
    fans_ ? walk_on<false, true>(door, low, high) : walk_on<false, false>(door, low, high);
  }
}

template <bool kHasSleeves, bool kHasFans>
void WedgeWalk::walk_on(std::uint32_t door, Limit low, Limit high) {
  const SightMap::Door* const doors = map_.doors().data();
  std::uint64_t steps = 0;
  // What has been reported of the door's ends, if it is the far end of a wall in sight: not tangent once the next wall
  // is in sight, too.
  std::uint32_t left_end = kNone, right_end = kNone;
  while (true) {
    ++steps;
    if (const Sleeves::Sleeve* sleeve = kHasSleeves ? sleeves_->behind(door) : nullptr) {
      will_need(doors + sleeve->exit);
      door = pass(*sleeve, low, high) ? sleeve->exit : kNone;
      left_end = right_end = kNone;
    } else {
      const SightMap::Door& triangle = doors[door];
      will_need(doors + triangle.left);
      will_need(doors + triangle.right);
      const int low_side = side(low, triangle.apex, triangle.site);
      if (low_side < 0) {
        door = triangle.left;
        right_end = kNone;
      } else {
        const int high_side = side(high, triangle.apex, triangle.site);
        if (high_side > 0) {
          door = triangle.right;
          left_end = kNone;
        } else {
          const End near = triangle.right == kNone ? End::kLow : End::kHigh;
          const std::uint32_t from = touch(low.from, high.from, near, triangle.apex);
          const bool in_range = (low_side > 0 || is_closed(low)) && (high_side < 0 || is_closed(high));
          const bool ends_right_wall = triangle.right == kNone && low_side > 0;
          const bool ends_left_wall = triangle.left == kNone && high_side < 0;
          std::uint32_t seen = kNone;
          if (in_range && triangle.node != kNone)
            seen = report(from, triangle.node, ends_right_wall ? right_end : ends_left_wall ? left_end : kNone);
          // A range from a limit to itself is empty.
          const Limit middle = limit(Kind::kMet, from, triangle.site, triangle.apex);
          const bool look_left = high_side < 0 && triangle.left != kNone;
          const bool look_right = low_side > 0 && triangle.right != kNone;
          if (look_left && look_right) stack_.push_back({triangle.right, low, middle});
          if (look_left) {
            right_end = ends_right_wall ? seen : kNone;
            door = triangle.left;
            low = middle;
          } else {
            left_end = ends_left_wall ? seen : kNone;
            door = look_right ? triangle.right : kNone;
            high = middle;
          }
        }
      }
      if constexpr (kHasFans) {
        if (door == triangle.left && door != kNone) {
          door = pass_fan<Hand::kLeft>(door, low);
          if (door != triangle.left) right_end = kNone;
        } else if (door != kNone) {
          door = pass_fan<Hand::kRight>(door, high);
          if (door != triangle.right) left_end = kNone;
        }
      }
    }
    if (door != kNone) continue;
    if (stack_.empty()) break;
    const Postponed& next = stack_.back();
    door = next.door;
    low = next.low;
    high = next.high;
    left_end = right_end = kNone;
    stack_.pop_back();
  }
  steps_ += steps;
}

template <WedgeWalk::Hand kPivot>
std::uint32_t WedgeWalk::pass_fan(std::uint32_t door, const Limit& limit) const {
  constexpr int kStep = kPivot == Hand::kLeft ? 1 : -1;
  const auto [fan, triangle] = fans_->behind<kStep>(door);
  if (!fan || kStep * side(limit, map_.sites()[fan->pivot], fan->pivot) <= 0) return door;
  const int least = is_closed(limit) ? 0 : 1;  // a corner on a ray that does not belong to the range is passed
  const auto stops = [&](std::uint32_t site) { return kStep * side(limit, map_.sites()[site], site) >= least; };
  const auto rises = [&](std::uint32_t from, std::uint32_t to) { return kStep * turn_along(limit, from, to) > 0; };
  if (const auto stop = fans_->first_stop<kStep>(*fan, triangle, stops, rises)) return fans_->door<kStep>(*fan, *stop);
  const SightMap::Door& last = map_.doors()[fans_->door<kStep>(*fan, LongFans::last_triangle<kStep>(*fan))];
  return kStep > 0 ? last.left : last.right;
}

// Sign of the cross product of the limit's direction with the way from one site to another one. Exact.
int WedgeWalk::turn_along(const Limit& limit, std::uint32_t from, std::uint32_t to) const {
  if (limit.kind() == Kind::kDown) return to > from ? 1 : -1;
  if (limit.kind() == Kind::kUp) return to > from ? -1 : 1;
  const Vec2 &p = map_.sites()[from], &q = map_.sites()[to];
  const int sure = filtered_sign(limit.direction.x(), limit.direction.y(), q.x() - p.x(), q.y() - p.y());
  if (sure != 0) return sure;
  const int exact = cross_sign(node(limit.from).at, map_.sites()[limit.site()], p, q);
  return limit.kind() == Kind::kAway ? -exact : exact;
}

// The wall is looked at from the place that the range's limit starts from, then from where the ray to the node found
// starts, and so on: each ray leaves more of the wall behind, until one leaves all of it there.
template <int kStep, class Passed, class From>
WedgeWalk::Contact WedgeWalk::contact(const Sleeves::Wall<kStep>& wall, std::uint32_t nodes, const Limit& own,
                                      const Limit* other, std::uint32_t guess, const Passed& passed_before,
                                      const From& touched_from) const {
  Contact found;
  found.ray = own;
  while (true) {
    const std::uint32_t from = found.ray.from;
    const std::uint32_t index = wall.limit_from(node(from).at, nodes, passed_before(from), guess, sure_);
    if (index == kNone || index == found.index) return found;
    const Node& n = wall.node(index);
    const int own_side = kStep * side(own, n.at, n.site);
    if (own_side > 0) return found;
    found.index = guess = index;
    found.own_side = own_side;
    if (other) found.other_side = kStep * side(*other, n.at, n.site);
    if (found.other_side < 0) return found;
    found.ray = limit(Kind::kMet, touched_from(index, n.at), n.site, n.at);
    if (found.ray.from == from) return found;
  }
}

bool WedgeWalk::pass(const Sleeves::Sleeve& sleeve, Limit& low, Limit& high) {
  const Sleeves::Wall<1> left(sleeve.left, map_.nodes());
  const Sleeves::Wall<-1> right(sleeve.right, map_.nodes());
  const auto none = [](std::uint32_t) { return 0u; };
  const auto touched = [&](End end) {
    return [&, end](std::uint32_t, const Vec2& at) { return touch(low.from, high.from, end, at); };
  };
  const std::uint32_t guess_left = left.guess(high.direction), guess_right = right.guess(low.direction);
  left.fetch(guess_left);
  right.fetch(guess_right);
  const Contact on_left = contact(left, left.count(), high, &low, guess_left, none, touched(End::kHigh));
  const Contact on_right = contact(right, right.count(), low, &high, guess_right, none, touched(End::kLow));
  bool passes = on_left.leaves_way() && on_right.leaves_way();
  if (passes && on_left.exists() && on_right.exists()) {
    passes = side(on_left.ray, right.node(on_right.index).at, right.node(on_right.index).site) < 0;
  }
  // What is in the range is seen unless the other wall, as far as it was passed before, hides it.
  const auto report_if_seen = [&](const Contact& c, const auto& wall, const Limit& own, const Limit& other,
                                  const auto& across, std::uint32_t passed) {
    const bool in_range =
        (c.own_side < 0 || is_closed(own)) && (c.other_side > 0 || (c.other_side == 0 && is_closed(other)));
    if (!in_range) return;
    if (!passes) {
      const Vec2& s = node(c.ray.from).at;
      const std::uint32_t hides = across.limit_from(s, passed, 0, 0, sure_);
      if (hides != kNone && across.turn(s, wall.node(c.index).at, across.node(hides).at) <= 0) return;
    }
    report(c.ray.from, wall.index_of_node(c.index));
  };
  if (on_left.exists())
    report_if_seen(on_left, left, high, low, right, passes ? 0 : sleeves_->right_before(sleeve, on_left.index));
  if (on_right.exists())
    report_if_seen(on_right, right, low, high, left, passes ? 0 : sleeves_->left_before(sleeve, on_right.index));
  if (passes && on_left.exists()) high = on_left.ray;
  if (passes && on_right.exists()) low = on_right.ray;
  return passes;
}

// The other wall is seen from the run up to the node that a ray of the run touches. A node is touched from what was
// passed of the run before it, and places within the sleeve do not see what was passed of the other wall before them.
template <WedgeWalk::Hand kHand>
bool WedgeWalk::pass_along(const Sleeves::Sleeve& sleeve, std::uint32_t count, std::uint32_t place, Limit& near) {
  constexpr bool kLeft = kHand == Hand::kLeft;
  const Sleeves::Wall<kLeft ? -1 : 1> across(kLeft ? sleeve.right : sleeve.left, map_.nodes());
  const auto across_before = [&](std::uint32_t i) {  // of the other wall, before one of the run
    return kLeft ? sleeves_->right_before(sleeve, i) : sleeves_->left_before(sleeve, i);
  };
  const auto ahead = [&](std::uint32_t nodes) { return kLeft ? place + nodes : place - nodes; };
  const auto passed_before = [&](std::uint32_t from) {
    if (kLeft ? from <= place : from >= place) return 0u;
    return across_before(kLeft ? from - place - 1 : place - from - 1);
  };
  const auto touched_from = [&](std::uint32_t index, const Vec2& at) {
    const std::uint32_t last =
        ahead(kLeft ? sleeves_->left_before(sleeve, index) : sleeves_->right_before(sleeve, index));
    return kLeft ? touch(near.from, last, End::kLow, at) : touch(last, near.from, End::kHigh, at);
  };
  const std::uint32_t in_sight =
      count == (kLeft ? sleeve.left.count : sleeve.right.count) ? across.count() : across_before(0);
  const Contact found =
      contact(across, in_sight, near, nullptr, across.guess(near.direction), passed_before, touched_from);
  if (!found.exists()) return true;
  const std::uint32_t end = ahead(count);
  if (found.ray.from == end && across.node(found.index).site < node(end).site)
    return false;  // rays from there on lead left
  if (found.own_side < 0 || is_closed(near)) report(found.ray.from, across.index_of_node(found.index));
  near = found.ray;
  return true;
}

inline std::uint32_t WedgeWalk::report(std::uint32_t place, std::uint32_t first_node, std::uint32_t instead_of) {
  const Node* const target = map_.nodes().data() + first_node;
  will_need(target);
  will_need(&target->vertex);
  const std::pair<std::uint32_t, std::uint32_t> seen{place == alias_ ? alias_of_ : place, first_node};
  if (instead_of != kNone) {
    seen_[instead_of] = seen;
    return instead_of;
  }
  seen_.push_back(seen);
  return map_.is_plain() ? static_cast<std::uint32_t>(seen_.size() - 1) : kNone;
}

void WedgeWalk::take_tangent() {
  for (const auto& [from, first_node] : seen_) {
    const Node& source = map_.nodes()[from];
    for (std::uint32_t n = first_node; n != kNone; n = map_.nodes()[n].sibling)
      if (is_tangent(map_.nodes()[n], source.at)) add(source, map_.nodes()[n]);
  }
  seen_.clear();
}

void WedgeWalk::add(const Node& source, const Node& target) {
  if (!map_.is_whole()) {
    ++candidates_;
    if (map_.is_blocked_by_broken({source.at, target.at})) return;
  }
  edges_.emplace_back(source.vertex, target.vertex);
}

EdgeList WedgeWalk::take_edges() {
  EdgeList taken = edges_;  // no longer than it must be
  edges_.clear();
  return taken;
}

double steps_a_node(const SightMap& map, const Executor& executor, const LongFans* fans) {
  constexpr std::size_t kSample = 256, kGolden = 2654435761;
  WedgeWalk walk(map, nullptr, fans);
  if (map.nodes().empty()) return 0.0;
  for (std::size_t i = 0; i < kSample; ++i) {
    end_if_over(executor);  // in a wide ring of obstacles a walk takes milliseconds
    walk.look_right(static_cast<std::uint32_t>(i * kGolden % map.nodes().size()));
  }
  return static_cast<double>(walk.steps()) / kSample;
}

LongFans worthwhile_fans(const SightMap& map, const Executor& executor) {
  // Saws of 10,000 vertices have 1,400 steps a node, and 9 with fans; of 100,000 vertices 14,000 and 9. Where walks are
  // shorter, fans do not pay: with those of a warehouse of 100,000 vertices, 200 to 600 steps a node, a build took 8 %
  // longer.
  constexpr double kVeryManySteps = 1000.0, kMuchLess = 0.5;
  constexpr std::uint32_t kLeastTriangles = 64;
  const double steps = steps_a_node(map, executor);
  if (steps < kVeryManySteps) return {};
  LongFans fans(map, kLeastTriangles, executor.clock());
  return steps_a_node(map, executor, &fans) < kMuchLess * steps ? std::move(fans) : LongFans();
}

std::vector<VertexId> tangent_neighbors(const SightMap& map, std::uint32_t node, const LongFans* fans) {
  if (node == kNone) return {};
  WedgeWalk walk(map, nullptr, fans);
  walk.look_around(node);
  std::vector<VertexId> row;
  for (const auto& [u, v] : walk.take_edges()) row.push_back(v);
  std::sort(row.begin(), row.end());
  return row;
}

}  // namespace arcway::internal
