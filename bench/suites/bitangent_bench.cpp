#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "bench/suites/corruption.h"
#include "bench/suites/suite.h"
#include "core/roadmap/turn_circle.h"
#include "datasets/io/random.h"

namespace arcway::internal::bench::bitangent_suite {
namespace {

using CirclePair = std::pair<TurnCircle, TurnCircle>;
constexpr std::size_t kPairs = 4096;

std::vector<CirclePair> circle_pairs() {
  Random random(1);
  const auto circle = [&] {
    const Vec2 center(random.uniform(0.0, 100.0), random.uniform(0.0, 100.0));
    return TurnCircle{center, random.uniform(1.0, 3.0), random.below(2) == 0 ? Side::kLeft : Side::kRight, kNone};
  };
  std::vector<CirclePair> pairs(kPairs);
  for (CirclePair& pair : pairs) pair = {circle(), circle()};
  return pairs;
}

/// Whether the line leaves the first circle and enters the second along their directions.
bool is_tangent_line(const Bitangent& line, const CirclePair& circles) {
  const Vec2 along = direction_of(line.start.heading);
  const auto touches = [&](const TurnCircle& circle, const Vec2& at) {
    const Vec2 expected = at + sign_of(circle.side) * circle.radius * perpendicular(along);
    return (expected - circle.center).norm() < 1e-9;
  };
  return touches(circles.first, line.start.position()) &&
         touches(circles.second, line.start.position() + line.length * along);
}

void time_bitangents(benchmark::State& state) {
  const std::vector<CirclePair> pairs = circle_pairs();
  bool right = true;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::optional<Bitangent> line = directed_bitangent(pairs[i].first, pairs[i].second);
    if (corrupting() && line) line->length += 1.0;
    const double apart = (pairs[i].first.center - pairs[i].second.center).norm();
    const bool must_exist = apart > pairs[i].first.radius + pairs[i].second.radius;
    right = right && (line ? is_tangent_line(*line, pairs[i]) : !must_exist);
  }
  if (!require(state, right, "a line is not tangent")) return;
  for ([[maybe_unused]] auto _ : state) {
    for (const auto& [from, to] : pairs) benchmark::DoNotOptimize(directed_bitangent(from, to));
  }
  set_batch(state, kPairs);
}

void add(Study /*study*/) { add_benchmark("Bitangents/directed", time_bitangents); }

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::bitangent_suite
