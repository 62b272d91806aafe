#pragma once

#include <cstddef>
#include <vector>

#include "arcway/sweep_query.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// What a body that is no rectangle sweeps when it drives straight: the union of its pieces' prisms. An edge meets it
/// if it meets the swept rectangle of the bounds, and one of the prisms. All are decided exactly, on corners that are
/// rounded here and nowhere else. Prisms are found when an edge first needs them.
class SweptShape {
 public:
  struct Memory {
    std::vector<Vec2> from, to, prism;
    std::vector<signed char> ahead;
    std::vector<Vec2> corners;      // of the prisms
    std::vector<std::size_t> ends;  // by prism, the index behind its last corner
  };

  /// @param body  with a shape.
  /// @param memory  used again by the next one; must outlive this.
  SweptShape(const StraightBody& body, Memory& memory);

  /// The swept rectangle of the bounds.
  [[nodiscard]] const SweptRectangle& bounds() const { return bounds_; }
  [[nodiscard]] bool meets(const LineSegment& edge) const;
  /// Whether a test holds for a point of any connected part, at the start of the motion.
  template <class Test>
  [[nodiscard]] bool has_inner_point(const Test& test) const {
    for (const Vec2& p : body_.body.shape->inner_points)
      if (test(place(p, 0.0))) return true;
    return false;
  }

 private:
  [[nodiscard]] Vec2 place(const Vec2& p, double further) const {
    return body_.from.position() + (further + p.x()) * along_ + p.y() * perpendicular(along_);
  }
  void find_prisms() const;

  const StraightBody& body_;
  Vec2 along_;
  SweptRectangle bounds_;
  Memory& memory_;
};

}  // namespace arcway::internal
