#include "accel/expansion/tangent_cone_expansion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/prefetch.h"
#include "core/geometry/expansion.h"
#include "core/geometry/predicates.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

namespace {

// Sign of the cross product of two differences of coordinates that have been rounded once; 0 if rounding may decide it.
inline int filtered_sign(double ux, double uy, double vx, double vy) {
  constexpr double kEpsilon = 0x1p-53;
  constexpr double kErrorBound = (3.0 + 16.0 * kEpsilon) * kEpsilon;  // [Shewchuk 1997, figure 21]
  const double left = ux * vy;
  const double right = uy * vx;
  const double determinant = left - right;
  const double error = kErrorBound * (std::abs(left) + std::abs(right));
  return (determinant > error) - (determinant < -error);
}

// Exact sign of the cross product of b - a and q - p.
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

// Nodes to prefetch ahead: the expansion of a chain reads all of its nodes.
constexpr std::size_t kNodesAhead = 256;

bool is_tangent_at(const FreeSpaceTriangulation::Node& node, const Vec2& from) {
  const double x = node.at.x() - from.x(), y = node.at.y() - from.y();
  int previous = filtered_sign(x, y, node.previous.x() - node.at.x(), node.previous.y() - node.at.y());
  int next = filtered_sign(x, y, node.next.x() - node.at.x(), node.next.y() - node.at.y());
  if (previous == 0) previous = orientation(from, node.at, node.previous);
  if (next == 0) next = orientation(from, node.at, node.next);
  return previous * next >= 0;
}

}  // namespace

TangentConeExpansion::TangentConeExpansion(const FreeSpaceTriangulation& triangulation, const Sleeves* sleeves,
                                           const LongFans* fans)
    : triangulation_(triangulation),
      sleeves_(sleeves && !sleeves->empty() ? sleeves : nullptr),
      fans_(fans && !fans->empty() ? fans : nullptr),
      sure_(triangulation.sure_cross_product()) {}

inline TangentConeExpansion::BoundingRay TangentConeExpansion::bounding_ray(Kind kind, std::uint32_t from,
                                                                            std::uint32_t point, const Vec2& at) const {
  const Vec2& origin = node(from).at;
  Vec2 direction = at - origin;
  if (kind == Kind::kAway) direction = -direction;
  return {origin, direction, from, point | static_cast<std::uint32_t>(kind) << kPointBits};
}

TangentConeExpansion::BoundingRay TangentConeExpansion::straight(Kind kind, std::uint32_t from) const {
  return {node(from).at, {0.0, kind == Kind::kUp ? 1.0 : -1.0}, from, static_cast<std::uint32_t>(kind) << kPointBits};
}

// +1 if the point, at p, lies to the left of the ray.
inline int TangentConeExpansion::side(const BoundingRay& ray, const Vec2& p, std::uint32_t point) const {
  const double determinant =
      ray.direction.x() * (p.y() - ray.origin.y()) - ray.direction.y() * (p.x() - ray.origin.x());
  if (determinant > sure_) return 1;
  if (determinant < -sure_) return -1;
  return exact_side(ray, point);
}

int TangentConeExpansion::exact_side(const BoundingRay& ray, std::uint32_t point) const {
  const Node& source = node(ray.from);
  const auto turn = [&] {
    return ray.point() == point
               ? 0
               : orientation(source.at, triangulation_.points()[ray.point()], triangulation_.points()[point]);
  };
  switch (ray.kind()) {
    case Kind::kMet:
    case Kind::kToward:
      return turn();
    case Kind::kAway:
      return -turn();
    case Kind::kDown:
      return point > source.point ? 1 : -1;
    case Kind::kUp:
      return point > source.point ? -1 : 1;
  }
  return 0;
}

