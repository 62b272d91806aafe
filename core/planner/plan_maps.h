#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "arcway/executor.h"
#include "arcway/vehicle.h"
#include "arcway/visibility_rows.h"
#include "arcway/world_change.h"
#include "core/attach/narrow_places.h"
#include "core/attach/roadmap.h"
#include "core/roadmap/lazy_feasible_graph.h"

namespace arcway::internal {

/// A vehicle with `factor` times the lateral acceleration in every turn, and at most the speed that it has on lines.
Vehicle with_other_turns(const Vehicle& vehicle, double factor);

/// The roadmaps on which one set of radii is planned.
struct PlanMaps {
  PlanMaps(Roadmap map, bool gap_circles);
  PlanMaps(const PlanMaps&) = delete;  // `narrow` refers to `plain`

  /// Largest number of vertices of a map with added circles in narrow gaps. That graph is lazy. Where there is no path,
  /// a search checks all that the start reaches, which takes seconds on larger maps.
  static constexpr std::size_t kNarrowVertices = 50'000;

  Roadmap plain;
  /// Roadmaps for vehicles with faster and with slower turns. After refinement, the fastest path may be on the route of
  /// one of them: many turns become wider or vanish, others stay as they are.
  Roadmap faster_turns, slower_turns;
  std::optional<NarrowPlaces> narrow;
};

/// Makes a planner's further roadmaps, with lazy graphs.
class LazyGraphs {
 public:
  /// What a planner before a change of the world has found.
  struct Change {
    const WorldChange& change;
    std::span<const VertexId> may_differ;  ///< see VisibilityRows::Changed
  };
  /// @param rows  of the reduced graph.
  /// @param change  null if all is made anew. It and the executor must outlive this.
  LazyGraphs(std::shared_ptr<const VisibilityRows> rows, const Executor& executor, const Change* change)
      : rows_(std::move(rows)), executor_(executor), change_(change) {}

  /// A roadmap with the graph of some radii.
  /// @param before  the roadmap of the same radii before the change; may be null.
  [[nodiscard]] Roadmap map_of(const Roadmap& map, const CircleRadii& radii, const Roadmap* before) const;
  /// When the making of graphs has to end.
  [[nodiscard]] StopClock clock() const { return executor_.clock(); }

 private:
  std::shared_ptr<const VisibilityRows> rows_;
  const Executor& executor_;
  const Change* change_;
};

/// A vehicle with turns of the first so many radii, and so many times the lateral acceleration.
struct OtherRoute {
  std::size_t radii;
  double factor;
  bool operator==(const OtherRoute&) const = default;
};

/// Roadmaps for further routes where there are several radii. The search does not know what refinement makes of a turn,
/// and circles around vertices have few radii. These maps therefore have fewer radii, as tight turns make a shorter
/// path, and vehicles with faster turns.
class OtherMaps {
 public:
  OtherMaps() = default;
  /// @param all       with more radii than `smallest`.
  /// @param smallest  with the first of them, see tightest_radii.
  /// @param routes    routes that equal one before, or the given maps, have no map.
  /// @param before    the maps before a change; null if there are none.
  OtherMaps(const Roadmap& all, const Roadmap& smallest, std::span<const OtherRoute> routes, const LazyGraphs& graphs,
            const OtherMaps* before);

  /// Null if it has no map.
  [[nodiscard]] const Roadmap* find(const OtherRoute& route) const;

 private:
  struct Entry {
    OtherRoute route;  // as it was given
    Roadmap map;
  };
  [[nodiscard]] const Roadmap* with_radii(std::size_t count) const;

  std::vector<Entry> entries_;
};

}  // namespace arcway::internal
