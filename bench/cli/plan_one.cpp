#include "bench/cli/plan_one.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "arcway/alternatives.h"
#include "arcway/curved_plan.h"
#include "arcway/datasets/plan_io.h"
#include "arcway/datasets/svg.h"
#include "arcway/evading_plan.h"
#include "bench/cli/counts_json.h"
#include "core/base/shortest_text.h"
#include "core/gaps/bottleneck_finder.h"
#include "core/geometry/closest_pair.h"
#include "core/motion/clearance.h"
#include "core/roadmap/feasible_graph.h"

namespace arcway::internal::cli {
namespace {

std::vector<LineSegment> edges_of(const Planner& planner) {
  const auto vertices = planner.world().vertices();
  std::vector<LineSegment> edges;
  const auto rows = planner.visibility_rows();
  for (VertexId u = 0; u < vertices.size(); ++u)
    for (const VertexId v : rows->of(u))
      if (u < v) edges.push_back({vertices[u], vertices[v]});
  return edges;
}

std::string caption_of(const PlanResult& result) {
  return "travel time " + fixed(result.travel_time, 2) + " s, length " + fixed(result.length, 1) +
         " m, smallest clearance " + fixed(result.min_clearance, 3) + " m";
}

// Text of a reason, part by part.
std::vector<std::string> lines_of(const std::string& reason) {
  std::vector<std::string> lines;
  for (std::size_t first = 0; first < reason.size();) {
    const std::size_t end = std::min(reason.find("; ", first), reason.size());
    lines.push_back(reason.substr(first, end - first));
    first = end + 2;
  }
  return lines;
}

// The point of an edge that is nearest to the body at a pose.
Vec2 nearest_point(const LineSegment& edge, const Footprint& body, const Pose& pose) {
  const SweptRectangle corners = swept_rectangle(pose, 0.0, body);
  ClosestPair nearest;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ClosestPair pair = closest_pair({corners[i], corners[(i + 1) % corners.size()]}, edge);
    if (pair.distance < nearest.distance) nearest = pair;
  }
  return nearest.b;
}

// Where the body comes nearest to an obstacle, once more and magnified.
void add_inset(SvgPicture& svg, const Planner& planner, const PlanResult& result) {
  const Body body = planner.vehicle().body();
  Clearance least;
  Pose pose = result.start;
  for (const PathSegment& segment : result.path()) {
    const Clearance here = clearance_along(segment, body, planner.world());
    if (!(here.distance < least.distance)) continue;
    least = here;
    pose = segment.at(here.arc_length);
  }
  if (least.edge == kNone) return;
  svg.add_bodies(std::vector{pose}, body);
  svg.add_inset(nearest_point(planner.world().edges()[least.edge], body, pose), body.front + body.rear,
                "the smallest clearance, " + rounded_text(least.distance) + " m");
}

// Picture of the first plan, with the lines of the others.
std::string picture(const PlanArguments& arguments, const Planner& planner, const TourRequest& request,
                    const std::vector<CheckedPlan>& plans) {
  const PlanResult& result = plans.front().result;
  const Body body = planner.vehicle().body();
  Box view;
  view.extend(result.start.position());
  view.extend(result.goal.position());
  for (const Place& place : request.waypoints) view.extend(place.position);
  // All that the body covers: on arcs the path bulges beyond its joints.
  const double length = body.length(), far = body.farthest();
  for (const CheckedPlan& plan : plans)
    for (const Vec2& p : polyline(plan.result.path(), std::max(length, plan.result.length / 10'000.0)))
      view.extend(Box{p, p}.grown(far));
  if (arguments.svg_view == "map" && !planner.world().box().empty()) {
    view.extend(planner.world().box().min);
    view.extend(planner.world().box().max);
    for (const Zone& zone : planner.world().zones())
      for (const Vec2& p : zone.area.outer) view.extend(p);
  } else {
    const double reach = body.front + body.rear + 0.05 * (view.max - view.min).maxCoeff();
    view.extend(Vec2(view.min.array() - reach));
    view.extend(Vec2(view.max.array() + reach));
  }
  SvgPicture svg(planner.world(), view);
  svg.add_axes();
  svg.add_obstacle_numbers(planner.world());
  if (std::ranges::find(arguments.svg_layers, "graph") != arguments.svg_layers.end()) svg.add_edges(edges_of(planner));
  if (result.solved()) {
    svg.add_swept_area(result.path(), body);
    for (std::size_t i = 1; i < plans.size(); ++i)
      svg.add_alternative(plans[i].result.path(), body,
                          "alternative " + std::to_string(i + 1) + ": " + caption_of(plans[i].result));
    svg.add_path(result.path(), body, caption_of(result));
    if (arguments.svg_color == "speed") svg.add_speeds(result.trajectory());
    if (arguments.svg_inset) add_inset(svg, planner, result);
    svg.set_title("Time-optimal path",
                  "The path of a car-like robot among polygonal obstacles, with its body drawn "
                  "along the way.");
  } else {
    std::vector<Pose> poses{result.start, result.goal};
    for (const Place& place : request.waypoints)
      if (place.heading) poses.push_back({place.position.x(), place.position.y(), *place.heading});
    svg.add_bodies(poses, body);
    svg.add_poses(result.start, result.goal, body);
    if (const auto& gap = result.bottleneck) svg.add_gap(gap->on_a, gap->on_b, rounded_text(gap->width) + " m");
    for (const std::string& line : lines_of(std::string(name_of(result.status)) + ": " + result.reason))
      svg.add_caption(line);
    svg.set_title("No path");
  }
  for (std::size_t i = 0; i < request.waypoints.size(); ++i)
    svg.add_place(request.waypoints[i].position,
                  request.waypoints.size() == 1 ? "waypoint" : "waypoint " + std::to_string(i + 1));
  svg.show(arguments.svg_layers);
  return svg.str();
}

/// JSON of the plan, of a tour's waypoints, and of the time for preparing the map.
std::string plan_json(const PreparedPlanner& prepared, const TourRequest& request, const CheckedPlan& plan,
                      std::uint64_t q) {
  const auto& [arguments, map, planner, build_seconds] = prepared;
  const PrepareStatistics& prepare = planner.prepare_statistics();
  auto json = nlohmann::ordered_json::parse(plan_to_json(plan.result, q, planner.vehicle().parameters()));
  if (plan.result.solved() && request.goals.size() > 1) json["goal_index"] = plan.goal;
  if (plan.result.solved() && !request.waypoints.empty()) json["passed"] = plan.passed;
  if (plan.evasion) json["evasion"] = {{"delay", plan.evasion->delay}, {"waiting", plan.evasion->waiting}};
  auto& statistics = json["statistics"];
  statistics["backend"] = arguments.build.backend;
  statistics["graph"] = planner.feasible_graph().finished() == nullptr ? "lazy" : "eager";
  statistics["builder"] = arguments.build.builder_name(planner.world());
  statistics["threads"] = arguments.build.thread_count();
  statistics["build_seconds"] = build_seconds;
  statistics["visibility_seconds"] = prepare.visibility_seconds;
  statistics["feasible_seconds"] = prepare.feasible_seconds;
  statistics["vertices"] = planner.world().vertices().size();
  statistics["rows"] = has_all_rows(planner) ? "all" : "lazy";
  if (has_all_rows(planner)) statistics["visibility_edges"] = planner.visibility_graph().edge_count();
  statistics.update(json_of(planner.feasible_graph().counts()));
  return json.dump() + "\n";
}

// The plan with a motion that evades the moving obstacles, checked.
CheckedPlan evading_and_checked(const PlanArguments& arguments, const Planner& planner, PlanResult result) {
  const Validator validator(planner.world());
  if (arguments.moving.empty()) return checked(validator, planner.vehicle(), std::move(result), arguments.reverse);
  const double planned_time = result.travel_time;
  CheckedPlan plan =
      checked(validator, planner.vehicle(), evading_plan(result, arguments.obstacles, arguments.evasion(planned_time)),
              arguments.reverse, arguments.obstacles);
  if (plan.result.solved()) plan.evasion = evasion_of(plan.result, planner.vehicle(), planned_time);
  return plan;
}

// Plans to the only goal, which has a heading.
PlanRequest plain(const PlanArguments& arguments, const TourRequest& request) {
  const EndSpeeds ends = arguments.end_speeds();
  const Place& goal = request.goals.front();
  return {.start = request.start,
          .goal = {goal.position.x(), goal.position.y(), *goal.heading},
          .reverse = request.reverse,
          .cusp_cost = request.cusp_cost,
          .max_gear_changes = request.max_gear_changes,
          .start_speed = ends.start,
          .goal_speed = ends.goal};
}

// The question whether polygons are free space, if one obstacle contains start and goal; else empty.
std::string free_space_row(const PlanArguments& arguments, const World& world, const PlanResult& result) {
  const bool collides = result.status == PlanStatus::kStartInCollision || result.status == PlanStatus::kGoalInCollision;
  if (!collides || arguments.reading.polygons == "free") return "";
  for (ObstacleId o = 0; o < world.obstacle_count(); ++o)
    if (world.locate(result.start.position(), o) == PointLocation::kInside &&
        world.locate(result.goal.position(), o) == PointLocation::kInside)
      return row("warning", "start and goal lie inside of " + region_text(world, o) +
                                "; is it meant as free space (--polygons free)?");
  return "";
}

}  // namespace

std::vector<CheckedPlan> plans_of(const PlanArguments& arguments, const Planner& planner, const TourRequest& request,
                                  const PlanLimits& limits) {
  std::vector<CheckedPlan> plans;
  const bool is_moving = arguments.end_speeds().is_moving();
  if (arguments.alternatives == 1 && !is_moving) {
    Tour tour = plan_tour(planner, request, limits);
    plans.push_back(evading_and_checked(arguments, planner, std::move(tour.plan)));
    plans.back().goal = tour.goal;
    plans.back().passed = std::move(tour.passed);
    return plans;
  }
  const Place& goal = request.goals.front();
  if (!request.waypoints.empty() || request.goals.size() > 1 || !goal.heading)
    throw UsageError(std::string(is_moving ? "--start-speed, --goal-speed" : "--alternatives") +
                     ": only to one goal with a heading, and without --waypoint");
  const PlanRequest asked = plain(arguments, request);
  std::vector<PlanResult> results = arguments.alternatives == 1
                                        ? std::vector{planner.plan(asked, limits)}
                                        : plan_alternatives(planner, asked, arguments.alternatives, limits);
  for (PlanResult& result : results) plans.push_back(evading_and_checked(arguments, planner, std::move(result)));
  return plans;
}

int plan_one(const PreparedPlanner& prepared, const TourRequest& request, const std::vector<CheckedPlan>& plans,
             const PlanOutput& output) {
  const auto& [arguments, map, planner, build_seconds] = prepared;
  auto& [files, out] = output;
  const CheckedPlan& plan = plans.front();
  const PlanResult& result = plan.result;

  if (!arguments.svg.empty()) files.add(arguments.svg, picture(arguments, planner, request, plans));
  std::string json;
  for (std::size_t i = 0; i < plans.size() && !arguments.json.empty(); ++i)
    json += plan_json(prepared, request, plans[i], i);
  if (!arguments.json.empty()) files.add(arguments.json, std::move(json));
  if (!arguments.csv.empty() && result.solved()) {
    files.add(arguments.csv, path_to_csv(result.trajectory(), arguments.sampling()));
  }
  if (!arguments.ros_path.empty() && result.solved()) {
    files.add(arguments.ros_path, path_to_nav_msgs(result.trajectory(), "map", arguments.sampling()) + "\n");
  }

  out += arguments.map + ": " + name_of(result.status) + "\n";
  if (!result.solved()) {
    out += row("reason", result.reason);
    out += row("certainty",
               result.certainty == Certainty::kProved ? "proved: there is no path" : "gave up: there may be a path");
    out += free_space_row(arguments, planner.world(), result);
  }
  out += row("start", pose_text(request.start));
  for (const Place& place : request.waypoints) out += row("waypoint", place_text(place));
  if (result.solved()) {
    out += row("goal", pose_text(result.goal)) + result_rows(result);
    if (plan.evasion) out += row("moving obstacles", to_string(*plan.evasion));
    out += validity_row(plan);
  } else {
    for (const Place& goal : request.goals) out += row("goal", place_text(goal));
  }
  bool good = plan.good();
  for (std::size_t i = 1; i < plans.size(); ++i) {
    out += "\n" + row("alternative", count_text(i + 1) + " of " + count_text(plans.size())) +
           result_rows(plans[i].result) + validity_row(plans[i]);
    good = good && plans[i].good();
  }
  out += "\n" + world_rows(planner.world()) + prepare_rows(planner, build_seconds) +
         row("built by", arguments.build.summary(planner.world())) + search_rows(result.statistics);
  out += warning_rows(map);
  files.write();
  out += files.summary();
  return good ? kExitSolved : kExitNoPath;
}

int no_plan(const PlanArguments& arguments, const LoadedMap& map, const TourRequest& request,
            const PlanOutput& output) {
  auto& [files, out] = output;
  PlanResult result;
  result.status = PlanStatus::kTimeLimit;
  result.interrupted = true;
  result.reason = "the time limit of " + shortest_text(arguments.limits().time) +
                  " s was over while the map was prepared; raise it, or prepare the map once: see arcway prepare";
  const Place& goal = request.goals.front();
  result.start = request.start;
  result.goal = {goal.position.x(), goal.position.y(), goal.heading.value_or(0.0)};
  if (!arguments.json.empty()) files.add(arguments.json, plan_to_json(result, 0) + "\n");
  out += arguments.map + ": " + name_of(result.status) + "\n" + row("reason", result.reason);
  out += row("start", pose_text(request.start));
  for (const Place& place : request.goals) out += row("goal", place_text(place));
  out += "\n" + world_rows(map.world) + warning_rows(map);
  files.write();
  out += files.summary();
  return kExitNoPath;
}

int plan_curved(const PlanArguments& arguments, LoadedMap& map, const TourRequest& request,
                const std::function<Planner(const World&)>& make_planner, const PlanOutput& output) {
  CurveTolerances tolerances;
  tolerances.last = arguments.reading.read_options().vector.curve_tolerance;
  tolerances.first = std::max(tolerances.first, tolerances.last);
  double build_seconds = 0.0;
  const auto timed = [&](const World& rings) {
    const Stopwatch watch;
    Planner planner = make_planner(rings);
    build_seconds = watch.seconds();
    return planner;
  };
  CurvedPlan plan = plan_among_curves(map.curved, plain(arguments, request), tolerances, timed, arguments.limits());
  const std::size_t curves = map.curved.curves.size();
  map.notes.push_back(count_text(curves) + (curves == 1 ? " curve" : " curves") + ", as rings within " +
                      shortest_text(tolerances.first) + " m, near the path within " +
                      shortest_text(plan.iterations.back().tolerance) + " m; planned " +
                      count_text(plan.iterations.size()) + (plan.iterations.size() == 1 ? " time" : " times"));
  const std::vector<CheckedPlan> plans{evading_and_checked(arguments, plan.planner, std::move(plan.result))};
  return plan_one({arguments, map, plan.planner, build_seconds}, request, plans, output);
}

}  // namespace arcway::internal::cli
