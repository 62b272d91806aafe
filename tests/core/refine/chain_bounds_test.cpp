#include "core/refine/chain_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/refine/chain_system.h"
#include "tests/support/arc_chains.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

constexpr ChainSpeeds kBoundSpeeds{2.0, 1.5, 16.0, 16.0};
constexpr double kBoundTightest = 1.3;  // [m]

test::ChainPart chain_part_of(const Bound& bound) { return {bound.is_of_line(), bound.index}; }

// What a bound says, by its definition.
double defined_value(const Bound& bound, const ArcChain& chain) {
  const std::size_t i = bound.index;
  const double widest = kBoundSpeeds.top / kBoundSpeeds.lateral;
  const double twice = 2.0 * kBoundSpeeds.acceleration;
  if (bound.is_of_line()) {
    const double length = chain.lines[i].length;
    const double entry = i > 0 ? chain.arcs[i - 1].exit : 0.0, exit = i < chain.arcs.size() ? chain.arcs[i].entry : 0.0;
    if (bound.limit == Limit::kLineLength) return length;
    return length - (bound.limit == Limit::kLineSpeedUp ? exit - entry : entry - exit) / twice;
  }
  const ArcChain::Arc& arc = chain.arcs[i];
  const double length = arc.radius * chain.turn(i), fast = bound.is_slow ? arc.radius : widest;
  switch (bound.limit) {
    case Limit::kTurn:
      return chain.turn(i);
    case Limit::kTightest:
      return arc.radius - kBoundTightest;
    case Limit::kWidest:
      return bound.is_slow ? widest - arc.radius : arc.radius - widest;
    case Limit::kEntry:
      return fast - arc.entry / kBoundSpeeds.lateral;
    case Limit::kExit:
      return fast - arc.exit / kBoundSpeeds.lateral;
    case Limit::kSpeedUp:
      return length - (arc.exit - arc.entry) / twice;
    default:
      return length - (arc.entry - arc.exit) / twice;
  }
}

std::size_t count_of(const std::vector<Bound>& bounds, Limit limit) {
  return static_cast<std::size_t>(std::ranges::count(bounds, limit, &Bound::limit));
}

TEST(ChainBounds, EveryPartHasItsOwn) {
  test::RandomInputs random(1);
  std::vector<Bound> bounds;
  std::size_t slow = 0, fast = 0;
  for (int i = 0; i < 100; ++i) {
    const ArcChain chain = test::random_arcs(random, 6);
    find_bounds(chain, {kBoundSpeeds, kBoundSpeeds}, bounds);
    const std::size_t arcs = chain.arcs.size();
    const auto untied = static_cast<std::size_t>(std::ranges::count(chain.lines, false, &ArcChain::Line::is_tied));
    for (const Limit limit :
         {Limit::kTurn, Limit::kTightest, Limit::kWidest, Limit::kEntry, Limit::kExit, Limit::kSpeedUp, Limit::kBrake})
      EXPECT_EQ(count_of(bounds, limit), arcs);
    EXPECT_EQ(count_of(bounds, Limit::kLineLength), untied);
    EXPECT_EQ(count_of(bounds, Limit::kLineSpeedUp), untied - 1);
    EXPECT_EQ(count_of(bounds, Limit::kLineBrake), untied - 1);
    for (const Bound& bound : bounds) {
      if (bound.is_of_line()) {
        EXPECT_FALSE(chain.lines[bound.index].is_tied);
        // From rest nothing brakes, and to rest nothing speeds up.
        EXPECT_FALSE(bound.limit == Limit::kLineBrake && bound.index == 0);
        EXPECT_FALSE(bound.limit == Limit::kLineSpeedUp && bound.index == arcs);
        continue;
      }
      EXPECT_EQ(bound.is_slow, chain.arcs[bound.index].radius < kBoundSpeeds.widest());
      ++(bound.is_slow ? slow : fast);
    }
  }
  EXPECT_GT(slow, 100u);
  EXPECT_GT(fast, 100u);
}

TEST(ChainBounds, ValuesAreThoseDefinedAndGradientsTheirDerivatives) {
  constexpr double kStep = 1e-5;
  test::RandomInputs random(2);
  std::vector<Bound> bounds;
  for (int i = 0; i < 100; ++i) {
    const ArcChain chain = test::random_arcs(random, 6, i % 2 == 1);
    find_bounds(chain, {kBoundSpeeds, kBoundSpeeds}, bounds);
    for (const Bound& bound : bounds) {
      SCOPED_TRACE(testing::Message() << "chain " << i << " limit " << static_cast<int>(bound.limit) << " of part "
                                      << bound.index);
      const BoundValue value = value_of(bound, chain, kBoundSpeeds, kBoundTightest);
      EXPECT_NEAR(value.value, defined_value(bound, chain), 1e-12);
      for (int number = 0; number < kLocalNumbers; ++number) {
        ArcChain low = chain, high = chain;
        double* const down = test::number_of(low, chain_part_of(bound), number);
        if (down == nullptr) continue;
        *down -= kStep;
        *test::number_of(high, chain_part_of(bound), number) += kStep;
        const double slope = (defined_value(bound, high) - defined_value(bound, low)) / (2.0 * kStep);
        EXPECT_NEAR(value.gradient[number], slope, 1e-8) << "number " << number;
      }
    }
  }
}

