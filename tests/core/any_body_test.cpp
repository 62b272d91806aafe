#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "accel/backend/make_queries.h"
#include "arcway/angle.h"
#include "arcway/backend.h"
#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "arcway/query_set.h"
#include "arcway/validation.h"
#include "core/collision/memoized_sweep.h"
#include "core/collision/walled_sweep.h"
#include "core/motion/clearance.h"
#include "core/planner/collision.h"
#include "tests/support/boxes.h"
#include "tests/support/mirrored.h"
#include "tests/support/random_bodies.h"

namespace arcway::internal {
namespace {

constexpr double kStep = 0.02;  // travel between two poses that are looked at [m]

Clutter clutter_of(std::uint64_t seed) {
  return generate_clutter({.kind = ClutterKind::kMixed, .obstacles = 30, .vertices = 7, .fill = 0.3, .seed = seed});
}

// Least distance from all boundaries along a motion, up to half a step of the body's travel; 0 where it is swallowed.
long double sampled_distance(const World& world, const Vehicle& vehicle, const PathSegment& motion) {
  const double travel = motion.length * (1.0 + 3.0 * std::abs(motion.curvature));
  const int count = std::max(1, static_cast<int>(std::ceil(travel / kStep)));
  long double least = INFINITY;
  for (int k = 0; k <= count; ++k) {
    const test::PlacedBody placed(vehicle.outline(), motion.at(motion.length * k / count));
    if (k == 0 && placed.is_swallowed_by(world)) return 0.0L;
    least = std::min(least, placed.distance_to(world));
  }
  return least;
}

void expect_as_sampled(bool is_free, long double distance, const char* what, int i) {
  if (is_free)
    EXPECT_GT(distance, 0.0L) << what << i;
  else
    EXPECT_LE(distance, 0.5L * kStep + 1e-9L) << what << i;
}

class AnyBody : public ::testing::Test {
 protected:
  Pose pose() {
    const Vec2 span = world_.box().max - world_.box().min;
    const Vec2 p = world_.box().min + random_.point(0.02, 0.98).cwiseProduct(span);
    return {p.x(), p.y(), random_.integer(0, 3) == 0 ? 0.5 * kPi : random_.uniform(-kPi, kPi)};
  }

