#include "bench/report/noise.h"

#include <algorithm>

#include "bench/quantiles.h"
#include "bench/report/markup.h"

namespace arcway::internal::report {
namespace {

/// By how much one time exceeds another, as a share; 0 where the clock was too coarse.
double excess(double time, double least) { return least > 0.0 ? time / least - 1.0 : 0.0; }

double median_of(std::span<const double> times) { return bench::median({times.begin(), times.end()}); }

/// Whole percents; one digit more where "10 %" would not tell why.
std::string percent_text(double share) { return number_text(share < 0.11 ? "%.1f" : "%.0f", 100.0 * share) + " %"; }

bool is_by_wall(const Measurement& m) { return threads_of(m.name) > 1 || place_of(m.name).key == "threads"; }

}  // namespace

const std::vector<double>& times_of(const Measurement& m) { return is_by_wall(m) ? m.wall_seconds : m.cpu_seconds; }

std::string noise_of(std::span<const double> wall, std::span<const double> processor, bool by_wall) {
  std::string noise;
  const std::span<const double> times = by_wall ? wall : processor;
  if (times.empty()) return noise;
  if (!by_wall && !wall.empty())
    if (const double waiting = excess(median_of(wall), median_of(processor)); waiting > kMostNoise)
      noise = "wall time " + percent_text(waiting) + " above processor time";
  const auto [low, high] = std::ranges::minmax(times);
  if (const double spread = excess(high, low); spread > kMostNoise)
    noise += (noise.empty() ? "" : ", ") + ("repetitions differ by " + percent_text(spread));
  return noise;
}

std::string noise_of(const Measurement& m) { return noise_of(m.wall_seconds, m.cpu_seconds, is_by_wall(m)); }

std::string marked(const std::string& time, bool is_noisy) { return is_noisy ? time + " †" : time; }

std::string mark_meaning() {
  const std::string share = number_text("%g", 100.0 * kMostNoise) + " %";
  return "† noisy: the wall time exceeds the processor time by more than " + share +
         ", or the longest repetition the shortest. Left out of fits.";
}

}  // namespace arcway::internal::report
