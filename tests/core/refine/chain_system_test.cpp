#include "core/refine/chain_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "core/base/infinity.h"
#include "core/motion/speed_profile.h"
#include "tests/support/arc_chains.h"
#include "tests/support/free_plans.h"
#include "tests/support/gear_paths.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// A cluttered world, and a system that begins with a free chain of it.
class SystemCases {
 public:
  explicit SystemCases(std::uint64_t seed)
      : world_(random_world({.obstacles = 40, .vertices = 8, .fill = 0.25, .seed = seed})),
        outlines_(world_),
        planner_(world_, vehicle_, {.radii = {}, .refinement = {.max_trials = 0}}),
        random_(seed) {}

  // Begins with the chain of another query.
  void begin_next() {
    for (;;) {
      const auto [request, path] = test::next_free_plan(planner_, random_);
      const auto circles = chain_of(path, request.start, request.goal);
      const auto lines = circles ? lines_of(*circles) : std::nullopt;
      if (!lines || !cut_turns(*circles, *lines, {3, 0.05, 72.0}, system.chain)) continue;
      const Footprint body = vehicle_.footprint(0.5 * vehicle_.safety_margin());
      const double reach = 4.0 * vehicle_.parameters().length;
      if (system.begin(vehicle_, body, {world_, outlines_, reach}) && least_contact() >= 0.0) return;
    }
  }
  // A random step of all unknowns, at most so large a share of their scales, or of lengths and turns that are small.
  void make_step(double most) {
    system.step.assign(system.unknowns.size(), 0.0);
    for (std::size_t i = 0; i < system.step.size(); ++i)
      if (!system.unknowns.is_tension(i))
        system.step[i] = random_.uniform(-most, most) / std::sqrt(system.unknowns.inverse_squares()[i]);
    const auto shorten = [&](int number, double scale) {
      if (number != kGiven) system.step[static_cast<std::size_t>(number)] *= std::min(1.0, scale);
    };
    const ArcChain& chain = system.chain;
    for (std::size_t i = 0; i < chain.lines.size(); ++i) {
      shorten(system.unknowns.of_line(i)[kLength], chain.lines[i].length);
      if (i > 0 && i < chain.arcs.size())
        shorten(system.unknowns.of_line(i)[kHeading], std::min(chain.turn(i - 1), chain.turn(i)));
    }
  }
  double least_contact() {
    double least = kInfinity;
    for (std::size_t i = 0; i < system.contacts.size(); ++i)
      least = std::min(least, system.contacts.look_around(system.chain, i).distance);
    return least;
  }
  const Vehicle& vehicle() const { return vehicle_; }

  ChainSystem system;

 private:
  Vehicle vehicle_{{.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0}};
  World world_;
  Outlines outlines_;
  Planner planner_;
  test::RandomInputs random_;
};

void expect_same_chain(const ArcChain& a, const ArcChain& b) {
  ASSERT_EQ(a.arcs.size(), b.arcs.size());
  for (std::size_t i = 0; i < a.arcs.size(); ++i) {
    EXPECT_EQ(a.arcs[i].center, b.arcs[i].center);
    EXPECT_EQ(a.arcs[i].radius, b.arcs[i].radius);
    EXPECT_EQ(a.arcs[i].entry, b.arcs[i].entry);
    EXPECT_EQ(a.arcs[i].exit, b.arcs[i].exit);
  }
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    EXPECT_EQ(a.lines[i].heading, b.lines[i].heading);
    EXPECT_EQ(a.lines[i].length, b.lines[i].length);
  }
}

void expect_ends_kept(const ArcChain& chain, const ArcChain& before) {
  EXPECT_EQ(chain.start.position(), before.start.position());
  EXPECT_EQ(chain.goal.position(), before.goal.position());
  EXPECT_EQ(chain.lines.front().heading, before.lines.front().heading);
  EXPECT_EQ(chain.lines.back().heading, before.lines.back().heading);
  for (std::size_t i = 0; i < chain.lines.size(); ++i)
    EXPECT_LT(test::residual_of(chain, i).norm(), 1e-9) << "line " << i;
}

