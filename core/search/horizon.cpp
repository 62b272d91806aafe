#include "core/search/horizon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/angle.h"

namespace arcway {

namespace {

constexpr double kSlack = 1e-6;  // of headings [rad], and of distances relative to them
// A piece within a ball this wide, seen from the circle's centre, spans less than pi of headings.
constexpr double kWidestPiece = 0.7;

// Seen from a distance of 1: the headings of its ends differ by pi within 1e-3, far more than rounding.
constexpr double kLongestEdge = 1000.0;

// An upper bound on asin(x), 0 <= x <= 1: asin is convex there.
double above_asin(double x) { return x < 0.5 ? (kPi / 3.0) * x : kPi / 6.0 + (2.0 * kPi / 3.0) * (x - 0.5); }

// atan2(d.y(), d.x()) within kDirectionError, d not zero; several times as fast [Abramowitz, Stegun 1964, 4.4.49].
constexpr double kDirectionError = 2e-5;
double about_atan2(const Vec2& d) {
  const double x = std::abs(d.x()), y = std::abs(d.y());
  const double t = std::min(x, y) / std::max(x, y);
  const double u = t * t;
  const double angle = t * (0.9998660 + u * (-0.3302995 + u * (0.1801410 + u * (-0.0851330 + u * 0.0208351))));
  const double upper = y > x ? 0.5 * kPi - angle : angle;
  return std::copysign(d.x() < 0.0 ? kPi - upper : upper, d.y());
}

}  // namespace

Horizon::Horizon(const TurnCircle& circle, double heading, double turn) : circle_(circle) {
  far_.fill(-std::numeric_limits<double>::infinity());
  const double low = heading - (circle.side == Side::kLeft ? 0.0 : turn) - kSlack;
  const auto first = static_cast<long>(std::floor(wrap_positive(low) * (kHeadings / kTwoPi)));
  const auto count = static_cast<long>(std::ceil((turn + 2.0 * kSlack) * (kHeadings / kTwoPi))) + 1;
  for (long k = first; k < first + std::min(count, static_cast<long>(kHeadings)); ++k)
    far_[static_cast<std::size_t>(k) % kHeadings] = std::numeric_limits<double>::infinity();
}

void Horizon::shorten(const Outlines& outlines) {
  outlines.visit_near_first(
      circle_.center, [this](const Box& box) { return !hides(box); },
      [this](const Outlines::Piece& piece) { shorten(piece.points); });
}

void Horizon::shorten(std::span<const Vec2> outline) {
  Box box;
  for (const Vec2& p : outline) box.extend(p);
  const double half = 0.5 * (box.max - box.min).norm();
  const double distance = (0.5 * (box.min + box.max) - circle_.center).norm();
  if (half > kWidestPiece * distance || distance - half <= circle_.radius * (1.0 + kSlack)) {
    if (outline.size() == 2) return shorten_by_edge({outline[0], outline[1]});
    const std::size_t middle = outline.size() / 2;
    shorten(outline.subspan(0, middle + 1));
    shorten(outline.subspan(middle));
    return;
  }
  shorten_by(outline);
}

// An edge outside of the circle spans less than pi of headings, however long it is.
void Horizon::shorten_by_edge(const std::array<Vec2, 2>& edge) {
  const Vec2 along = edge[1] - edge[0];
  const double t = std::clamp((circle_.center - edge[0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
  const double distance = (edge[0] + t * along - circle_.center).norm();
  const bool clear = distance > circle_.radius * (1.0 + kSlack) && along.norm() < kLongestEdge * distance;
  if (clear) shorten_by(edge);
}

void Horizon::shorten_by(std::span<const Vec2> outline) {
  // Directions of the straights through the points: d = length t + offset n, see directed_bitangent.
  const double offset = -sign_of(circle_.side) * circle_.radius;
  Vec2 low, high;
  double far = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 d = outline[i] - circle_.center;
    const double length = std::sqrt(d.squaredNorm() - offset * offset);
    const Vec2 t = length * d - offset * perpendicular(d);
    if (i == 0 || cross(t, low) > 0.0) low = t;
    if (i == 0 || cross(high, t) > 0.0) high = t;
    far = std::max(far, length);
  }
  far *= 1.0 + kSlack;
  const double slack = kDirectionError + kSlack;
  const double from = about_atan2(low) + slack + kTwoPi;
  const double to = from + about_atan2({low.dot(high), cross(low, high)}) - 3.0 * slack;
  const auto first = static_cast<long>(std::ceil(from * (kHeadings / kTwoPi)));
  const auto last = static_cast<long>(std::floor(to * (kHeadings / kTwoPi)));  // ranges [first, last)
  for (long k = first; k < last; ++k) {
    double& known = far_[static_cast<std::size_t>(k) % kHeadings];
    known = std::min(known, far);
  }
}

Horizon::Sight Horizon::sight_of(const TurnCircle& to) const {
  const Vec2 d = to.center - circle_.center;
  const double offset = sign_of(to.side) * to.radius - sign_of(circle_.side) * circle_.radius;
  const double square = d.squaredNorm() - offset * offset;
  if (!(square > kSlack * offset * offset)) return {0.0, 0.0};  // they may touch, or there may be none
  const double length = std::sqrt(square);
  const double heading = about_atan2(length * d - offset * perpendicular(d));
  return {heading < 0.0 ? heading + kTwoPi : heading, length};
}

bool Horizon::hides(const Sight& sight) const {
  if (sight.length == 0.0) return false;
  const double slack = kDirectionError + kSlack;
  const double heading = sight.heading + kTwoPi;
  const auto first = static_cast<std::size_t>((heading - slack) * (kHeadings / kTwoPi));
  const auto last = static_cast<std::size_t>((heading + slack) * (kHeadings / kTwoPi));
  return std::max(far_[first % kHeadings], far_[last % kHeadings]) < sight.length * (1.0 - kSlack);
}

double Horizon::reach(double heading) const {
  const auto range = static_cast<std::size_t>(wrap_positive(heading) * (kHeadings / kTwoPi));
  return far_[std::min(range, kHeadings - 1)];
}

// Of the straights to a ball, which the circle's centre is outside of.
// @param half  radius of the ball;  @param near  no point looked at is nearer to the circle's centre, nor is its
// radius.
Horizon::Headings Horizon::headings_towards(const Vec2& d, double half, double near) const {
  const double distance = d.norm();
  const double spread = above_asin(half / distance) + kDirectionError;
  const double toward = about_atan2(d);
  const double lead_near = above_asin(circle_.radius / near);
  const double lead_far = circle_.radius / std::max(near, distance + half);  // below its asin
  const bool left = circle_.side == Side::kLeft;
  return {toward - spread + (left ? lead_far : -lead_near) - kSlack,
          toward + spread + (left ? lead_near : -lead_far) + kSlack};
}

bool Horizon::hides(const Box& box) const {
  const Vec2 middle = 0.5 * (box.min + box.max);
  const Vec2 d = middle - circle_.center;
  const Vec2 extent = 0.5 * (box.max - box.min);
  // No tangent enters the disc.
  if ((d.cwiseAbs() + extent).norm() < circle_.radius * (1.0 - kSlack)) return true;
  const double half = extent.norm();
  const double distance = d.norm();
  if (distance <= half) return false;
  const Vec2 nearest = circle_.center.cwiseMax(box.min).cwiseMin(box.max);
  const double near = std::max((nearest - circle_.center).norm(), circle_.radius);
  const auto [low, high] = headings_towards(d, half, near);
  const double closest = std::sqrt((near - circle_.radius) * (near + circle_.radius)) * (1.0 - kSlack);
  const auto first = static_cast<long>(std::floor(low * (kHeadings / kTwoPi))) + static_cast<long>(kHeadings);
  const auto last = static_cast<long>(std::floor(high * (kHeadings / kTwoPi))) + static_cast<long>(kHeadings);
  for (long k = first; k <= last; ++k)
    if (far_[static_cast<std::size_t>(k) % kHeadings] >= closest) return false;
  return true;
}

Sectors Horizon::sectors_towards(const Box& box) const {
  const Vec2 d = 0.5 * (box.min + box.max) - circle_.center;
  const double half = 0.5 * (box.max - box.min).norm();
  if (d.norm() <= half) return kAllSectors;
  const Vec2 nearest = circle_.center.cwiseMax(box.min).cwiseMin(box.max);
  const auto [low, high] = headings_towards(d, half, std::max((nearest - circle_.center).norm(), circle_.radius));
  return sectors_of(low, high);
}

}  // namespace arcway
