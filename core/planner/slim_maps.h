#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/visibility_rows.h"
#include "core/attach/roadmap.h"
#include "core/base/late_value.h"
#include "core/planner/strategy.h"

namespace arcway::internal {

/// The vehicle with a body that is narrower by a share of its width, and shorter by half that share of its length.
Vehicle slimmer(const Vehicle& vehicle, double share);

/// A roadmap for a vehicle of another body, in the world of a roadmap. Its graph is lazy, so that this takes
/// O(vertices).
/// @param rows  of the reduced graph.
/// @throws Canceled if the clock is over before.
Roadmap roadmap_for(const Vehicle& vehicle, const CircleRadii& radii, const Roadmap& map,
                    const std::shared_ptr<const VisibilityRows>& rows, const StopClock& clock);

/// Roadmaps of a world for slimmer bodies. Where a body has next to no room, the path of a slimmer one is far easier to
/// find, and shows where that of the real one is. Made when first asked for. Thread-safe.
class SlimMaps {
 public:
  /// @param map  of the real body; must outlive this.
  /// @param rows  of the reduced graph.
  SlimMaps(const Roadmap& map, std::shared_ptr<const VisibilityRows> rows) : map_(map), rows_(std::move(rows)) {}

  /// The roadmap for a body of kSlimBodies, with turns of the smallest radius; null if the clock is over before it is
  /// made. Its graph is lazy, so that this takes O(vertices).
  [[nodiscard]] const Roadmap* operator()(std::size_t i, const StopClock& clock) const;

 private:
  const Roadmap& map_;
  std::shared_ptr<const VisibilityRows> rows_;
  std::array<LateValue<Roadmap>, kSlimBodies.size()> maps_;
};

}  // namespace arcway::internal
