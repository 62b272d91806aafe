#include <vector>

#include "arcway/datasets/svg.h"
#include "arcway/query_set.h"
#include "arcway/visibility_graph.h"
#include "bench/figures/figures.h"
#include "core/roadmap/finished_feasible_graph.h"

namespace arcway::internal::figures {
namespace {

std::vector<LineSegment> lines_of(const World& world, const VisibilityGraph& graph) {
  std::vector<LineSegment> lines;
  for (VertexId u = 0; u < graph.vertex_count(); ++u)
    for (const VertexId v : graph.row(u)) lines.push_back({world.vertex(u), world.vertex(v)});
  return lines;
}

}  // namespace

Figure visibility_graphs(const Planner& planner) {
  const World& world = planner.world();
  const VisibilityGraph full = build_full_visibility_graph(world, *make_reference_queries(world).visibility);
  const VisibilityGraph& reduced = planner.visibility_graph();
  SvgPicture picture(world);
  picture.add_edges(lines_of(world, full), {.color = "#8a929c", .width = 0.7, .opacity = 0.5}, "full");
  picture.add_edges(lines_of(world, reduced), {.color = "#0072b2", .width = 1.6, .opacity = 0.95}, "reduced");
  const std::string caption =
      "Full visibility graph, " + std::to_string(full.edge_count()) + " edges (gray), and reduced one, " +
      std::to_string(reduced.edge_count()) + " (blue, tangent at both ends): " +
      digits(100.0 * static_cast<double>(reduced.edge_count()) / static_cast<double>(full.edge_count()), 0) + " %.";
  picture.set_title("Full and reduced visibility graph", caption);
  picture.add_caption(caption);
  return {"figure1", picture.str(), caption};
}

Figure feasible_graph_and_motion(const Planner& planner, const PlanResult& plan) {
  const FinishedFeasibleGraph& graph = *planner.feasible_graph().finished();
  std::vector<LineSegment> lines;
  for (const FeasibleGraph::Link& link : graph.links()) {
    const Pose from = pose_on(graph.circles()[link.from], link.heading);
    lines.push_back({from.position(), from.position() + link.length * direction_of(link.heading)});
  }
  SvgPicture picture(planner.world());
  picture.add_edges(lines, {.color = "#0072b2", .width = 0.8, .opacity = 0.45}, "feasible");
  picture.add_path(plan.path(), planner.vehicle().body());
  const std::string caption = "Feasible visibility graph, " + std::to_string(graph.links().size()) +
                              " directed bitangents, and the fastest motion: " + digits(plan.travel_time, 2) +
                              " s over " + digits(plan.length, 1) + " m, no path takes less than " +
                              digits(plan.lower_bound, 2) + " s, smallest clearance " +
                              digits(1e3 * plan.min_clearance, 1) + " mm.";
  picture.set_title("Feasible visibility graph and final motion", caption);
  picture.add_caption(caption);
  return {"figure7", picture.str(), caption};
}

}  // namespace arcway::internal::figures
