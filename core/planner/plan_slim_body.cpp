// The step of PlanRun that plans for a slimmer body.

#include <memory>
#include <optional>
#include <utility>

#include "core/planner/plan_run.h"
#include "core/search/push_free.h"

namespace arcway::internal {

void PlanRun::take(const PlanSlimBody& step, double trials) {
  if (map_.world.vertices().size() > step.most_vertices || result_.statistics.tree_poses > step.most_tree_poses) return;
  keep_all();
  const PlannerMaps* maps = query_.maps.slim_plans(query_.clock);
  if (!maps) return;
  const QueryContext query{*maps, query_.options, query_.request, query_.limits, query_.clock};
  PlanResult planned;
  planned.lower_bound = result_.lower_bound;  // it holds for points
  if (!workspace_.part) workspace_.part = std::make_unique<PlanWorkspace>();
  PlanRun run(query, *workspace_.part, planned, Scope::kSlimBody);
  run.search_options_.faster_than = (1.0 + step.slower) * best_cost_;
  run.follow(rows_);
  result_.statistics += planned.statistics;
  result_.interrupted = result_.interrupted || planned.interrupted;
  if (!run.found() || run.best_cost_ >= best_cost_) return;
  const PushSpace space{map_.vehicle, map_.body, *map_.outlines, *map_.queries.sweep};
  std::optional<Path> free = push_free(run.best(), query_.request.goal, space, query_.clock);
  if (!free) return;
  if (is_driven_forwards(*free)) {
    keep_beside_roadmap(query_.maps.all, std::move(*free), trials);
  } else {
    keep(std::move(*free), {}, trials, RefineMode::kBothGears);
  }
}

}  // namespace arcway::internal
