#include "core/collision/arc_query.h"

namespace arcway::internal {

bool arc_free(const SweepQuery& sweep, const TurningBody& body, double heading, double angle, HeadingSet& headings) {
  if (const auto* arcs = dynamic_cast<const ArcQuery*>(&sweep)) return arcs->arc_free(body, heading, angle);
  sweep.free_headings({&body, 1}, {&headings, 1});
  return headings.reach(heading, body.side) >= angle;
}

double reach(const SweepQuery& sweep, const TurningBody& body, double heading, Side towards, HeadingSet& headings) {
  if (const auto* arcs = dynamic_cast<const ArcQuery*>(&sweep)) return arcs->reach(body, heading, towards);
  sweep.free_headings({&body, 1}, {&headings, 1});
  return headings.reach(heading, towards);
}

}  // namespace arcway::internal
