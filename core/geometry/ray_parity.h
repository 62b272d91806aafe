#pragma once

#include <limits>

#include "core/geometry/predicates.h"

namespace arcway::internal {

/// Locates a point among closed rings by the even-odd rule: it counts the edges that the ray from `p` in +x direction
/// crosses. Edges may be given in any order; those that miss the ray's box may be left out. Exact.
class RayParity {
 public:
  explicit RayParity(const Vec2& p) : p_(p) {}

  void add(const Vec2& a, const Vec2& b) {
    if (p_ == a || p_ == b) {
      on_boundary_ = true;
      return;
    }
    const bool a_below = a.y() <= p_.y();
    if (a_below == (b.y() <= p_.y())) {
      if (a.y() == p_.y() && b.y() == p_.y() && (a.x() < p_.x()) != (b.x() < p_.x())) on_boundary_ = true;
      return;
    }
    if (a.x() < p_.x() && b.x() < p_.x()) return;
    const int side = a_below ? orientation(a, b, p_) : orientation(b, a, p_);
    if (side == 0) on_boundary_ = true;
    if (side > 0) inside_ = !inside_;
  }

  [[nodiscard]] PointLocation location() const {
    if (on_boundary_) return PointLocation::kBoundary;
    return inside_ ? PointLocation::kInside : PointLocation::kOutside;
  }
  [[nodiscard]] Box ray_box() const {
    Box box;
    box.extend(p_);
    box.max.x() = std::numeric_limits<double>::infinity();
    return box;
  }

 private:
  Vec2 p_;
  bool on_boundary_ = false;
  bool inside_ = false;
};

/// Locates the point just after `p` on the way to `towards` by the even-odd rule. Exact, also if `p` lies on the rings,
/// as long as the way does not start along one of their edges.
class StepParity {
 public:
  StepParity(const Vec2& p, const Vec2& towards) : p_(p), towards_(towards) {}

  void add(const Vec2& a, const Vec2& b) {
    const bool a_below = is_below(a);
    if (a_below == is_below(b)) return;
    const Vec2& low = a_below ? a : b;
    const Vec2& high = a_below ? b : a;
    const int side = orientation(low, high, p_);
    // With p on the line through the edge, the step's side is the side of all points ahead.
    if (side > 0 || (side == 0 && orientation(low, high, towards_) > 0)) inside_ = !inside_;
  }

  [[nodiscard]] bool inside() const { return inside_; }
  [[nodiscard]] Box ray_box() const { return RayParity(p_).ray_box(); }

 private:
  [[nodiscard]] bool is_below(const Vec2& a) const {
    return a.y() < p_.y() || (a.y() == p_.y() && p_.y() <= towards_.y());
  }

  Vec2 p_;
  Vec2 towards_;
  bool inside_ = false;
};

}  // namespace arcway::internal