  Clutter clutter_ = clutter_of(4);
  World world_{clutter_.obstacles, clutter_.bounds};
  QuerySet reference_ = make_reference_queries(world_), embree_ = make_embree_queries(world_);
  test::RandomInputs random_{21};
};

// Lines, poses and arcs of many bodies against poses along the motion, and Embree against the reference.
TEST_F(AnyBody, IsDecidedAsByDensePoses) {
  int free_lines = 0, free_arcs = 0;
  HeadingSet memory;
  for (int i = 0; i < 250; ++i) {
    const Vehicle vehicle = test::random_body_vehicle(random_);
    const Body body = vehicle.body();
    ASSERT_NE(body.shape, nullptr);
    const Pose from = pose();
    const double length = i % 3 == 0 ? 0.0 : random_.uniform(0.0, 3.0);
    const bool line = reference_.sweep->straight_free({from, length, body});
    EXPECT_EQ(embree_.sweep->straight_free({from, length, body}), line);
    expect_as_sampled(line, sampled_distance(world_, vehicle, {from, length, 0.0}), "line ", i);
    free_lines += line;

    const Side side = i % 2 == 0 ? Side::kLeft : Side::kRight;
    const double radius = random_.uniform(0.3, 3.0), angle = random_.uniform(0.05, 2.0);
    const Vec2 center = from.position() + sign_of(side) * radius * perpendicular(direction_of(from.heading));
    const TurningBody turning{center, radius, side, body};
    const bool arc = reference_.sweep->arc_free(turning, from.heading, angle, memory);
    EXPECT_EQ(embree_.sweep->arc_free(turning, from.heading, angle, memory), arc) << i;
    const PathSegment motion{from, radius * angle, sign_of(side) / radius};
    expect_as_sampled(arc, sampled_distance(world_, vehicle, motion), "arc ", i);
    free_arcs += arc;
  }
  EXPECT_GT(free_lines, 50);
  EXPECT_LT(free_lines, 200);
  EXPECT_GT(free_arcs, 25);
}

TEST_F(AnyBody, HasTheSameHeadingsInBothQueries) {
  HeadingSet memory;
  for (int i = 0; i < 500; ++i) {
    const Vehicle vehicle = test::random_body_vehicle(random_);
    const double radius = std::exp(random_.uniform(-1.0, 3.0));
    const TurningBody turning{pose().position(), radius, i % 2 == 0 ? Side::kLeft : Side::kRight,
                              vehicle.body(0.5 * vehicle.safety_margin())};
    const HeadingSet all = reference_.sweep->free_headings(turning), other = embree_.sweep->free_headings(turning);
    ASSERT_EQ(all.intervals().size(), other.intervals().size());
    for (std::size_t k = 0; k < all.intervals().size(); ++k) {
      EXPECT_EQ(all.intervals()[k].low, other.intervals()[k].low);
      EXPECT_EQ(all.intervals()[k].high, other.intervals()[k].high);
    }
    for (int k = 0; k < 30; ++k) {
      const double heading = random_.uniform(-kPi, kPi);
      for (const Side towards : {Side::kLeft, Side::kRight})
        EXPECT_EQ(embree_.sweep->reach(turning, heading, towards, memory), all.reach(heading, towards));
      const bool near_an_end = std::ranges::any_of(all.intervals(), [&](const HeadingInterval& interval) {
        return std::abs(wrap_signed(heading - interval.low)) < 1e-6 ||
               std::abs(wrap_signed(heading - interval.high)) < 1e-6;
      });
      if (near_an_end) continue;
      const Vec2 p = turning.center - sign_of(turning.side) * radius * perpendicular(direction_of(heading));
      EXPECT_EQ(all.contains(heading), reference_.sweep->straight_free({{p.x(), p.y(), heading}, 0.0, turning.body}));
    }
  }
}

// A rectangle that is given as a polygon is no polygon any more.
TEST_F(AnyBody, ARectangleIsOneHoweverItIsGiven) {
  const Vehicle plain;
  const Footprint box = plain.footprint();
  VehicleParameters parameters;
  parameters.footprint = {test::reversed(test::box_ring(-box.rear, -box.right, box.front, box.left))};
  const Vehicle polygon(parameters);
  EXPECT_EQ(polygon.shape(), nullptr);
  for (const double growth : {0.0, 0.0005, 0.001, 0.1}) {
    const Footprint one = plain.footprint(growth), two = polygon.footprint(growth);
    EXPECT_EQ(one.front, two.front);
    EXPECT_EQ(one.rear, two.rear);
    EXPECT_EQ(one.left, two.left);
    EXPECT_EQ(one.right, two.right);
    EXPECT_EQ(polygon.body(growth).shape, nullptr);
  }
}

TEST_F(AnyBody, MirroredInAMirroredWorldHasTheSameAnswers) {
  const World other(test::mirrored(clutter_.obstacles), test::mirrored(clutter_.bounds));
  const QuerySet queries = make_reference_queries(other);
  HeadingSet memory;
  for (int i = 0; i < 300; ++i) {
    VehicleParameters parameters;
    parameters.footprint = test::random_footprint(random_);
    const Vehicle vehicle(parameters);
    for (Ring& ring : parameters.footprint) ring = test::mirrored(ring);
    const Vehicle flipped(parameters);
    const Pose from = pose(), to = test::mirrored(from);
    const double length = random_.uniform(0.0, 3.0), radius = random_.uniform(0.5, 3.0);
    EXPECT_EQ(reference_.sweep->straight_free({from, length, vehicle.body(0.01)}),
              queries.sweep->straight_free({to, length, flipped.body(0.01)}));
    const HeadingSet one =
        reference_.sweep->free_headings(TurningBody{from.position(), radius, Side::kLeft, vehicle.body(0.01)});
    const HeadingSet two =
        queries.sweep->free_headings(TurningBody{to.position(), radius, Side::kRight, flipped.body(0.01)});
    double sum = 0.0;
    for (const HeadingInterval& interval : one.intervals()) sum += interval.high - interval.low;
    for (const HeadingInterval& interval : two.intervals()) sum -= interval.high - interval.low;
    EXPECT_NEAR(sum, 0.0, 1e-6);
  }
}

// Clearance on lines, arcs and poses against dense poses.
TEST_F(AnyBody, HasTheClearanceOfDensePoses) {
  const Outlines outlines(world_);
  for (int i = 0; i < 400; ++i) {
    const Vehicle vehicle = test::random_body_vehicle(random_);
    const double curvature = i % 2 == 0 ? 0.0 : random_.uniform(-1.0, 1.0);
    const PathSegment motion{pose(), i % 5 == 0 ? 0.0 : random_.uniform(0.1, 1.5), curvature};
    if (test::PlacedBody(vehicle.outline(), motion.start).is_swallowed_by(world_)) continue;
    const Clearance found = clearance_along(motion, vehicle.body(), world_);
    if (found.distance == 0.0 && i % 8 != 0) continue;  // most are in contact
    const auto sampled = static_cast<double>(sampled_distance(world_, vehicle, motion));
    EXPECT_LE(found.distance, sampled + 1e-9) << i;
    EXPECT_GE(found.distance, sampled - 0.5 * kStep - 1e-9) << i;
    EXPECT_EQ(clearance_below(1e9, motion, vehicle.body(), outlines), found.distance);
    const auto there =
        static_cast<double>(test::PlacedBody(vehicle.outline(), motion.at(found.arc_length)).distance_to(world_));
    EXPECT_NEAR(there, found.distance, 1e-7) << i;
  }
}

// The validator decides on the bare body: it agrees with the query about it, but for contacts of rounding.
TEST_F(AnyBody, IsValidatedAsTheQueryDecides) {
  const Validator validate(world_);
  int collisions = 0;
  for (int i = 0; i < 300; ++i) {
    const Vehicle vehicle = test::random_body_vehicle(random_);
    const double curvature = i % 2 == 0 ? 0.0 : random_.uniform(-0.7, 0.7);
    PathSegment motion{pose(), random_.uniform(0.1, 2.5), curvature};
    if (i % 4 == 0) motion.gear = Gear::kReverse;
    ValidationOptions options;
    options.reverse = true;
    const ValidationReport report = validate(vehicle, motion.start, motion.end(), {{motion}, {}, {}, {}}, options);
    const PathSegment forwards = motion.gear == Gear::kReverse ? motion.reversed() : motion;
    const long double distance = sampled_distance(world_, vehicle, forwards);
    expect_as_sampled(report.valid(), distance, "motion ", i);
    collisions += !report.valid();
    if (!report.valid()) continue;
    EXPECT_NEAR(report.min_clearance, static_cast<double>(distance), 0.5 * kStep + 1e-5);
  }
  EXPECT_GT(collisions, 60);
  EXPECT_LT(collisions, 280);
}

TEST_F(AnyBody, IsRememberedByItsShape) {
  const MemoizedSweep memoized(reference_.sweep);
  std::vector<Vehicle> vehicles;
  for (int i = 0; i < 20; ++i) vehicles.push_back(test::random_body_vehicle(random_));
  std::vector<Pose> poses;
  for (int i = 0; i < 20; ++i) poses.push_back(pose());
  for (int round = 0; round < 2; ++round) {
    for (const Vehicle& vehicle : vehicles) {
      for (const Pose& from : poses) {
        const StraightBody line{from, 0.5, vehicle.body()};
        EXPECT_EQ(memoized.straight_free(line), reference_.sweep->straight_free(line));
        const TurningBody turning{from.position(), 2.0, Side::kLeft, vehicle.body()};
        EXPECT_EQ(memoized.free_headings(turning).intervals().size(),
                  reference_.sweep->free_headings(turning).intervals().size());
      }
    }
  }
}

// Walls have the answers of a world that has them as thin obstacles.
TEST_F(AnyBody, DoesNotPassWalls) {
  const Vehicle vehicle([] {
    VehicleParameters parameters;
    parameters.footprint = {test::square(0, -1, 1), test::square(0, 1, 1)};
    return parameters;
  }());
  const World open({});
  const WalledSweep sweep(make_reference_queries(open).sweep, {LineSegment{{3, 0.1}, {4, 0.9}}});
  EXPECT_TRUE(sweep.straight_free({{0, 0, 0}, 5.0, vehicle.body(0.05)}));  // between the parts
  EXPECT_FALSE(sweep.straight_free({{0, 0, 0}, 5.0, vehicle.body(0.15)}));
  EXPECT_FALSE(sweep.straight_free({{0, 0.5, 0}, 5.0, vehicle.body()}));
  EXPECT_TRUE(sweep.straight_free({{0, 0.5, 0}, 1.5, vehicle.body()}));
}

// Cut corners, tines and two parts, all within the body of the paper's robot.
std::vector<Vehicle> slimmer_bodies() {
  const std::vector<std::vector<Ring>> footprints = {
      {{{-0.1, 0}, {0.2, -0.4}, {1.1, -0.4}, {1.4, 0}, {1.1, 0.4}, {0.2, 0.4}}},
      {{{-0.1, -0.4},
        {0.8, -0.4},
        {0.8, -0.3},
        {1.4, -0.3},
        {1.4, -0.15},
        {0.8, -0.15},
        {0.8, 0.15},
        {1.4, 0.15},
        {1.4, 0.3},
        {0.8, 0.3},
        {0.8, 0.4},
        {-0.1, 0.4}}},
      {test::box_ring(-0.1, -0.4, 0.4, 0.4), test::box_ring(0.9, -0.3, 1.4, 0.4)}};
  std::vector<Vehicle> vehicles;
  for (const std::vector<Ring>& footprint : footprints) {
    VehicleParameters parameters;
    parameters.footprint = footprint;
    vehicles.emplace_back(parameters);
  }
  return vehicles;
}

TEST_F(AnyBody, IsPlannedForAsOftenAsWhatBoundsIt) {
  const Validator validate(world_);
  const Backend backend = reference_backend(world_);
  const Planner rectangle(world_, Vehicle{}, backend);
  std::vector<PlanRequest> requests;
  std::size_t bounded = 0;
  for (int i = 0; i < 25; ++i) {
    requests.push_back({pose(), pose()});
    bounded += rectangle.plan(requests.back()).solved();
  }
  EXPECT_GT(bounded, 4u);
  for (const Vehicle& vehicle : slimmer_bodies()) {
    const Planner planner(world_, vehicle, backend);
    std::size_t solved = 0;
    for (const PlanRequest& request : requests) {
      const PlanResult plan = planner.plan(request);
      if (!plan.solved()) continue;
      ++solved;
      const ValidationReport report = validate(vehicle, request.start, request.goal, plan.timed_path());
      EXPECT_TRUE(report.valid()) << to_string(report);
      EXPECT_NEAR(report.min_clearance, plan.min_clearance, 1e-5);
    }
    EXPECT_GE(solved, bounded);
  }
}

TEST_F(AnyBody, ARectangleGivenAsAPolygonHasTheSamePlans) {
  VehicleParameters parameters;
  const Footprint box = Vehicle{}.footprint();
  parameters.footprint = {test::box_ring(-box.rear, -box.right, box.front, box.left)};
  const Backend backend = reference_backend(world_);
  const Planner plain(world_, Vehicle{}, backend), polygon(world_, Vehicle(parameters), backend);
  int solved = 0;
  for (int i = 0; i < 15; ++i) {
    const PlanRequest request{pose(), pose()};
    const PlanResult one = plain.plan(request), two = polygon.plan(request);
    EXPECT_EQ(one.status, two.status);
    EXPECT_EQ(one.travel_time, two.travel_time);
    EXPECT_EQ(one.length, two.length);
    solved += one.solved();
  }
  EXPECT_GT(solved, 2);
}

// The body straddles a wall between two lanes that are narrower than what bounds it: no proof may say otherwise.
TEST(AnyBodyBetweenWalls, IsNotProvedToBeTooWide) {
  VehicleParameters parameters;
  parameters.footprint = {test::box_ring(-0.7, -1.0, 0.8, -0.5), test::box_ring(-0.7, 0.5, 0.8, 1.0)};
  const Vehicle vehicle(parameters);
  const World world({test::box(5, -0.4, 15, 0.4), test::box(5, 1.1, 15, 4), test::box(5, -4, 15, -1.1)},
                    test::box_ring(0, -4, 20, 4));
  const PlanRequest request{{2, 0, 0}, {18, 0, 0}};
  const Planner planner(world, vehicle, reference_backend(world));
  const PlanResult plan = planner.plan(request);
  ASSERT_TRUE(plan.solved()) << to_string(plan);
  EXPECT_TRUE(validate(world, vehicle, request.start, request.goal, plan.timed_path(), {}).valid());
  const PlanResult beside = planner.plan({{2, 0, 0}, {10, 0, 0}});  // the goal is between the walls
  EXPECT_TRUE(beside.solved()) << to_string(beside);
  // Lanes that no disc in the body passes.
  const World narrow({test::box(5, -0.6, 15, 0.6), test::box(5, 1.0, 15, 4), test::box(5, -4, 15, -1.0)},
                     test::box_ring(0, -4, 20, 4));
  const PlanResult none = Planner(narrow, vehicle, reference_backend(narrow)).plan(request);
  EXPECT_EQ(none.status, PlanStatus::kNoPassage) << to_string(none);
}

// An obstacle in a notch, or between parts, is free; a part wholly inside of one is not, wherever F is.
TEST(AnyBodyAndOnePole, DependsOnWhatTheBodyTouches) {
  const Ring notched{{-1, -1}, {2, -1}, {2, -0.5}, {0, -0.5}, {0, 0.5}, {2, 0.5}, {2, 1}, {-1, 1}};
  VehicleParameters parameters;
  parameters.footprint = {notched};
  const Vehicle notch(parameters);
  parameters.footprint = {test::square(1, 1, 0.5), test::square(1, -1.5, 0.5)};
  const Vehicle apart(parameters);  // F lies off the body
  const World pole({test::box(0.9, -0.2, 1.3, 0.2)}), around_f({test::box(-0.3, -0.3, 0.3, 0.3)});
  const World block({test::box(0.5, 0.5, 9, 9)}), wall({test::box(-9, -9, 9, 9)});
  for (const auto make : {make_reference_queries, +[](const World& world) { return make_embree_queries(world); }}) {
    EXPECT_TRUE(make(pole).sweep->straight_free({{0, 0, 0}, 0.5, notch.body()}));
    EXPECT_FALSE(make(pole).sweep->straight_free({{0, 0, 0}, 1.0, notch.body()}));
    EXPECT_FALSE(make(pole).sweep->straight_free({{0, 0, 0}, 0.0, notch.footprint()}));  // the bounding rectangle
    EXPECT_TRUE(make(around_f).sweep->straight_free({{0, 0, 0}, 3.0, apart.body()}));
    EXPECT_TRUE(make(around_f).sweep->free_headings(TurningBody{{0, 0}, 1e-3, Side::kLeft, apart.body()}).is_full());
    EXPECT_FALSE(make(block).sweep->straight_free({{0, 0, 0}, 0.0, apart.body()}));  // one of the parts is inside
    EXPECT_FALSE(make(wall).sweep->straight_free({{0, 0, 0}, 0.0, apart.body()}));
    EXPECT_TRUE(make(wall).sweep->free_headings(TurningBody{{0, 0}, 1.0, Side::kLeft, notch.body()}).empty());
  }
}

// Sides of the body cross no edge of an obstacle that lies in it.
TEST(AnyBodyAndOnePole, CoversWhatLiesInIt) {
  VehicleParameters parameters;
  parameters.footprint = {{{2, 0}, {1, 1}, {0, 0}, {1, -1}}};
  const Vehicle vehicle(parameters);
  const World pebble({test::box(2.99, 0.99, 3.01, 1.01)});
  const TurningBody turning{{3, 2}, 2.0, Side::kLeft, vehicle.body()};
  for (const auto make : {make_reference_queries, +[](const World& world) { return make_embree_queries(world); }}) {
    const HeadingSet free = make(pebble).sweep->free_headings(turning);
    for (double heading = 0.0; heading < kTwoPi; heading += 0.01) {
      const Vec2 p = turning.center - 2.0 * perpendicular(direction_of(heading));
      const test::PlacedBody placed(vehicle.outline(), {p.x(), p.y(), heading});
      EXPECT_EQ(free.contains(heading), placed.distance_to(pebble) > 0.0L) << heading;
    }
    EXPECT_FALSE(make(pebble).sweep->straight_free({{2, 1, 0}, 0.0, vehicle.body()}));
  }
}

TEST(AnyBodyAndOnePole, TheValidatorSeesPartsInObstaclesAndWallsPassedThrough) {
  const auto issues = [](const World& world, const Vehicle& vehicle, const PathSegment& motion) {
    return validate(world, vehicle, motion.start, motion.end(), {{motion}, {}, {}, {}}, {}).issues;
  };
  VehicleParameters parameters;
  parameters.footprint = {test::square(1, -1.5, 0.5), test::square(1, 1, 0.5)};
  const Vehicle apart(parameters);
  const World block({test::box(0.5, 0.5, 9, 9)});
  EXPECT_EQ(issues(block, apart, {{0, 0, 0}, 0.1, 0.0}).size(), 1u);
  EXPECT_TRUE(issues(block, apart, {{0, -2, 0}, 0.1, 0.0}).empty());
  // A small body drives through a long wall: no join of the wall's first and last place touches it.
  parameters.footprint = {{{0.1, 0.0}, {0.0, 0.1}, {-0.1, 0.0}}};
  const Vehicle small(parameters);
  const World wall({test::box(5, -4, 5.01, 10)});
  const auto found = issues(wall, small, {{0, 0, 0}, 8.0, 0.0});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].arc_length, 4.9, 0.02);
  EXPECT_TRUE(issues(wall, small, {{0, 0, 0}, 4.89, 0.0}).empty());
}

