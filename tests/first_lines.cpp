// What new users type first, each as one would type it: all of it compiles and does what it says. Public headers alone.
#include <arcway/arcway.h>
#include <arcway/datasets/plan_io.h>
#include <arcway/datasets/read_map.h>
#include <arcway/datasets/svg.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace {

int failures = 0;

void expect(bool right, int line) {
  if (right) return;
  std::cerr << "first_lines.cpp:" << line << ": wrong\n";
  ++failures;
}
#define EXPECT(condition) expect(condition, __LINE__)

template <class T>
std::string text(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

}  // namespace

int main() {
  using namespace arcway;

  // 1. A world from a rectangle.
  const World world({Polygon::rectangle({8, -4}, {12, 4})});
  EXPECT(world.obstacle_count() == 1);
  // 2. A world from a list of polygons within bounds.
  const World yard = World::from_polygons({Polygon::rectangle(8, -4, 12, 4), Polygon::regular({20, 5}, 2.0, 8)},
                                          Polygon::rectangle({-10, -20}, {40, 20}));
  EXPECT(yard.has_bounds());
  // 3. A world from corners.
  const World corners = World::from_polygons({{{8, -4}, {12, -4}, {12, 4}, {8, 4}}});
  EXPECT(corners.vertices().size() == 4);
  // 4. A plan in one call.
  const PlanResult result = plan(world, Vehicle{}, {0, 0, 0}, {20, 0, 0});
  EXPECT(result.solved());
  // 5. Printing it.
  std::cout << result << '\n';
  EXPECT(text(result).rfind("solved: ", 0) == 0);
  // 6. Its status.
  EXPECT(text(result.status) == "solved" && to_string(result.status) == "solved");
  // 7. The pose after a second.
  const Trajectory trajectory(result);
  const Pose pose = trajectory.at(1.0).pose;
  EXPECT(pose.x > 0.0);
  // 8. Printing a pose.
  std::cout << pose << ' ' << trajectory.at(1.0) << '\n';
  // 9. The whole state.
  const auto state = trajectory.at(0.5);
  EXPECT(state.speed > 0.0 && std::abs(state.steering_angle) < 1.0 && state.gear == Gear::kForward);
  // 10. The state in the middle of the path.
  EXPECT(trajectory.at_distance(trajectory.length() / 2).time < trajectory.duration());
  // 11. A loop of a controller.
  double driven = 0.0;
  for (const auto& s : trajectory.sample(0.1)) driven = s.distance;
  EXPECT(driven == trajectory.length());
  // 12. Points to draw.
  const std::vector<Vec2> points = trajectory.polyline(0.25);
  EXPECT(points.size() > 80);
  // 13. How near it comes to obstacles then.
  EXPECT(trajectory.clearance_at(1.0) >= result.min_clearance);
  // 14. Whether the robot fits at a place.
  const Planner planner(yard, Vehicle{});
  EXPECT(planner.is_free({0, 0, 0}) && !planner.is_free({10, 0, 0}));
  // 15. Whether a path of one's own is free.
  const Path straight{{{0, 0, 0}, 20.0, 0.0}};
  EXPECT(!planner.is_free(straight));
  // 16. The nearest place where it fits.
  EXPECT(planner.nearest_free({7, 0, 0}).has_value());
  // 17. The pose along a path.
  EXPECT(straight.at(2.5).x == 2.5);
  // 18. Timing a path of one's own.
  EXPECT(Trajectory(straight, Vehicle{}).duration() > 1.0);
  // 19. The edges of the graph.
  std::size_t edges = 0;
  for (const auto [a, b] : planner.visibility_graph().edges()) edges += a < b;
  EXPECT(edges == planner.visibility_graph().edge_count());
  // 20. Saving a plan and loading it.
  const std::string path = "first_lines_plan.json";
  write_plan(path, result);
  EXPECT(read_plan(path).trajectory().duration() == trajectory.duration());
  // 21. Why there is no plan.
  const PlanResult none = planner.plan({.start = {0, 0, 0}, .goal = {10, 0, 0}});
  std::cout << none << '\n';
  EXPECT(!none.solved() && none.certainty == Certainty::kProved);
  // 22. Checking a plan.
  const ValidationReport report = validate(world, Vehicle{}, result.start, result.goal, result.timed_path());
  std::cout << report << '\n';
  EXPECT(report.valid());
  // 23. Many plans.
  const std::vector<PlanRequest> requests{{.start = {0, 0, 0}, .goal = {30, 0, 0}}, {{0, 5, 0}, {30, 5, 0}}};
  for (const PlanResult& one : plan_batch(planner, requests, ThreadExecutor())) EXPECT(one.solved());
  // 24. A picture.
  write_svg("first_lines.svg", result);
  // 25. Two poses for a planner.
  EXPECT(planner.plan({0, 0, 0}, {30, 0, 0}).solved());
  // 26. Bounds as a rectangle.
  EXPECT(World({}, Polygon::rectangle({0, 0}, {9, 9})).has_bounds());
  // 27. Whether it arrives at the goal.
  const Pose goal{20, 0, 0};
  EXPECT(result.goal == goal);
  std::remove("first_lines.svg");
  std::remove(path.c_str());
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
