#include "core/search/search_map.h"

#include <cmath>
#include <utility>

#include "core/geometry/angle.h"

namespace arcway {

namespace {

// Around the reference point on an arc.
Box box_of(const TurnCircle& circle, const HeadingInterval& headings) {
  const double turn = headings.high - headings.low;
  Box box;
  if (turn >= kPi)
    return {circle.center - Vec2::Constant(circle.radius), circle.center + Vec2::Constant(circle.radius)};
  box.extend(pose_on(circle, headings.low).position());
  box.extend(pose_on(circle, headings.high).position());
  const double height = circle.radius * (1.0 - std::cos(0.5 * turn));  // of the arc above its chord
  return {box.min - Vec2::Constant(height), box.max + Vec2::Constant(height)};
}

SearchMap::ArcsOfRadius arcs_of_radius(const FeasibleGraph& graph, double radius) {
  SearchMap::ArcsOfRadius found;
  std::vector<Box> boxes;
  const auto add = [&](std::uint32_t circle, int interval, const HeadingInterval& headings) {
    found.arcs.push_back({circle, interval});
    boxes.push_back(box_of(graph.circles()[circle], headings));
  };
  for (std::uint32_t c = 0; c < graph.circles().size(); ++c) {
    if (graph.circles()[c].radius != radius) continue;
    if (graph.mode() == GraphMode::kLazy) {
      add(c, SearchMap::kAnyHeading, {0.0, kTwoPi});
      continue;
    }
    int interval = 0;
    for (const HeadingInterval& headings : graph.free_headings(c).intervals()) add(c, interval++, headings);
  }
  found.boxes = BoxTree(boxes);
  return found;
}

}  // namespace

SearchMap::SearchMap(const World& w, const Vehicle& v, QuerySet q, std::vector<double> r, FeasibleGraph g)
    : world(w),
      vehicle(v),
      queries(std::move(q)),
      radii(std::move(r)),
      graph(std::move(g)),
      body(v.footprint(0.5 * v.safety_margin())),
      outlines(w) {
  for (const double radius : radii) arcs.push_back(arcs_of_radius(graph, radius));
}

}  // namespace arcway
