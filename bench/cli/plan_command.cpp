#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/cli/arguments.h"
#include "bench/cli/progress_bar.h"
#include "core/alternatives.h"
#include "core/bytes.h"
#include "core/curved_plan.h"
#include "core/path/validation.h"
#include "core/plan_batch.h"
#include "core/planner.h"
#include "core/shortest_text.h"
#include "datasets/plan_io.h"
#include "datasets/robot.h"
#include "datasets/svg.h"

namespace arcway::cli {
namespace {

struct PlanArguments {
  std::string map;
  MapOptions reading;
  std::string robot;
  std::string start;
  std::vector<std::string> goals, via;
  std::uint32_t alternatives = 1;
  std::string queries, out;
  std::string heuristic = "travel_time";
  std::string graph;
  std::string time_limit;
  bool reverse = false;
  std::string cusp_cost;
  std::uint32_t refine_trials = RefineOptions{}.max_trials;
  std::string svg, json, csv, ros_path;
  std::vector<std::string> svg_layers{"bounds", "obstacles", "swept", "path", "robot", "markers"};
  std::string svg_view = "map";
  BuildOptions build;
};

Heuristic heuristic_of(const std::string& name) {
  if (name == "travel_time") return Heuristic::kTravelTime;
  if (name == "paper") return Heuristic::kPaperDistance;
  if (name == "dijkstra") return Heuristic::kDijkstra;
  throw UsageError("--heuristic: expected travel_time, paper or dijkstra, got \"" + name + "\"");
}

GraphMode graph_mode_of(const std::string& name, bool batch) {
  if (name.empty()) return batch ? GraphMode::kEager : GraphMode::kLazy;
  if (name == "eager") return GraphMode::kEager;
  if (name == "lazy") return GraphMode::kLazy;
  throw UsageError("--graph: expected eager or lazy, got \"" + name + "\"");
}

/// A plan and what the validator says of it; no report unless solved.
struct CheckedPlan {
  PlanResult result;
  std::optional<ValidationReport> report;
  [[nodiscard]] bool good() const { return report && report->valid(); }
};

CheckedPlan checked(const Planner& planner, PlanResult result, bool reverse) {
  CheckedPlan plan{std::move(result), std::nullopt};
  if (plan.result.solved()) {
    plan.report = validate(planner.world(), planner.vehicle(), plan.result.start, plan.result.goal,
                           plan.result.timed_path(), {.reverse = reverse});
  }
  return plan;
}

PlanLimits limits_of(const PlanArguments& arguments) {
  const std::string& text = arguments.time_limit;
  if (text.empty()) return {};
  const double seconds = parse_number(text, "--time-limit");
  if (seconds < 0.0) throw UsageError("--time-limit: at least 0 s, got \"" + text + "\"");
  return {.time = seconds};
}

// Seconds; 0 if not given.
double cusp_cost_of(const PlanArguments& arguments) {
  const std::string& text = arguments.cusp_cost;
  if (text.empty()) return 0.0;
  if (!arguments.reverse) throw UsageError("--cusp-cost: only with --reverse");
  const double seconds = parse_number(text, "--cusp-cost");
  if (seconds < 0.0) throw UsageError("--cusp-cost: at least 0 s, got \"" + text + "\"");
  return seconds;
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
  text += row("before refinement", fixed(result.statistics.unrefined_travel_time, 3) + " s");
  text += row("length", fixed(result.length, 3) + " m in " + count_text(result.segments.size()) + " segments");
  const Path path = result.path();
  const bool reverse = std::any_of(path.begin(), path.end(), [](const auto& s) { return s.gear == Gear::kReverse; });
  if (reverse) text += row("changes of gear", count_text(cusps_of(path)));
  text +=
      row("lower bound", fixed(result.lower_bound, 3) + " s, gap " + fixed(100.0 * result.optimality_gap(), 2) + " %");
  text += row("smallest clearance", fixed(result.min_clearance, 6) + " m");
  return text;
}

std::string search_rows(const PlanStatistics& statistics) {
  std::string text;
  text +=
      row("query", duration_text(statistics.total_seconds) + " (search " + duration_text(statistics.search_seconds) +
                       ", refinement " + duration_text(statistics.refine_seconds) + ", profile " +
                       duration_text(statistics.profile_seconds) + ")");
  text += row("arrivals",
              count_text(statistics.nodes_expanded) + " expanded, " + count_text(statistics.nodes_pushed) + " pushed");
  return text;
}

std::string validity_row(const ValidationReport& report) {
  if (report.valid()) return row("valid", "yes, every moment of the motion checked");
  return row("valid", "NO: " + report.issues.front().message);
}

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

// A reason, part by part.
std::vector<std::string> lines_of(const std::string& reason) {
  std::vector<std::string> lines;
  for (std::size_t first = 0; first < reason.size();) {
    const std::size_t end = std::min(reason.find("; ", first), reason.size());
    lines.push_back(reason.substr(first, end - first));
    first = end + 2;
  }
  return lines;
}

// The first plan, and the lines of the others.
std::string picture(const PlanArguments& arguments, const Planner& planner, const std::vector<CheckedPlan>& plans) {
  const PlanResult& result = plans.front().result;
  const Footprint body = planner.vehicle().footprint();
  Box view;
  view.extend(result.start.position());
  view.extend(result.goal.position());
  for (const CheckedPlan& plan : plans)
    for (const TimedSegment& s : plan.result.segments) view.extend(s.segment.start.position());
  if (arguments.svg_view == "map" && !planner.world().box().empty()) {
    view.extend(planner.world().box().min);
    view.extend(planner.world().box().max);
  } else {
    const double reach = body.front + body.rear + 0.05 * (view.max - view.min).maxCoeff();
    view.extend(Vec2(view.min.array() - reach));
    view.extend(Vec2(view.max.array() + reach));
  }
  SvgPicture svg(planner.world(), view);
  if (std::ranges::find(arguments.svg_layers, "graph") != arguments.svg_layers.end()) svg.add_edges(edges_of(planner));
  if (result.solved()) {
    svg.add_swept_area(result.path(), body);
    svg.add_caption(caption_of(result));
    for (std::size_t i = 1; i < plans.size(); ++i)
      svg.add_alternative(plans[i].result.path(), body,
                          "alternative " + std::to_string(i + 1) + ": " + caption_of(plans[i].result));
    svg.add_path(result.path(), body);
    svg.set_title("Time-optimal path",
                  "The path of a car-like robot among polygonal obstacles, with its body drawn "
                  "along the way.");
  } else {
    svg.add_poses(result.start, result.goal, body);
    if (const auto& gap = result.bottleneck) svg.add_gap(gap->on_a, gap->on_b, rounded_text(gap->width) + " m");
    for (const std::string& line : lines_of(std::string(name_of(result.status)) + ": " + result.reason))
      svg.add_caption(line);
    svg.set_title("No path");
  }
  svg.show(arguments.svg_layers);
  return svg.str();
}

/// The plan, and in its statistics what it took to prepare the map.
std::string plan_json(const PlanArguments& arguments, const Planner& planner, double build_seconds,
                      const PlanResult& result, std::uint64_t q) {
  const PrepareStatistics& prepare = planner.prepare_statistics();
  const FeasibleGraphCounts counts = planner.feasible_graph().counts();
  auto json = nlohmann::ordered_json::parse(plan_to_json(result, q));
  auto& statistics = json["statistics"];
  statistics["backend"] = arguments.build.backend;
  statistics["graph"] = planner.feasible_graph().mode() == GraphMode::kLazy ? "lazy" : "eager";
  statistics["builder"] = arguments.build.builder_name(planner.world());
  statistics["threads"] = arguments.build.thread_count();
  statistics["build_seconds"] = build_seconds;
  statistics["visibility_seconds"] = prepare.visibility_seconds;
  statistics["feasible_seconds"] = prepare.feasible_seconds;
  statistics["vertices"] = planner.world().vertices().size();
  statistics["rows"] = has_all_rows(planner) ? "all" : "lazy";
  if (has_all_rows(planner)) statistics["visibility_edges"] = planner.visibility_graph().edge_count();
  statistics["circles"] = counts.circles;
  statistics["candidates"] = counts.candidates;
  statistics["kept"] = counts.kept;
  statistics["rejected_overlap"] = counts.rejected_overlap;
  statistics["rejected_departure"] = counts.rejected_departure;
  statistics["rejected_arrival"] = counts.rejected_arrival;
  statistics["rejected_straight"] = counts.rejected_straight;
  return json.dump() + "\n";
}

// Alternatives, or the one plan that leads by all places to a goal.
std::vector<CheckedPlan> plans_of(const PlanArguments& arguments, const Planner& planner, const TourRequest& request,
                                  const PlanLimits& limits) {
  std::vector<CheckedPlan> plans;
  if (arguments.alternatives == 1) {
    plans.push_back(checked(planner, plan_tour(planner, request, limits).plan, request.reverse));
    return plans;
  }
  const Place& goal = request.goals.front();
  if (!request.via.empty() || request.goals.size() > 1 || !goal.heading)
    throw UsageError("--alternatives: only to one goal with a heading, and without --via");
  const PlanRequest plain{.start = request.start,
                          .goal = {goal.position.x(), goal.position.y(), *goal.heading},
                          .reverse = request.reverse,
                          .cusp_cost = request.cusp_cost};
  for (PlanResult& result : plan_alternatives(planner, plain, arguments.alternatives, limits))
    plans.push_back(checked(planner, std::move(result), request.reverse));
  return plans;
}

int plan_one(const PlanArguments& arguments, const LoadedMap& map, const Planner& planner, double build_seconds,
             const TourRequest& request, const std::vector<CheckedPlan>& plans, const Team& team, std::string& out) {
  const CheckedPlan& plan = plans.front();
  const PlanResult& result = plan.result;

  OutputFiles files;
  if (!arguments.svg.empty()) files.add(arguments.svg, picture(arguments, planner, plans));
  std::string json;
  for (std::size_t i = 0; i < plans.size() && !arguments.json.empty(); ++i)
    json += plan_json(arguments, planner, build_seconds, plans[i].result, i);
  if (!arguments.json.empty()) files.add(arguments.json, std::move(json));
  if (!arguments.csv.empty() && result.solved()) {
    files.add(arguments.csv, path_to_csv(result.segments, planner.vehicle()));
  }
  if (!arguments.ros_path.empty() && result.solved()) {
    files.add(arguments.ros_path, path_to_nav_msgs(result.segments, planner.vehicle()) + "\n");
  }

  out += arguments.map + ": " + name_of(result.status) + "\n";
  if (!result.solved()) out += row("reason", result.reason);
  out += row("start", pose_text(request.start));
  for (const Place& place : request.via) out += row("by way of", place_text(place));
  if (result.solved()) {
    out += row("goal", pose_text(result.goal)) + result_rows(result) + validity_row(*plan.report);
  } else {
    for (const Place& goal : request.goals) out += row("goal", place_text(goal));
  }
  bool good = plan.good();
  for (std::size_t i = 1; i < plans.size(); ++i) {
    out += "\n" + row("alternative", count_text(i + 1) + " of " + count_text(plans.size())) +
           result_rows(plans[i].result) + validity_row(*plans[i].report);
    good = good && plans[i].good();
  }
  out += "\n" + world_rows(planner.world()) + prepare_rows(planner, build_seconds) +
         row("built by", arguments.build.summary(planner.world())) + search_rows(result.statistics);
  out += warning_rows(map);
  if (team.rank() == 0) files.write();
  out += files.summary();
  return good ? kExitSolved : kExitNoPath;
}

/// Plans on rings that are refined near the path, down to the tolerance that the map was read with.
int plan_curved(const PlanArguments& arguments, LoadedMap& map, const TourRequest& request,
                const std::function<Planner(const World&)>& make_planner, const PlanLimits& limits, const Team& team,
                std::string& out) {
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
  const Place& goal = request.goals.front();
  const PlanRequest plain{.start = request.start,
                          .goal = {goal.position.x(), goal.position.y(), *goal.heading},
                          .reverse = request.reverse,
                          .cusp_cost = request.cusp_cost};
  CurvedPlan plan = plan_among_curves(map.curved, plain, tolerances, timed, limits);
  map.notes.push_back(count_text(map.curved.curves.size()) + " curves, as rings within " +
                      shortest_text(tolerances.first) + " m, near the path within " +
                      shortest_text(plan.rounds.back().tolerance) + " m; planned " + count_text(plan.rounds.size()) +
                      (plan.rounds.size() == 1 ? " time" : " times"));
  const std::vector<CheckedPlan> plans{checked(plan.planner, std::move(plan.result), request.reverse)};
  return plan_one(arguments, map, plan.planner, build_seconds, request, plans, team, out);
}

std::string batch_line(std::uint64_t q, const CheckedPlan& plan) {
  const PlanResult& result = plan.result;
  std::string line = std::to_string(q) + "," + name_of(result.status) + ",";
  if (result.solved()) {
    line += shortest_text(result.travel_time) + "," + shortest_text(result.length) + "," +
            shortest_text(result.lower_bound) + "," + shortest_text(result.min_clearance) + "," +
            (plan.good() ? "1" : "0");
  } else {
    line += ",,,,";
  }
  return line + "," + fixed(1e3 * result.statistics.total_seconds, 3) + "\n";
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What a batch says of one query.
struct Answer {
  std::string line, json, refusal;  ///< the validator's first complaint, if it refuses the plan
  double seconds = 0.0;
  bool solved = false;
};

std::string to_bytes(const std::vector<Answer>& answers) {
  std::string bytes;
  for (const Answer& answer : answers) {
    for (const std::string& text : {answer.line, answer.json, answer.refusal}) {
      append_bytes(bytes, text.size());
      bytes += text;
    }
    append_bytes(bytes, answer.seconds);
    append_bytes(bytes, answer.solved);
  }
  return bytes;
}

void append_answers(std::string_view bytes, std::vector<Answer>& answers) {
  while (!bytes.empty()) {
    Answer answer;
    for (std::string* text : {&answer.line, &answer.json, &answer.refusal}) {
      const std::vector<char> found = take_bytes<char>(bytes, take_bytes<std::size_t>(bytes));
      text->assign(found.begin(), found.end());
    }
    answer.seconds = take_bytes<double>(bytes);
    answer.solved = take_bytes<char>(bytes) != 0;
    answers.push_back(std::move(answer));
  }
}

/// Of this process's share of the queries.
std::vector<Answer> answer_share(const Planner& planner, std::span<const NumberedRequest> queries,
                                 const PlanLimits& limits, bool with_json, const Executor& threads) {
  std::vector<PlanRequest> requests;
  for (const NumberedRequest& query : queries) requests.push_back(query.request);
  ProgressBar bar;
  std::vector<PlanResult> results =
      plan_batch(planner, requests, threads, {.time_limit = limits.time, .progress = bar.callback()});
  std::vector<Answer> answers(results.size());
  const ReportingExecutor watched(threads, bar.callback());
  watched.begin_stage("validations");
  watched.for_ranges(results.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const CheckedPlan plan = checked(planner, std::move(results[i]), requests[i].reverse);
      Answer& answer = answers[i];
      answer.line = batch_line(queries[i].q, plan);
      if (with_json) answer.json = plan_to_json(plan.result, queries[i].q) + "\n";
      answer.seconds = plan.result.statistics.total_seconds;
      answer.solved = plan.result.solved();
      if (answer.solved && !plan.good())
        answer.refusal = "query " + std::to_string(queries[i].q) + ": " + plan.report->issues.front().message;
    }
  });
  return answers;
}

int answer_queries(const PlanArguments& arguments, const LoadedMap& map, const Planner& planner, double build_seconds,
                   const std::vector<NumberedRequest>& queries, const PlanLimits& limits, const Team& team,
                   std::string& out) {
  const PrepareStatistics& prepare = planner.prepare_statistics();
  std::string csv = "# build " + fixed(build_seconds, 6) + " s: reduced graph " + fixed(prepare.visibility_seconds, 6) +
                    " s, feasible graph " + fixed(prepare.feasible_seconds, 6) + " s; " +
                    arguments.build.summary(planner.world()) + "\n";
  csv += "q,status,travel_time_s,length_m,lower_bound_s,min_clearance_m,valid,plan_ms\n";
  std::string json;
  std::size_t solved = 0;
  std::size_t refused = 0;
  std::string first_refusal;
  std::vector<double> seconds;
  const Stopwatch watch;
  const auto threads = arguments.build.executor();
  const auto [first, last] = team.share_of(queries.size());
  std::vector<Answer> answers;
  for (const std::string& share : team.gather(to_bytes(answer_share(
           planner, std::span(queries).subspan(first, last - first), limits, !arguments.json.empty(), *threads))))
    append_answers(share, answers);
  for (const Answer& answer : answers) {
    csv += answer.line;
    json += answer.json;
    seconds.push_back(answer.seconds);
    solved += answer.solved ? 1 : 0;
    if (!answer.refusal.empty() && refused++ == 0) first_refusal = answer.refusal;
  }
  const double total = watch.seconds();

  OutputFiles files;
  files.add(arguments.out, std::move(csv));
  if (!arguments.json.empty()) files.add(arguments.json, std::move(json));

  out += arguments.map + ": " + count_text(solved) + " of " + count_text(queries.size()) + " solved\n";
  out += row("valid", solved == 0    ? "no plan to check"
                      : refused == 0 ? "all of them, every moment of the motion checked"
                                     : "NO, " + count_text(refused) + " refused; " + first_refusal);
  out += row("query times", "median " + duration_text(median(seconds)) + ", sum " +
                                duration_text(std::accumulate(seconds.begin(), seconds.end(), 0.0)) + "; " +
                                duration_text(total) + " with validation");
  out += "\n" + world_rows(map.world) + prepare_rows(planner, build_seconds) +
         row("built by", arguments.build.summary(planner.world())) + warning_rows(map);
  if (team.rank() == 0) files.write();
  out += files.summary();
  return refused == 0 ? kExitSolved : kExitNoPath;
}

/// From the map's file what it has of this vehicle; the rest is built, or found as a search asks for it.
Planner make_planner(const PlanArguments& arguments, LoadedMap& map, const Vehicle& vehicle,
                     const PlannerOptions& options) {
  const QuerySet queries = arguments.build.queries(map.world);
  const auto threads = arguments.build.executor();
  ProgressBar bar;
  const ReportingExecutor executor(*threads, bar.callback());
  if (!map.prepared) {
    const bool lazy = options.graph_mode == GraphMode::kLazy;
    if (const auto rows = lazy ? arguments.build.lazy_rows(map.world, executor) : nullptr)
      return {map.world, vehicle, queries, rows, options, executor};
    return {map.world, vehicle, queries, options, executor};
  }
  VisibilityGraph& reduced = map.prepared->reduced_graph;
  auto& robot = map.prepared->robot;
  if (!robot || to_json(robot->parameters) != to_json(vehicle.parameters()))
    return {map.world, vehicle, queries, std::move(reduced), options, executor};
  try {
    PreparedGraph graphs{std::move(reduced), std::move(robot->radii), std::move(robot->feasible)};
    return {map.world, vehicle, queries, std::move(graphs), options};
  } catch (const TableError& error) {
    throw FormatError(map.prepared->source.complaint(error));
  }
}

int run_plan(PlanArguments arguments, const Team& team, std::string& out) {
  const bool batch = !arguments.queries.empty();
  if (batch) {
    if (arguments.out.empty()) throw UsageError("--queries: needs --out R.csv for the results");
    if (!arguments.start.empty() || !arguments.goals.empty() || !arguments.via.empty() || arguments.alternatives > 1) {
      throw UsageError(
          "--queries: start and goal come from the file; leave out --start, --goal, --via, --alternatives");
    }
    if (!arguments.svg.empty() || !arguments.csv.empty() || !arguments.ros_path.empty()) {
      throw UsageError("--queries: --svg, --csv and --ros-path show one plan; leave them out");
    }
  } else if (!arguments.out.empty()) {
    throw UsageError("--out: only with --queries; see --json and --csv for one plan");
  }
  arguments.build.check();
  PlannerOptions options;
  options.heuristic = heuristic_of(arguments.heuristic);
  if (arguments.svg_view != "map" && arguments.svg_view != "path")
    throw UsageError("--svg-view: expected map or path, got \"" + arguments.svg_view + "\"");
  for (const std::string& layer : arguments.svg_layers)
    if (std::ranges::find(SvgPicture::layers(), layer) == SvgPicture::layers().end())
      throw UsageError("--svg-layers: expected bounds, obstacles, graph, swept, path, robot or markers, got \"" +
                       layer + "\"");
  options.graph_mode = graph_mode_of(arguments.graph, batch);
  options.reduced_graph = arguments.build.reduced_graph(team);
  options.refinement.max_trials = arguments.refine_trials;
  options.team = &team;
  const PlanLimits limits = limits_of(arguments);
  const double cusp_cost = cusp_cost_of(arguments);

  std::optional<Pose> start;
  TourRequest request{.start = {}, .goals = {}, .reverse = arguments.reverse, .cusp_cost = cusp_cost};
  if (!arguments.start.empty()) start = parse_pose(arguments.start, "--start");
  for (const std::string& via : arguments.via) request.via.push_back(parse_place(via, "--via"));
  for (const std::string& goal : arguments.goals) request.goals.push_back(parse_place(goal, "--goal"));
  std::vector<NumberedRequest> queries;
  if (batch) queries = read_queries(arguments.queries);
  for (NumberedRequest& query : queries) {
    query.request.reverse = arguments.reverse;
    query.request.cusp_cost = cusp_cost;
  }

  LoadedMap map = load_map(arguments.map, arguments.reading);
  arguments.build.prepared = map.prepared.has_value();
  const bool robot_of_map = arguments.robot.empty() && map.prepared && map.prepared->robot;
  const Vehicle vehicle = robot_of_map ? Vehicle(map.prepared->robot->parameters) : load_vehicle(arguments.robot);
  if (!batch) {
    if (!start) start = map.start;
    if (request.goals.empty() && map.goal) request.goals.push_back({map.goal->position(), map.goal->heading});
    if (!start) throw UsageError("--start X,Y,HEADING is missing, and " + arguments.map + " has no start");
    if (request.goals.empty()) throw UsageError("--goal X,Y,HEADING is missing, and " + arguments.map + " has no goal");
  }

  const auto executor = arguments.build.executor();
  const auto plan_on = [&](const World& world) {
    return Planner(world, vehicle, arguments.build.queries(world), options, *executor);
  };
  if (!batch) request.start = *start;
  // Tours and alternatives keep to the rings of the map.
  const bool plain = !batch && arguments.alternatives == 1 && request.via.empty() && request.goals.size() == 1 &&
                     request.goals[0].heading;
  if (plain && !map.curved.curves.empty()) return plan_curved(arguments, map, request, plan_on, limits, team, out);
  const Stopwatch watch;
  const Planner planner = make_planner(arguments, map, vehicle, options);
  const double build_seconds = watch.seconds();
  if (batch) return answer_queries(arguments, map, planner, build_seconds, queries, limits, team, out);
  return plan_one(arguments, map, planner, build_seconds, request, plans_of(arguments, planner, request, limits), team,
                  out);
}

}  // namespace

