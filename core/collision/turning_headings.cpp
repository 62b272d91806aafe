#include "core/collision/turning_headings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "arcway/angle.h"
#include "core/collision/turning_piece.h"

namespace arcway::internal {

namespace {

using CenteredBody = EdgeContacts::CenteredBody;

CenteredBody centered(const TurningBody& t) {
  const double y = -sign_of(t.side) * t.radius;
  return {-t.body.rear, t.body.front, y - t.body.right, y + t.body.left};
}

class CriticalAngles {
 public:
  void add(double angle) { angles_[count_++] = wrap_positive(angle); }
  void add_wrapped(std::span<const double> angles) {
    for (const double angle : angles) angles_[count_++] = angle;
  }
  [[nodiscard]] std::span<double> sorted() {
    std::sort(angles_.begin(), angles_.begin() + count_);
    return {angles_.data(),
            static_cast<std::size_t>(std::unique(angles_.begin(), angles_.begin() + count_) - angles_.begin())};
  }

 private:
  std::array<double, 24> angles_;  // 4 corners meet the edge twice, 2 ends meet 4 sides twice
  std::ptrdiff_t count_ = 0;
};

// @param corner_angle  that of the corner about the center, if it is known yet [rad].
void add_corner_contacts(const Vec2& corner, std::optional<double>& corner_angle, const LineSegment& edge,
                         CriticalAngles& angles) {
  const auto& [p, q] = edge;
  const Vec2 d = q - p;
  const double dd = d.squaredNorm();
  const double along = -p.dot(d) / dd;
  const Vec2 foot = p + along * d;
  const double rest = corner.squaredNorm() - foot.squaredNorm();
  if (rest < -kCriticalSlack * corner.squaredNorm()) return;
  const double half = std::sqrt(std::max(rest, 0.0) / dd);
  const auto is_on_edge = [](double t) { return t >= -kCriticalSlack && t <= 1.0 + kCriticalSlack; };
  if (!is_on_edge(along - half) && !is_on_edge(along + half)) return;
  if (!corner_angle) corner_angle = std::atan2(corner.y(), corner.x());
  for (const double t : {along - half, along + half}) {
    if (!is_on_edge(t)) continue;
    const Vec2 x = p + t * d;
    angles.add(std::atan2(x.y(), x.x()) - *corner_angle);
  }
}

// At most 4 sides meet an end, each twice.
std::size_t find_end_contacts(const Vec2& p, const CenteredBody& b, std::array<double, 8>& angles) {
  const double rr = p.squaredNorm();
  const double slack = kCriticalSlack * (rr + 1e-300);
  const double reach = kCriticalSlack * std::sqrt(rr);
  const double angle = std::atan2(p.y(), p.x());
  std::size_t count = 0;
  for (const double y : {b.y_low, b.y_high}) {
    if (rr - y * y < -slack) continue;
    const double x = std::sqrt(std::max(rr - y * y, 0.0));
    for (const double side : {-x, x})
      if (side >= b.x_low - reach && side <= b.x_high + reach)
        angles[count++] = wrap_positive(angle - std::atan2(y, side));
  }
  for (const double x : {b.x_low, b.x_high}) {
    if (rr - x * x < -slack) continue;
    const double y = std::sqrt(std::max(rr - x * x, 0.0));
    for (const double side : {-y, y})
      if (side >= b.y_low - reach && side <= b.y_high + reach)
        angles[count++] = wrap_positive(angle - std::atan2(side, x));
  }
  return count;
}

bool touches(const CenteredBody& b, const Vec2& p, const Vec2& q, double heading) {
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  const Vec2 u(c * p.x() + s * p.y(), c * p.y() - s * p.x());
  const Vec2 v(c * q.x() + s * q.y(), c * q.y() - s * q.x());
  if (std::max(u.x(), v.x()) < b.x_low || std::min(u.x(), v.x()) > b.x_high) return false;
  if (std::max(u.y(), v.y()) < b.y_low || std::min(u.y(), v.y()) > b.y_high) return false;
  const Vec2 d = v - u;
  const double side_a = cross(d, Vec2(b.x_low, b.y_low) - u);
  const double side_b = cross(d, Vec2(b.x_high, b.y_low) - u);
  const double side_c = cross(d, Vec2(b.x_high, b.y_high) - u);
  const double side_d = cross(d, Vec2(b.x_low, b.y_high) - u);
  const bool all_left = side_a > 0 && side_b > 0 && side_c > 0 && side_d > 0;
  const bool all_right = side_a < 0 && side_b < 0 && side_c < 0 && side_d < 0;
  return !all_left && !all_right;
}

// By the pieces of its shape.
void append_blocked_by_shape(const TurningBody& body, const LineSegment& about, std::vector<HeadingInterval>& blocked) {
  const Vec2 center(0.0, sign_of(body.side) * body.radius);
  for (const Ring& piece : body.body.shape->pieces) append_blocked_by_piece(piece, center, about, blocked);
}

}  // namespace

void remove_headings(std::vector<HeadingInterval>& blocked, HeadingSet& free) {
  if (blocked.empty()) return;
  const std::span<const HeadingInterval> intervals = free.intervals();
  if (!free.is_full()) {
    for (std::size_t k = 0; k < intervals.size(); ++k) {
      const bool last = k + 1 == intervals.size();
      blocked.push_back({intervals[k].high, last ? intervals[0].low + kTwoPi : intervals[k + 1].low});
    }
  }
  HeadingSet::complement(blocked, free);
}

double reach_of(const TurningBody& body) {
  return swept_annulus(body.body, body.side, body.radius).outer * (1.0 + kCriticalSlack);
}

EdgeContacts::EdgeContacts(const TurningBody& body) : body_(body), centered_(centered(body)) {
  const SweptAnnulus annulus = swept_annulus(body.body, body.side, body.radius);
  const double inner = annulus.inner * (1.0 - kCriticalSlack), outer = annulus.outer * (1.0 + kCriticalSlack);
  inner_square_ = inner * inner;
  outer_square_ = outer * outer;
}

bool EdgeContacts::may_touch(const LineSegment& edge) const {
  const Vec2 p = edge.a - body_.center;
  const Vec2 q = edge.b - body_.center;
  if (std::max(p.squaredNorm(), q.squaredNorm()) < inner_square_) return false;
  const Vec2 d = q - p;
  const double t = std::clamp(-p.dot(d) / d.squaredNorm(), 0.0, 1.0);
  return (p + t * d).squaredNorm() <= outer_square_;
}

const EdgeContacts::End& EdgeContacts::end_at(const Vec2& p) {
  for (const End& end : ends_)
    if (end.place == p) return end;
  End& end = ends_[next_end_++ % ends_.size()];
  end.place = p;
  end.count = find_end_contacts(p, centered_, end.angles);
  return end;
}

void EdgeContacts::append_blocked(const LineSegment& edge, std::vector<HeadingInterval>& blocked) {
  const LineSegment about{edge.a - body_.center, edge.b - body_.center};
  if (body_.body.shape != nullptr) return append_blocked_by_shape(body_, about, blocked);
  const CenteredBody& b = centered_;
  CriticalAngles critical;
  const std::array corners{Vec2(b.x_low, b.y_low), Vec2(b.x_high, b.y_low), Vec2(b.x_high, b.y_high),
                           Vec2(b.x_low, b.y_high)};
  for (std::size_t i = 0; i < corners.size(); ++i) add_corner_contacts(corners[i], corner_angles_[i], about, critical);
  for (const Vec2& p : {about.a, about.b}) {
    const End& end = end_at(p);
    critical.add_wrapped({end.angles.data(), end.count});
  }

  const std::span<double> angles = critical.sorted();
  if (angles.empty()) {
    if (touches(b, about.a, about.b, 0.0)) blocked.push_back({0.0, kTwoPi});
    return;
  }
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double low = angles[i];
    const double high = i + 1 < angles.size() ? angles[i + 1] : angles[0] + kTwoPi;
    if (touches(b, about.a, about.b, 0.5 * (low + high))) blocked.push_back({low, high});
  }
}

bool may_touch(const TurningBody& body, const LineSegment& edge) { return EdgeContacts(body).may_touch(edge); }

void append_blocked_headings(const TurningBody& body, const LineSegment& edge, std::vector<HeadingInterval>& blocked) {
  EdgeContacts(body).append_blocked(edge, blocked);
}

}  // namespace arcway::internal
