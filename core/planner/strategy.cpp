#include "core/planner/strategy.h"

#include <algorithm>

namespace arcway::internal {

std::vector<StrategyRow> strategy_without(std::span<const std::string> names) {
  std::vector<StrategyRow> rows;
  for (const StrategyRow& row : kStrategy)
    if (std::ranges::find(names, row.name) == names.end()) rows.push_back(row);
  return rows;
}

}  // namespace arcway::internal
