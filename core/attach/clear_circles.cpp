#include "core/attach/clear_circles.h"

#include <algorithm>
#include <map>
#include <vector>

#include "arcway/executor.h"
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

// The rules of a cost by distance, ascending: those that cost something.
std::map<double, std::vector<const ClearanceCost::Rule*>> rules_by_distance(const ClearanceCost& cost) {
  std::map<double, std::vector<const ClearanceCost::Rule*>> rules;
  for (const ClearanceCost::Rule& rule : cost.rules())
    if (rule.cost > 0.0) rules[rule.close.distance()].push_back(&rule);
  return rules;
}

}  // namespace

Roadmap with_clear_circles(const Roadmap& map, const StopClock& clock) {
  AddedCircles added;
  StopTicker ticker(clock);
  for (const auto& of_distance : rules_by_distance(*map.clearance_cost)) {
    const std::vector<const ClearanceCost::Rule*>& rules = of_distance.second;
    // Half of the safety margin beyond the distance, as base circles keep it beyond what is checked.
    const Footprint body = rules.front()->close.body().grown(0.5 * map.vehicle.safety_margin());
    const auto is_wanted = [&rules](const TurnCircle& circle) {
      const Box around = Box{circle.center, circle.center}.grown(circle.radius);
      return std::ranges::any_of(rules, [&](const auto* rule) { return rule->may_count_in(around); });
    };
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const std::vector<double> radii = clear_radii(map.radii, side, body);
      for (const VertexId v : map.world.convex_vertices())
        for (const double radius : radii) {
          end_if_over(ticker);
          const TurnCircle circle = turn_circle(map.world, v, radius, side, body);
          if (is_wanted(circle)) added.around_vertices.push_back(circle);
        }
    }
  }
  return map.with_graph(extend_feasible_graph(map.graph, map.vehicle, added, clock), map.radii, nullptr, clock);
}

}  // namespace arcway::internal