TEST(ChainSystem, BeginsALittleBelowTheFastestSpeeds) {
  SystemCases cases(1);
  for (int i = 0; i < 10; ++i) {
    cases.begin_next();
    const ArcChain& chain = cases.system.chain;
    const SpeedProfile profile = speed_profile(test::path_of(chain), cases.vehicle());
    std::size_t joint = 0;
    for (std::size_t k = 0; k < chain.arcs.size(); ++k) {
      if (!chain.lines[k].is_tied) ++joint;
      EXPECT_NEAR(chain.arcs[k].entry, 0.9 * profile.speeds[joint] * profile.speeds[joint], 1e-9);
      ++joint;
      EXPECT_NEAR(chain.arcs[k].exit, 0.9 * profile.speeds[joint] * profile.speeds[joint], 1e-9);
    }
    EXPECT_EQ(cases.system.unit, 1.5 + cases.vehicle().safety_margin());
    EXPECT_EQ(cases.system.tightest, SideRadii(cases.vehicle()));
    EXPECT_EQ(cases.system.tensions.size(), chain.lines.size());
    for (const Vec2& tension : cases.system.tensions) EXPECT_EQ(tension, Vec2::Zero());
  }
}

TEST(ChainSystem, MovesByAShareOfAStep) {
  SystemCases cases(2);
  ChainSystem& system = cases.system;
  int moved = 0;
  for (int i = 0; i < 15; ++i) {
    cases.begin_next();
    const ArcChain before = system.chain;
    for (int k = 0; k < 20; ++k) {
      cases.make_step(0.02);
      if (!system.move(0.5)) continue;
      ++moved;
      expect_same_chain(system.chain, before);
      expect_ends_kept(system.trial, before);
      EXPECT_TRUE(system.trial.is_drivable());
      const auto half = [&](int number) { return 0.5 * part_of(system.step, number); };
      for (std::size_t a = 0; a < before.arcs.size(); ++a) {
        const Numbers& at = system.unknowns.of_arc(a);
        EXPECT_EQ(system.trial.arcs[a].radius, before.arcs[a].radius + half(at[kRadius]));
        EXPECT_EQ(system.trial.arcs[a].entry, before.arcs[a].entry + half(at[kEntry]));
        EXPECT_EQ(system.trial.arcs[a].exit, before.arcs[a].exit + half(at[kExit]));
        if (a > 0 && before.lines[a].is_tied) {
          EXPECT_EQ(system.trial.lines[a].heading, before.lines[a].heading + half(at[kHeading]));
        }
      }
      const auto length = half(system.unknowns.of_line(0)[kLength]);
      EXPECT_EQ(system.trial.lines[0].length, before.lines[0].length + length);
    }
  }
  EXPECT_GT(moved, 100);
}

TEST(ChainSystem, RefusesStepsThatLeaveNoPath) {
  SystemCases cases(3);
  ChainSystem& system = cases.system;
  cases.begin_next();
  const Numbers& arc = system.unknowns.of_arc(1);
  const ArcChain::Arc& now = system.chain.arcs[1];
  for (const auto& [number, value] :
       {std::pair(kRadius, now.radius), std::pair(kEntry, now.entry), std::pair(kExit, now.exit)}) {
    system.step.assign(system.unknowns.size(), 0.0);
    system.step[static_cast<std::size_t>(arc[number])] = -1.01 * value;
    EXPECT_FALSE(system.move(1.0)) << "number " << number;
  }
  // A first line that is driven backwards, and a turn to the wrong side.
  system.step.assign(system.unknowns.size(), 0.0);
  system.step[static_cast<std::size_t>(system.unknowns.of_line(0)[kLength])] = -1.01 * system.chain.lines[0].length;
  EXPECT_FALSE(system.move(1.0));
  for (std::size_t k = 0; k < system.chain.arcs.size(); ++k) {
    if (!system.chain.lines[k + 1].is_tied) continue;
    system.step.assign(system.unknowns.size(), 0.0);
    system.step[static_cast<std::size_t>(system.unknowns.of_arc(k)[kNextHeading])] =
        -1.01 * now.sign * system.chain.turn(k);
    const bool same_side = system.chain.arcs[k].sign == now.sign;
    if (same_side) {
      EXPECT_FALSE(system.move(1.0)) << "arc " << k;
    }
  }
}

