// example
#include <arcway/datasets/catalog.h>
#include <arcway/plan_batch.h>
#include <arcway/planner.h>

#include <iostream>

// Many queries on one map, on all threads of the machine: the graphs are built once, and each query has a time limit.
int main() {
  const std::string name = "clutter/convex/n40/m8/f20/s3";
  const arcway::World world = arcway::catalog_world(name);
  const arcway::ThreadExecutor threads;
  const arcway::Planner planner(world, arcway::Vehicle{}, arcway::reference_backend(world),
                                {.graph_mode = arcway::GraphMode::kEager});
  planner.warm_up(threads.threads());
  const std::vector<arcway::PlanRequest> requests = arcway::catalog_queries(name, 10, 1);
  std::size_t solved = 0;
  for (const arcway::PlanResult& plan : arcway::plan_batch(planner, requests, threads, {.time_limit = 10.0})) {
    solved += plan.solved();
    std::cout << plan << '\n';
  }
  return solved > 0 ? 0 : 1;
}
// end
