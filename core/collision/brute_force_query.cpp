#include "core/collision/brute_force_query.h"

#include <algorithm>
#include <cmath>

#include "arcway/query_set.h"
#include "core/collision/blocking.h"
#include "core/collision/swept_shape.h"
#include "core/collision/turning_headings.h"
#include "core/geometry/distance.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

ObstacleId find_containing(const World& world, const Vec2& p) {
  for (ObstacleId o = 0; o < world.region_count(); ++o) {
    const bool bounds = o == world.obstacle_count();
    if (!bounds && !world.box_of(o).contains(p)) continue;
    if (world.locate(p, o) == PointLocation::kInside) return o;
  }
  return kNone;
}

// Whether a test holds for an edge near a swept rectangle.
template <class Test>
bool is_met(const World& world, const SweptRectangle& rectangle, const Test& test) {
  Box box;
  for (const Vec2& corner : rectangle) box.extend(corner);
  for (ObstacleId o = 0; o < world.region_count(); ++o) {
    if (!world.box_of(o).overlaps(box)) continue;
    const auto [first, last] = world.vertices_of(o);
    for (VertexId e = first; e < last; ++e)
      if (box_of(world.edges()[e]).overlaps(box) && test(world.edges()[e])) return true;
  }
  return false;
}

}  // namespace

void BruteForceQuery::do_visible(std::span<const LineSegment> segments, std::span<std::uint8_t> visible) const {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const LineSegment& s = segments[i];
    const Box box = box_of(s);
    const auto blocked = [&] {
      if (s.a == s.b) return find_containing(world_, s.a) != kNone;
      for (ObstacleId o = 0; o < world_.region_count(); ++o) {
        if (!world_.box_of(o).overlaps(box)) continue;
        const auto [first, last] = world_.vertices_of(o);
        for (VertexId e = first; e < last; ++e)
          if (box_of(world_.edges()[e]).overlaps(box) && blocks(world_, e, s)) return true;
      }
      return find_containing(world_, s.a) != kNone;
    };
    visible[i] = blocked() ? 0 : 1;
  }
}

void BruteForceQuery::do_closest(std::span<const Vec2> points, std::span<ClosestPoint> result) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    ClosestPoint best;
    for (VertexId e = 0; e < world_.edges().size(); ++e) {
      const Vec2 candidate = closest_point(points[i], world_.edges()[e]);
      const double distance = (candidate - points[i]).norm();
      if (distance < best.distance) best = {distance, candidate, e};
    }
    result[i] = best;
  }
}

void BruteForceQuery::do_closer_than(std::span<const Vec2> points, std::span<const double> distances,
                                     std::span<std::uint8_t> closer) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& p = points[i];
    closer[i] = std::any_of(world_.edges().begin(), world_.edges().end(),
                            [&](const LineSegment& e) { return (closest_point(p, e) - p).norm() < distances[i]; });
  }
}

void BruteForceQuery::do_containing(std::span<const Vec2> points, std::span<ObstacleId> result) const {
  for (std::size_t i = 0; i < points.size(); ++i) result[i] = find_containing(world_, points[i]);
}

void BruteForceQuery::do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const {
  for (std::size_t i = 0; i < rectangles.size(); ++i) {
    const SweptRectangle& r = rectangles[i];
    // Where no edge meets it, it lies on one side of every boundary.
    const bool blocked = is_met(world_, r, [&](const LineSegment& edge) { return intersects(edge, r); }) ||
                         find_containing(world_, r[0]) != kNone;
    free[i] = blocked ? 0 : 1;
  }
}

void BruteForceQuery::do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const {
  SweptShape::Memory memory;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const SweptShape shape(bodies[i], memory);
    // Where no edge meets it, each connected part lies on one side of every boundary.
    const bool blocked = is_met(world_, shape.bounds(), [&](const LineSegment& edge) { return shape.meets(edge); }) ||
                         shape.has_inner_point([&](const Vec2& p) { return find_containing(world_, p) != kNone; });
    free[i] = blocked ? 0 : 1;
  }
}

void BruteForceQuery::do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const {
  std::vector<HeadingInterval> blocked;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const TurningBody& body = bodies[i];
    const double reach = reach_of(body);
    const Box box{body.center - Vec2(reach, reach), body.center + Vec2(reach, reach)};
    blocked.clear();
    for (ObstacleId o = 0; o < world_.region_count(); ++o) {
      if (!world_.box_of(o).overlaps(box)) continue;
      const auto [first, last] = world_.vertices_of(o);
      for (VertexId e = first; e < last; ++e)
        if (may_touch(body, world_.edges()[e])) append_blocked_headings(body, world_.edges()[e], blocked);
    }
    HeadingSet::complement(blocked, result[i]);
    // Where no edge is touched, each connected part of the body is wholly inside or wholly outside each region.
    for (int k = static_cast<int>(result[i].intervals().size()) - 1; k >= 0; --k) {
      const HeadingInterval& interval = result[i].intervals()[static_cast<std::size_t>(k)];
      const bool is_inside = has_inner_point(body, 0.5 * (interval.low + interval.high),
                                             [&](const Vec2& p) { return find_containing(world_, p) != kNone; });
      if (is_inside) result[i].erase(k);
    }
  }
}

}  // namespace arcway::internal

namespace arcway {

QuerySet make_reference_queries(const World& world) {
  const auto queries = std::make_shared<const internal::BruteForceQuery>(world);
  return {queries, queries, queries};
}

}  // namespace arcway
