#include "arcway/plan_batch.h"

#include <optional>
#include <stdexcept>
#include <string>

namespace arcway {

using namespace internal;

std::vector<PlanResult> plan_batch(const Planner& planner, std::span<const PlanRequest> requests,
                                   const Executor& executor, const BatchOptions& options) {
  std::vector<PlanResult> results(requests.size());
  std::vector<std::optional<std::string>> complaints(requests.size());
  const ReportingExecutor watched(executor, [&](const Progress& progress) {
    if (options.progress) options.progress(progress);
  });
  watched.begin_stage("queries");
  watched.for_ranges(requests.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (options.stop.stop_requested()) {
        results[i].status = PlanStatus::kCanceled;
        results[i].reason = "the batch was canceled before this query began";
        results[i].start = requests[i].start;
        results[i].goal = requests[i].goal;
        continue;
      }
      try {
        results[i] = planner.plan(requests[i], {.time = options.time_limit, .stop = options.stop});
      } catch (const std::invalid_argument& error) {
        complaints[i] = error.what();
      }
    }
  });
  for (std::size_t i = 0; i < complaints.size(); ++i)
    if (complaints[i]) throw std::invalid_argument("request " + std::to_string(i) + ": " + *complaints[i]);
  return results;
}

}  // namespace arcway
