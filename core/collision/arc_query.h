#pragma once

#include "arcway/heading_set.h"
#include "arcway/sweep_query.h"

namespace arcway::internal {

/// Answers about one arc that a body turns along: those of SweepQuery::free_headings, bit for bit, for less than the
/// set of all free headings costs. A sweep query may be one as well. Thread-safe.
class ArcQuery {
 public:
  virtual ~ArcQuery() = default;

  /// Whether the body touches no obstacle while it turns from a heading by an angle, in its driving direction.
  /// @param angle  from 0 to 2 pi [rad].
  [[nodiscard]] virtual bool arc_free(const TurningBody& body, double heading, double angle) const = 0;
  /// How far the body turns from a heading, to the left or to the right, until it touches an obstacle:
  /// HeadingSet::reach of its free headings [rad].
  [[nodiscard]] virtual double reach(const TurningBody& body, double heading, Side towards) const = 0;
};

/// ArcQuery::arc_free of a sweep query, by the set of all free headings unless it is an ArcQuery.
/// @param headings  memory that is used again.
/// @throws std::invalid_argument as SweepQuery::free_headings does, unless it is one.
bool arc_free(const SweepQuery& sweep, const TurningBody& body, double heading, double angle, HeadingSet& headings);
/// ArcQuery::reach likewise.
double reach(const SweepQuery& sweep, const TurningBody& body, double heading, Side towards, HeadingSet& headings);

}  // namespace arcway::internal
