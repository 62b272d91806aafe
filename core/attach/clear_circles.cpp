#include "core/attach/clear_circles.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/roadmap/extend_feasible_graph.h"

namespace arcway::internal {

namespace {

// The radii of a roadmap to a side, as far as the grown body does not cover the center; at least one.
std::vector<double> clear_radii(const CircleRadii& radii, Side side, const Footprint& grown_body) {
  std::vector<double> clear;
  for (const double radius : radii.of(side)) {
    const double wide = std::max(radius, grown_body.beside(side));
    if (clear.empty() || clear.back() != wide) clear.push_back(wide);
  }
  return clear;
}

}  // namespace

Roadmap with_clear_circles(const Roadmap& map) {
  // Half of the safety margin beyond the distance, as base circles keep it beyond what is checked.
  const Footprint body = map.clearance_cost->body().grown(0.5 * map.vehicle.safety_margin());
  AddedCircles added;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::vector<double> radii = clear_radii(map.radii, side, body);
    for (const VertexId v : map.world.convex_vertices())
      for (const double radius : radii) added.around_vertices.push_back(turn_circle(map.world, v, radius, side, body));
  }
  return map.with_graph(extend_feasible_graph(map.graph, map.vehicle, added), map.radii);
}

}  // namespace arcway::internal