// The tangent directions of a node form two cones. One reaches from the direction of the previous vertex
// counter-clockwise to the opposite of the next vertex's. The other reaches from the opposite of the previous vertex's
// direction to the next vertex's.
void TangentConeExpansion::expand_all(std::uint32_t index) {
  alias_ = kNone;
  const Node& source = triangulation_.nodes()[index];
  follow_edges<Sense::kRight>(source);
  follow_edges<Sense::kLeft>(source);
  expand_cone(index, bounding_ray(Kind::kToward, index, source.previous_point, source.previous),
              bounding_ray(Kind::kAway, index, source.next_point, source.next));
  expand_cone(index, bounding_ray(Kind::kAway, index, source.previous_point, source.previous),
              bounding_ray(Kind::kToward, index, source.next_point, source.next));
  take_tangent();
}

void TangentConeExpansion::expand_right(std::uint32_t index) {
  alias_ = kNone;
  const Node& source = triangulation_.nodes()[index];
  if (index + kNodesAhead < triangulation_.nodes().size()) {
    const Node& ahead = triangulation_.nodes()[index + kNodesAhead];
    will_need(&ahead);
    will_need(&ahead.last_half_edge);
  }
  const bool from_left = source.previous_point < source.point, to_left = source.next_point < source.point;
  if (source.is_simple()) {
    if ((from_left || source.before != kNone) && (to_left || source.after != kNone)) {
      if (!from_left) add(source, triangulation_.nodes()[source.before]);
      if (!to_left) add(source, triangulation_.nodes()[source.after]);
    } else {
      follow_edges<Sense::kRight>(source);
    }
    // Chains start here unless the node lies within a chain, or its rays lead left.
    if (from_left ? source.before == kNone : !to_left) expand_from_chain<Hand::kLeft>(index);
    if (to_left ? source.after == kNone : !from_left) expand_from_chain<Hand::kRight>(index);
  } else {
    follow_edges<Sense::kRight>(source);
    expand_right_from(index);
  }
  take_tangent();
}

void TangentConeExpansion::expand_right_from(std::uint32_t index) {
  const Node& source = node(index);
  const auto leads_right = [&](const BoundingRay& ray) {
    return (ray.kind() == Kind::kToward) == (ray.point() > source.point);
  };
  const auto expand_if_right = [&](const BoundingRay& low, const BoundingRay& high) {
    const bool low_is_right = leads_right(low), high_is_right = leads_right(high);
    if (!low_is_right && !high_is_right) return;
    expand_cone(index, low_is_right ? low : straight(Kind::kDown, index),
                high_is_right ? high : straight(Kind::kUp, index));
  };
  expand_if_right(bounding_ray(Kind::kToward, index, source.previous_point, source.previous),
                  bounding_ray(Kind::kAway, index, source.next_point, source.next));
  expand_if_right(bounding_ray(Kind::kAway, index, source.previous_point, source.previous),
                  bounding_ray(Kind::kToward, index, source.next_point, source.next));
}

// Follows boundary edges that leave the source, straight on, to the first point with a node.
template <Sense kSense>
void TangentConeExpansion::follow_edges(const Node& source) {
  const auto is_free = [&](const PlanarMap::Edge& edge) { return !triangulation_.is_covered(edge); };
  visit_boundary<kSense>(triangulation_, source.point, [&](const PlanarMap::Edge& first) {
    if (const PlanarMap::Edge* last = edge_to_node<kSense>(triangulation_, first, is_free))
      report_along_boundary(source, end_of<kSense>(first), begin_of<kSense>(*last), end_of<kSense>(*last));
  });
}

void TangentConeExpansion::report_along_boundary(const Node& source, std::uint32_t first, std::uint32_t before_end,
                                                 std::uint32_t end) {
  const std::span<const Node> nodes = triangulation_.nodes();
  const bool along_own = first == source.previous_point || first == source.next_point;
  for (std::uint32_t n = triangulation_.first_node_at(end); n != kNone; n = nodes[n].sibling) {
    const bool along_its = before_end == nodes[n].previous_point || before_end == nodes[n].next_point;
    if ((along_own || is_tangent_at(source, nodes[n].at)) && (along_its || is_tangent_at(nodes[n], source.at)))
      add(source, nodes[n]);
  }
}