TEST(ChainBounds, LengthsOfArcsAreCurvedByRadiusAndHeadings) {
  constexpr double kStep = 1e-3;
  test::RandomInputs random(3);
  for (int i = 0; i < 50; ++i) {
    const ArcChain chain = test::random_arcs(random, 6);
    for (std::uint32_t arc = 0; arc < chain.arcs.size(); ++arc) {
      const Bound bound{Limit::kTurn, arc, true};
      const Term::Hessian curvature = length_curvature(chain, arc);
      const auto length_after = [&](int a, double by_a, int b, double by_b) {
        ArcChain moved = chain;
        *test::number_of(moved, chain_part_of(bound), a) += by_a;
        *test::number_of(moved, chain_part_of(bound), b) += by_b;
        return moved.arcs[arc].radius * moved.turn(arc);
      };
      for (int a = 0; a < kLocalNumbers; ++a)
        for (int b = 0; b < kLocalNumbers; ++b) {
          const double second = (length_after(a, kStep, b, kStep) - length_after(a, kStep, b, -kStep) -
                                 length_after(a, -kStep, b, kStep) + length_after(a, -kStep, b, -kStep)) /
                                (4.0 * kStep * kStep);
          EXPECT_NEAR(curvature(a, b), second, 1e-7);
        }
    }
  }
}

TEST(ChainBounds, SpeedsOfATableAreCurvedByTheRadius) {
  constexpr double kStep = 1e-4;
  constexpr std::pair<double, double> kTable[] = {{1.0, 1.0}, {8.0, 4.0}};
  const ChainSpeeds speeds{2.0, 2.0, 16.0, 16.0, kTable};
  ArcChain chain;
  chain.lines = {{0.0, 1.0, false}, {1.0, 1.0, false}};
  chain.arcs = {{Vec2::Zero(), 5.0, 1.0, 3.0, 4.0}};
  for (const Limit limit : {Limit::kEntry, Limit::kExit})
    for (const bool is_slow : {true, false}) {
      const Bound bound{limit, 0, is_slow};
      const auto value_at = [&](double radius) {
        ArcChain moved = chain;
        moved.arcs[0].radius = radius;
        return value_of(bound, moved, speeds, 1.0);
      };
      const BoundValue now = value_at(5.0), low = value_at(5.0 - kStep), high = value_at(5.0 + kStep);
      EXPECT_NEAR(now.gradient[kRadius], (high.value - low.value) / (2.0 * kStep), 1e-8);
      EXPECT_NEAR(speed_curvature(bound, chain, speeds),
                  (high.gradient[kRadius] - low.gradient[kRadius]) / (2.0 * kStep), 1e-8);
      // On the bound the speed is that of the circle, or of a line.
      EXPECT_NEAR(now.value, ((is_slow ? speeds.of(5.0) : 16.0) - (limit == Limit::kEntry ? 3.0 : 4.0)) / 2.0, 1e-13);
    }
}

TEST(ChainBounds, AreAllKeptWhereAnOptimizationBegins) {
  test::RandomInputs random(4);
  const Vehicle vehicle({.max_speed = 4.0, .turn_speed = LateralAccelerationLimit{1.5}, .max_acceleration = 2.0});
  const World world({});
  const Outlines outlines(world);
  ChainSystem system;
  int begun = 0;
  for (int i = 0; i < 100; ++i) {
    Pose pose{0.0, 0.0, random.uniform(-4.0, 4.0)};
    const Pose start = pose;
    Path path;
    for (int k = 0; k < 5; ++k) {
      const double radius = random.uniform(1.31, 14.0), turn = random.uniform(0.01, 2.5);
      for (const auto& [length, curvature] : {std::pair(random.uniform(0.0, 6.0), 0.0),
                                              std::pair(radius * turn, (random.unit() < 0.5 ? 1.0 : -1.0) / radius)}) {
        path.push_back({pose, length, curvature});
        pose = path.back().end();
      }
    }
    const CircleChain chain = chain_of(path, start, pose).value();
    const TurnCuts cuts{3, 0.05, vehicle.max_speed() * vehicle.max_speed() / 1.5};
    if (!cut_turns(chain, lines_of(chain).value(), cuts, system.chain)) continue;
    ASSERT_TRUE(system.begin(vehicle, vehicle.footprint(), {world, outlines, 1.0}));
    ++begun;
    for (const Bound& bound : system.bounds)
      EXPECT_GT(system.value(bound, system.chain).value, 0.0)
          << "chain " << i << " limit " << static_cast<int>(bound.limit) << " of part " << bound.index;
  }
  EXPECT_GT(begun, 80);
}

}  // namespace
}  // namespace arcway::internal