void add_plan_command(CLI::App& app, Action& action, const Team& team) {
  CLI::App& command = *app.add_subcommand("plan", "Plan the fastest path from start to goal, or many on one map");
  const auto arguments = std::make_shared<PlanArguments>();
  command.add_option("WORLD", arguments->map, kMapHelp)->required();
  arguments->reading.add_to(command);
  command.add_option("--robot", arguments->robot, "Robot (JSON); default: the paper's")->type_name("R.json");
  command.add_option("--start", arguments->start, "Start pose; default: the map's")->type_name("X,Y,HEADING");
  command
      .add_option("--goal", arguments->goals,
                  "Goal, without HEADING in any; repeated: the one that is reached first; default: the map's")
      ->type_name("X,Y[,HEADING]")
      ->allow_extra_args(false);
  command.add_option("--via", arguments->via, "Place to pass on the way; repeated: in this order")
      ->type_name("X,Y[,HEADING]")
      ->allow_extra_args(false);
  command
      .add_option("--alternatives", arguments->alternatives,
                  "So many ways, the fastest first, which pass some obstacle on different sides")
      ->type_name("K")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command.add_option("--queries", arguments->queries, "Many queries: q,sx,sy,stheta,gx,gy,gtheta")->type_name("Q.csv");
  command.add_option("--out", arguments->out, "Results of --queries, one line a query")->type_name("R.csv");
  command.add_option("--heuristic", arguments->heuristic, "travel_time (admissible), paper (distance) or dijkstra")
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option("--graph", arguments->graph,
                  "eager (check all bitangents first), the default of --queries, or lazy (as the search needs them), "
                  "that of one query")
      ->type_name("MODE");
  command.add_option("--time-limit", arguments->time_limit, "Of each search; then the best path found so far, if any")
      ->type_name("SECONDS");
  command.add_flag("--reverse", arguments->reverse,
                   "Drive backwards as well, where that is faster or nothing else leads there");
  command.add_option("--cusp-cost", arguments->cusp_cost, "Of a change of gear, beside the time to stop; default: 0")
      ->type_name("SECONDS");
  command.add_option("--refine-trials", arguments->refine_trials, "Paths that refinement may try; 0 leaves it out")
      ->type_name("N")
      ->capture_default_str();
  arguments->build.add_to(command);
  command.add_option("--svg", arguments->svg, "Write a picture")->type_name("F.svg");
  command
      .add_option("--svg-layers", arguments->svg_layers,
                  "What it shows: bounds,obstacles,graph,swept,path,robot,markers")
      ->type_name("LAYER,...")
      ->delimiter(',')
      ->default_str("all but graph");
  command
      .add_option("--svg-view", arguments->svg_view, "What part it shows: the whole map, or the path's surroundings")
      ->type_name("map|path")
      ->capture_default_str();
  command.add_option("--json", arguments->json, "Write the exact plan; with --queries one object a line")
      ->type_name("F.json");
  command.add_option("--csv", arguments->csv, "Write the path as samples")->type_name("F.csv");
  command.add_option("--ros-path", arguments->ros_path, "Write the path as a nav_msgs/Path in JSON")
      ->type_name("F.json");
  command.callback([arguments, &action, &team] {
    action = [arguments, &team](std::string& out) { return run_plan(*arguments, team, out); };
  });
}

}  // namespace arcway::cli