TEST(ChainSystem, KnowsHowFarItMoves) {
  SystemCases cases(4);
  ChainSystem& system = cases.system;
  int moved = 0;
  for (int i = 0; i < 15; ++i) {
    cases.begin_next();
    system.trial = system.chain;
    EXPECT_EQ(system.movement(), 0.0);
    system.step.assign(system.unknowns.size(), 0.0);
    ASSERT_TRUE(system.move(1.0));
    EXPECT_LT(system.movement(), 1e-9);
    for (int k = 0; k < 20; ++k) {
      cases.make_step(0.05);
      if (!system.move(1.0)) continue;
      ++moved;
      const double movement = system.movement();
      double joints = 0.0, turned = 0.0;
      for (std::size_t a = 0; a < system.chain.arcs.size(); ++a) {
        for (const std::size_t line : {a, a + 1})
          joints =
              std::max(joints, (test::place_on(system.trial, a, line) - test::place_on(system.chain, a, line)).norm());
        turned = std::max(turned, std::abs(system.trial.lines[a].heading - system.chain.lines[a].heading));
      }
      EXPECT_GE(movement, joints - 1e-12);
      EXPECT_GE(movement, system.unit * turned - 1e-12);
    }
  }
  EXPECT_GT(moved, 50);
}

TEST(ChainSystem, NumbersAndValuesAreThoseOfTheParts) {
  SystemCases cases(5);
  cases.begin_next();
  const ChainSystem& system = cases.system;
  for (const Bound& bound : system.bounds) {
    EXPECT_EQ(&system.numbers_of(bound),
              bound.is_of_line() ? &system.unknowns.of_line(bound.index) : &system.unknowns.of_arc(bound.index));
    EXPECT_EQ(system.value(bound, system.chain).value,
              value_of(bound, system.chain, system.speeds.forwards, system.tightest).value);
  }
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const ChainContacts::Place place = system.contacts.look(system.chain, i);
    EXPECT_EQ(&system.numbers_at(place),
              place.part % 2 == 0 ? &system.unknowns.of_line(place.part / 2) : &system.unknowns.of_arc(place.part / 2));
  }
}

// A chain of a path in both gears, and its system. False if it cannot be closed.
bool begin_in_both_gears(test::RandomInputs& random, const Vehicle& vehicle, ChainSystem& system) {
  static const World kNothing({});
  static const Outlines kNoOutlines(kNothing);
  const Path path = test::random_gear_path(random, 1.2 * vehicle.min_turning_radius(), 8.0);
  return cut_turns(path, {3, 0.05, 72.0}, system.chain) &&
         system.begin(vehicle, vehicle.footprint(), {kNothing, kNoOutlines, 1.0});
}

TEST(ChainSystem, ClosesChainsInBothGears) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  test::RandomInputs random(9);
  ChainSystem system;
  int begun = 0, moved = 0;
  for (int i = 0; i < 60; ++i) {
    if (!begin_in_both_gears(random, vehicle, system)) continue;
    ++begun;
    EXPECT_TRUE(system.chain.is_drivable());
    const ArcChain before = system.chain;
    expect_ends_kept(system.chain, before);
    for (std::size_t k = 0; k < before.arcs.size(); ++k) {
      EXPECT_EQ(before.arcs[k].entry == 0.0, before.stops_before(k));
      EXPECT_EQ(before.arcs[k].exit == 0.0, before.stops_behind(k));
    }
    // The factors of a closing serve for other steps.
    for (int k = 0; k < 10; ++k) {
      system.step.assign(system.unknowns.size(), 0.0);
      for (std::size_t n = 0; n < system.step.size(); ++n)
        if (!system.unknowns.is_tension(n))
          system.step[n] = random.uniform(-0.02, 0.02) / std::sqrt(system.unknowns.inverse_squares()[n]);
      if (!system.move(1.0)) continue;
      ++moved;
      expect_same_chain(system.chain, before);
      expect_ends_kept(system.trial, before);
      EXPECT_TRUE(system.trial.is_drivable());
    }
  }
  EXPECT_GE(begun, 50);
  EXPECT_GE(moved, 200);
}

// In the end no radius is smaller than allowed, and no line shorter than nothing, by rounding.
TEST(ChainSystem, SettlesOnTheLimits) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  test::RandomInputs random(10);
  ChainSystem system;
  int settled = 0;
  for (int i = 0; i < 60; ++i) {
    if (!begin_in_both_gears(random, vehicle, system)) continue;
    const double smallest = system.tightest.left;
    const std::size_t tight = system.chain.arcs.size() / 2;
    system.chain.arcs[tight].radius = smallest - 1e-6;
    for (ArcChain::Line& line : system.chain.lines)
      if (!line.is_tied && line.length < 0.01) line.length = -1e-6;
    if (!system.settle()) continue;
    ++settled;
    expect_ends_kept(system.chain, system.chain);
    EXPECT_EQ(system.chain.arcs[tight].radius, smallest);
    for (const ArcChain::Arc& arc : system.chain.arcs) EXPECT_GE(arc.radius, smallest);
    for (const ArcChain::Line& line : system.chain.lines) EXPECT_GE(line.length, 0.0);
    for (std::size_t k = 0; k < system.chain.arcs.size(); ++k) EXPECT_GE(system.chain.turn(k), 0.0);
  }
  EXPECT_GE(settled, 20);
}

