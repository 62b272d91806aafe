#include <cmath>
#include <cstddef>
#include <limits>

#include "accel/embree/embree_queries.h"
#include "arcway/angle.h"
#include "core/collision/heading_range.h"
#include "core/collision/turning_headings.h"
#include "core/geometry/predicates.h"

namespace arcway::internal::embree {

namespace {

// Beyond this many parallel rays, one point query about the whole rectangle is cheaper.
constexpr double kMostRays = 16.0;
// Angle to both sides of a heading that is examined first [rad]. Where obstacles end the turn within it, the rest of
// the circle need not be examined.
constexpr double kNearTurn = kPi / 4.0;
// Number of edges near a circle up to which the whole circle is examined at once.
constexpr std::size_t kFewEdges = 24;
// Distance from the ends of the angle examined first at which other edges may count [rad].
constexpr double kSureOfEnd = 1e-6;

}  // namespace

bool MeetsRectangle::operator()(VertexId edge) const {
  const LineSegment& e = world.edges()[edge];
  return shape == nullptr ? intersects(e, rectangle) : shape->meets(e);
}

// Covers the rectangle by bands along its longer sides, none wider than twice the scene's inflation. Every point of a
// band lies within half the band's width of its middle line, and so does the box of an edge through that point. This
// holds for any convex quadrilateral, so rounded corners are no problem.
bool EmbreeSweep::is_met(const SweptRectangle& r, const SweptShape* shape) const {
  const MeetsRectangle test{scenes_->world(), r, shape};
  const double ends = std::max((r[3] - r[0]).norm(), (r[2] - r[1]).norm());
  const double sides = std::max((r[1] - r[0]).norm(), (r[2] - r[3]).norm());
  const bool lengthwise = sides >= ends;
  const EdgeScene& edges = scenes_->sweep.edges();
  const Vec2 a = edges.scaled(r[0]);
  const Vec2 b = edges.scaled(lengthwise ? r[3] : r[1]);
  const Vec2 c = edges.scaled(lengthwise ? r[1] : r[3]);
  const Vec2 d = edges.scaled(r[2]);
  const double bands = std::max(1.0, std::ceil((lengthwise ? ends : sides) / (2.0 * edges.inflation())));
  if (bands <= kMostRays) {
    for (int k = 0; k < static_cast<int>(bands); ++k) {
      const double t = (k + 0.5) / bands;
      if (scenes_->sweep.any(a + t * (b - a), c + t * (d - c), test)) return true;
    }
    return false;
  }
  const Vec2 middle = 0.25 * (r[0] + r[1] + r[2] + r[3]);
  double reach = 0.0;
  for (const Vec2& corner : r) reach = std::max(reach, (corner - middle).norm());
  bool met = false;
  scenes_->visibility.edges().visit_near(middle, reach, [&](VertexId e) {
    met = test(e);
    return met ? -1.0 : reach;
  });
  return met;
}

void EmbreeSweep::do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const {
  scenes_->for_batch(rectangles.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      // Where no edge meets it, the rectangle lies on one side of every boundary.
      free[i] = !is_met(rectangles[i]) && scenes_->locator.containing(rectangles[i][0]) == kNone ? 1 : 0;
    }
  });
}

void EmbreeSweep::do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const {
  scenes_->for_batch(bodies.size(), [&](std::size_t begin, std::size_t end) {
    static thread_local SweptShape::Memory memory;
    for (std::size_t i = begin; i < end; ++i) {
      const SweptShape shape(bodies[i], memory);
      // Where no edge meets it, each connected part lies on one side of every boundary.
      const bool blocked = is_met(shape.bounds(), &shape) || shape.has_inner_point([&](const Vec2& p) {
        return scenes_->locator.containing(p) != kNone;
      });
      free[i] = blocked ? 0 : 1;
    }
  });
}

void EmbreeSweep::do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const {
  scenes_->for_batch(bodies.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      find_headings(bodies[i], std::numeric_limits<std::size_t>::max(), result[i]);
  });
}

bool EmbreeSweep::find_headings(const TurningBody& body, std::size_t most_edges, HeadingSet& free) const {
  static thread_local std::vector<HeadingInterval> blocked;  // single queries are frequent and must not allocate
  const std::span<const LineSegment> edges = scenes_->world().edges();
  const double reach = reach_of(body);
  std::size_t count = 0;
  EdgeContacts contacts(body);
  blocked.clear();
  scenes_->visibility.edges().visit_near(body.center, reach, [&](VertexId e) {
    if (++count > most_edges) return -1.0;
    if (contacts.may_touch(edges[e])) contacts.append_blocked(edges[e], blocked);
    return reach;
  });
  if (count > most_edges) return false;
  HeadingSet::complement(blocked, free);
  for (int k = static_cast<int>(free.intervals().size()) - 1; k >= 0; --k) {
    const HeadingInterval& interval = free.intervals()[static_cast<std::size_t>(k)];
    if (!is_outside(body, 0.5 * (interval.low + interval.high))) free.erase(k);
  }
  return true;
}

bool EmbreeSweep::do_arc_free(const TurningBody& body, double heading, double angle, HeadingSet& /*headings*/) const {
  static thread_local HeadingRange::Memory memory;
  const std::span<const LineSegment> edges = scenes_->world().edges();
  HeadingRange range(body, body.side == Side::kLeft ? heading : heading - angle, angle, memory);
  scenes_->visibility.edges().visit_near(range.middle(), range.reach(),
                                         [&](VertexId e) { return range.add(edges[e]) ? range.reach() : -1.0; });
  return range.is_clear() && range.free_headings().reach(heading, body.side) >= angle && is_outside(body, heading);
}

double EmbreeSweep::do_reach(const TurningBody& body, double heading, Side towards, HeadingSet& all) const {
  if (find_headings(body, kFewEdges, all)) return all.reach(heading, towards);
  static thread_local HeadingRange::Memory memory;
  const std::span<const LineSegment> edges = scenes_->world().edges();
  HeadingRange range(body, heading - kNearTurn, 2.0 * kNearTurn, memory);
  scenes_->visibility.edges().visit_near(range.middle(), range.reach(), [&](VertexId e) {
    range.add(edges[e]);
    return range.reach();
  });
  const HeadingSet& free = range.free_headings();
  const auto ends_near = [&](Side side) { return free.reach(heading, side) < kNearTurn - kSureOfEnd; };
  if (!ends_near(Side::kLeft) || !ends_near(Side::kRight)) {
    do_free_headings({&body, 1}, {&all, 1});
    return all.reach(heading, towards);
  }
  return is_outside(body, heading) ? free.reach(heading, towards) : -1.0;
}

// Where the body touches no edge, each of its connected parts is wholly inside or wholly outside each region.
bool EmbreeSweep::is_outside(const TurningBody& body, double heading) const {
  return !has_inner_point(body, heading, [&](const Vec2& p) { return scenes_->locator.containing(p) != kNone; });
}

}  // namespace arcway::internal::embree
