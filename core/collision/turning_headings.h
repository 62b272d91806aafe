#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "arcway/heading_set.h"
#include "arcway/sweep_query.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// The headings [rad] at which one turning body touches obstacle edges. What depends on the body alone is computed
/// once, and the contacts of an end serve the next edges that it belongs to.
class EdgeContacts {
 public:
  /// @param body  must outlive this.
  explicit EdgeContacts(const TurningBody& body);

  /// Whether an edge is near enough to the body's annulus for append_blocked to be worth a call. Never false for an
  /// edge that the body touches at some heading.
  [[nodiscard]] bool may_touch(const LineSegment& edge) const;
  /// Appends the headings at which the body touches an edge. Contact changes only at critical headings, which are
  /// computed:
  /// - A corner of the body, on its circle, meets the edge.
  /// - An end of the edge, on its circle about the center, meets a side of the body. Each interval between neighboring
  ///   critical headings is decided once. Constant time.
  void append_blocked(const LineSegment& edge, std::vector<HeadingInterval>& blocked);

  /// The body about the rotation center, at heading 0.
  struct CenteredBody {
    double x_low, x_high, y_low, y_high;
  };

 private:
  // An end of an edge, about the center, and the headings at which sides of the body meet it.
  struct End {
    Vec2 place{std::numeric_limits<double>::quiet_NaN(), 0.0};
    std::array<double, 8> angles;
    std::size_t count = 0;
  };
  const End& end_at(const Vec2& place);

  const TurningBody& body_;
  CenteredBody centered_;
  double inner_square_, outer_square_;  // of the annulus, with a slack [m^2]
  std::array<std::optional<double>, 4> corner_angles_;
  std::array<End, 4> ends_;  // the last ones
  std::size_t next_end_ = 0;
};

/// EdgeContacts::append_blocked for a single edge.
void append_blocked_headings(const TurningBody& body, const LineSegment& edge, std::vector<HeadingInterval>& blocked);
/// EdgeContacts::may_touch for a single edge.
bool may_touch(const TurningBody& body, const LineSegment& edge);

/// Takes closed intervals of headings out of a set. A set that none are taken out of keeps its bits.
/// @param blocked  in any order; unspecified afterwards, keeps its memory.
void remove_headings(std::vector<HeadingInterval>& blocked, HeadingSet& free);

/// The distance from a turning body's center within which all edges lie that it can touch [m].
double reach_of(const TurningBody& body);

/// Whether a test holds for a point of any connected part of a turning body at a heading. The point is one of the part,
/// which the reference point need not be.
template <class Test>
bool has_inner_point(const TurningBody& body, double heading, const Test& test) {
  const Vec2 ahead = direction_of(heading), aside = perpendicular(ahead);
  const Vec2 place = body.center - sign_of(body.side) * body.radius * aside;
  if (body.body.shape == nullptr) return test(middle_of(body.body, {place.x(), place.y(), heading}));
  for (const Vec2& p : body.body.shape->inner_points)
    if (test(Vec2(place + p.x() * ahead + p.y() * aside))) return true;
  return false;
}

}  // namespace arcway::internal
