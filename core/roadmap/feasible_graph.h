#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/base/executor.h"
#include "core/base/stop_clock.h"
#include "core/base/team.h"
#include "core/collision/query_set.h"
#include "core/model/heading_set.h"
#include "core/model/vehicle.h"
#include "core/model/world.h"
#include "core/model/world_change.h"
#include "core/roadmap/turn_circle.h"
#include "core/roadmap/turn_circles.h"
#include "core/roadmap/visibility_graph.h"
#include "core/roadmap/visibility_rows.h"

namespace [[gnu::visibility("default")]] arcway {

/// Bitangents in, and why the others are out.
struct FeasibleGraphCounts {
  std::uint64_t circles = 0;          ///< turn circles of convex vertices, see TurnCircles
  std::uint64_t circles_blocked = 0;  ///< those without any free heading
  std::uint64_t candidates = 0;       ///< directed, between circles of the reduced graph's neighbors and beyond;
                                      ///< if lazy, those looked at so far
  std::uint64_t repeated = 0;         ///< those of circles round two vertices that were candidates before
  std::uint64_t kept = 0;
  std::uint64_t rejected_overlap = 0;    ///< no bitangent: circles overlap
  std::uint64_t rejected_departure = 0;  ///< (7): the body collides on the first circle at that heading
  std::uint64_t rejected_arrival = 0;    ///< (7): ... on the second circle
  std::uint64_t rejected_straight = 0;   ///< (6): the swept rectangle meets an obstacle
};

enum class GraphMode {
  kEager,  ///< everything is checked when the graph is built: for many queries on one map
  kLazy    ///< headings and bitangents are checked when a search first asks for them, and remembered: for few
};

struct FeasibleTables;

/// The feasible visibility graph: turn circles with their free headings, and the directed bitangents whose swept
/// rectangle is free. Arcs are not stored: from an arrival on a circle every departure is reachable that lies
/// ahead within the same free interval.
///
/// Both modes describe the same graph. Immutable to its users and safe to share between threads; copies share the data,
/// what a lazy graph has found out included. A lazy graph never takes more memory than one link for each candidate.
class FeasibleGraph {
 public:
  struct Link {
    std::uint32_t from;  ///< circle
    std::uint32_t to;    ///< circle
    double heading;      ///< [0, 2 pi)
    double length;       ///< [m]
  };

  /// @param radii     of the turn circles [m], positive and ascending, at least one: std::invalid_argument otherwise.
  /// @param executor  used during construction only.
  /// @param team      of processes that build the same eager graph: each checks a share of the circles, all get the
  ///   whole graph.
  FeasibleGraph(const World& world, const Vehicle& vehicle, const VisibilityGraph& graph, const QuerySet& queries,
                std::span<const double> radii, const Executor& executor, GraphMode mode = GraphMode::kEager,
                const Team& team = SoloTeam());
  /// The same from rows: a lazy graph asks for those that searches reach.
  FeasibleGraph(const World& world, const Vehicle& vehicle, std::shared_ptr<const VisibilityRows> rows,
                const QuerySet& queries, std::span<const double> radii, const Executor& executor,
                GraphMode mode = GraphMode::kEager, const Team& team = SoloTeam());
  /// An eager graph from what one has found out before; see feasible_tables.h. Nothing is checked again.
  /// @throws TableError if the tables are not those of such a graph: a value out of range or order.
  FeasibleGraph(const World& world, const Vehicle& vehicle, std::shared_ptr<const VisibilityRows> rows,
                const QuerySet& queries, std::span<const double> radii, FeasibleTables known);

  /// The graph after a change of the world, the same as built anew. What lies where nothing came or went is taken from
  /// the graph before, as far as that one has found it out; the rest is checked now if eager, and when a search first
  /// asks for it if lazy. O(n) beside that.
  /// @param before  of the world before the change, the same vehicle and the same radii.
  /// @param rows    of `world`; all are asked for, as are those of `before`.
  FeasibleGraph(const FeasibleGraph& before, const World& world, const WorldChange& change, const Vehicle& vehicle,
                std::shared_ptr<const VisibilityRows> rows, const QuerySet& queries, std::span<const double> radii,
                const Executor& executor, GraphMode mode = GraphMode::kEager);

  /// A lazy graph with extra circles: all straights of the usual one, those between its circles and the extra ones
  /// round a vertex as if these were usual, and those that lead on to gates, through them and off them.
  /// @param usual  of the same vehicle, without extra circles.
  FeasibleGraph(const FeasibleGraph& usual, const Vehicle& vehicle, const ExtraCircles& extra);

  [[nodiscard]] GraphMode mode() const;
  /// In the order of TurnCircles::all.
  [[nodiscard]] std::span<const TurnCircle> circles() const;
  [[nodiscard]] const TurnCircles& turn_circles() const;
  /// On circles wider than the smallest only those of a turn round the vertex: a right angle and some to either side.
  [[nodiscard]] const HeadingSet& free_headings(std::uint32_t circle) const;
  /// Links that leave a circle, by heading, then `to`: the kept ones if eager; those whose first heading is free if
  /// lazy.
  /// @throws Cancelled if the clock is over before a lazy graph has found them: where vertices see thousands of others
  ///   that takes up to a second.
  [[nodiscard]] std::span<const Link> links_from(std::uint32_t circle, const StopClock& clock = {}) const;
  /// Whether links_from(circle)[index] is kept.
  [[nodiscard]] bool is_kept(std::uint32_t circle, std::size_t index) const;
  /// All kept links, by circle. Eager graphs only.
  [[nodiscard]] std::span<const Link> links() const;
  /// All that has been found out, to be taken up again. Eager graphs only.
  [[nodiscard]] FeasibleTables tables() const;
  /// Of what has been decided so far.
  [[nodiscard]] FeasibleGraphCounts counts() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace arcway
