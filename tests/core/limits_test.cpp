#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "arcway/alternatives.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/planner.h"
#include "arcway/tour.h"
#include "tests/support/plans.h"
#include "tests/support/stopping_queries.h"

namespace arcway::internal {
namespace {

using test::expect_same_plan;
using test::expect_valid;
using test::StoppingQueries;

// Number of queries that may follow a stop: those of one iteration of a loop. An iteration is a maneuver pose, a gear
// motion, one change of a path, or the complete paths that are left on the open list.
constexpr std::size_t kMostAfterStop = 250;
constexpr std::size_t kStops = 40;  // tried in each case, over the whole query

struct StoppedCase {
  std::string name;
  World world;
  Vehicle vehicle;
  PlanRequest request;
  PlanStatus status;  // without a stop
};

World room(std::vector<Polygon> obstacles, double width, double height) {
  return World(std::move(obstacles), Ring{{0, 0}, {width, 0}, {width, height}, {0, height}});
}

// Cases that go through the stages of a query.
std::vector<StoppedCase> cases() {
  std::vector<StoppedCase> all;
  const World clutter =
      random_world({.kind = ClutterKind::kMixed, .obstacles = 30, .vertices = 6, .fill = 0.25, .seed = 5});
  const auto queries =
      random_queries(clutter, make_reference_queries(clutter), Vehicle{}, {.count = 1, .min_distance = 0.6});
  const auto [start, goal] = std::pair(queries[0].start, queries[0].goal);
  constexpr PlanStatus kSolved = PlanStatus::kSolved;
  all.push_back({"clutter", clutter, Vehicle{}, {start, goal}, kSolved});
  all.push_back({"clutter, both gears", clutter, Vehicle{}, {.start = start, .goal = goal, .reverse = true}, kSolved});
  VehicleParameters wide;
  wide.turn_speed = LateralAccelerationLimit{0.5};
  all.push_back({"clutter, several radii", clutter, Vehicle(wide), {start, goal}, kSolved});
  // The goal lies in a box with a wall around it.
  const Polygon cell{{{20, 20}, {40, 20}, {40, 40}, {20, 40}}, {{{24, 24}, {24, 36}, {36, 36}, {36, 24}}}};
  all.push_back({"no passage", room({cell}, 60, 60), Vehicle{}, {{5, 5, 0}, {30, 30, 0}}, PlanStatus::kNoPassage});
  // A dead end that is left backwards only.
  const Polygon u_shape{{{20, 20}, {32, 20}, {32, 21}, {21, 21}, {21, 23}, {32, 23}, {32, 24}, {20, 24}}, {}};
  all.push_back(
      {"dead end", room({u_shape}, 60, 60), Vehicle{}, {{22.5, 22, kPi}, {5, 5, 0}}, PlanStatus::kStartBlocked});
  all.push_back({"dead end, both gears",
                 room({u_shape}, 60, 60),
                 Vehicle{},
                 {.start = {22.5, 22, kPi}, .goal = {5, 5, 0}, .reverse = true},
                 kSolved});
  return all;
}

// Calls check(stop, question) for stops spread over the questions of a query.
void at_many_stops(StoppingQueries& stopping, std::size_t questions,
                   const std::function<void(std::stop_token, std::size_t)>& check) {
  const std::size_t stops = std::min(kStops, questions);
  for (std::size_t k = 0; k < stops; ++k) {
    const std::size_t question = 1 + k * questions / stops;
    check(stopping.stop_at(question), question);
  }
}

TEST(Limits, AQueryEndsSoonAfterAStopWhereverThatComes) {
  for (const StoppedCase& c : cases()) {
    SCOPED_TRACE(c.name);
    for (const GraphMode mode : {GraphMode::kEager, GraphMode::kLazy}) {
      StoppingQueries stopping(c.world);
      const Planner planner(c.world, c.vehicle, backend_of(c.world, stopping.queries()), {.graph_mode = mode});
      const auto plan_with = [&](std::size_t question) {
        return planner.plan(c.request, {.stop = stopping.stop_at(question)});
      };
      // Where a planner keeps what it finds out, the second query asks less.
      (void)plan_with(StoppingQueries::kNever);
      const PlanResult whole = plan_with(StoppingQueries::kNever);
      EXPECT_EQ(whole.status, c.status);
      EXPECT_FALSE(whole.interrupted);
      at_many_stops(stopping, stopping.asked(), [&](const std::stop_token& stop, std::size_t question) {
        SCOPED_TRACE("stopped at question " + std::to_string(question));
        const PlanResult result = planner.plan(c.request, {.stop = stop});
        EXPECT_LE(stopping.asked_after_stop(), kMostAfterStop);
        EXPECT_TRUE(result.interrupted || result.status == whole.status);
        if (result.solved()) {
          expect_valid(planner, result, c.request.reverse);
        } else if (result.interrupted) {
          EXPECT_EQ(result.status, PlanStatus::kCanceled);
        }
      });
    }
  }
}

TEST(Limits, AStoppedQueryLeavesNoTraceInThePlanner) {
  for (const StoppedCase& c : cases()) {
    SCOPED_TRACE(c.name);
    StoppingQueries stopping(c.world);
    const auto make = [&] {
      return Planner(c.world, c.vehicle, backend_of(c.world, stopping.queries()), {.graph_mode = GraphMode::kLazy});
    };
    const Planner fresh = make();
    const PlanResult whole = fresh.plan(c.request, {.stop = stopping.stop_at(StoppingQueries::kNever)});
    const std::size_t questions = stopping.asked();
    for (std::size_t k = 0; k < 8; ++k) {
      const Planner planner = make();
      const std::size_t question = 1 + k * questions / 8;
      SCOPED_TRACE("stopped at question " + std::to_string(question));
      (void)planner.plan(c.request, {.stop = stopping.stop_at(question)});
      EXPECT_LE(stopping.asked_after_stop(), kMostAfterStop);
      expect_same_plan(planner.plan(c.request, {.stop = stopping.stop_at(StoppingQueries::kNever)}), whole);
    }
  }
}

TEST(Limits, ToursAndAlternativesEndSoonAfterAStop) {
  const Polygon block{{{25, 20}, {35, 20}, {35, 45}, {25, 45}}, {}};
  const StoppedCase c{"hall", room({block}, 60, 60), Vehicle{}, {{10, 30, 0}, {50, 30, 0}}, PlanStatus::kSolved};
  StoppingQueries stopping(c.world);
  const Planner planner(c.world, c.vehicle, backend_of(c.world, stopping.queries()));
  const TourRequest tour{.start = c.request.start, .goals = {{c.request.goal.position()}}};
  const auto count = [&](const auto& work) {
    work(stopping.stop_at(StoppingQueries::kNever));
    at_many_stops(stopping, stopping.asked(), [&](const std::stop_token& stop, std::size_t question) {
      SCOPED_TRACE("stopped at question " + std::to_string(question));
      work(stop);
      EXPECT_LE(stopping.asked_after_stop(), kMostAfterStop);
    });
  };
  count([&](const std::stop_token& stop) {
    const Tour done = plan_tour(planner, tour, {.stop = stop});
    if (done.plan.solved()) expect_valid(planner, done.plan);
  });
  count([&](const std::stop_token& stop) {
    for (const PlanResult& plan : plan_alternatives(planner, c.request, 2, {.stop = stop}))
      if (plan.solved()) expect_valid(planner, plan);
  });
}

TEST(Limits, ABoundProvedByTheTimeOfAStopHolds) {
  const StoppedCase c = cases().front();
  StoppingQueries stopping(c.world);
  const Planner planner(c.world, c.vehicle, backend_of(c.world, stopping.queries()));
  const PlanResult whole = planner.plan(c.request, {.stop = stopping.stop_at(StoppingQueries::kNever)});
  const std::size_t questions = stopping.asked();
  at_many_stops(stopping, questions, [&](const std::stop_token& stop, std::size_t) {
    const PlanResult result = planner.plan(c.request, {.stop = stop});
    EXPECT_LE(result.lower_bound, whole.lower_bound * (1.0 + 1e-12));
    EXPECT_GT(result.lower_bound, 0.0);
  });
}

}  // namespace
}  // namespace arcway::internal