void TangentConeExpansion::expand_cone(std::uint32_t index, const BoundingRay& cone_low, const BoundingRay& cone_high) {
  const Node& source = triangulation_.nodes()[index];
  struct Spoke {
    BoundingRay ray;
    int low, high;  // sides of the cone's bounding rays
  };
  const auto spoke_to = [&](std::uint32_t point, const Vec2& at) {
    return Spoke{bounding_ray(Kind::kMet, index, point, at), side(cone_low, at, point), side(cone_high, at, point)};
  };
  const FreeSpaceTriangulation::Fan own{source.first_half_edge, source.previous_point};
  for (const FreeSpaceTriangulation::Fan& fan : source.is_simple() ? std::span(&own, 1) : triangulation_.fans(index)) {
    Spoke from = spoke_to(fan.first_point, triangulation_.points()[fan.first_point]);
    std::uint32_t half_edge = fan.half_edge;
    do {
      const FreeSpaceTriangulation::HalfEdge& triangle = triangulation_.half_edges()[half_edge];
      const Spoke to = spoke_to(triangle.point, triangle.apex);
      const bool from_inside = from.low >= 0 && from.high < 0;
      const bool to_inside = to.low >= 0 && to.high <= 0;
      const bool low_between = from.low <= 0 && to.low > 0;
      if (triangle.right != kNone && (from_inside || low_between))
        expand(triangle.right, from_inside ? from.ray : cone_low, to_inside ? to.ray : cone_high);
      const bool is_diagonal = triangle.left != kNone;
      if (is_diagonal && to_inside && triangle.node != kNone) report(index, triangle.node);
      from = to;
      half_edge = triangle.left;
    } while (half_edge != kNone && half_edge != fan.half_edge);
  }
}

