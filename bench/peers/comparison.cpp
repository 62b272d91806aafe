#include "bench/peers/comparison.h"

#include <algorithm>
#include <cstdio>

#include "core/path/speed_profile.h"
#include "core/path/validation.h"

namespace arcway::peers {
namespace {

std::string number(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Of sorted values, between the two nearest ranks.
double quantile(const std::vector<double>& sorted, double share) {
  const double rank = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::string quantile_text(std::vector<double> values, std::initializer_list<double> shares, const char* format) {
  if (values.empty()) return "–";
  std::ranges::sort(values);
  std::string text;
  for (const double share : shares) text += (text.empty() ? "" : " / ") + number(format, quantile(values, share));
  return text;
}

std::string table_line(const std::string& world, const std::string& planner, std::size_t p, std::span<const Row> rows) {
  std::size_t tasks = 0, solved = 0, valid = 0, ours_alone = 0, theirs_alone = 0;
  std::vector<double> milliseconds, ratios;
  for (const Row& row : rows) {
    if (row.world != world) continue;
    ++tasks;
    const auto& ours = row.answers.front();
    const auto& theirs = row.answers[p];
    ours_alone += ours && !theirs;
    theirs_alone += theirs && !ours;
    if (!theirs) continue;
    ++solved;
    valid += theirs->valid;
    milliseconds.push_back(1e3 * theirs->seconds);
    if (ours) ratios.push_back(theirs->travel_time / ours->travel_time);
  }
  return "| " + world + " | " + planner + " | " + std::to_string(solved) + " / " + std::to_string(tasks) + " | " +
         std::to_string(valid) + " | " + quantile_text(milliseconds, {0.5}, "%.3g") + " | " +
         quantile_text(ratios, {0.0, 0.25, 0.5, 0.75, 1.0}, "%.3f") + " | " + std::to_string(ours_alone) + " | " +
         std::to_string(theirs_alone) + " |\n";
}

}  // namespace

bool is_valid(const Problem& problem, const Path& path) {
  const SpeedProfile profile = speed_profile(path, problem.vehicle);
  TimedPath timed{path, {}, {}, profile.durations};
  for (std::size_t i = 0; i < path.size(); ++i) {
    timed.speed_in.push_back(profile.speeds[i]);
    timed.speed_out.push_back(profile.speeds[i + 1]);
  }
  return validate(problem.world, problem.vehicle, problem.request.start, problem.request.goal, timed).valid();
}

std::string comparison_table(std::span<const std::string> planners, std::span<const Row> rows) {
  std::string table =
      "| world | planner | solved | valid | median time [ms] | travel time / arcway's: min / 25 % / median / 75 % / "
      "max "
      "| arcway alone | planner alone |\n|---|---|---:|---:|---:|---|---:|---:|\n";
  std::vector<std::string> worlds;
  for (const Row& row : rows)
    if (std::ranges::find(worlds, row.world) == worlds.end()) worlds.push_back(row.world);
  for (const std::string& world : worlds)
    for (std::size_t p = 0; p < planners.size(); ++p) table += table_line(world, planners[p], p, rows);
  return table;
}

std::string comparison_csv(std::span<const std::string> planners, std::span<const Row> rows) {
  std::string csv = "world,query,planner,solved,valid,seconds,travel_time_s,lower_bound_s\n";
  for (const Row& row : rows) {
    for (std::size_t p = 0; p < planners.size(); ++p) {
      const auto& answer = row.answers[p];
      csv += row.world + "," + std::to_string(row.query) + "," + planners[p] + "," + (answer ? "1," : "0,");
      csv += answer ? std::to_string(static_cast<int>(answer->valid)) + "," + number("%.6g", answer->seconds) + "," +
                          number("%.9g", answer->travel_time)
                    : ",,";
      csv += "," + number("%.9g", row.lower_bound) + "\n";
    }
  }
  return csv;
}

}  // namespace arcway::peers
