#include "bench/report/gate.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "bench/report/document.h"
#include "bench/report/markup.h"
#include "bench/report/statistics.h"

namespace arcway::internal::report {
namespace {

/// First words of the counters that count work: less is better.
constexpr std::array<std::string_view, 8> kCounts = {"edges", "links", "expansions",  "trials",
                                                     "steps", "poses", "allocations", "instructions"};
constexpr std::string_view kInstructions = "instructions";
/// Differences of times that chance makes less often than this are significant. Of some 200 benchmarks one then looks
/// slower by chance, but hardly by the factor of the limits.
constexpr double kSignificance = 0.01;

std::string_view first_word(std::string_view counter) { return counter.substr(0, counter.find('_')); }

std::string context_of(const Results& results, const std::string& key) {
  const auto found = std::ranges::find(results.context, key, &std::pair<std::string, std::string>::first);
  return found == results.context.end() ? "unknown " + key : found->second;
}

const Measurement* same_in(const Results& results, const std::string& name) {
  const auto found = std::ranges::find(results.measurements, name, &Measurement::name);
  return found == results.measurements.end() ? nullptr : &*found;
}

void compare_counts(const Measurement& before, const Measurement& after, const GateLimits& limits,
                    GateFindings& findings) {
  for (const auto& [counter, old_count] : before.counters) {
    const std::string_view word = first_word(counter);
    if (std::ranges::find(kCounts, word) == kCounts.end()) continue;
    if (word == kInstructions && !findings.same_processor) continue;
    const auto found = after.counters.find(counter);
    if (found == after.counters.end()) {
      findings.missing.push_back({before.name, "no count of " + counter});
      continue;
    }
    ++findings.counts;
    if (found->second > old_count * (1.0 + limits.counts))
      findings.rises.push_back(
          {.benchmark = before.name, .what = counter, .before = old_count, .after = found->second});
  }
}

/// Whether the most different samples of these sizes would be significant.
bool can_be_significant(const Measurement& before, const Measurement& after) {
  const std::vector<double> low(before.cpu_seconds.size(), 0.0), high(after.cpu_seconds.size(), 1.0);
  return mann_whitney_p(low, high) < kSignificance;
}

void compare_times(const Measurement& before, const Measurement& after, const GateLimits& limits,
                   GateFindings& findings) {
  if (before.cpu_seconds.empty() || after.cpu_seconds.empty()) return;
  const double old_time = std::ranges::min(before.cpu_seconds), new_time = std::ranges::min(after.cpu_seconds);
  if (!(old_time > 0.0)) return;  // too short for the clock
  ++findings.times;
  if (!can_be_significant(before, after)) ++findings.too_few;
  const double p = mann_whitney_p(before.cpu_seconds, after.cpu_seconds);
  if (p >= kSignificance || new_time <= limits.times * old_time) return;
  findings.rises.push_back({.benchmark = before.name,
                            .what = "processor time",
                            .before = old_time,
                            .after = new_time,
                            .p = p,
                            .is_time = true});
}

std::string limit_text(double share) { return number_text("%.3g %%", 100.0 * share); }

std::string factor_of(const Rise& rise) {
  return rise.before > 0.0 ? number_text("%.3f", rise.after / rise.before) : "from none";
}

/// A count as it is, with separators where it is a large whole number.
std::string amount_text(const Rise& rise, double value) {
  if (rise.is_time) return time_text(value);
  return value >= 1e4 ? count_text(value) : number_text("%.6g", value);
}

std::string rule_of(const Rise& rise, const GateLimits& limits) {
  if (!rise.is_time) return "count, at most +" + limit_text(limits.counts);
  return "time, at most " + number_text("%.3g", limits.times) + " times; p = " + number_text("%.2g", rise.p);
}

std::string run_text(const Results& results) {
  return results.name + ", commit " + context_of(results, "commit") + ", on " + context_of(results, "processor") + "\n";
}

std::string list_of(const std::string& title, const std::vector<Absence>& absences) {
  if (absences.empty()) return "";
  std::string text = "\n" + title + "\n";
  for (const Absence& absence : absences) text += "- " + absence.benchmark + ": " + absence.why + "\n";
  return text;
}

/// What was compared, and what was not and why.
std::string scope_text(const GateFindings& findings, const GateLimits& limits) {
  std::string text = "Compared: " + count_text(static_cast<double>(findings.counts)) + " counts, which may rise by " +
                     limit_text(limits.counts) + "; ";
  if (!findings.same_processor)
    return text + "no times and no instructions, because the runs are of different processors.\n";
  text += count_text(static_cast<double>(findings.times)) + " processor times, whose fastest repetition may take " +
          number_text("%.3g", limits.times) +
          " times as long, or longer if that may be chance (p >= " + number_text("%g", kSignificance) + ").\n";
  if (findings.too_few > 0)
    text += "Of " + count_text(static_cast<double>(findings.too_few)) +
            " benchmarks no time can fail: they have too few repetitions. Five in each run are enough "
            "(--benchmark_repetitions=5).\n";
  return text;
}

}  // namespace

GateFindings compare_for_gate(const Results& before, const Results& after, const GateLimits& limits) {
  GateFindings findings;
  findings.same_processor = context_of(before, "processor") == context_of(after, "processor");
  for (const Measurement& b : before.measurements) {
    if (!b.error.empty()) continue;
    const Measurement* a = same_in(after, b.name);
    if (a == nullptr) {
      findings.missing.push_back({b.name, "not in the new run"});
    } else if (!a->error.empty()) {
      (a->left_out() ? findings.missing : findings.failed).push_back({b.name, a->error});
    } else {
      compare_counts(b, *a, limits, findings);
      if (findings.same_processor) compare_times(b, *a, limits, findings);
    }
  }
  std::ranges::stable_sort(findings.rises, [](const Rise& x, const Rise& y) {
    if (x.is_time != y.is_time) return y.is_time;
    return x.after * y.before > y.after * x.before;
  });
  return findings;
}

std::string gate_text(const GateFindings& findings, const Results& before, const Results& after,
                      const GateLimits& limits) {
  std::string text = "Old: " + run_text(before) + "New: " + run_text(after) + scope_text(findings, limits);
  if (findings.rises.empty()) {
    text += "Nothing rose beyond its limit.\n";
  } else {
    Table table{{"benchmark", "what", "old", "new", "new / old", "rule"}, {}, 2};
    for (const Rise& rise : findings.rises)
      table.rows.push_back({rise.benchmark, rise.what, amount_text(rise, rise.before), amount_text(rise, rise.after),
                            factor_of(rise), rule_of(rise, limits)});
    text += "Rose beyond its limit: " + count_text(static_cast<double>(findings.rises.size())) + "\n\n" +
            to_markdown(table);
  }
  return text + list_of("Fail now, and did not:", findings.failed) +
         list_of("Are no longer measured, which fails no gate:", findings.missing);
}

}  // namespace arcway::internal::report
