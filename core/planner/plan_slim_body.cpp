// The step of PlanRun that plans for a slimmer body.

#include <cstddef>
#include <optional>
#include <utility>

#include "core/planner/plan_run.h"

namespace arcway::internal {

void PlanRun::take(const PlanSlimBody& step, double trials) {
  keep_all();
  const PlannerMaps* maps = query_.maps.slim_plans(query_.clock);
  if (!maps) return;
  const QueryContext query{*maps, query_.options, query_.request, query_.limits, query_.clock};
  PlanResult planned;
  planned.lower_bound = result_.lower_bound;  // for the gaps that rows ask for
  PlanRun run(query, workspace_within(), planned, Scope::kSlimBody);
  if (query_.maps.tightest && result_.statistics.tree_poses == 0) {
    run.tree_poses_ = static_cast<std::size_t>(step.first_tree_share * static_cast<double>(run.tree_poses_));
    run.tree_effort_.attachments = 0;  // the rows before have searched the roadmap, up to the same cost
  }
  run.search_options_.faster_than = (1.0 + step.slower) * best_cost_;
  follow_within(run);
  if (!run.found() || run.best_cost_ >= best_cost_) return;
  std::optional<Path> free = push_free(run.best(), query_.request.goal, push_space(), query_.clock);
  if (!free) return;
  if (is_driven_forwards(*free)) {
    keep_beside_roadmap(std::move(*free), trials);
  } else {
    keep(std::move(*free), {}, trials, RefineMode::kBothGears);
  }
}

}  // namespace arcway::internal
