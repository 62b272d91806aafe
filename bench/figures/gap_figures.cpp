#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "arcway/datasets/svg.h"
#include "bench/figures/figures.h"
#include "core/gaps/minimum_distances.h"
#include "core/model/body_size.h"
#include "core/roadmap/feasible_graph.h"

namespace arcway::internal::figures {
namespace {

/// Start, the vertices that the graph's best path goes round, goal: before refinement, which moves turns away from the
/// vertices.
std::vector<Vec2> point_path(const Planner& refining, const PlanResult& plan) {
  PlannerOptions options;
  options.refinement.max_trials = 0;
  const Planner planner(refining.world(), refining.vehicle(), options);
  std::vector<Vec2> points{plan.start.position()};
  for (const PathSegment& s : planner.plan({.start = plan.start, .goal = plan.goal}).path()) {
    if (s.is_line()) continue;
    const double radius = 1.0 / std::abs(s.curvature);
    const Side side = s.curvature > 0.0 ? Side::kLeft : Side::kRight;
    const Vec2 center = turn_circle(s.start, radius, side).center;
    for (const TurnCircle& circle : planner.feasible_graph().circles())
      if ((circle.center - center).norm() < 1e-6 && circle.side == side &&
          points.back() != planner.world().vertex(circle.vertex))
        points.push_back(planner.world().vertex(circle.vertex));
  }
  points.push_back(plan.goal.position());
  return points;
}

std::vector<LineSegment> legs_of(const std::vector<Vec2>& points) {
  std::vector<LineSegment> legs;
  for (std::size_t i = 1; i < points.size(); ++i) legs.push_back({points[i - 1], points[i]});
  return legs;
}

std::vector<LineSegment> outlines(const World& world, const std::vector<ObstacleId>& obstacles) {
  std::vector<LineSegment> edges;
  for (const ObstacleId o : obstacles)
    for (VertexId v = world.vertices_of(o).first; v < world.vertices_of(o).last; ++v) edges.push_back(world.edges()[v]);
  return edges;
}

std::string counts_of(const MinimumDistances& distances) {
  std::string text;
  for (const RadialSet& set : distances.by_segment)
    text += (text.empty() ? "" : ", ") + std::to_string(set.left.size()) + " + " + std::to_string(set.right.size());
  return text;
}

void add_caption(SvgPicture& picture, const std::string& caption) {
  const std::size_t end = caption.find('\n');
  picture.add_caption(caption.substr(0, end));
  picture.add_caption(caption.substr(end + 1));
}

}  // namespace

Figure radial_sets(const Planner& planner, const PlanResult& plan) {
  const World& world = planner.world();
  const std::vector<Vec2> points = point_path(planner, plan);
  const MinimumDistances distances = minimum_distances(world, points);
  const double reach = (world.box().max - world.box().min).maxCoeff();
  std::vector<LineSegment> bisectors;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec2 in = (points[i] - points[i - 1]).normalized(), out = (points[i + 1] - points[i]).normalized();
    const Vec2 along = (in - out).norm() > 1e-12 ? Vec2((in - out).normalized()) : perpendicular(in);
    bisectors.push_back({points[i] - 0.12 * reach * along, points[i] + 0.12 * reach * along});
  }
  SvgPicture picture(world);
  picture.add_edges(bisectors, {.color = "#7a828c", .width = 1.2, .opacity = 0.8}, "bisectors");
  picture.add_edges(outlines(world, distances.obstacles.left), {.color = "#0072b2", .width = 4.0, .opacity = 1.0},
                    "left");
  picture.add_edges(outlines(world, distances.obstacles.right), {.color = "#d55e00", .width = 4.0, .opacity = 1.0},
                    "right");
  picture.add_edges(legs_of(points), {.color = "#1d2126", .width = 2.0, .opacity = 1.0}, "path");
  const std::string caption =
      "Obstacles left (blue, " + std::to_string(distances.obstacles.left.size()) + ") and right (orange, " +
      std::to_string(distances.obstacles.right.size()) +
      ") of the point path.\nThe bisectors of its turns (gray) part the radial sets of its segments, left + "
      "right: " +
      counts_of(distances) + ".";
  picture.set_title("Left, right and radial sets");
  add_caption(picture, caption);
  return {"figure3", picture.str(), caption};
}

Figure minimum_distance_pairs(const Planner& planner, const PlanResult& plan) {
  const World& world = planner.world();
  const std::vector<Vec2> points = point_path(planner, plan);
  const MinimumDistances distances = minimum_distances(world, points);
  std::vector<LineSegment> across, to_path;
  double narrowest = INFINITY;
  for (const ObstaclePairDistance& pair : distances.pairs) {
    across.push_back({pair.on_left, pair.on_right});
    narrowest = std::min(narrowest, pair.distance);
  }
  for (const SegmentObstacleDistance& d : distances.to_segments) to_path.push_back({d.on_segment, d.on_obstacle});
  SvgPicture picture(world);
  picture.add_edges(legs_of(points), {.color = "#1d2126", .width = 2.0, .opacity = 1.0}, "path");
  picture.add_edges(to_path, {.color = "#009e73", .width = 1.6, .opacity = 0.9}, "to_path");
  picture.add_edges(across, {.color = "#d55e00", .width = 2.2, .opacity = 0.9}, "across");
  const std::string caption =
      "Minimum distances: " + std::to_string(across.size()) + " between obstacles across the path (orange), " +
      std::to_string(to_path.size()) + " from its segments to obstacles (green).\nThe narrowest gap is " +
      digits(narrowest, 1) + " m wide; driving straight needs " + digits(body_width(planner.vehicle()), 1) +
      " m, (6), turning at the smallest radius " +
      digits(swept_annulus(planner.vehicle().footprint(), Side::kLeft, planner.vehicle().min_turning_radius()).width(),
             2) +
      " m, (7).";
  picture.set_title("Minimum distances along the path");
  add_caption(picture, caption);
  return {"figure4", picture.str(), caption};
}

std::string digits(double value, int count) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", count, value);
  return text;
}

}  // namespace arcway::internal::figures
