#include "core/search/body_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace arcway::internal {

namespace {

constexpr double kSameDepth = 1e-4;  // difference of depths over two sides that counts as none, in lengths of the body

// How far an edge reaches over a side of the body, in the frame of the body.
struct Over {
  double depth;
  Vec2 at;  // place of the contact
  Vec2 by;  // gradient of the depth by that place
};

struct Range {
  double low, high;
};

// How far an edge reaches over the nearer end of the range `ends`, where it lies within the range `within`.
// @param along  axis of `within`: 0 for x, 1 for y. The other axis is that of `ends`.
std::optional<Over> over_ends(Vec2 a, Vec2 b, const Range& within, const Range& ends, Eigen::Index along) {
  const Eigen::Index across = 1 - along;
  if (a[along] > b[along]) std::swap(a, b);
  if (b[along] <= within.low || a[along] >= within.high) return std::nullopt;
  const double run = b[along] - a[along], slope = run > 0.0 ? (b[across] - a[across]) / run : 0.0;
  const bool cut_a = a[along]<within.low, cut_b = b[along]> within.high;
  if (cut_a) a[across] += slope * (within.low - a[along]), a[along] = within.low;
  if (cut_b) b[across] += slope * (within.high - b[along]), b[along] = within.high;
  const bool a_is_lower = a[across] < b[across];
  const Vec2 &least = a_is_lower ? a : b, &most = a_is_lower ? b : a;
  const double over_low = most[across] - ends.low, over_high = ends.high - least[across];
  const bool is_low = over_low < over_high;
  const bool is_cut = is_low == a_is_lower ? cut_b : cut_a;
  // Where the edge goes on beyond `within`, a corner of the body is nearest to it: its distance from the edge counts.
  const double tilt = is_cut ? slope : 0.0, scale = 1.0 / std::hypot(1.0, tilt), sign = is_low ? scale : -scale;
  Vec2 by;
  by[across] = sign;
  by[along] = -sign * tilt;
  Vec2 at = is_low ? most : least;
  if (is_cut) at[across] = is_low ? ends.low : ends.high;
  return Over{scale * std::min(over_low, over_high), at, by};
}

// The contact by the position and the heading of the body, relative to which the edge moves the other way.
BodyContact contact_of(const Over& over, const Vec2& ahead) {
  return {over.depth, -over.by.x() * ahead - over.by.y() * perpendicular(ahead),
          over.by.x() * over.at.y() - over.by.y() * over.at.x()};
}

// The contact at a corner, from two contacts of equal depth. The depth of one falls as that of the other grows.
BodyContact at_corner(const BodyContact& a, const BodyContact& b, const Vec2& ahead, double curvature) {
  const double rate_a = a.by_place.dot(ahead) + a.by_turn * curvature;
  const double rate_b = b.by_place.dot(ahead) + b.by_turn * curvature;
  if (rate_a * rate_b >= 0.0) return a;
  const double share = rate_b / (rate_b - rate_a);
  return {a.depth, share * a.by_place + (1.0 - share) * b.by_place, share * a.by_turn + (1.0 - share) * b.by_turn};
}

}  // namespace

std::optional<BodyContact> body_contact(const Footprint& body, const BodyMotion& motion, const LineSegment& edge,
                                        double near) {
  const Vec2& place = motion.place;
  const Vec2& ahead = motion.ahead;
  const double curvature = motion.curvature;
  const auto in_frame = [&](const Vec2& p) {
    const Vec2 d = p - place;
    return Vec2(ahead.dot(d), cross(ahead, d));
  };
  const Vec2 a = in_frame(edge.a), b = in_frame(edge.b);
  const Range x{-body.rear, body.front}, y{-body.right, body.left};
  const auto is_far = [&](double p, double q, const Range& range) {
    return std::max(p, q) <= range.low - near || std::min(p, q) >= range.high + near;
  };
  if (is_far(a.x(), b.x(), x) || is_far(a.y(), b.y(), y)) return std::nullopt;
  const auto beside = over_ends(a, b, x, y, 0), before = over_ends(a, b, y, x, 1);
  if (!beside && !before) return std::nullopt;
  const bool is_beside = beside && (!before || beside->depth <= before->depth);
  const BodyContact least = contact_of(is_beside ? *beside : *before, ahead);
  if (least.depth <= -near) return std::nullopt;
  const bool same = beside && before && std::abs(beside->depth - before->depth) <= kSameDepth * body.length();
  return same ? at_corner(least, contact_of(is_beside ? *before : *beside, ahead), ahead, curvature) : least;
}

double distance_beside(const Footprint& body, const Vec2& place, const Vec2& ahead, const LineSegment& edge) {
  const Vec2 p = edge.a - place, q = edge.b - place;
  const Vec2 a(ahead.dot(p), cross(ahead, p)), b(ahead.dot(q), cross(ahead, q));
  const Vec2 low = a.cwiseMin(b), high = a.cwiseMax(b);
  return std::max({low.x() - body.front, -body.rear - high.x(), low.y() - body.left, -body.right - high.y()});
}

}  // namespace arcway::internal
