#pragma once

#include <nlohmann/json.hpp>

#include "core/roadmap/feasible_graph.h"

namespace arcway::internal::cli {

inline nlohmann::ordered_json json_of(const FeasibleGraphCounts& counts) {
  return {{"circles", counts.circles},
          {"circles_blocked", counts.circles_blocked},
          {"candidates", counts.candidates},
          {"kept", counts.kept},
          {"rejected_overlap", counts.rejected_overlap},
          {"rejected_departure", counts.rejected_departure},
          {"rejected_arrival", counts.rejected_arrival},
          {"rejected_straight", counts.rejected_straight}};
}

}  // namespace arcway::internal::cli
