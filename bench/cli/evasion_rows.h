#pragma once

#include <string>

#include "arcway/plan_result.h"
#include "arcway/vehicle.h"

namespace arcway::internal::cli {

/// What a plan does among moving obstacles.
struct EvasionSummary {
  double delay = 0.0;         ///< later at the goal than the fastest motion [s]
  double waiting = 0.0;       ///< [s] of it
  double waits_until = 0.0;   ///< end of the last wait [s]
  double slower_until = 0.0;  ///< when it last drives below its highest speed [s]; 0 if it never does so
};
/// @param planned_time  of the fastest motion along the path [s].
EvasionSummary evasion_of(const PlanResult& plan, const Vehicle& vehicle, double planned_time);

/// "waits 2.500 s, until 4.100 s; drives more slowly until 7.200 s; 3.300 s later at the goal", or
/// "none is met".
std::string to_string(const EvasionSummary& summary);

}  // namespace arcway::internal::cli
