#include "core/roadmap/build_feasible_graph.h"

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "core/roadmap/exchange_circle_rows.h"
#include "core/roadmap/find_circle_rows.h"

namespace arcway::internal {

std::shared_ptr<const FinishedFeasibleGraph> build_feasible_graph(const FeasibleGraphInputs& inputs,
                                                                  const Executor& executor) {
  return build_feasible_graph(inputs, executor, kSingleProcess);
}

std::shared_ptr<const FinishedFeasibleGraph> build_feasible_graph(const FeasibleGraphInputs& inputs,
                                                                  const Executor& executor,
                                                                  const ProcessGroup& process_group) {
  auto checks = std::make_shared<const CircleChecks>(inputs, executor);
  std::vector<HeadingSet> headings(checks->circles().all().size());
  const auto [begin, end] = process_group.share_of(headings.size());
  std::vector<std::uint32_t> share(end - begin);
  std::iota(share.begin(), share.end(), static_cast<std::uint32_t>(begin));

  const bool is_alone = process_group.size() == 1;
  find_headings(*checks, share, executor, headings);
  if (!is_alone) exchange_headings(headings, process_group);
  const std::vector<LinkRow> found = find_kept_links(*checks, headings, share, executor);
  LinkRows rows = is_alone ? compressed(found) : exchange_links(found, process_group);
  return std::make_shared<const FinishedFeasibleGraph>(std::move(checks), std::move(headings), std::move(rows));
}

}  // namespace arcway::internal
