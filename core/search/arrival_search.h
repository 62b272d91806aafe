#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/graph/feasible_graph.h"
#include "core/path/path.h"
#include "core/query/sweep_query.h"
#include "core/vehicle.h"

namespace arcway {

/// A pose from which, or to which, the search connects to the graph.
struct Terminal {
  Pose pose;
  Path connection;    ///< from the start to `pose`, or from `pose` to the goal; empty for start and goal themselves
  double cost = 0.0;  ///< travel time of the connection [s]
};

struct SearchOptions {
  double seconds_per_meter = 0.0;  ///< heuristic: this times the straight distance to the goal
  std::span<const double> radii;
};

struct SearchResult {
  std::optional<Path> path;      ///< from start to goal, connections in
  bool start_connected = false;  ///< some motion leads from a start terminal to the graph or the goal
  bool goal_reached = false;     ///< a goal terminal could be entered from some circle, reachable or not
  std::uint64_t nodes_expanded = 0;
  std::uint64_t nodes_pushed = 0;
  std::uint64_t straights_checked = 0;
  std::uint64_t turns_checked = 0;
};

/// A* over directed arrivals, (11): a node is the arrival on a circle at the end of a bitangent, its cost the travel
/// time by (9) and (10) with arcs driven at v_mc. Departures on a circle are sorted by heading, so that one walk along
/// the arc relaxes them in turn and stops where an earlier arrival got there sooner: linear in the bitangents.
///
/// Terminals join by their left and right circles of every radius, and by each other by all six Dubins words. Their
/// bitangents are checked when they come off the open list. Ties are broken by order of creation: same answer every
/// time.
SearchResult search_arrivals(const FeasibleGraph& graph, const Vehicle& vehicle, const SweepQuery& sweep,
                             std::span<const Terminal> starts, std::span<const Terminal> goals,
                             const SearchOptions& options);

/// A* through a segment of a path whose speeds need not be reachable: a lower bound that equals (9) or (10) where they
/// hold.
double relaxed_segment_time(double length, double v1, double v2, double v3, double acceleration);

}  // namespace arcway