// Goes around the obstacle from node to node, and around each node from spoke to spoke. All rays of the chain beyond
// the near bounding ray cross the current spoke, or start at the current node behind it.
// Long because all cases of a step share the current node, half-edge and bounding ray.
template <TangentConeExpansion::Hand kHand>
void TangentConeExpansion::expand_from_chain(std::uint32_t first) {
  constexpr bool kLeft = kHand == Hand::kLeft;
  constexpr Kind kStart = kLeft ? Kind::kDown : Kind::kUp, kEnd = kLeft ? Kind::kUp : Kind::kDown;
  const FreeSpaceTriangulation::HalfEdge* const half_edges = triangulation_.half_edges().data();
  const auto onward = [&](std::uint32_t half_edge) {
    return kLeft ? half_edges[half_edge].left : half_edges[half_edge].right;
  };
  const auto outward = [&](std::uint32_t half_edge) {
    return kLeft ? half_edges[half_edge].right : half_edges[half_edge].left;
  };
  const auto expand_out = [&](std::uint32_t half_edge, const BoundingRay& near, const BoundingRay& far) {
    if (half_edge != kNone) expand(half_edge, kLeft ? near : far, kLeft ? far : near);
  };

  hand_ = kHand;
  alias_ = kNone;
  std::uint32_t place = first;
  if (!kLeft && triangulation_.nodes()[first].before != kNone && triangulation_.nodes()[first].before > first) {
    alias_ = place = triangulation_.nodes()[first].before + 1;
    alias_of_ = first;
  }
  const Node* source = &node(place);
  std::uint32_t half_edge = kLeft ? source->first_half_edge : source->last_half_edge;
  BoundingRay near = straight(kStart, place);
  const std::uint32_t behind = kLeft ? source->previous_point : source->next_point;
  if (behind < source->point) {
    near = bounding_ray(Kind::kAway, place, behind, kLeft ? source->previous : source->next);
  } else {
    while (half_edges[half_edge].point > source->point) half_edge = onward(half_edge);
  }
  const auto move_on = [&](std::uint32_t nodes) {
    place = kLeft ? place + nodes : place - nodes;
    source = &node(place);
  };
  while (true) {
    ++steps_;
    const std::uint32_t ahead = kLeft ? source->next_point : source->previous_point;
    const bool leads_right = ahead > source->point;
    const bool chain_goes_on = leads_right && (kLeft ? source->after : source->before) != kNone;
    const Sleeves::Sleeve* const sleeve = sleeves_ ? sleeves_->behind(half_edge) : nullptr;
    if (sleeve) {
      const std::uint32_t count = kLeft ? sleeve->left.count : sleeve->right.count;
      if (!pass_along<kHand>(*sleeve, chain_goes_on ? count : 0, place, near)) return;
      if (chain_goes_on || count == 0) {
        move_on(count);
        half_edge = sleeve->exit;
        continue;
      }
    }
    const bool is_last = sleeve || onward(half_edge) == kNone;
    if (is_last && chain_goes_on) {
      move_on(1);
      half_edge = outward(half_edge);
      continue;
    }
    if (is_last) {
      const std::uint32_t boundary = kLeft ? source->last_half_edge : source->first_half_edge;
      expand_out(onward(boundary), near,
                 leads_right ? bounding_ray(Kind::kMet, place, ahead, kLeft ? source->next : source->previous)
                             : straight(kEnd, place));
      return;
    }
    const FreeSpaceTriangulation::HalfEdge& triangle = half_edges[half_edge];
    const int near_side = (kLeft ? 1 : -1) * side(near, triangle.apex, triangle.point);
    if (near_side >= 0) {
      const std::uint32_t from = kLeft ? touch(near.from, place, End::kLow, triangle.apex)
                                       : touch(place, near.from, End::kHigh, triangle.apex);
      if (from == place && triangle.point < source->point) {
        expand_out(outward(half_edge), near, straight(kEnd, place));
        return;
      }
      if (triangle.node != kNone && (near_side > 0 || is_closed(near))) report(from, triangle.node);
      const BoundingRay middle = bounding_ray(Kind::kMet, from, triangle.point, triangle.apex);
      if (near_side > 0) expand_out(outward(half_edge), near, middle);
      near = middle;
    }
    half_edge = onward(half_edge);
  }
}

