#include "core/attach/occlusion_horizon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "arcway/angle.h"

namespace arcway::internal {

namespace {

// Largest half width of a piece of outline, in distances from the circle's center. A narrower piece spans less than pi
// of headings.
constexpr double kWidestPiece = 0.7;

// Longest edge, in distances from the center. The headings of its ends differ from pi by more than 1e-3, far more than
// rounding.
constexpr double kLongestEdge = 1000.0;

// An upper bound on asin(x), 0 <= x <= 1: asin is convex there.
double above_asin(double x) { return x < 0.5 ? (kPi / 3.0) * x : kPi / 6.0 + (2.0 * kPi / 3.0) * (x - 0.5); }

// The ball around a box, seen from outside of it.
struct Ball {
  double heading, distance;  // of its center; the heading within kQuickAngleError
  double radius;
};

// The ball around a box as seen from a place; nothing if the ball contains the place.
std::optional<Ball> ball_around(const Box& box, const Vec2& place) {
  const Vec2 d = 0.5 * (box.min + box.max) - place;
  const Vec2 extent = 0.5 * (box.max - box.min);
  if (d.squaredNorm() <= extent.squaredNorm()) return std::nullopt;
  return Ball{quick_angle_of(d), d.norm(), extent.norm()};
}

// Distance from the center within which no straight that leaves the circle reaches a point of the box.
double nearest_of(const Box& box, const TurnCircle& circle) {
  return std::max(box.distance_to(circle.center), circle.radius);
}

struct Headings {
  double low, high;
};

// The headings of straights that leave a circle and lead to points of a ball, seen from its center.
// @param near  no point is nearer to the center [m]; at least the circle's radius.
Headings headings_towards(const Ball& ball, double near, const TurnCircle& circle) {
  const double spread = above_asin(ball.radius / ball.distance) + kQuickAngleError;
  const double lead_near = above_asin(circle.radius / near);
  const double lead_far = circle.radius / std::max(near, ball.distance + ball.radius);  // below its asin
  const bool left = circle.side == Side::kLeft;
  return {ball.heading - spread + (left ? lead_far : -lead_near) - kHorizonSlack,
          ball.heading + spread + (left ? lead_near : -lead_far) + kHorizonSlack};
}

}  // namespace

OcclusionHorizon::OcclusionHorizon(const TurnCircle& circle, double heading, double turn) : circle_(circle) {
  far_.setConstant(-std::numeric_limits<double>::infinity());
  farthest_.fill(std::numeric_limits<double>::infinity());
  const double low = heading - (circle.side == Side::kLeft ? 0.0 : turn) - kHorizonSlack;
  const auto first = static_cast<long>(std::floor(wrap_positive(low) * (kHeadings / kTwoPi)));
  const auto count = static_cast<long>(std::ceil((turn + 2.0 * kHorizonSlack) * (kHeadings / kTwoPi))) + 1;
  for (long k = first; k < first + std::min(count, static_cast<long>(kHeadings)); ++k)
    far_[k % kHeadings] = std::numeric_limits<double>::infinity();
}

void OcclusionHorizon::shorten(const Outlines& outlines) {
  outlines.visit_near_first(
      circle_.center, [this](const Box& box) { return !hides(box); },
      [this](const Outlines::Piece& piece) { shorten(piece.points, piece.box); });
}

void OcclusionHorizon::shorten(std::span<const Vec2> outline, const Box& box) {
  const double half = 0.5 * (box.max - box.min).norm();
  const double distance = (0.5 * (box.min + box.max) - circle_.center).norm();
  if (half > kWidestPiece * distance || distance - half <= circle_.radius * (1.0 + kHorizonSlack)) {
    if (outline.size() == 2) return shorten_by_edge({outline[0], outline[1]});
    const std::size_t middle = outline.size() / 2;
    for (const auto part : {outline.subspan(0, middle + 1), outline.subspan(middle)}) {
      Box part_box;
      for (const Vec2& p : part) part_box.extend(p);
      shorten(part, part_box);
    }
    return;
  }
  shorten_by(outline);
}

// An edge outside of the circle spans less than pi of headings, however long it is.
void OcclusionHorizon::shorten_by_edge(const std::array<Vec2, 2>& edge) {
  const Vec2 along = edge[1] - edge[0];
  const double t = std::clamp((circle_.center - edge[0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
  const double distance = (edge[0] + t * along - circle_.center).norm();
  const bool clear = distance > circle_.radius * (1.0 + kHorizonSlack) && along.norm() < kLongestEdge * distance;
  if (clear) shorten_by(edge);
}

void OcclusionHorizon::shorten_by(std::span<const Vec2> outline) {
  // All straights between those through two points of the outline meet it. The first and the last point seen from the
  // center give nearly the whole range, at less cost.
  Vec2 first_seen = outline[0] - circle_.center, last_seen = first_seen;
  double farthest = first_seen.squaredNorm();
  for (const Vec2& p : outline.subspan(1)) {
    const Vec2 d = p - circle_.center;
    if (cross(d, first_seen) > 0.0) first_seen = d;
    if (cross(last_seen, d) > 0.0) last_seen = d;
    farthest = std::max(farthest, d.squaredNorm());
  }
  // Directions of the straights: d = length t + offset n, see directed_bitangent.
  const double offset = -sign_of(circle_.side) * circle_.radius;
  const auto direction_through = [&](const Vec2& d) -> Vec2 {
    return std::sqrt(d.squaredNorm() - offset * offset) * d - offset * perpendicular(d);
  };
  const Vec2 low = direction_through(first_seen), high = direction_through(last_seen);
  const double far = std::sqrt(farthest - offset * offset) * (1.0 + kHorizonSlack);
  const double slack = kQuickAngleError + kHorizonSlack;
  const double from = quick_angle_of(low) + slack + kTwoPi;
  const double to = from + quick_angle_of({low.dot(high), cross(low, high)}) - 3.0 * slack;
  const int first = static_cast<int>(from * (kHeadings / kTwoPi)) + 1;
  const int count = static_cast<int>(to * (kHeadings / kTwoPi)) - first;
  if (count <= 0) return;
  const int begin = first % kHeadings;
  const int before_end = std::min(count, kHeadings - begin);
  const auto shorten = [far](auto ranges) { ranges = ranges.min(far); };
  shorten(far_.segment(begin, before_end));
  shorten(far_.head(count - before_end));
}

OcclusionHorizon::TangentLine OcclusionHorizon::tangent_to(const TurnCircle& to) const {
  const auto line = line_to(to);
  return line && line->length > 0.0 ? tangent_along(*line) : TangentLine{0.0, 0.0};
}

void OcclusionHorizon::finish() {
  constexpr int kRanges = kHeadings / kOctants;
  for (int octant = 0; octant < kOctants; ++octant) {
    const int first = octant * kRanges;
    const double within = far_.segment(first, kRanges).maxCoeff();
    // Rounding may put a heading in the octant beside its own.
    farthest_[octant] =
        std::max({within, far_[(first + kHeadings - 1) % kHeadings], far_[(first + kRanges) % kHeadings]});
  }
}

double OcclusionHorizon::reach(double heading) const {
  const int range = static_cast<int>(wrap_positive(heading) * (kHeadings / kTwoPi));
  return far_[std::min(range, kHeadings - 1)];
}

bool OcclusionHorizon::end_before(double distance, int first, int last) const {
  constexpr int kAtOnce = 8;
  int k = first;
  for (; k <= last - kAtOnce; k += kAtOnce)
    if (far_.segment<kAtOnce>(k).maxCoeff() >= distance) return false;
  for (; k < last; ++k)
    if (far_[k] >= distance) return false;
  return true;
}

bool OcclusionHorizon::hides(const Box& box) const {
  // No tangent enters the disc.
  const double disc = circle_.radius * (1.0 - kHorizonSlack);
  const Vec2 farthest = (0.5 * (box.min + box.max) - circle_.center).cwiseAbs() + 0.5 * (box.max - box.min);
  if (farthest.squaredNorm() < disc * disc) return true;
  const auto ball = ball_around(box, circle_.center);
  if (!ball) return false;
  // Most boxes that are visible are so at their middle.
  if (far_[range_of(ball->heading)] >= ball->distance) return false;
  const double near = nearest_of(box, circle_);
  const auto [low, high] = headings_towards(*ball, near, circle_);
  const double closest = std::sqrt((near - circle_.radius) * (near + circle_.radius)) * (1.0 - kHorizonSlack);
  const int first = range_of(low), last = range_of(high) + 1;
  if (first < last) return end_before(closest, first, last);
  return end_before(closest, first, kHeadings) && end_before(closest, 0, last);
}

Sectors OcclusionHorizon::sectors_towards(const Box& box) const {
  const auto ball = ball_around(box, circle_.center);
  if (!ball) return kAllSectors;
  const auto [low, high] = headings_towards(*ball, nearest_of(box, circle_), circle_);
  return sectors_of(low, high);
}

}  // namespace arcway::internal
