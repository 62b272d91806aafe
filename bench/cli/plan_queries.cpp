#include "bench/cli/plan_queries.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>

#include "arcway/datasets/plan_io.h"
#include "arcway/plan_batch.h"
#include "bench/cli/plan_rows.h"
#include "bench/cli/progress_bar.h"
#include "bench/cli/signal_stop.h"
#include "bench/quantiles.h"
#include "core/base/bytes.h"
#include "core/base/shortest_text.h"

namespace arcway::internal::cli {
namespace {

std::string batch_line(std::uint64_t q, const CheckedPlan& plan) {
  const PlanResult& result = plan.result;
  std::string line = std::to_string(q) + "," + name_of(result.status) + ",";
  if (result.solved()) {
    line += shortest_text(result.travel_time) + "," + shortest_text(result.length) + "," +
            shortest_text(result.lower_bound) + "," + shortest_text(result.min_clearance) + "," +
            (plan.good() ? "1" : "0");
  } else {
    line += ",,,,";
  }
  return line + "," + fixed(1e3 * result.statistics.total_seconds, 3) + "\n";
}

/// Output of a batch for one query.
struct Answer {
  std::string line, json, refusal;  ///< `refusal`: the validator's first complaint, if it refuses the plan; `line` is
                                    ///< empty for a query that a signal ended
  double seconds = 0.0;
  bool solved = false;
};

std::string to_bytes(const std::vector<Answer>& answers) {
  std::string bytes;
  for (const Answer& answer : answers) {
    for (const std::string& text : {answer.line, answer.json, answer.refusal}) {
      append_bytes(bytes, text.size());
      bytes += text;
    }
    append_bytes(bytes, answer.seconds);
    append_bytes(bytes, answer.solved);
  }
  return bytes;
}

void append_answers(std::string_view bytes, std::vector<Answer>& answers) {
  while (!bytes.empty()) {
    Answer answer;
    for (std::string* text : {&answer.line, &answer.json, &answer.refusal}) {
      const std::vector<char> found = take_bytes<char>(bytes, take_bytes<std::size_t>(bytes));
      text->assign(found.begin(), found.end());
    }
    answer.seconds = take_bytes<double>(bytes);
    answer.solved = take_bytes<char>(bytes) != 0;
    answers.push_back(std::move(answer));
  }
}

/// Answers to this process's share of the queries.
std::vector<Answer> answer_share(const Planner& planner, std::span<const NumberedRequest> queries,
                                 const PlanLimits& limits, bool with_json, const Executor& threads) {
  std::vector<PlanRequest> requests;
  for (const NumberedRequest& query : queries) requests.push_back(query.request);
  ProgressBar bar;
  std::vector<PlanResult> results = plan_batch(
      planner, requests, threads, {.time_limit = limits.time, .stop = limits.stop, .progress = bar.callback()});
  std::vector<Answer> answers(results.size());
  const ReportingExecutor watched(threads, bar.callback());
  watched.begin_stage("validations");
  const Validator validator(planner.world());
  watched.for_ranges(results.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (limits.stop.stop_requested() && (results[i].interrupted || results[i].status == PlanStatus::kCanceled))
        continue;
      const CheckedPlan plan = checked(validator, planner.vehicle(), std::move(results[i]), requests[i].reverse);
      Answer& answer = answers[i];
      answer.line = batch_line(queries[i].q, plan);
      if (with_json) answer.json = plan_to_json(plan.result, queries[i].q, planner.vehicle().parameters()) + "\n";
      answer.seconds = plan.result.statistics.total_seconds;
      answer.solved = plan.result.solved();
      if (answer.solved && !plan.good())
        answer.refusal = "query " + std::to_string(queries[i].q) + ": " +
                         (plan.report->valid() ? plan.defect : plan.report->issues.front().message);
    }
  });
  return answers;
}

// Lines before those of the queries: how the graphs were built, and the header.
std::string batch_header(const PreparedPlanner& prepared) {
  const PrepareStatistics& prepare = prepared.planner.prepare_statistics();
  std::string csv = "# build " + fixed(prepared.build_seconds, 6) + " s: reduced graph " +
                    fixed(prepare.visibility_seconds, 6) + " s, feasible graph " + fixed(prepare.feasible_seconds, 6) +
                    " s; " + prepared.arguments.build.summary(prepared.planner.world());
  const double suboptimality = prepared.planner.options().suboptimality.value_or(0.0);
  if (suboptimality > 0.0) csv += "; suboptimality " + shortest_text(suboptimality);
  return csv + "\nq,status,travel_time_s,length_m,lower_bound_s,min_clearance_m,valid,plan_ms\n";
}

}  // namespace

int answer_queries(const PreparedPlanner& prepared, const std::vector<NumberedRequest>& queries,
                   const ProcessGroup& process_group, const PlanOutput& output) {
  const auto& [arguments, map, planner, build_seconds] = prepared;
  auto& [files, out] = output;
  std::string csv = batch_header(prepared);
  std::string json;
  std::size_t solved = 0;
  std::size_t refused = 0;
  std::string first_refusal;
  std::vector<double> seconds;
  const Stopwatch watch;
  const auto threads = arguments.build.executor();
  const auto [first, last] = process_group.share_of(queries.size());
  std::vector<Answer> answers;
  const SignalStop signals;
  PlanLimits limits = arguments.limits();
  limits.stop = signals.token();
  for (const std::string& share : process_group.gather(to_bytes(answer_share(
           planner, std::span(queries).subspan(first, last - first), limits, !arguments.json.empty(), *threads))))
    append_answers(share, answers);
  const std::size_t canceled = std::erase_if(answers, [](const Answer& answer) { return answer.line.empty(); });
  if (canceled > 0) csv += "# interrupted: " + std::to_string(canceled) + " queries have no line\n";
  for (const Answer& answer : answers) {
    csv += answer.line;
    json += answer.json;
    seconds.push_back(answer.seconds);
    solved += answer.solved ? 1 : 0;
    if (!answer.refusal.empty() && refused++ == 0) first_refusal = answer.refusal;
  }
  const double total = watch.seconds();

  files.add(arguments.out, std::move(csv));
  if (!arguments.json.empty()) files.add(arguments.json, std::move(json));

  out += arguments.map + ": " + count_text(solved) + " of " + count_text(queries.size()) + " solved\n";
  if (canceled > 0)
    out += row("interrupted", count_text(canceled) + " queries were not finished; those that were are kept");
  out += row("valid", solved == 0    ? "no plan to check"
                      : refused == 0 ? "all of them, every moment of the motion checked"
                                     : "NO, " + count_text(refused) + " refused; " + first_refusal);
  const auto share_text = [&](double share) {
    return duration_text(seconds.empty() ? 0.0 : bench::quantile(seconds, share));
  };
  out += row("query times", "median " + share_text(0.5) + ", 99 % within " + share_text(0.99) + ", sum " +
                                duration_text(std::accumulate(seconds.begin(), seconds.end(), 0.0)) + "; " +
                                duration_text(total) + " with validation");
  out += suboptimality_row(planner.options().suboptimality.value_or(0.0));
  out += "\n" + world_rows(map.world) + prepare_rows(planner, build_seconds) +
         row("built by", arguments.build.summary(planner.world())) + warning_rows(map);
  files.write();
  out += files.summary();
  if (canceled > 0) return kExitInterrupted;
  return refused == 0 ? kExitSolved : kExitNoPath;
}

}  // namespace arcway::internal::cli