// The position in [low, high] whose tangent ray passes p while no other position hides it. The search gallops from one
// end, because neighbors along a boundary are mostly seen from neighboring positions.
std::uint32_t TangentConeExpansion::touch(std::uint32_t low, std::uint32_t high, End from, const Vec2& p) const {
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

void TangentConeExpansion::expand(std::uint32_t half_edge, const BoundingRay& low, const BoundingRay& high) {
  if (sleeves_) {
    fans_ ? expand_through<true, true>(half_edge, low, high) : expand_through<true, false>(half_edge, low, high);
  } else {
    fans_ ? expand_through<false, true>(half_edge, low, high) : expand_through<false, false>(half_edge, low, high);
  }
}

// Long because all cases of a step share the half-edge, both bounding rays and the reports that may be replaced.
template <bool kHasSleeves, bool kHasFans>
void TangentConeExpansion::expand_through(std::uint32_t half_edge, BoundingRay low, BoundingRay high) {
  const FreeSpaceTriangulation::HalfEdge* const half_edges = triangulation_.half_edges().data();
  std::uint64_t steps = 0;
  // Reports of the half-edge's ends, if they are far ends of visible boundary edges. They turn out not to be tangent
  // once the next boundary edge is visible too.
  std::uint32_t left_end = kNone, right_end = kNone;
  while (true) {
    ++steps;
    if (const Sleeves::Sleeve* sleeve = kHasSleeves ? sleeves_->behind(half_edge) : nullptr) {
      will_need(half_edges + sleeve->exit);
      half_edge = pass(*sleeve, low, high) ? sleeve->exit : kNone;
      left_end = right_end = kNone;
    } else {
      const FreeSpaceTriangulation::HalfEdge& triangle = half_edges[half_edge];
      will_need(half_edges + triangle.left);
      will_need(half_edges + triangle.right);
      const int low_side = side(low, triangle.apex, triangle.point);
      if (low_side < 0) {
        half_edge = triangle.left;
        right_end = kNone;
      } else {
        const int high_side = side(high, triangle.apex, triangle.point);
        if (high_side > 0) {
          half_edge = triangle.right;
          left_end = kNone;
        } else {
          const End near = triangle.right == kNone ? End::kLow : End::kHigh;
          const std::uint32_t from = touch(low.from, high.from, near, triangle.apex);
          const bool in_range = (low_side > 0 || is_closed(low)) && (high_side < 0 || is_closed(high));
          const bool ends_right_boundary = triangle.right == kNone && low_side > 0;
          const bool ends_left_boundary = triangle.left == kNone && high_side < 0;
          std::uint32_t seen = kNone;
          if (in_range && triangle.node != kNone)
            seen = report(from, triangle.node, ends_right_boundary ? right_end : ends_left_boundary ? left_end : kNone);
          // The cone between a bounding ray and itself is empty.
          const BoundingRay middle = bounding_ray(Kind::kMet, from, triangle.point, triangle.apex);
          const bool goes_left = high_side < 0 && triangle.left != kNone;
          const bool goes_right = low_side > 0 && triangle.right != kNone;
          if (goes_left && goes_right) stack_.push_back({triangle.right, low, middle});
          if (goes_left) {
            right_end = ends_right_boundary ? seen : kNone;
            half_edge = triangle.left;
            low = middle;
          } else {
            left_end = ends_left_boundary ? seen : kNone;
            half_edge = goes_right ? triangle.right : kNone;
            high = middle;
          }
        }
      }
      if constexpr (kHasFans) {
        if (half_edge == triangle.left && half_edge != kNone) {
          half_edge = pass_fan<Hand::kLeft>(half_edge, low);
          if (half_edge != triangle.left) right_end = kNone;
        } else if (half_edge != kNone) {
          half_edge = pass_fan<Hand::kRight>(half_edge, high);
          if (half_edge != triangle.right) left_end = kNone;
        }
      }
    }
    if (half_edge != kNone) continue;
    if (stack_.empty()) break;
    const Postponed& next = stack_.back();
    half_edge = next.half_edge;
    low = next.low;
    high = next.high;
    left_end = right_end = kNone;
    stack_.pop_back();
  }
  steps_ += steps;
}

template <TangentConeExpansion::Hand kPivot>
std::uint32_t TangentConeExpansion::pass_fan(std::uint32_t half_edge, const BoundingRay& ray) const {
  constexpr int kStep = kPivot == Hand::kLeft ? 1 : -1;
  const auto [fan, triangle] = fans_->behind<kStep>(half_edge);
  if (!fan || kStep * side(ray, triangulation_.points()[fan->pivot], fan->pivot) <= 0) return half_edge;
  const int least = is_closed(ray) ? 0 : 1;  // a corner on an open bounding ray is crossed
  const auto stops = [&](std::uint32_t point) {
    return kStep * side(ray, triangulation_.points()[point], point) >= least;
  };
  const auto rises = [&](std::uint32_t from, std::uint32_t to) { return kStep * turn_along(ray, from, to) > 0; };
  if (const auto stop = fans_->first_stop<kStep>(*fan, triangle, stops, rises))
    return fans_->half_edge<kStep>(*fan, *stop);
  const FreeSpaceTriangulation::HalfEdge& last =
      triangulation_.half_edges()[fans_->half_edge<kStep>(*fan, LongFans::last_triangle<kStep>(*fan))];
  return kStep > 0 ? last.left : last.right;
}

// Exact sign of the cross product of the ray's direction and the vector from one point to another.
int TangentConeExpansion::turn_along(const BoundingRay& ray, std::uint32_t from, std::uint32_t to) const {
  if (ray.kind() == Kind::kDown) return to > from ? 1 : -1;
  if (ray.kind() == Kind::kUp) return to > from ? -1 : 1;
  const Vec2 &p = triangulation_.points()[from], &q = triangulation_.points()[to];
  const int sure = filtered_sign(ray.direction.x(), ray.direction.y(), q.x() - p.x(), q.y() - p.y());
  if (sure != 0) return sure;
  const int exact = cross_sign(node(ray.from).at, triangulation_.points()[ray.point()], p, q);
  return ray.kind() == Kind::kAway ? -exact : exact;
}

// Searches the chain from the position where the cone's bounding ray starts. The ray to the node found may start at
// another position, so the search repeats from there. Each ray leaves more of the chain behind, until one leaves all of
// it there.
template <int kStep, class Passed, class From>
TangentConeExpansion::Contact TangentConeExpansion::contact(const Sleeves::Chain<kStep>& chain,
                                                            const ChainSearch& search, const Passed& passed_before,
                                                            const From& touched_from) const {
  const auto& [nodes, own, other, first_guess] = search;
  std::uint32_t guess = first_guess;
  Contact found;
  found.ray = own;
  while (true) {
    const std::uint32_t from = found.ray.from;
    const std::uint32_t index = chain.bounding_node_from(node(from).at, nodes, passed_before(from), guess, sure_);
    if (index == kNone || index == found.index) return found;
    const Node& n = chain.node(index);
    const int own_side = kStep * side(own, n.at, n.point);
    if (own_side > 0) return found;
    found.index = guess = index;
    found.own_side = own_side;
    if (other) found.other_side = kStep * side(*other, n.at, n.point);
    if (found.other_side < 0) return found;
    found.ray = bounding_ray(Kind::kMet, touched_from(index, n.at), n.point, n.at);
    if (found.ray.from == from) return found;
  }
}

bool TangentConeExpansion::pass(const Sleeves::Sleeve& sleeve, BoundingRay& low, BoundingRay& high) {
  const Sleeves::Chain<1> left(sleeve.left, triangulation_.nodes());
  const Sleeves::Chain<-1> right(sleeve.right, triangulation_.nodes());
  const auto none = [](std::uint32_t) { return 0u; };
  const auto touched = [&](End end) {
    return [&, end](std::uint32_t, const Vec2& at) { return touch(low.from, high.from, end, at); };
  };
  const std::uint32_t guess_left = left.guess(high.direction), guess_right = right.guess(low.direction);
  left.fetch(guess_left);
  right.fetch(guess_right);
  const Contact on_left = contact(left, {left.count(), high, &low, guess_left}, none, touched(End::kHigh));
  const Contact on_right = contact(right, {right.count(), low, &high, guess_right}, none, touched(End::kLow));
  bool passes = on_left.leaves_way() && on_right.leaves_way();
  if (passes && on_left.exists() && on_right.exists()) {
    passes = side(on_left.ray, right.node(on_right.index).at, right.node(on_right.index).point) < 0;
  }
  // A node in the cone is visible unless the other chain hides it, as far as that chain was passed before.
  const auto report_if_seen = [&](const Contact& c, const auto& chain, const BoundingRay& own, const BoundingRay& other,
                                  const auto& across, std::uint32_t passed) {
    const bool in_range =
        (c.own_side < 0 || is_closed(own)) && (c.other_side > 0 || (c.other_side == 0 && is_closed(other)));
    if (!in_range) return;
    if (!passes) {
      const Vec2& s = node(c.ray.from).at;
      const std::uint32_t hides = across.bounding_node_from(s, passed, 0, 0, sure_);
      if (hides != kNone && across.turn(s, chain.node(c.index).at, across.node(hides).at) <= 0) return;
    }
    report(c.ray.from, chain.index_of_node(c.index));
  };
  if (on_left.exists())
    report_if_seen(on_left, left, high, low, right, passes ? 0 : sleeves_->right_before(sleeve, on_left.index));
  if (on_right.exists())
    report_if_seen(on_right, right, low, high, left, passes ? 0 : sleeves_->left_before(sleeve, on_right.index));
  if (passes && on_left.exists()) high = on_left.ray;
  if (passes && on_right.exists()) low = on_right.ray;
  return passes;
}

// From the chain, the other chain is visible up to the node that a ray of the chain touches. Such a ray starts at one
// of the chain's nodes before that node. Positions within the sleeve do not see the other chain's nodes before them.
template <TangentConeExpansion::Hand kHand>
bool TangentConeExpansion::pass_along(const Sleeves::Sleeve& sleeve, std::uint32_t count, std::uint32_t place,
                                      BoundingRay& near) {
  constexpr bool kLeft = kHand == Hand::kLeft;
  const Sleeves::Chain<kLeft ? -1 : 1> across(kLeft ? sleeve.right : sleeve.left, triangulation_.nodes());
  const auto across_before = [&](std::uint32_t i) {  // number of the other chain's nodes before one of this chain
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
  const std::uint32_t visible_count =
      count == (kLeft ? sleeve.left.count : sleeve.right.count) ? across.count() : across_before(0);
  const Contact found =
      contact(across, {visible_count, near, nullptr, across.guess(near.direction)}, passed_before, touched_from);
  if (!found.exists()) return true;
  const std::uint32_t end = ahead(count);
  if (found.ray.from == end && across.node(found.index).point < node(end).point)
    return false;  // rays from there on lead left
  if (found.own_side < 0 || is_closed(near)) report(found.ray.from, across.index_of_node(found.index));
  near = found.ray;
  return true;
}

inline std::uint32_t TangentConeExpansion::report(std::uint32_t place, std::uint32_t first_node,
                                                  std::uint32_t instead_of) {
  const Node* const target = triangulation_.nodes().data() + first_node;
  will_need(target);
  will_need(&target->vertex);
  const std::pair<std::uint32_t, std::uint32_t> seen{place == alias_ ? alias_of_ : place, first_node};
  if (instead_of != kNone) {
    seen_[instead_of] = seen;
    return instead_of;
  }
  seen_.push_back(seen);
  return triangulation_.is_simple() ? static_cast<std::uint32_t>(seen_.size() - 1) : kNone;
}

void TangentConeExpansion::take_tangent() {
  for (const auto& [from, first_node] : seen_) {
    const Node& source = triangulation_.nodes()[from];
    for (std::uint32_t n = first_node; n != kNone; n = triangulation_.nodes()[n].sibling)
      if (is_tangent_at(triangulation_.nodes()[n], source.at)) add(source, triangulation_.nodes()[n]);
  }
  seen_.clear();
}

void TangentConeExpansion::add(const Node& source, const Node& target) {
  if (!triangulation_.is_valid()) {
    ++candidates_;
    if (triangulation_.is_blocked_by_invalid({source.at, target.at})) return;
  }
  edges_.emplace_back(source.vertex, target.vertex);
}

EdgeList TangentConeExpansion::take_edges() {
  EdgeList taken = edges_;  // a copy has no spare capacity
  edges_.clear();
  return taken;
}

std::vector<VertexId> tangent_neighbors(const FreeSpaceTriangulation& triangulation, std::uint32_t node,
                                        const LongFans* fans) {
  if (node == kNone) return {};
  TangentConeExpansion expansion(triangulation, nullptr, fans);
  expansion.expand_all(node);
  std::vector<VertexId> row;
  for (const auto& [u, v] : expansion.take_edges()) row.push_back(v);
  std::sort(row.begin(), row.end());
  return row;
}

}  // namespace arcway::internal
