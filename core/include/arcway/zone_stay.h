#pragma once

#include <cstdint>
#include <vector>

#include "arcway/export.h"
#include "arcway/plan_result.h"

namespace arcway {

/// How long a plan is in a zone.
struct ZoneStay {
  std::uint32_t zone;  ///< index among World::zones of PlanResult::scene
  double length;       ///< that F drives in it [m]
  double time;         ///< [s]
};

/// The zones that F enters along a plan, ascending. Keep-outs for other vehicles are among them. The border belongs to
/// a zone. Empty unless the plan is solved and has a scene. O(zones * segments).
/// @throws std::invalid_argument as Trajectory does.
ARCWAY_API std::vector<ZoneStay> zone_stays(const PlanResult& plan);

}  // namespace arcway
