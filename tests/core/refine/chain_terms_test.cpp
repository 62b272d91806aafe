#include "core/refine/chain_terms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>

#include "core/motion/speed_profile.h"
#include "tests/support/arc_chains.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

constexpr ChainSpeeds kTermSpeeds{2.0, 1.5, 16.0, 16.0};  // the widest slow radius is 10.7 m

// Speeds below the limits. Lengths need not suffice to reach one from the other.
void set_random_speeds(test::RandomInputs& random, ArcChain& chain) {
  for (ArcChain::Arc& arc : chain.arcs) {
    const double limit = kTermSpeeds.of(arc.radius);
    if (arc.entry > 0.0) arc.entry = random.uniform(0.1, 0.95) * limit;
    if (arc.exit > 0.0) arc.exit = random.uniform(0.1, 0.95) * limit;
  }
}

using test::ChainPart;
using test::number_of;

Term time_of_part(const ArcChain& chain, const ChainPart& part) {
  return part.is_line ? line_time(chain, part.index, kTermSpeeds) : arc_time(chain, part.index, kTermSpeeds);
}

double time_alone_of_part(const ArcChain& chain, const ChainPart& part) {
  return part.is_line ? line_time_alone(chain, part.index, kTermSpeeds)
                      : arc_time_alone(chain, part.index, kTermSpeeds);
}

// The length on which a part holds its top speed, negative where it does not reach it.
double holding_length(const ArcChain& chain, const ChainPart& part) {
  const std::size_t i = part.index;
  double length = chain.lines[i].length, limit = kTermSpeeds.top;
  double entry = entry_of_line(chain, i), exit = exit_of_line(chain, i);
  if (!part.is_line) {
    const ArcChain::Arc& arc = chain.arcs[i];
    length = arc.radius * chain.turn(i);
    limit = kTermSpeeds.of(arc.radius);
    entry = arc.entry;
    exit = arc.exit;
  }
  return length - (2.0 * limit - entry - exit) / (2.0 * kTermSpeeds.acceleration);
}

void expect_term_derivatives(const ArcChain& chain, const ChainPart& part) {
  constexpr double kStep = 1e-5;
  const Term term = time_of_part(chain, part);
  EXPECT_NEAR((term.hessian - term.hessian.transpose()).norm(), 0.0, 1e-14 * (1.0 + term.hessian.norm()));
  for (int number = 0; number < kLocalNumbers; ++number) {
    ArcChain low = chain, high = chain;
    double* const down = number_of(low, part, number);
    if (down == nullptr) continue;
    *down -= kStep;
    *number_of(high, part, number) += kStep;
    const double slope = (time_alone_of_part(high, part) - time_alone_of_part(low, part)) / (2.0 * kStep);
    EXPECT_NEAR(term.gradient[number], slope, 1e-7 * (1.0 + std::abs(slope))) << "number " << number;
    const Term::Gradient before = time_of_part(low, part).gradient, behind = time_of_part(high, part).gradient;
    for (int other = 0; other < kLocalNumbers; ++other) {
      // A speed that is given counts as none.
      if (number_of(low, part, other) == nullptr) continue;
      const double curve = (behind[other] - before[other]) / (2.0 * kStep);
      EXPECT_NEAR(term.hessian(other, number), curve, 1e-6 * (1.0 + std::abs(curve)))
          << "numbers " << other << " and " << number;
    }
  }
}

TEST(ChainTerms, DerivativesAreThoseOfTheTimes) {
  test::RandomInputs random(1);
  int held[2] = {0, 0}, not_held[2] = {0, 0}, fast = 0, ends = 0;
  for (int i = 0; i < 300; ++i) {
    ArcChain chain = test::random_arcs(random, 8, i % 2 == 1);
    set_random_speeds(random, chain);
    for (const bool is_line : {false, true})
      for (std::size_t k = 0; k < chain.arcs.size() + (is_line ? 1 : 0); ++k) {
        if (is_line && chain.lines[k].is_tied) continue;
        const ChainPart part{is_line, k};
        SCOPED_TRACE(testing::Message() << "chain " << i << (is_line ? " line " : " arc ") << k);
        EXPECT_NEAR(time_of_part(chain, part).value, time_alone_of_part(chain, part), 1e-14);
        const double holding = holding_length(chain, part);
        if (std::abs(holding) < 1e-3) continue;  // second derivatives jump
        (holding > 0.0 ? held : not_held)[is_line] += 1;
        fast += !is_line && chain.arcs[k].radius > kTermSpeeds.widest();
        ends += is_line && (k == 0 || k == chain.arcs.size());
        expect_term_derivatives(chain, part);
      }
  }
  for (const bool is_line : {false, true}) {
    EXPECT_GT(held[is_line], 30);
    EXPECT_GT(not_held[is_line], 30);
  }
  EXPECT_GT(fast, 30);
  EXPECT_GT(ends, 100);
}

