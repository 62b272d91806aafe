#include "bench/cli/plan_rows.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "arcway/zone.h"
#include "arcway/zone_stay.h"
#include "bench/cli/arguments.h"
#include "core/base/shortest_text.h"

namespace arcway::internal::cli {

namespace {

// The bound has its rounding taken off.
std::string defect_of(const PlanResult& result) {
  if (result.travel_time >= result.lower_bound) return "";
  return "the plan takes " + shortest_text(result.travel_time) + " s, less than the lower bound of " +
         shortest_text(result.lower_bound) +
         " s: one of them is wrong. Please report this with the map, the robot and the command";
}

// What is driven close in a zone; empty if nothing is.
std::string close_text(const PlanResult& result, std::uint32_t zone) {
  const auto close = std::ranges::find(result.close_in_zones, zone, &ZoneCloseDriving::zone);
  if (close == result.close_in_zones.end()) return "";
  return ", " + fixed(close->close.length, 3) + " m of it closer than " + shortest_text(close->close.distance) +
         " m to an obstacle, which costs " + fixed(close->close.cost, 3) + " s";
}

std::string zone_rows(const PlanResult& result) {
  std::string text;
  for (const ZoneStay& stay : zone_stays(result))
    text += row("in zone", zone_text(result.scene->world.zones()[stay.zone], stay.zone) + ", " + fixed(stay.time, 3) +
                               " s, " + fixed(stay.length, 3) + " m" + close_text(result, stay.zone));
  if (!result.close_in_zones.empty()) text += row("cost", fixed(result.cost(), 3) + " s");
  return text;
}

}  // namespace

CheckedPlan checked(const Validator& validator, const Vehicle& vehicle, PlanResult result, bool reverse,
                    std::span<const MovingObstacle> moving) {
  CheckedPlan plan{.result = std::move(result), .report = std::nullopt};
  if (plan.result.solved()) {
    plan.report = validator(vehicle, plan.result.start, plan.result.goal, plan.result.timed_path(),
                            {.reverse = reverse,
                             .start_speed = plan.result.start_speed,
                             .goal_speed = plan.result.goal_speed,
                             .moving = {moving.begin(), moving.end()}});
    plan.defect = defect_of(plan.result);
  }
  return plan;
}

bool has_all_rows(const Planner& planner) {
  return planner.visibility_graph().vertex_count() == planner.world().vertices().size();
}

std::string prepare_rows(const Planner& planner, double build_seconds) {
  const PrepareStatistics& prepare = planner.prepare_statistics();
  std::string text;
  text += row("reduced graph", has_all_rows(planner) ? count_text(planner.visibility_graph().edge_count()) + " edges"
                                                     : "rows found as the search needed them");
  text += feasible_row(planner);
  text += row("build", duration_text(build_seconds) + " (reduced graph " + duration_text(prepare.visibility_seconds) +
                           ", feasible graph " + duration_text(prepare.feasible_seconds) + ")");
  return text;
}

std::string result_rows(const PlanResult& result) {
  std::string text;
  text += row("travel time", fixed(result.travel_time, 3) + " s" +
                                 (result.interrupted ? ", the best found within the time limit" : ""));
  if (result.start_speed != 0.0 || result.goal_speed != 0.0)
    text += row("speeds", fixed(result.start_speed, 3) + " m/s at the start, " + fixed(result.goal_speed, 3) +
                              " m/s at the goal");
  text += row("before refinement", fixed(result.statistics.unrefined_travel_time, 3) + " s");
  text += row("length", fixed(result.length, 3) + " m in " + count_text(result.segments.size()) + " segments");
  const Path path = result.path();
  const bool reverse = std::any_of(path.begin(), path.end(), [](const auto& s) { return s.gear == Gear::kReverse; });
  if (reverse) text += row("changes of gear", count_text(cusps_of(path)));
  text += row("lower bound",
              fixed(result.lower_bound, 3) + " s" +
                  (result.lower_bound > 0.0 ? ", gap " + fixed(100.0 * result.optimality_gap(), 2) + " %" : ""));
  text += row("smallest clearance",
              (result.clearance_is_lower_bound ? "at least " : "") + fixed(result.min_clearance, 6) + " m");
  if (const auto& close = result.close_driving)
    text += row("driven closer", fixed(close->length, 3) + " m, closer than " + shortest_text(close->distance) +
                                     " m; with that the plan costs " + fixed(result.cost(), 3) + " s");
  return text + zone_rows(result);
}

std::string search_rows(const PlanStatistics& statistics) {
  std::string text;
  if (statistics.first_path_seconds > 0.0)
    text += row("first path",
                fixed(statistics.first_travel_time, 3) + " s, after " + duration_text(statistics.first_path_seconds));
  text +=
      row("query", duration_text(statistics.total_seconds) + " (search " + duration_text(statistics.search_seconds) +
                       ", refinement " + duration_text(statistics.refine_seconds) + ", profile " +
                       duration_text(statistics.profile_seconds) + ")");
  text += row("arrivals",
              count_text(statistics.nodes_expanded) + " expanded, " + count_text(statistics.nodes_pushed) + " pushed");
  return text + suboptimality_row(statistics.suboptimality);
}

std::string suboptimality_row(double suboptimality) {
  if (suboptimality == 0.0) return "";
  return row("search",
             "may take up to " + shortest_text(1.0 + suboptimality) + " times as long as the fastest of the graph");
}

std::string validity_row(const CheckedPlan& plan) {
  const ValidationReport& report = *plan.report;
  std::string text = row("valid", report.valid()          ? "yes, every moment of the motion checked"
                                  : report.issues.empty() ? "NO: " + to_string(report.conflicts.front())
                                                          : "NO: " + report.issues.front().message);
  if (!plan.defect.empty()) text += row("DEFECT", plan.defect);
  return text;
}

}  // namespace arcway::internal::cli
