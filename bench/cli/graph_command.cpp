#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/svg.h"
#include "arcway/planner.h"
#include "arcway/process_group.h"
#include "arcway/visibility_graph.h"
#include "bench/cli/arguments.h"
#include "bench/cli/counts_json.h"
#include "bench/cli/output_files.h"
#include "core/roadmap/finished_feasible_graph.h"

namespace arcway::internal::cli {
namespace {

struct GraphArguments {
  std::string map;
  MapOptions reading;
  std::string kind = "reduced";
  std::string robot;
  std::string edges, svg, json;
  BuildOptions build;
};

struct BuiltGraph {
  std::string edges_csv;           ///< if a file of them is wanted
  std::vector<LineSegment> lines;  ///< if a picture is wanted
  std::size_t edge_count = 0;
  double visibility_seconds = 0.0;
  double feasible_seconds = 0.0;
  FeasibleGraphCounts counts;  ///< counts of the feasible graph; empty for other graphs
};

void append_edge(std::string& csv, VertexId u, VertexId v) {
  csv += std::to_string(u);
  csv += ',';
  csv += std::to_string(v);
  csv += '\n';
}

BuiltGraph build_visibility_graph(const GraphArguments& arguments, const World& world) {
  const std::unique_ptr<const Executor> executor = arguments.build.executor();
  const bool with_csv = !arguments.edges.empty(), with_lines = !arguments.svg.empty();
  BuiltGraph built;
  if (with_csv) built.edges_csv = "u,v\n";

  const Stopwatch visibility_watch;
  const VisibilityGraph graph = arguments.kind == "visibility" ? arguments.build.full_graph_of(world, *executor)
                                                               : arguments.build.reduced_graph_of(world, *executor);
  built.visibility_seconds = visibility_watch.seconds();
  built.edge_count = graph.edge_count();
  for (VertexId u = 0; u < graph.vertex_count(); ++u) {
    for (const VertexId v : graph.row(u)) {
      if (with_csv) append_edge(built.edges_csv, u, v);
      if (with_lines) built.lines.push_back({world.vertex(u), world.vertex(v)});
    }
  }
  return built;
}

/// That of the tightest turn, by a planner, which refuses what plans would be refused for.
BuiltGraph build_feasible_graph(const GraphArguments& arguments, LoadedMap& map) {
  const Vehicle vehicle = load_vehicle(arguments.robot, map);
  close_for(vehicle, map);
  const std::unique_ptr<const Executor> executor = arguments.build.executor();
  const bool with_csv = !arguments.edges.empty(), with_lines = !arguments.svg.empty();
  const Planner planner(map.world, vehicle, arguments.build.backend_for(map.world, *executor, kSingleProcess),
                        {.graph_mode = GraphMode::kEager, .radii = {vehicle.min_turning_radius()}});
  const FinishedFeasibleGraph& feasible = *planner.feasible_graph().finished();

  BuiltGraph built;
  if (with_csv) built.edges_csv = "u,v\n";
  built.visibility_seconds = planner.prepare_statistics().visibility_seconds;
  built.feasible_seconds = planner.prepare_statistics().feasible_seconds;
  built.counts = feasible.counts();
  built.edge_count = feasible.links().size();
  for (const FeasibleGraph::Link& link : feasible.links()) {
    const TurnCircle& from = feasible.circles()[link.from];
    if (with_csv) append_edge(built.edges_csv, from.vertex, feasible.circles()[link.to].vertex);
    if (!with_lines) continue;
    const Vec2 begin = pose_on(from, link.heading).position();
    built.lines.push_back({begin, begin + link.length * direction_of(link.heading)});
  }
  return built;
}

std::string counts_json(const GraphArguments& arguments, const World& world, const BuiltGraph& built) {
  nlohmann::ordered_json json = {{"format", "arcway-graph"},
                                 {"version", 1},
                                 {"kind", arguments.kind},
                                 {"obstacles", world.obstacle_count()},
                                 {"vertices", world.vertices().size()},
                                 {"convex_vertices", world.graph_vertex_count()},
                                 {"edges", built.edge_count},
                                 {"backend", arguments.build.backend},
                                 {"builder", arguments.build.builder_name(world)},
                                 {"threads", arguments.build.thread_count()},
                                 {"visibility_seconds", built.visibility_seconds}};
  if (arguments.kind == "feasible") {
    json["feasible_seconds"] = built.feasible_seconds;
    json.update(json_of(built.counts));
  }
  return json.dump() + "\n";
}

std::string picture(const World& world, const BuiltGraph& built, const std::string& title) {
  SvgPicture svg(world);
  // Stronger than below a path: here nothing else is to be seen.
  const std::size_t stride = svg.add_edges(built.lines, {.color = "#0072b2", .width = 1.0, .opacity = 0.6});
  std::string caption = title + ": " + count_text(built.edge_count) + " edges";
  if (stride > 1) caption += ", one in " + std::to_string(stride) + " drawn";
  svg.add_caption(caption);
  svg.set_title(title);
  return svg.str();
}

int run_graph(const GraphArguments& arguments, std::string& out) {
  std::string title;
  if (arguments.kind == "visibility") {
    title = "Visibility graph";
  } else if (arguments.kind == "reduced") {
    title = "Reduced visibility graph";
  } else if (arguments.kind == "feasible") {
    title = "Feasible visibility graph";
  } else {
    throw UsageError("--kind: expected visibility, reduced or feasible, got " + in_quotes(arguments.kind));
  }
  if (arguments.kind != "feasible" && !arguments.robot.empty())
    throw UsageError("--robot: only with --kind feasible; the other graphs are those of any robot");
  arguments.build.check();
  OutputFiles files({arguments.edges, arguments.svg, arguments.json}, {arguments.map, arguments.robot});
  LoadedMap map = load_map(arguments.map, arguments.reading);
  files.protect(map.files);
  const bool feasible = arguments.kind == "feasible";
  BuiltGraph built = feasible ? build_feasible_graph(arguments, map) : build_visibility_graph(arguments, map.world);

  if (!arguments.svg.empty()) files.add(arguments.svg, picture(map.world, built, title));
  if (!arguments.json.empty()) files.add(arguments.json, counts_json(arguments, map.world, built));
  if (!arguments.edges.empty()) files.add(arguments.edges, std::move(built.edges_csv));

  out += arguments.map + ": " + title + "\n";
  out += row(feasible ? "bitangents" : "edges", count_text(built.edge_count) + (feasible ? " directed" : ""));
  if (feasible) {
    const FeasibleGraphCounts& counts = built.counts;
    out += row("candidates", count_text(counts.candidates));
    out += row("rejected", count_text(counts.rejected_overlap) + " circles overlap, " +
                               count_text(counts.rejected_departure) + " no room to turn at the departure (7),");
    out += row("", count_text(counts.rejected_arrival) + " none at the arrival (7), " +
                       count_text(counts.rejected_straight) + " no room to go straight (6)");
    out += row("turn circles",
               count_text(counts.circles) + ", " + count_text(counts.circles_blocked) + " without free heading");
  }
  out += row("build", duration_text(built.visibility_seconds + built.feasible_seconds) +
                          (feasible ? " (reduced graph " + duration_text(built.visibility_seconds) +
                                          ", feasible graph " + duration_text(built.feasible_seconds) + ")"
                                    : ""));
  out += "\n" + world_rows(map.world) + warning_rows(map);
  files.write();
  out += files.summary();
  return kExitSolved;
}

}  // namespace

void add_graph_command(CLI::App& app, Action& action) {
  CLI::App& command = *app.add_subcommand("graph", "Build one of the graphs of a map");
  const auto arguments = std::make_shared<GraphArguments>();
  command.add_option("WORLD", arguments->map, kMapHelp)->required();
  arguments->reading.add_to(command);
  command.add_option("--kind", arguments->kind, "visibility, reduced or feasible")
      ->type_name("KIND")
      ->capture_default_str();
  command.add_option("--robot", arguments->robot, std::string(kRobotHelp) + "; only the feasible graph depends on it")
      ->type_name("R.json");
  arguments->build.add_to(command);
  command.add_option("--edges", arguments->edges, "Write the edges: u,v by vertices in file order")->type_name("F.csv");
  command.add_option("--svg", arguments->svg, "Write a picture")->type_name("F.svg");
  command.add_option("--json", arguments->json, "Write counts and stage times")->type_name("F.json");
  command.callback(
      [arguments, &action] { action = [arguments](std::string& out) { return run_graph(*arguments, out); }; });
}

}  // namespace arcway::internal::cli