TEST(ResolveOverlaps, FreesMostChainsThatOverlapByLittle) {
  SystemCases cases(6);
  ChainSystem& system = cases.system;
  int overlapping = 0, freed = 0;
  for (int i = 0; i < 15; ++i) {
    cases.begin_next();
    const ArcChain free = system.chain;
    for (int k = 0; k < 40; ++k) {
      system.chain = free;
      cases.make_step(0.003);
      for (std::size_t arc = 0; arc < free.arcs.size(); ++arc)
        if (double& grow = system.step[static_cast<std::size_t>(system.unknowns.of_arc(arc)[kRadius])]; grow < 0.0)
          grow = -grow;
      if (!system.move(1.0)) continue;
      system.chain = system.trial;
      const double least = cases.least_contact();
      if (!(least < -1e-5 * system.unit && least > -0.01 * system.unit)) continue;
      ++overlapping;
      resolve_overlaps(system);
      expect_ends_kept(system.chain, free);
      EXPECT_TRUE(system.chain.is_drivable());
      const double tightest = std::ranges::min(system.chain.arcs, {}, &ArcChain::Arc::radius).radius;
      freed += tightest >= system.tightest.left && cases.least_contact() >= 0.0;
    }
  }
  EXPECT_GT(overlapping, 50);
  EXPECT_GE(freed, overlapping * 8 / 10);
}

TEST(ResolveOverlaps, LeavesFreeChainsAlone) {
  SystemCases cases(7);
  for (int i = 0; i < 10; ++i) {
    cases.begin_next();
    const ArcChain before = cases.system.chain;
    resolve_overlaps(cases.system);
    expect_same_chain(cases.system.chain, before);
  }
}

// Radii below the smallest one grow, where no line is so short that it ends the step.
TEST(ResolveOverlaps, WidensArcsThatAreTooTight) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  const World world({});
  const Outlines outlines(world);
  ChainSystem system;
  Path path{{{0, 0, 0}, 3.0, 0.0}};
  for (const auto& [length, curvature] : {std::pair{2.0, 0.5}, {6.0, 0.0}, {3.0, -0.4}, {4.0, 0.0}})
    path.push_back({path.back().end(), length, curvature});
  const CircleChain circles = chain_of(path, path.front().start, path.back().end()).value();
  ASSERT_TRUE(cut_turns(circles, lines_of(circles).value(), {3, 0.05, 72.0}, system.chain));
  ASSERT_TRUE(system.begin(vehicle, vehicle.footprint(), {world, outlines, 1.0}));
  const ArcChain before = system.chain;
  for (const std::size_t arc : {1u, 4u}) system.chain.arcs[arc].radius = system.tightest.left - 0.01;
  ASSERT_TRUE(system.chain.join());
  resolve_overlaps(system);
  expect_ends_kept(system.chain, before);
  for (std::size_t arc = 0; arc < before.arcs.size(); ++arc) {
    EXPECT_GE(system.chain.arcs[arc].radius, system.tightest.left);
    // By little more than needed.
    if (arc == 1 || arc == 4) {
      EXPECT_NEAR(system.chain.arcs[arc].radius, system.tightest.left, 1e-3 * system.unit);
    }
  }
}

// A line of next to nothing is scaled by its length, so that it is hardly in the way of a step.
TEST(ResolveOverlaps, WidensArcsBesideShortLines) {
  SystemCases cases(8);
  ChainSystem& system = cases.system;
  int tried = 0, widened = 0;
  for (int i = 0; i < 10; ++i) {
    cases.begin_next();
    const auto tightest_radius = [&] { return std::ranges::min(system.chain.arcs, {}, &ArcChain::Arc::radius).radius; };
    std::ranges::min_element(system.chain.arcs, {}, &ArcChain::Arc::radius)->radius = system.tightest.left - 0.0075;
    if (!system.chain.join() || !system.chain.is_drivable()) continue;
    ++tried;
    resolve_overlaps(system);
    EXPECT_TRUE(system.chain.is_drivable());
    widened += tightest_radius() >= system.tightest.left;
  }
  EXPECT_GE(tried, 5);
  EXPECT_GE(widened, tried - 1);
}

}  // namespace
}  // namespace arcway::internal
