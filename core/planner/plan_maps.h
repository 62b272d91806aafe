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

/// The vehicle that may take every turn with `factor` times the lateral acceleration, at most as fast as it drives
/// straight.
/// @param factor  > 0
Vehicle with_other_turns(const Vehicle& vehicle, double factor);

/// What paths with turns of some radii are looked for on.
struct PlanMaps {
  PlanMaps(Roadmap map, bool gap_circles);
  PlanMaps(const PlanMaps&) = delete;  // `narrow` refers to `plain`

  /// The graph with circles in narrow places is lazy: where there is no path, a search checks all that the start
  /// reaches, seconds on larger maps.
  static constexpr std::size_t kNarrowVertices = 50'000;

  Roadmap plain;
  /// The same for vehicles with faster and with slower turns. The path that refinement makes the fastest may take the
  /// way of one of them: many turns become wider or are left out, others stay what they are.
  Roadmap faster_turns, slower_turns;
  std::optional<NarrowPlaces> narrow;
};

/// Where there are several radii, maps beside those of PlanMaps on which the fastest path may take a way of its own.
/// Circles round vertices have few radii, and what refinement makes of a turn is not known before: these maps have some
/// of the radii, as a path of tight turns is a shorter one, and vehicles with faster turns.
/// @param all       with more radii than `smallest`.
/// @param smallest  with the first of them, see tightest_radii.
/// @param rows      of the reduced graph of both.
/// @param executor  used during the call only.
std::vector<Roadmap> maps_of_other_routes(const Roadmap& all, const Roadmap& smallest,
                                          const std::shared_ptr<const VisibilityRows>& rows, const Executor& executor);

}  // namespace arcway::internal
