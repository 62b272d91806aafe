#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/suites/corruption.h"
#include "bench/suites/suite.h"
#include "core/motion/speed_profile.h"
#include "datasets/io/random.h"

namespace arcway::internal::bench::speed_profile_suite {
namespace {

Path random_path(std::size_t segments) {
  Random random(1);
  Path path;
  for (std::size_t i = 0; i < segments; ++i) {
    const double curvature = i % 2 == 0 ? 0.0 : random.uniform(-0.7, 0.7);
    path.push_back({path.empty() ? Pose{} : path.back().end(), random.uniform(0.1, 20.0), curvature});
  }
  return path;
}

/// The fastest speed at each joint by definition: what every limit along the path allows from afar. O(n^2).
bool are_fastest(const SpeedProfile& profile, const Path& path, const Vehicle& vehicle) {
  std::vector<double> stations{0.0}, limits(path.size() + 1, vehicle.max_speed());
  limits.front() = limits.back() = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    stations.push_back(stations.back() + path[i].length);
    const double limit =
        path[i].is_line() ? vehicle.max_speed() : vehicle.turn_speed(1.0 / std::abs(path[i].curvature));
    limits[i] = std::min(limits[i], limit);
    limits[i + 1] = std::min(limits[i + 1], limit);
  }
  for (std::size_t i = 0; i < stations.size(); ++i) {
    double fastest = limits[i];
    for (std::size_t j = 0; j < stations.size(); ++j) {
      const double change = 2.0 * vehicle.max_acceleration() * std::abs(stations[i] - stations[j]);
      fastest = std::min(fastest, std::sqrt(limits[j] * limits[j] + change));
    }
    if (std::abs(profile.speeds[i] - fastest) > 1e-9 * (1.0 + fastest)) return false;
  }
  return true;
}

void time_profile(benchmark::State& state, std::size_t segments) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  const Path path = random_path(segments);
  SpeedProfile profile = speed_profile(path, vehicle);
  if (corrupting()) profile.speeds[segments / 2] *= 1.01;
  const auto right = [&] { return are_fastest(profile, path, vehicle); };
  if (!require_once(state, "SpeedProfile/" + std::to_string(segments), right, "a speed is not the fastest")) return;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(profile = speed_profile(path, vehicle));
}

void add(Study study) {
  Series series(study, "SpeedProfile", "segments", "O(n)", 1.0);
  for (const std::size_t n : sizes(study, {10, 32, 100, 316, 1000, 3162}, 32, 3162))
    series.add(static_cast<double>(n), [n](benchmark::State& state) { time_profile(state, n); });
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::speed_profile_suite