// The top speed is just reached: both formulas hold.
TEST(ChainTerms, ValuesAndGradientsAreSmoothWhereTheTopSpeedIsReached) {
  test::RandomInputs random(2);
  for (int i = 0; i < 100; ++i) {
    ArcChain chain = test::random_arcs(random, 8);
    set_random_speeds(random, chain);
    const ChainPart part{true, 0};
    const double reached = chain.lines[0].length - holding_length(chain, part);
    chain.lines[0].length = reached * (1.0 - 1e-12);
    const Term before = time_of_part(chain, part);
    chain.lines[0].length = reached * (1.0 + 1e-12);
    const Term behind = time_of_part(chain, part);
    EXPECT_NEAR(before.value, behind.value, 1e-10);
    EXPECT_NEAR((before.gradient - behind.gradient).norm(), 0.0, 1e-10);
  }
}

TEST(ChainTerms, AnArcOfAKnownTime) {
  // 4 m from 1 m/s to 1 m/s, at 2 m/s^2 and at most 2 m/s: each change of speed takes 0.5 s and 0.75 m.
  ArcChain chain;
  chain.lines = {{0.0, 1.0, false}, {-2.0, 1.0, false}};
  chain.arcs = {{Vec2::Zero(), 2.0, -1.0, 1.0, 1.0}};
  const ChainSpeeds speeds{2.0, 2.0, 100.0, 100.0};
  EXPECT_NEAR(arc_time_alone(chain, 0, speeds), 1.0 + 2.5 / 2.0, 1e-14);
  EXPECT_EQ(entry_of_line(chain, 0), 0.0);
  EXPECT_EQ(exit_of_line(chain, 0), 1.0);
  EXPECT_EQ(entry_of_line(chain, 1), 1.0);
  EXPECT_EQ(exit_of_line(chain, 1), 0.0);
  EXPECT_EQ(speeds.widest(), 50.0);
  EXPECT_EQ(speeds.of(49.0), 98.0);
  EXPECT_EQ(speeds.of(51.0), 100.0);
}

TEST(ChainTerms, WithTheFastestSpeedsTheyAddUpToTheTravelTime) {
  test::RandomInputs random(3);
  const Vehicle vehicle({.max_speed = std::sqrt(kTermSpeeds.top),
                         .turn_speed = LateralAccelerationLimit{kTermSpeeds.lateral},
                         .max_acceleration = kTermSpeeds.acceleration});
  for (int i = 0; i < 300; ++i) {
    ArcChain chain = test::random_arcs(random, 8);
    const SpeedProfile profile = speed_profile(test::path_of(chain), vehicle);
    std::size_t segment = 0;
    for (std::size_t k = 0; k < chain.arcs.size(); ++k) {
      if (!chain.lines[k].is_tied) ++segment;
      chain.arcs[k].entry = profile.speeds[segment] * profile.speeds[segment];
      ++segment;
      chain.arcs[k].exit = profile.speeds[segment] * profile.speeds[segment];
    }
    double time = 0.0;
    for (std::size_t k = 0; k < chain.arcs.size(); ++k) time += arc_time(chain, k, kTermSpeeds).value;
    for (std::size_t k = 0; k < chain.lines.size(); ++k)
      if (!chain.lines[k].is_tied) time += line_time(chain, k, kTermSpeeds).value;
    EXPECT_NEAR(time, profile.total_time, 1e-9 * profile.total_time) << "chain " << i;
  }
}

const Vehicle& vehicle_of_table() {
  static const Vehicle vehicle({.max_speed = 4.0,
                                .turn_speed = TurnSpeedTable{{{2.0, 1.0}, {4.0, 2.5}, {8.0, 3.5}, {10.0, 4.5}}},
                                .max_acceleration = 2.0});
  return vehicle;
}

