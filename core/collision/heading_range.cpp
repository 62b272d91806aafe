#include "core/collision/heading_range.h"

#include <algorithm>
#include <cmath>

#include "arcway/angle.h"

namespace arcway::internal {

namespace {

// Of the largest distance of the body from the center: edges so near the swept area count. The ends of blocked headings
// are rounded by the square root of the precision, 1e-8, where an edge is touched at a grazing angle.
constexpr double kHeadingSlack = 1e-6;
// Blocked headings that reach further than this into the range leave no doubt [rad].
constexpr double kDoubt = 1e-9;

// How far a point at (x, y) gets along the y axis that turns about the origin by up to an angle to either side.
double farthest(double x, double y, double r, double cosine, double sine) {
  return y >= r * cosine ? r : y * cosine + std::abs(x) * sine;
}

// Around the area that the body sweeps, as it turns by up to `half` to either side of heading 0.
Box swept_box(const TurningBody& t, double half) {
  const double y = -sign_of(t.side) * t.radius, cosine = std::cos(half), sine = std::sin(half);
  Box box;
  for (const Vec2& p : {Vec2(-t.body.rear, y - t.body.right), Vec2(t.body.front, y - t.body.right),
                        Vec2(t.body.front, y + t.body.left), Vec2(-t.body.rear, y + t.body.left)}) {
    const double r = p.norm();
    box.extend(Vec2(farthest(p.y(), p.x(), r, cosine, sine), farthest(p.x(), p.y(), r, cosine, sine)));
    box.extend(Vec2(-farthest(p.y(), -p.x(), r, cosine, sine), -farthest(p.x(), -p.y(), r, cosine, sine)));
  }
  return box;
}

}  // namespace

HeadingRange::HeadingRange(const TurningBody& body, double low, double angle, Memory& memory)
    : body_(body),
      contacts_(body),
      low_(low),
      angle_(angle),
      along_(direction_of(low + 0.5 * angle)),
      box_(swept_box(body, 0.5 * std::min(angle, kTwoPi))),
      memory_(memory) {
  const double all = reach_of(body);
  box_ = box_.grown(kHeadingSlack * all);
  const Vec2 middle = 0.5 * (box_.min + box_.max);
  middle_ = body.center + middle.x() * along_ + middle.y() * perpendicular(along_);
  reach_ = 0.5 * (box_.max - box_.min).norm() + kHeadingSlack * all;
  if (reach_ >= all) {
    middle_ = body.center;
    reach_ = all;
  }
  memory_.blocked.clear();
}

// False only for edges that meet no point of the box.
bool HeadingRange::is_near(const LineSegment& edge) const {
  const Vec2 p = edge.a - body_.center, q = edge.b - body_.center;
  const Vec2 a(along_.dot(p), cross(along_, p)), b(along_.dot(q), cross(along_, q));
  return std::max(a.x(), b.x()) >= box_.min.x() && std::min(a.x(), b.x()) <= box_.max.x() &&
         std::max(a.y(), b.y()) >= box_.min.y() && std::min(a.y(), b.y()) <= box_.max.y() && contacts_.may_touch(edge);
}

bool HeadingRange::add(const LineSegment& edge) {
  if (!is_near(edge)) return is_clear_;
  std::vector<HeadingInterval>& blocked = memory_.blocked;
  const std::size_t known = blocked.size();
  contacts_.append_blocked(edge, blocked);
  for (std::size_t i = known; i < blocked.size(); ++i) {
    const double from = wrap_positive(blocked[i].low - low_), to = from + (blocked[i].high - blocked[i].low);
    if (from < angle_ - kDoubt || to > kTwoPi + kDoubt) is_clear_ = false;
  }
  return is_clear_;
}

const HeadingSet& HeadingRange::free_headings() {
  HeadingSet::complement(memory_.blocked, memory_.free);
  return memory_.free;
}

}  // namespace arcway::internal
