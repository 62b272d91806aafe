#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/executor.h"
#include "core/graph/turn_circle.h"
#include "core/graph/visibility_graph.h"
#include "core/query/heading_set.h"
#include "core/query/query_set.h"
#include "core/vehicle.h"
#include "core/world.h"

namespace arcway {

/// Bitangents in, and why the others are out.
struct FeasibleGraphCounts {
  std::uint64_t circles = 0;          ///< turn circles of convex vertices
  std::uint64_t circles_blocked = 0;  ///< those without any free heading
  std::uint64_t candidates = 0;       ///< directed: two for each edge of the reduced graph and pair of radii
  std::uint64_t kept = 0;
  std::uint64_t rejected_overlap = 0;    ///< no bitangent: circles overlap
  std::uint64_t rejected_departure = 0;  ///< (7): the body collides on the first circle at that heading
  std::uint64_t rejected_arrival = 0;    ///< (7): ... on the second circle
  std::uint64_t rejected_straight = 0;   ///< (6): the swept rectangle meets an obstacle
};

/// The feasible visibility graph: turn circles with their free headings, and the directed bitangents whose swept
/// rectangle is free. Arcs are not stored: from an arrival on a circle every departure is reachable that lies
/// ahead within the same free interval.
///
/// Bitangents are grouped by the circle they leave, sorted by heading within it.
class FeasibleGraph {
 public:
  struct Link {
    std::uint32_t from;  ///< circle
    std::uint32_t to;    ///< circle
    double heading;      ///< [0, 2 pi)
    double length;       ///< [m]
  };

  FeasibleGraph() = default;
  FeasibleGraph(const World& world, const Vehicle& vehicle, const VisibilityGraph& graph, const QuerySet& queries,
                std::span<const double> radii, const Executor& executor);

  [[nodiscard]] std::span<const TurnCircle> circles() const { return circles_; }
  [[nodiscard]] const HeadingSet& free_headings(std::uint32_t circle) const { return free_headings_[circle]; }
  [[nodiscard]] std::span<const Link> links() const { return links_; }
  /// Links [first, last) that leave a circle.
  [[nodiscard]] std::uint32_t first_link(std::uint32_t circle) const { return link_starts_[circle]; }
  [[nodiscard]] std::uint32_t last_link(std::uint32_t circle) const { return link_starts_[circle + 1]; }
  [[nodiscard]] const FeasibleGraphCounts& counts() const { return counts_; }

 private:
  std::vector<TurnCircle> circles_;
  std::vector<HeadingSet> free_headings_;
  std::vector<Link> links_;
  std::vector<std::uint32_t> link_starts_;
  FeasibleGraphCounts counts_;
};

}  // namespace arcway