TEST(ChainTerms, SpeedsOfATableAreThoseOfTheVehicle) {
  const ChainSpeeds speeds = speeds_of(vehicle_of_table());
  EXPECT_NEAR(speeds.widest(), 9.0, 1e-14);
  EXPECT_EQ(speeds.of(std::nan("")), speeds.top);
  constexpr double kStep = 1e-5;
  for (const double radius : {1.4, 1.9, 2.5, 3.9, 4.1, 7.0, 8.5, 8.9, 9.5, 30.0}) {
    const double speed = vehicle_of_table().turn_speed(radius);
    const ChainSpeeds::Square square = speeds.square(radius);
    EXPECT_NEAR(square.value, speed * speed, 1e-13);
    const double low = speeds.of(radius - kStep), high = speeds.of(radius + kStep);
    EXPECT_NEAR(square.slope, (high - low) / (2.0 * kStep), 1e-8) << radius;
    EXPECT_NEAR(square.curvature, (high - 2.0 * square.value + low) / (kStep * kStep), 1e-3) << radius;
  }
}

TEST(ChainTerms, WhereATableEndsTurnsGetNoFasterAndLinesAreFaster) {
  const Vehicle vehicle({.max_speed = 4.0, .turn_speed = TurnSpeedTable{{{2.0, 1.0}, {6.0, 3.0}}}});
  const ChainSpeeds speeds = speeds_of(vehicle);
  EXPECT_NEAR(speeds.widest(), 6.0, 1e-14);
  for (const double radius : {1.4, 3.0, 5.9, 6.0, 6.1, 50.0}) {
    const double speed = vehicle.turn_speed(radius);
    EXPECT_NEAR(speeds.of(radius), speed * speed, 1e-13) << radius;
  }
  EXPECT_EQ(speeds.top, 16.0);
  ArcChain chain;
  chain.lines = {{0.0, 8.0, false}, {1.0, 8.0, false}};
  chain.arcs = {{Vec2::Zero(), 20.0, 1.0, 9.0, 9.0}};
  EXPECT_NEAR(arc_time(chain, 0, speeds).value, 20.0 / 3.0, 1e-12);
  EXPECT_EQ(arc_time(chain, 0, speeds).gradient[kRadius], 1.0 / 3.0);
}

TEST(ChainTerms, TimesOfATableHaveItsDerivatives) {
  test::RandomInputs random(5);
  const ChainSpeeds speeds = speeds_of(vehicle_of_table());
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 200; ++i) {
    ArcChain chain;
    chain.lines = {{0.0, 1.0, false}, {2.0, 1.0, false}};
    chain.arcs = {{Vec2::Zero(), random.uniform(2.1, 3.9), 1.0, 0.0, 0.0}};
    ArcChain::Arc& arc = chain.arcs[0];
    arc.entry = random.uniform(0.5, 0.9) * speeds.of(arc.radius);
    arc.exit = random.uniform(0.5, 0.9) * speeds.of(arc.radius);
    const Term term = arc_time(chain, 0, speeds);
    ArcChain low = chain, high = chain;
    low.arcs[0].radius -= kStep;
    high.arcs[0].radius += kStep;
    const double slope = (arc_time_alone(high, 0, speeds) - arc_time_alone(low, 0, speeds)) / (2.0 * kStep);
    EXPECT_NEAR(term.gradient[kRadius], slope, 1e-7);
    const double curve =
        (arc_time(high, 0, speeds).gradient[kRadius] - arc_time(low, 0, speeds).gradient[kRadius]) / (2.0 * kStep);
    EXPECT_NEAR(term.hessian(kRadius, kRadius), curve, 1e-6);
  }
}

// Tables must ascend up to the top speed.
TEST(ChainTerms, SomeTablesHaveNoSpeedsOfChains) {
  const auto has = [](TurnSpeedTable table) {
    return has_chain_speeds(Vehicle({.max_speed = 4.0, .turn_speed = std::move(table)}));
  };
  EXPECT_TRUE(has({{{1.0, 1.0}, {9.0, 4.0}}}));
  EXPECT_TRUE(has({{{1.0, 1.0}, {9.0, 5.0}, {10.0, 2.0}}}));  // below the top speed it ascends
  EXPECT_TRUE(has({{{1.0, 1.0}, {9.0, 3.0}}}));               // to its end
  EXPECT_FALSE(has({{{1.0, 1.0}, {1.2, 3.0}}}));              // all turns are as fast
  EXPECT_FALSE(has({{{1.0, 1.0}, {5.0, 1.0}, {9.0, 4.0}}}));
  EXPECT_FALSE(has({{{1.0, 4.0}}}));
  EXPECT_FALSE(has({{{1.0, 2.0}}}));
}

}  // namespace
}  // namespace arcway::internal
