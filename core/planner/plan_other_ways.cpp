// The steps of PlanRun that look for other ways by trees that keep off the paths so far.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/infinity.h"
#include "core/planner/plan_run.h"
#include "core/planner/strategy.h"

namespace arcway::internal {

void PlanRun::take(const TryOtherWays& step, double trials) {
  struct Kind {
    std::variant<GrowSlimTrees, GrowTrees> trees;
    bool finds_new = true;
  };
  const GrowSlimTrees slim{.passes = step.passes, .shortenings = step.shortenings, .slower = step.slower};
  const GrowTrees body{.share = 1.0, .passes = step.passes, .shortenings = step.shortenings};
  std::array kinds{Kind{slim}, Kind{body}};
  std::vector<double> known{best_cost_};  // costs
  // Whether trees find a path whose cost is new. Where they do not, they would find the same paths again.
  const auto find_new = [&](const auto& trees) {
    const std::optional<double> cost = grow(trees, trials);
    if (!cost || *cost == kInfinity) return cost.has_value();
    const bool is_new =
        std::ranges::none_of(known, [&](double other) { return std::abs(*cost - other) <= kSameWay * *cost; });
    known.push_back(*cost);
    return is_new;
  };
  for (std::size_t i = 0; i < step.rounds && !result_.interrupted; ++i) {
    avoided_.push_back(best());
    for (Kind& kind : kinds) kind.finds_new = kind.finds_new && std::visit(find_new, kind.trees);
  }
  avoided_.clear();
}

void PlanRun::take(const TryOtherWaysInBothGears& step, double trials) {
  keep_all();
  const Roadmap* slim = slim_map(0);
  if (!slim) return;
  const auto keep_widened = [&](const Path& path, const Pose& goal) -> std::optional<Path> {
    const std::optional<Path> free = pushed_free(path, goal, slim->vehicle, trials);
    if (!free) return std::nullopt;
    Path whole = reversing_->between_stops(*free);
    if (cost_of(whole) <= (1.0 + step.slower) * best_cost_)
      keep(std::move(whole), {}, trials, RefineMode::kBothGears);
    else
      avoided_.push_back(std::move(whole));
    return std::nullopt;  // kept, though the first path may cost less before refinement
  };
  for (std::size_t i = 0; i < step.rounds && !result_.interrupted; ++i) {
    avoided_.push_back(best());
    const double most = (1.0 + step.slower) * best_cost_;
    search([&] {
      return reversing_search().grow_slim_gear_trees({*slim, step.poses, kRestWeight, most, avoided_}, keep_widened);
    });
  }
  avoided_.clear();
}

}  // namespace arcway::internal