TEST(AnyBodyAndOnePole, CollisionsNameThePartThatTouches) {
  VehicleParameters parameters;
  parameters.footprint = {test::square(1, 1, 0.5), test::square(1, -1.5, 0.5)};
  const Vehicle apart(parameters);
  const World world({test::box(0.9, -0.2, 1.3, 0.2), test::box(1.25, -3, 1.75, -1.25), test::box(-9, -9, -8, -8)});
  const QuerySet queries = make_reference_queries(world);
  const Outlines outlines(world);
  const auto contact = contact_of(world, outlines, *queries.distance, apart.body(), {0, 0, 0});
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->region, 1u);
  EXPECT_NEAR(contact->point.x(), 1.25, 0.5);
  EXPECT_NEAR(contact->point.y(), -1.25, 1e-12);
  EXPECT_FALSE(contact_of(world, outlines, *queries.distance, apart.body(), {0, 3, 0}));
  const World block({test::box(0.5, 0.5, 9, 9)});
  const auto inside =
      contact_of(block, Outlines(block), *make_reference_queries(block).distance, apart.body(), {0, 0, 0});
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->region, 0u);
  EXPECT_GT(inside->point.y(), 1.0);
  const auto free = nearest_free_pose(*queries.sweep, apart.body(), {0, 0, 0});
  ASSERT_TRUE(free);
  EXPECT_TRUE(queries.sweep->straight_free({free->pose, 0.0, apart.body()}));
}

}  // namespace
}  // namespace arcway::internal
