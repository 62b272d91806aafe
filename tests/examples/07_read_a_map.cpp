// example
#include <arcway/datasets/plan_io.h>
#include <arcway/datasets/read_map.h>
#include <arcway/planner.h>
#include <arcway/validation.h>

#include <iostream>

// Reads a map of any format, plans from its start to its goal, checks the path and writes it as CSV.
int main(int argc, char** argv) {
  const arcway::MapFile map = arcway::read_map(argc > 1 ? argv[1] : "yard.geojson");
  for (const std::string& warning : map.warnings) std::cerr << warning << '\n';
  const arcway::World world = arcway::to_world(map, "yard");
  const arcway::Vehicle vehicle;
  const arcway::PlanResult plan =
      arcway::Planner(world, vehicle).plan({.start = map.start.value(), .goal = map.goal.value()});
  if (!plan.solved()) {
    std::cerr << plan.reason << " (" << arcway::name_of(plan.certainty) << ")\n";
    return 1;
  }
  const arcway::ValidationReport report = arcway::validate(world, vehicle, plan.start, plan.goal, plan.timed_path());
  std::cout << arcway::path_to_csv(plan.trajectory(), {.max_length = 1.0});
  return report.valid() ? 0 : 1;
}
// end
