#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "arcway/executor.h"
#include "arcway/feasible_graph_snapshot.h"
#include "arcway/graph_mode.h"
#include "arcway/heading_set.h"
#include "arcway/process_group.h"
#include "arcway/query_set.h"
#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/visibility_graph.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "arcway/world_change.h"
#include "core/roadmap/turn_circle.h"
#include "core/roadmap/turn_circles.h"

namespace arcway::internal {

/// The feasible visibility graph: turn circles with their free headings, and the directed bitangents whose swept
/// rectangle is free. Arcs are not stored: from an arrival on a circle every departure is reachable that lies
/// ahead within the same free interval.
///
/// Both modes describe the same graph. Immutable to its users and safe to share between threads; copies share the data,
/// what a lazy graph has found out included. A lazy graph never takes more memory than one link for each candidate.
class FeasibleGraph {
 public:
  using Link = FeasibleLink;

  /// @param radii     of the turn circles [m], positive and ascending, at least one: std::invalid_argument otherwise.
  /// @param executor  used during construction only.
  /// @param process_group  builds the same eager graph: each process checks a share of the circles, all get the whole
  ///   graph.
  FeasibleGraph(const World& world, const Vehicle& vehicle, const VisibilityGraph& graph, const QuerySet& queries,
                std::span<const double> radii, const Executor& executor, GraphMode mode = GraphMode::kEager,
                const ProcessGroup& process_group = SingleProcess());
  /// The same from rows: a lazy graph asks for those that searches reach.
  FeasibleGraph(const World& world, const Vehicle& vehicle, std::shared_ptr<const VisibilityRows> rows,
                const QuerySet& queries, std::span<const double> radii, const Executor& executor,
                GraphMode mode = GraphMode::kEager, const ProcessGroup& process_group = SingleProcess());
  /// An eager graph from what one has found out before; see feasible_graph_snapshot.h. Nothing is checked again.
  /// @throws SnapshotError if the snapshot is not that of such a graph: a value out of range or order.
  FeasibleGraph(const World& world, const Vehicle& vehicle, std::shared_ptr<const VisibilityRows> rows,
                const QuerySet& queries, std::span<const double> radii, FeasibleGraphSnapshot known);

  /// The graph after a change of the world, the same as built anew. What lies where nothing came or went is taken from
  /// the graph before, as far as that one has found it out; the rest is checked now if eager, and when a search first
  /// asks for it if lazy. O(n) beside that.
  /// @param before  of the world before the change, the same vehicle and the same radii.
  /// @param rows    of `world`; all are asked for, as are those of `before`.
  FeasibleGraph(const FeasibleGraph& before, const World& world, const WorldChange& change, const Vehicle& vehicle,
                std::shared_ptr<const VisibilityRows> rows, const QuerySet& queries, std::span<const double> radii,
                const Executor& executor, GraphMode mode = GraphMode::kEager);

  /// A lazy graph with added circles: all straights of the base one, those between its circles and the added ones
  /// round a vertex as if these were base, and those that lead on to gap straights, through them and off them.
  /// @param base  of the same vehicle, without added circles.
  FeasibleGraph(const FeasibleGraph& base, const Vehicle& vehicle, const AddedCircles& added);

  [[nodiscard]] GraphMode mode() const;
  /// In the order of TurnCircles::all.
  [[nodiscard]] std::span<const TurnCircle> circles() const;
  [[nodiscard]] const TurnCircles& turn_circles() const;
  /// On circles wider than the smallest only those of a turn round the vertex: a right angle and some to either side.
  [[nodiscard]] const HeadingSet& free_headings(std::uint32_t circle) const;
  /// Links that leave a circle, by heading, then `to`: the kept ones if eager; those whose first heading is free if
  /// lazy.
  /// @throws Canceled if the clock is over before a lazy graph has found them: where vertices see thousands of others
  ///   that takes up to a second.
  [[nodiscard]] std::span<const Link> links_from(std::uint32_t circle, const StopClock& clock = {}) const;
  /// Whether links_from(circle)[index] is kept.
  [[nodiscard]] bool is_kept(std::uint32_t circle, std::size_t index) const;
  /// All kept links, by circle. Eager graphs only.
  [[nodiscard]] std::span<const Link> links() const;
  /// All that has been found out, to be taken up again. Eager graphs only.
  [[nodiscard]] FeasibleGraphSnapshot snapshot() const;
  /// Of what has been decided so far.
  [[nodiscard]] FeasibleGraphCounts counts() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace arcway::internal
