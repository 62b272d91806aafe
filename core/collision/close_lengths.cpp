#include "core/collision/close_lengths.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "arcway/angle.h"
#include "core/collision/motion_free.h"
#include "core/collision/turning_headings.h"

namespace arcway::internal {

namespace {

// Whether a test holds for an edge of an outline whose box, and those around it, pass another one.
template <class IsNear, class Visitor>
void visit_edges(const Outlines& outlines, const IsNear& is_near, const Visitor& visit) {
  outlines.visit_if(is_near, [&](const Outlines::Piece& piece) {
    for (std::size_t i = 0; i < piece.edge_count(); ++i) {
      const LineSegment edge{piece.points[i], piece.points[i + 1]};
      if (is_near(box_of(edge))) visit(edge);
    }
    return true;
  });
}

}  // namespace

CloseLengths::CloseLengths(const Vehicle& vehicle, std::shared_ptr<const Outlines> outlines, double distance)
    : vehicle_(vehicle), outlines_(std::move(outlines)), distance_(distance), body_(vehicle_.body(distance)) {}

double CloseLengths::on(const PathSegment& segment) const {
  if (!(segment.length > 0.0)) return 0.0;
  const PathSegment ahead = segment.forwards();
  if (ahead.is_line()) return close_length(StraightBody{ahead.start, ahead.length, body_});
  const TurningBody turning = turning_body(ahead, body_);
  return turning.radius * close_angle(turning, ahead.start.heading, ahead.length / turning.radius);
}

double CloseLengths::close_length(const StraightBody& straight) const {
  // The swept rectangle, in the frame of the start.
  const Box swept{{-body_.rear, -body_.right}, {straight.length + body_.front, body_.left}};
  const Vec2 ahead = direction_of(straight.from.heading), axis = ahead.cwiseAbs();
  const auto is_near = [&](const Box& box) {
    const Vec2 d = 0.5 * (box.min + box.max) - straight.from.position(), half = 0.5 * (box.max - box.min);
    const Vec2 middle(ahead.dot(d), cross(ahead, d));
    const Vec2 extent(axis.dot(half), axis.x() * half.y() + axis.y() * half.x());
    return swept.overlaps({middle - extent, middle + extent});
  };
  std::vector<BlockedRange> blocked;
  visit_edges(*outlines_, is_near, [&](const LineSegment& edge) { append_blocked_stations(straight, edge, blocked); });
  return length_of_union(blocked);
}

std::vector<HeadingInterval> CloseLengths::headings_on(const TurningBody& turning) const {
  std::vector<HeadingInterval> headings = headings_near(turning, turning.center, reach_of(turning));
  std::ranges::sort(headings, {}, &HeadingInterval::low);
  std::vector<HeadingInterval> merged;
  for (const HeadingInterval& interval : headings) {
    if (merged.empty() || interval.low > merged.back().high) {
      merged.push_back(interval);
    } else {
      merged.back().high = std::max(merged.back().high, interval.high);
    }
  }
  return merged;
}

double CloseLengths::close_angle(const TurningBody& turning, double heading, double angle) const {
  const double sign = sign_of(turning.side);
  const auto place_at = [&](double at) {
    return Vec2(turning.center - sign * turning.radius * perpendicular(direction_of(at)));
  };
  const Vec2 middle = place_at(heading + 0.5 * sign * angle);
  const double driven = angle < kPi ? (place_at(heading) - middle).norm() : 2.0 * turning.radius;
  return angle_within(headings_near(turning, middle, body_.farthest() + driven), heading, turning.side, angle);
}

// The headings at which edges within a reach of a place are touched.
std::vector<HeadingInterval> CloseLengths::headings_near(const TurningBody& turning, const Vec2& place,
                                                         double reach) const {
  const Box around = Box{place, place}.grown(reach);
  EdgeContacts contacts(turning);
  std::vector<HeadingInterval> headings;
  visit_edges(
      *outlines_, [&](const Box& box) { return around.overlaps(box); },
      [&](const LineSegment& edge) {
        if (contacts.may_touch(edge)) contacts.append_blocked(edge, headings);
      });
  return headings;
}

// By angles from the first heading in the sense of the turn.
double angle_within(std::span<const HeadingInterval> headings, double heading, Side side, double angle) {
  const double sign = sign_of(side);
  std::vector<BlockedRange> blocked;
  for (const HeadingInterval& interval : headings) {
    const double begin = sign > 0.0 ? interval.low : interval.high, length = interval.high - interval.low;
    double at = wrap_positive(sign * (begin - heading)) - kTwoPi;
    while (at <= angle) {
      if (at + length >= 0.0) blocked.push_back({std::max(at, 0.0), std::min(at + length, angle)});
      at += kTwoPi;
    }
  }
  return length_of_union(blocked);
}

}  // namespace arcway::internal
