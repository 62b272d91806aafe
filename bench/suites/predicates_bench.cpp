#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/suites/corruption.h"
#include "bench/suites/suite.h"
#include "core/geometry/predicates.h"
#include "datasets/io/random.h"

// The sign on which everything rests: points at random, and points on a line, of which no filter can be sure.
namespace arcway::internal::bench::predicates_suite {
namespace {

using Triple = std::array<Vec2, 3>;
constexpr std::size_t kTriples = 4096;
constexpr double kGrid = 0x1p51;  // whole coordinates: what is reckoned of them is exact in 128 bits, not in doubles

std::vector<Triple> triples(bool collinear) {
  Random random(1);
  const auto whole = [&] { return std::floor(random.uniform(0.0, kGrid)); };
  std::vector<Triple> result(kTriples);
  for (Triple& t : result) {
    t[0] = Vec2(whole(), whole());
    t[1] = Vec2(whole(), whole());
    t[2] = collinear ? Vec2(2.0 * t[1] - t[0]) : Vec2(whole(), whole());
  }
  return result;
}

int whole_orientation(const Triple& t) {
  __extension__ using Wide = __int128;
  const auto at = [](double v) { return static_cast<Wide>(static_cast<std::int64_t>(v)); };
  const Wide area = (at(t[1].x()) - at(t[0].x())) * (at(t[2].y()) - at(t[0].y())) -
                    (at(t[1].y()) - at(t[0].y())) * (at(t[2].x()) - at(t[0].x()));
  return (area > 0) - (area < 0);
}

void add_case(const std::string& name, bool collinear) {
  add_benchmark("Predicates/orientation/" + name, [collinear](benchmark::State& state) {
    const std::vector<Triple> inputs = triples(collinear);
    bool right = true;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      int sign = orientation(inputs[i][0], inputs[i][1], inputs[i][2]);
      if (corrupting() && i == 0) sign = sign == 0 ? 1 : 0;
      right = right && sign == whole_orientation(inputs[i]);
    }
    if (!require(state, right, "a sign differs from whole-number arithmetic")) return;
    for ([[maybe_unused]] auto _ : state) {
      int sum = 0;
      for (const Triple& t : inputs) sum += orientation(t[0], t[1], t[2]);
      benchmark::DoNotOptimize(sum);
    }
    set_batch(state, kTriples);
  });
}

void add(Study /*study*/) {
  add_case("random", false);
  add_case("collinear", true);
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::predicates_suite
