#pragma once

#include <algorithm>

#include "arcway/angle.h"
#include "arcway/heading_set.h"

namespace arcway::internal {

/// Whether an interval may contain a heading in [-2 pi, 2 pi] that is known up to `slack` [rad]. Never false if it
/// does.
inline bool may_contain(const HeadingInterval& interval, double heading, double slack) {
  const double ahead = heading - interval.low + slack;  // of the interval's begin, up to whole turns
  const double width = interval.high - interval.low + 2.0 * slack;
  return (ahead >= 0.0 && ahead <= width) || (ahead + kTwoPi >= 0.0 && ahead + kTwoPi <= width) || ahead >= kTwoPi;
}

/// Whether a set may contain a heading in [-2 pi, 2 pi] that is known up to `slack` [rad]. Never false if it does.
inline bool may_contain(const HeadingSet& set, double heading, double slack) {
  const double positive = heading < 0.0 ? heading + kTwoPi : heading;
  return std::ranges::any_of(set.intervals(),
                             [&](const HeadingInterval& interval) { return may_contain(interval, positive, slack); });
}

}  // namespace arcway::internal
