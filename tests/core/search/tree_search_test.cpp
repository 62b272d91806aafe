#include "core/search/tree_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/geometry/angle.h"
#include "core/planner.h"
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"

namespace arcway {
namespace {

// A motion of the plane: scaled, perhaps mirrored, turned, shifted.
struct Variant {
  const char* name;
  double scale, turn;
  bool mirrored;
  Vec2 shift;
  [[nodiscard]] Vec2 operator()(const Vec2& p) const {
    const Vec2 q = scale * Vec2(p.x(), mirrored ? -p.y() : p.y());
    return std::cos(turn) * q + std::sin(turn) * perpendicular(q) + shift;
  }
  [[nodiscard]] Pose operator()(const Pose& pose) const {
    const Vec2 p = (*this)(pose.position());
    return {p.x(), p.y(), (mirrored ? -pose.heading : pose.heading) + turn};
  }
};

struct NarrowQuery {
  const char* name;
  VehicleParameters vehicle;
  std::vector<Ring> obstacles;
  Ring bounds;
  Pose start, goal;
};

Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

VehicleParameters car() {
  return {.length = 4.5,
          .width = 1.8,
          .wheelbase = 2.7,
          .max_steering_angle = 0.55,
          .max_speed = 2.5,
          .turn_speed = ConstantTurnSpeed{1.5},
          .max_acceleration = 1.0,
          .safety_margin = 0.01};
}

VehicleParameters bus() {
  return {.length = 12.0,
          .width = 2.55,
          .wheelbase = 6.0,
          .max_steering_angle = 0.7,
          .max_speed = 8.0,
          .turn_speed = ConstantTurnSpeed{3.0},
          .max_acceleration = 1.0,
          .safety_margin = 0.05};
}

std::vector<NarrowQuery> narrow_queries() {
  return {
      {"bus pulls up 20 cm from a kerb",
       bus(),
       {box(-60.0, -4.0, 200.0, -1.475)},
       box(-60.0, -4.0, 200.0, 12.0),
       {0.0, 3.5, 0.0},
       {80.0, 0.0, 0.0}},
      {"bus pulls out",
       bus(),
       {box(-60.0, -4.0, 200.0, -1.475)},
       box(-60.0, -4.0, 200.0, 12.0),
       {0.0, 0.0, 0.0},
       {80.0, 3.5, 0.0}},
      {"car leaves a wall at 2 cm",
       car(),
       {box(-30.0, -3.0, 80.0, -0.92)},
       box(-30.0, -3.0, 80.0, 15.0),
       {0.0, 0.0, 0.0},
       {40.0, 3.0, 0.0}},
      {"car pulls up 15 cm from a kerb within 20 m",
       car(),
       {box(-30.0, -3.0, 80.0, -1.05)},
       box(-30.0, -3.0, 80.0, 15.0),
       {0.0, 3.0, 0.0},
       {20.0, 0.0, 0.0}},
      {"car turns round in a hall of 12.3 m",
       car(),
       {box(-80.0, 6.15, 20.0, 9.15), box(-80.0, -9.15, 20.0, -6.15), box(18.0, -6.15, 20.0, 6.15)},
       box(-80.0, -9.15, 20.0, 9.15),
       {-50.0, 0.0, 0.0},
       {-55.0, 0.0, kPi}},
  };
}

VehicleParameters scaled(VehicleParameters v, double by) {
  for (double* length : {&v.length, &v.width, &v.wheelbase, &v.max_speed, &v.max_acceleration, &v.safety_margin})
    *length *= by;
  v.turn_speed = ConstantTurnSpeed{by * std::get<ConstantTurnSpeed>(v.turn_speed).speed};
  return v;
}

Planner planner_of(const NarrowQuery& query, const Variant& variant) {
  const auto moved = [&](Ring ring) {
    std::ranges::transform(ring, ring.begin(), variant);
    if (variant.mirrored) std::ranges::reverse(ring);
    return ring;
  };
  std::vector<Polygon> obstacles;
  for (const Ring& ring : query.obstacles) obstacles.push_back({moved(ring), {}});
  return {World(std::move(obstacles), moved(query.bounds)), Vehicle(scaled(query.vehicle, variant.scale))};
}

class NarrowWays : public testing::TestWithParam<Variant> {};

TEST_P(NarrowWays, AreFoundForwards) {
  for (const NarrowQuery& query : narrow_queries()) {
    SCOPED_TRACE(query.name);
    const Planner planner = planner_of(query, GetParam());
    const PlanResult result = planner.plan({.start = GetParam()(query.start), .goal = GetParam()(query.goal)});
    EXPECT_TRUE(result.solved()) << result.reason;
    if (result.solved()) test::expect_valid(planner, result);
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, NarrowWays,
                         testing::Values(Variant{"plain", 1.0, 0.0, false, {0.0, 0.0}},
                                         Variant{"turned", 1.0, 37.0 * kPi / 180.0, false, {0.0, 0.0}},
                                         Variant{"mirrored", 1.0, 0.0, true, {0.0, 0.0}},
                                         Variant{"mirrored_and_turned", 1.0, 2.0, true, {0.0, 0.0}},
                                         Variant{"moved", 1.0, 0.0, false, {1e6, -1e6}},
                                         Variant{"turned_and_moved", 1.0, 37.0 * kPi / 180.0, false, {-1e6, 1e6}},
                                         Variant{"small", 0.1, 1.0, false, {0.0, 0.0}},
                                         Variant{"large", 7.0, 1.0, false, {0.0, 0.0}}),
                         [](const auto& param_info) { return std::string(param_info.param.name); });

// No motion leads out of a bay that is as long as the body: the trees run dry.
TEST(TreeSearch, EndsWhereNothingLeadsOn) {
  const NarrowQuery query{"shut in",
                          car(),
                          {box(3.75, -1.0, 5.0, 1.0), box(-2.0, -3.0, 5.0, -1.0), box(-2.0, 1.0, 5.0, 3.0)},
                          box(-10.0, -10.0, 30.0, 10.0),
                          {0.0, 0.0, 0.0},
                          {20.0, 0.0, 0.0}};
  const Planner planner = planner_of(query, {"plain", 1.0, 0.0, false, {0.0, 0.0}});
  const PlanResult result = planner.plan({.start = query.start, .goal = query.goal});
  EXPECT_EQ(result.status, PlanStatus::kStartBlocked) << result.reason;
}

TEST(TreeSearch, CanBeStopped) {
  const NarrowQuery query = narrow_queries().back();
  const Planner planner = planner_of(query, {"plain", 1.0, 0.0, false, {0.0, 0.0}});
  std::stop_source stopped;
  stopped.request_stop();
  const PlanResult result = planner.plan({.start = query.start, .goal = query.goal}, {.stop = stopped.get_token()});
  EXPECT_EQ(result.status, PlanStatus::kCancelled);
}

}  // namespace
}  // namespace arcway
