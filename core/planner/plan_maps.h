#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "arcway/executor.h"
#include "arcway/vehicle.h"
#include "arcway/visibility_rows.h"
#include "core/attach/narrow_places.h"
#include "core/attach/roadmap.h"

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

/// Roadmaps for further routes where there are several radii. The search does not know what refinement makes of a turn,
/// and circles around vertices have few radii. These maps therefore have fewer radii, as tight turns make a shorter
/// path, and vehicles with faster turns.
/// @param all  with more radii than `smallest`.
/// @param smallest  with the first of them, see tightest_radii.
/// @param rows  of the reduced graph of both.
/// @param executor  used during the call only.
std::vector<Roadmap> maps_of_other_routes(const Roadmap& all, const Roadmap& smallest,
                                          const std::shared_ptr<const VisibilityRows>& rows, const Executor& executor);

}  // namespace arcway::internal
