#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/peers/exact_motion.h"

namespace arcway::peers {

/// One planner's answer to one task.
struct Answer {
  double seconds = 0.0;      ///< until the answer
  double travel_time = 0.0;  ///< from rest to rest [s]
  Path path;
  bool valid = false;  ///< as the validator finds
};

/// One task and all answers to it, in the order of the planners.
struct Row {
  std::string world;
  std::size_t query = 0;
  PlanRequest request;
  double lower_bound = 0.0;  ///< [s]
  std::vector<std::optional<Answer>> answers;
};

/// Checks a peer's path like one of the planner's.
bool is_valid(const Problem& problem, const Path& path);

/// A Markdown table, one line a world and planner: solved, valid, median time to the answer, travel time over that of
/// planners.front(): quartiles and extremes over the tasks that both solved, and the tasks that only one of the two
/// solved.
std::string comparison_table(std::span<const std::string> planners, std::span<const Row> rows);

/// `world,query,planner,solved,valid,seconds,travel_time_s,lower_bound_s`, a line an answer.
std::string comparison_csv(std::span<const std::string> planners, std::span<const Row> rows);

}  // namespace arcway::peers
