#include "core/search/arrival_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/graph_mode.h"
#include "core/attach/clear_circles.h"
#include "core/attach/maneuvers.h"
#include "core/base/infinity.h"
#include "core/collision/clearance_cost.h"
#include "core/motion/dubins.h"
#include "core/motion/speed_profile.h"
#include "core/roadmap/build_feasible_graph.h"
#include "core/roadmap/circle_radii.h"
#include "core/roadmap/lazy_feasible_graph.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

Roadmap make_map(const World& world, const Vehicle& vehicle, const CircleRadii& radii, GraphMode mode) {
  const QuerySet queries = make_reference_queries(world);
  const FeasibleGraphInputs inputs{
      world, vehicle, rows_of(world, build_reduced_visibility_graph(world, *queries.visibility)), queries, radii};
  std::shared_ptr<const FeasibleGraph> graph;
  if (mode == GraphMode::kLazy) {
    graph = std::make_shared<const LazyFeasibleGraph>(inputs, SerialExecutor());
  } else {
    graph = build_feasible_graph(inputs, SerialExecutor());
  }
  return Roadmap(world, vehicle, queries, radii, std::move(graph), std::make_shared<const Outlines>(world));
}

// Every path of the graph whose cost could be below a bound, one by one, without comparing any two of them.
class Enumeration {
 public:
  Enumeration(const Roadmap& map, const Pose& start, const Pose& goal, double bound, std::uint32_t not_first = kNone,
              std::uint32_t not_last = kNone, const EndSpeeds& ends = {})
      : map_(map), start_(start), goal_(goal), best_(bound), not_first_(not_first), not_last_(not_last), ends_(ends) {}

  double best() {
    for (std::size_t k = 0; k < map_.radii.size(); ++k)
      for (const DubinsWord word : kDubinsWords)
        if (const auto path = dubins_path(word, start_, goal_, map_.radii[k]))
          if (std::all_of(path->begin(), path->end(), [this](const PathSegment& s) { return is_free(s); })) end(*path);
    for (const Side side : {Side::kLeft, Side::kRight})
      for (const double radius : map_.radii.of(side)) {
        const TurnCircle circle = turn_circle(start_, radius, side);
        for (std::uint32_t c = 0; c < map_.graph->circles().size(); ++c)
          if (const auto line = directed_bitangent(circle, map_.graph->circles()[c]); line && c != not_first_)
            if (try_push(circle, start_.heading, *line)) {
              visit(c, line->start.heading);
              pop();
            }
      }
    return best_;
  }
  [[nodiscard]] std::size_t paths() const { return paths_; }

  std::uint32_t not_around = kNone;  // see SearchOptions

 private:
  bool is_free(const PathSegment& s) const {
    if (s.is_line()) return map_.queries.sweep->straight_free(swept_rectangle(s.start, s.length, map_.body));
    const Side side = s.curvature > 0.0 ? Side::kLeft : Side::kRight;
    const TurnCircle circle = turn_circle(s.start, 1.0 / std::abs(s.curvature), side);
    return map_.queries.sweep->free_headings({circle.center, circle.radius, side, map_.body})
               .reach(s.start.heading, side) >= s.length * std::abs(s.curvature);
  }

  // By a turn on a circle and a straight. On a circle of the graph, turns stay within its free headings.
  bool try_push(const TurnCircle& circle, double heading, const Bitangent& line, std::uint32_t of_graph = kNone) {
    const double turn = turn_between(heading, line.start.heading, circle.side);
    if (of_graph != kNone && turn > map_.graph->free_headings(of_graph).reach(heading, circle.side)) return false;
    const PathSegment arc{pose_on(circle, heading), turn * circle.radius, sign_of(circle.side) / circle.radius};
    const PathSegment straight{line.start, line.length, 0.0};
    path_.push_back(arc);
    path_.push_back(straight);
    // No way to go on from here is faster than straight to the goal at top speed.
    const Vec2 here = straight.end().position();
    const double distance = (goal_.position() - here).norm();
    Path relaxed = path_;
    relaxed.push_back({straight.end(), distance, 0.0});
    const double least =
        ends_.is_moving() ? time_without_braking(relaxed) : speed_profile(relaxed, map_.vehicle).total_time;
    const bool hopeful = least + clearance_cost(map_.clearance_cost.get(), path_) <= best_ + 1e-9;
    if (hopeful && is_free(straight) && (turn == 0.0 || is_free(arc))) return true;
    pop();
    return false;
  }
  void pop() { path_.resize(path_.size() - 2); }

  // A lower bound: at each place as fast as the start's speed, acceleration and limits allow.
  [[nodiscard]] double time_without_braking(const Path& path) const {
    double time = 0.0, speed = ends_.start;
    for (const PathSegment& s : path) {
      const double limit = speed_limit(s, map_.vehicle), a = map_.vehicle.max_acceleration();
      speed = std::min(speed, limit);
      const double next = std::min(limit, std::sqrt(speed * speed + 2.0 * a * s.length));
      const double rising = 0.5 * (next * next - speed * speed) / a;
      time += (next - speed) / a + std::max(0.0, s.length - rising) / limit;
      speed = next;
    }
    return time;
  }

  void end(const Path& path) {
    const double cost = travel_time(path, map_.vehicle, ends_, profile_, map_.speed_zones.get()) +
                        clearance_cost(map_.clearance_cost.get(), path);
    if (std::isinf(cost)) return;
    ++paths_;
    best_ = std::min(best_, cost);
  }

  void visit(std::uint32_t c, double heading) {
    const TurnCircle& circle = map_.graph->circles()[c];
    if (Way::turn_around(map_.world.obstacle_of(circle.vertex), circle.side == Side::kLeft) == not_around) return;
    if (!map_.graph->free_headings(c).contains(heading)) return;
    for (const Side side : {Side::kLeft, Side::kRight})
      for (const double radius : map_.radii.of(side)) {
        const TurnCircle last = turn_circle(goal_, radius, side);
        const auto line = directed_bitangent(circle, last);
        if (c == not_last_ || !line || !try_push(circle, heading, *line, c)) continue;
        const double turn = turn_between(line->start.heading, goal_.heading, side);
        const PathSegment arc{pose_on(last, line->start.heading), turn * radius, sign_of(side) / radius};
        if (turn == 0.0 || is_free(arc)) {
          path_.push_back(arc);
          end(path_);
          path_.pop_back();
        }
        pop();
      }
    const auto links = map_.graph->links_from(c);
    for (const FeasibleGraph::Link& link : links)
      if (try_push(circle, heading, {pose_on(circle, link.heading), link.length}, c)) {
        visit(link.to, link.heading);
        pop();
      }
  }

  const Roadmap& map_;
  Pose start_, goal_;
  Path path_;
  double best_;
  std::uint32_t not_first_, not_last_;
  EndSpeeds ends_;
  SpeedProfile profile_;
  std::size_t paths_ = 0;
};

// A few obstacles, so that all paths can be enumerated.
World world_of_few(std::size_t obstacles, double fill, std::uint64_t seed) {
  return random_world({.kind = ClutterKind::kConvex,
                       .obstacles = obstacles,
                       .vertices = 4,
                       .fill = fill,
                       .min_radius = 3.0,
                       .max_radius = 6.0,
                       .seed = seed});
}

Pose random_pose(test::RandomInputs& random, const World& world) {
  const double side = world.box().max.x();
  return {random.uniform(1.0, side - 1.0), random.uniform(1.0, side - 1.0), random.uniform(-kPi, kPi)};
}

// Vehicles of several accelerations, two in three of which turn by a lateral one.
VehicleParameters parameters_of(std::uint64_t seed) {
  VehicleParameters parameters;
  parameters.max_acceleration = std::array{1.0, 2.0, 4.0, 50.0}[seed % 4];
  if (seed % 3 != 0) parameters.turn_speed = LateralAccelerationLimit{2.0};
  return parameters;
}

// Of one radius, or of two for every other seed.
Roadmap map_of_radii(const World& world, const Vehicle& vehicle, std::uint64_t seed) {
  std::vector<double> radii{vehicle.min_turning_radius()};
  if (seed % 2 == 0) radii.push_back(3.0 * radii[0]);
  return make_map(world, vehicle, CircleRadii(vehicle, radii), GraphMode::kEager);
}

TEST(ArrivalSearch, FindsTheFastestOfAllPathsWhateverTheAcceleration) {
  test::RandomInputs random(11);
  ArrivalSearch search;
  int solved = 0;
  std::size_t paths = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const World world = world_of_few(4, 0.2, seed);
    VehicleParameters parameters = parameters_of(seed);
    if (seed % 4 < 2) parameters.max_steering_angle_right = 0.4;
    const Vehicle vehicle(parameters);
    const Roadmap map = map_of_radii(world, vehicle, seed);
    for (int i = 0; i < 20; ++i) {
      const Attachment start{random_pose(random, world), {}}, goal{random_pose(random, world), {}};
      const SearchResult result = search.find(map, {&start, 1}, {&goal, 1}, {});
      if (!result.path) {
        const double straight = (goal.pose.position() - start.pose.position()).norm() / vehicle.max_speed();
        EXPECT_EQ(Enumeration(map, start.pose, goal.pose, 2.0 * straight + 5.0).paths(), 0u)
            << "seed " << seed << ", query " << i;
        continue;
      }
      ++solved;
      const double time = speed_profile(*result.path, vehicle).total_time;
      Enumeration all(map, start.pose, goal.pose, time);
      EXPECT_NEAR(all.best(), time, 1e-9 * time) << "seed " << seed << ", query " << i;
      EXPECT_GE(all.paths(), 1u);
      paths += all.paths();
    }
  }
  EXPECT_GT(solved, 30);
  EXPECT_GT(paths, 120u);
}

TEST(ArrivalSearch, FindsTheFastestOfAllPathsThroughZones) {
  ArrivalSearch search;
  int solved = 0, slowed = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    test::RandomInputs random(seed);
    const World open = world_of_few(4, 0.2, seed);
    std::vector<Zone> zones;
    for (int i = 0; i < 3; ++i) {
      const Vec2 middle = random.point(0.0, open.box().max.x());
      zones.push_back({Polygon::regular(middle, random.uniform(2.0, 8.0), 5), SpeedLimit{random.uniform(0.5, 5.0)}});
    }
    const World world = open.with_zones(zones);
    const Vehicle vehicle(parameters_of(seed));
    const Roadmap map = map_of_radii(world, vehicle, seed);
    for (int i = 0; i < 20; ++i) {
      const Attachment start{random_pose(random, world), {}}, goal{random_pose(random, world), {}};
      const SearchResult result = search.find(map, {&start, 1}, {&goal, 1}, {});
      if (!result.path) continue;
      ++solved;
      const double time = speed_profile(*result.path, vehicle, {}, map.speed_zones.get()).total_time;
      if (time > speed_profile(*result.path, vehicle).total_time) ++slowed;
      Enumeration all(map, start.pose, goal.pose, time);
      EXPECT_NEAR(all.best(), time, 1e-9 * time) << "seed " << seed << ", query " << i;
      EXPECT_GE(all.paths(), 1u);
    }
  }
  EXPECT_GT(solved, 30);
  EXPECT_GT(slowed, 15);
}

// On the circles of the vehicle, and on those that keep the distance as well; with zones for some. Costs are small, so
// that times matter, or so large that goals close to obstacles raise all estimates.
TEST(ArrivalSearch, FindsTheCheapestOfAllPathsThatMayDriveCloseToObstacles) {
  ArrivalSearch search;
  int solved = 0, close = 0, slower = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    test::RandomInputs random(seed);
    World world = world_of_few(4, 0.3, seed);
    if (seed % 4 == 3)
      world =
          world.with_zones({{Polygon::regular(0.5 * (world.box().min + world.box().max), 5.0, 5), SpeedLimit{2.0}}});
    const Vehicle vehicle(parameters_of(seed));
    const Roadmap plain = make_map(world, vehicle, {vehicle.min_turning_radius()}, GraphMode::kEager);
    const ClearancePreference preference{.distance = random.uniform(0.2, 1.0),
                                         .cost = std::exp(random.uniform(-4.0, 1.0) + (seed % 3 == 0 ? 5.0 : 0.0))};
    const Vec2 middle = 0.5 * (world.box().min + world.box().max);
    const Zone zone{Polygon::regular(middle, 6.0, 5), KeepClear{0.8, 3.0}};
    Roadmap map = plain.with_cost(
        ClearanceCost::of(vehicle, plain.outlines, preference, std::span(&zone, seed % 5 == 0 ? 1 : 0)));
    if (seed % 2 == 0) map = with_clear_circles(map);
    for (int i = 0; i < 30; ++i) {
      const Attachment start{random_pose(random, world), {}}, goal{random_pose(random, world), {}};
      const SearchResult result = search.find(map, {&start, 1}, {&goal, 1}, {});
      if (!result.path) continue;
      ++solved;
      const double close_cost = map.clearance_cost->of(*result.path);
      const double time = speed_profile(*result.path, vehicle, {}, map.speed_zones.get()).total_time;
      const double cost = time + close_cost;
      close += close_cost > 0.0 ? 1 : 0;
      Enumeration all(map, start.pose, goal.pose, cost);
      EXPECT_NEAR(all.best(), cost, 1e-9 * cost) << "seed " << seed << ", query " << i;
      EXPECT_GE(all.paths(), 1u);
      const SearchResult fastest = search.find(plain, {&start, 1}, {&goal, 1}, {});
      if (!fastest.path) continue;
      slower += time > speed_profile(*fastest.path, vehicle, {}, map.speed_zones.get()).total_time + 1e-9 ? 1 : 0;
    }
  }
  EXPECT_GT(solved, 60);
  EXPECT_GT(close, 50);
  EXPECT_GT(slower, 15);
}

// The links of further goals may cost less than estimates of the search before count on.
TEST(ArrivalSearch, GoesOnWithFurtherAttachmentsWhereCloseDrivingCosts) {
  test::RandomInputs random(12);
  ArrivalSearch before, anew;
  int solved = 0, improved = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const World world = world_of_few(6, 0.3, seed);
    const Vehicle vehicle;
    const Roadmap plain = make_map(world, vehicle, {vehicle.min_turning_radius()}, GraphMode::kEager);
    const Roadmap map = plain.with_cost(std::make_shared<const ClearanceCost>(
        vehicle, plain.outlines, ClearancePreference{.distance = 1.0, .cost = 100.0}));
    for (int i = 0; i < 20; ++i) {
      const Pose start = random_pose(random, world), goal = random_pose(random, world);
      ManeuverSearch at_start, at_goal;
      const ManeuveringBody body(vehicle, map.radii[0], *map.queries.sweep);
      const auto starts = at_start.find(start, Direction::kFromStart, body, {12, Spread::kDense});
      const auto goals = at_goal.find(goal, Direction::kToGoal, body, {12, Spread::kDense});
      if (starts.size() * goals.size() <= 64) continue;  // else Dubins words as well, of other pairs
      const auto cost_of = [&](const SearchResult& result) {
        return result.path ? speed_profile(*result.path, vehicle).total_time + map.clearance_cost->of(*result.path)
                           : kInfinity;
      };
      const double first = cost_of(before.find(map, std::span(starts).first(1), std::span(goals).first(1), {}));
      const double whole = cost_of(anew.find(map, starts, goals, {}));
      SearchOptions options;
      options.warm_start = true;
      const double more = std::min(first, cost_of(before.find(map, starts, goals, options)));
      if (whole == kInfinity) continue;
      ++solved;
      EXPECT_NEAR(more, whole, 1e-9 * whole) << "seed " << seed << ", query " << i;
      improved += more < 0.9 * first ? 1 : 0;
    }
  }
  EXPECT_GT(solved, 15);
  EXPECT_GT(improved, 5);
}

TEST(ArrivalSearch, FindsTheFastestOfAllPathsBetweenMovingEnds) {
  test::RandomInputs random(21);
  ArrivalSearch search;
  int solved = 0, unsolved = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const World world = world_of_few(4, 0.2, seed);
    VehicleParameters parameters;
    parameters.max_acceleration = std::array{1.0, 2.0, 4.0}[seed % 3];
    parameters.turn_speed = LateralAccelerationLimit{2.0};
    const Vehicle vehicle(parameters);
    const double tightest = vehicle.min_turning_radius();
    const std::vector<std::vector<double>> radii{{tightest}, {tightest, 4.0 * tightest}, {3.0 * tightest}};
    const double fastest = vehicle.turn_speed(radii[seed % 3].back());
    const Roadmap map = make_map(world, vehicle, radii[seed % 3], GraphMode::kEager);
    for (int i = 0; i < 20; ++i) {
      const Attachment start{random_pose(random, world), {}}, goal{random_pose(random, world), {}};
      const EndSpeeds ends{i % 3 == 0 ? 0.0 : random.uniform(0.0, fastest),
                           i % 3 == 1 ? 0.0 : random.uniform(0.0, fastest)};
      const SearchResult result = search.find(map, {&start, 1}, {&goal, 1}, {.ends = ends});
      if (!result.path) {
        const double straight = (goal.pose.position() - start.pose.position()).norm() / vehicle.max_speed();
        ++unsolved;
        EXPECT_EQ(Enumeration(map, start.pose, goal.pose, 2.0 * straight + 5.0, kNone, kNone, ends).paths(), 0u)
            << "seed " << seed << ", query " << i;
        continue;
      }
      ++solved;
      SpeedProfile profile;
      const double time = travel_time(*result.path, vehicle, ends, profile);
      Enumeration all(map, start.pose, goal.pose, time * (1.0 + 1e-9), kNone, kNone, ends);
      EXPECT_NEAR(all.best(), time, 1e-9 * time) << "seed " << seed << ", query " << i;
      EXPECT_GE(all.paths(), 1u);
    }
  }
  EXPECT_GT(solved, 30);
  EXPECT_GT(unsolved, 10);
}

// The next path may not join the graph, or leave it, by the circle of the fastest one.
TEST(ArrivalSearch, FindsTheFastestPathThatJoinsOrLeavesTheGraphElsewhere) {
  test::RandomInputs random(17);
  ArrivalSearch search;
  int others = 0, alone = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const World world = world_of_few(5, 0.25, seed);
    const Vehicle vehicle;
    const Roadmap map = make_map(world, vehicle, {vehicle.min_turning_radius()}, GraphMode::kEager);
    for (int i = 0; i < 20; ++i) {
      const Attachment start{random_pose(random, world), {}}, goal{random_pose(random, world), {}};
      const SearchResult best = search.find(map, {&start, 1}, {&goal, 1}, {});
      if (!best.path || best.first_circle == kNone) continue;
      ASSERT_NE(best.last_circle, kNone);
      const double fastest = speed_profile(*best.path, vehicle).total_time;
      for (const bool at_start : {true, false}) {
        SearchOptions options;
        options.warm_start = true;  // has no effect, as the question differs
        (at_start ? options.not_first : options.not_last) = at_start ? best.first_circle : best.last_circle;
        const SearchResult other = search.find(map, {&start, 1}, {&goal, 1}, options);
        if (!other.path) {
          Enumeration all(map, start.pose, goal.pose, 1.5 * fastest, options.not_first, options.not_last);
          all.best();
          EXPECT_EQ(all.paths(), 0u) << "seed " << seed << ", query " << i;
          ++alone;
          continue;
        }
        EXPECT_NE(at_start ? other.first_circle : other.last_circle, at_start ? best.first_circle : best.last_circle);
        const double time = speed_profile(*other.path, vehicle).total_time;
        EXPECT_GE(time, fastest);
        Enumeration all(map, start.pose, goal.pose, time, options.not_first, options.not_last);
        EXPECT_NEAR(all.best(), time, 1e-9 * time) << "seed " << seed << ", query " << i;
        EXPECT_GE(all.paths(), 1u);
        ++others;
      }
    }
  }
  EXPECT_GT(others, 40);
  EXPECT_GT(alone, 0);
}

// The next path may not turn around an obstacle as the fastest one does.
TEST(ArrivalSearch, FindsTheFastestPathThatDoesNotTurnAroundAnObstacle) {
  test::RandomInputs random(18);
  ArrivalSearch search;
  int others = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const World world = world_of_few(5, 0.25, seed);
    const Vehicle vehicle;
    const Roadmap map = make_map(world, vehicle, {vehicle.min_turning_radius()}, GraphMode::kEager);
    for (int i = 0; i < 20; ++i) {
      const Attachment start{random_pose(random, world), {}}, goal{random_pose(random, world), {}};
      const SearchResult best = search.find(map, {&start, 1}, {&goal, 1}, {});
      for (const std::uint32_t turn : std::span(best.way.turns).first(best.way.count)) {
        SearchOptions options;
        options.warm_start = true;  // has no effect, as the question differs
        options.not_around = turn;
        const SearchResult other = search.find(map, {&start, 1}, {&goal, 1}, options);
        if (!other.path) continue;
        const auto turns = std::span(other.way.turns).first(other.way.count);
        EXPECT_EQ(std::ranges::find(turns, turn), turns.end());
        EXPECT_NE(other.way.number, best.way.number);
        const double time = speed_profile(*other.path, vehicle).total_time;
        Enumeration all(map, start.pose, goal.pose, time);
        all.not_around = turn;
        EXPECT_NEAR(all.best(), time, 1e-9 * time) << "seed " << seed << ", query " << i;
        EXPECT_GE(all.paths(), 1u);
        ++others;
      }
    }
  }
  EXPECT_GT(others, 25);
}

TEST(ArrivalSearch, TakesTheSamePathThroughEagerAndLazyGraphs) {
  const World world =
      random_world({.kind = ClutterKind::kStar, .obstacles = 30, .vertices = 6, .fill = 0.3, .seed = 2});
  VehicleParameters parameters;
  parameters.max_acceleration = 2.0;
  parameters.turn_speed = LateralAccelerationLimit{2.0};
  const Vehicle vehicle(parameters);
  const std::vector<double> radii{vehicle.min_turning_radius(), 3.0 * vehicle.min_turning_radius()};
  const Roadmap eager = make_map(world, vehicle, radii, GraphMode::kEager);
  const Roadmap lazy = make_map(world, vehicle, radii, GraphMode::kLazy);
  ArrivalSearch first, second;
  test::RandomInputs random(4);
  const double side = world.box().max.x();
  int solved = 0;
  for (int i = 0; i < 120; ++i) {
    const auto pose = [&] {
      return Pose{random.uniform(1.0, side - 1.0), random.uniform(1.0, side - 1.0), random.uniform(-kPi, kPi)};
    };
    const Attachment start{pose(), {}}, goal{pose(), {}};
    const SearchResult a = first.find(eager, {&start, 1}, {&goal, 1}, {});
    const SearchResult b = second.find(lazy, {&start, 1}, {&goal, 1}, {});
    ASSERT_EQ(a.path.has_value(), b.path.has_value());
    EXPECT_EQ(a.counts.nodes_expanded, b.counts.nodes_expanded);
    if (!a.path) continue;
    ++solved;
    ASSERT_EQ(a.path->size(), b.path->size());
    for (std::size_t k = 0; k < a.path->size(); ++k) {
      EXPECT_EQ((*a.path)[k].start.x, (*b.path)[k].start.x);
      EXPECT_EQ((*a.path)[k].start.y, (*b.path)[k].start.y);
      EXPECT_EQ((*a.path)[k].start.heading, (*b.path)[k].start.heading);
      EXPECT_EQ((*a.path)[k].length, (*b.path)[k].length);
      EXPECT_EQ((*a.path)[k].curvature, (*b.path)[k].curvature);
    }
  }
  EXPECT_GT(solved, 15);
}

TEST(ArrivalSearch, EndsWithTheBestPathThatItHasAfterSoManyExpansions) {
  const World world = random_world({.obstacles = 30, .vertices = 6, .fill = 0.2, .seed = 6});
  const Vehicle vehicle;
  const Roadmap map = make_map(world, vehicle, {vehicle.min_turning_radius()}, GraphMode::kEager);
  ArrivalSearch arrivals;
  const double side = world.box().max.x();
  test::RandomInputs random(8);
  const auto pose = [&] {
    return Pose{random.uniform(1.0, side - 1.0), random.uniform(1.0, side - 1.0), random.uniform(-kPi, kPi)};
  };
  Attachment start, goal;
  const auto search = [&](std::uint64_t most) {
    SearchOptions options;
    options.most_expanded = most;
    return arrivals.find(map, {&start, 1}, {&goal, 1}, options);
  };
  SearchResult whole;
  for (int i = 0; i < 200 && !(whole.path && whole.counts.nodes_expanded > 20); ++i) {
    start.pose = pose();
    goal.pose = pose();
    whole = search(SearchOptions{}.most_expanded);
  }
  ASSERT_TRUE(whole.path);
  const double fastest = speed_profile(*whole.path, vehicle).total_time;
  std::uint64_t without = 0, slower = 0;
  for (std::uint64_t most = 1; most <= whole.counts.nodes_expanded + 1; ++most) {
    const SearchResult result = search(most);
    EXPECT_FALSE(result.interrupted);
    EXPECT_LE(result.counts.nodes_expanded, most);
    const double time = result.path ? speed_profile(*result.path, vehicle).total_time : 2.0 * fastest;
    EXPECT_GE(time, fastest);
    without += result.path ? 0 : 1;
    slower += result.path && time > fastest ? 1 : 0;
    EXPECT_TRUE(most <= whole.counts.nodes_expanded || time == fastest);
  }
  EXPECT_GT(without, 0u);
  EXPECT_LT(without + slower, whole.counts.nodes_expanded + 1);
}

TEST(ArrivalSearch, GoesOnWithMoreEndsAsFarAsASearchAnew) {
  test::RandomInputs random(3);
  ArrivalSearch before, anew;
  int improved = 0, plain = 0;
  std::uint64_t expanded = 0, expanded_anew = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const World world =
        random_world({.kind = ClutterKind::kStar, .obstacles = 60, .vertices = 6, .fill = 0.35, .seed = seed});
    VehicleParameters parameters;
    if (seed % 2 == 0) parameters.max_acceleration = 2.0;
    const Vehicle vehicle(parameters);
    const Roadmap map = make_map(world, vehicle, {vehicle.min_turning_radius()}, GraphMode::kEager);
    const double side = world.box().max.x();
    for (int i = 0; i < 80; ++i) {
      const auto pose = [&] {
        return Pose{random.uniform(1.0, side - 1.0), random.uniform(1.0, side - 1.0), random.uniform(-kPi, kPi)};
      };
      const Pose start = pose(), goal = pose();
      ManeuverSearch at_start, at_goal;
      const ManeuveringBody body(vehicle, map.radii[0], *map.queries.sweep);
      const auto starts = at_start.find(start, Direction::kFromStart, body, {12, Spread::kSparse});
      const auto goals = at_goal.find(goal, Direction::kToGoal, body, {12, Spread::kSparse});
      if (starts.size() * goals.size() <= 64) continue;  // else Dubins words as well, of other pairs
      const SearchResult first = before.find(map, std::span(starts).first(1), std::span(goals).first(1), {});
      if (!first.path) continue;
      ++plain;
      SearchOptions options;
      const double known = speed_profile(*first.path, vehicle).total_time;
      options.faster_than = known * (1.0 - 1e-9);
      const SearchResult whole = anew.find(map, starts, goals, options);
      options.warm_start = true;
      options.least_gain = i % 2 == 0 ? 0.0 : 0.01 * known;
      const SearchResult more = before.find(map, starts, goals, options);
      const double least = whole.path ? speed_profile(*whole.path, vehicle).total_time : options.faster_than;
      const double time = more.path ? speed_profile(*more.path, vehicle).total_time : options.faster_than;
      EXPECT_GE(time, least * (1.0 - 1e-9)) << "seed " << seed << ", query " << i;
      EXPECT_LE(time, least * (1.0 + 1e-9) + options.least_gain) << "seed " << seed << ", query " << i;
      // A search with fewer ends cannot continue one with more.
      EXPECT_FALSE(before.find(map, std::span(starts).first(1), std::span(goals).first(1), options).path);
      improved += more.path ? 1 : 0;
      expanded += more.counts.nodes_expanded;
      expanded_anew += whole.counts.nodes_expanded;
    }
  }
  EXPECT_GT(plain, 40);
  EXPECT_GT(improved, 5);
  EXPECT_LT(improved, plain);
  EXPECT_LT(expanded, expanded_anew / 2);
}

TEST(ArrivalSearch, GoesOnOnlyFromAPartOfItself) {
  const World world =
      random_world({.kind = ClutterKind::kStar, .obstacles = 30, .vertices = 6, .fill = 0.25, .seed = 3});
  VehicleParameters parameters;
  parameters.max_acceleration = 2.0;
  const Vehicle vehicle(parameters);
  parameters.turn_speed = ConstantTurnSpeed{2.0};
  const Roadmap map = make_map(world, vehicle, {vehicle.min_turning_radius()}, GraphMode::kEager);
  Roadmap slower_turns = map;  // on the same circles
  slower_turns.vehicle = Vehicle(parameters);
  parameters.max_reverse_speed = 1.0;
  Roadmap slower_backwards = map;
  slower_backwards.vehicle = Vehicle(parameters);

  struct Change {
    const char* what;
    const Roadmap& before;
    SearchOptions options_before;
    const Roadmap& map;
    SearchOptions options;
  };
  const auto with = [](auto set) {
    SearchOptions options;
    set(options);
    return options;
  };
  const std::array<Change, 8> changes{{
      {"vehicle", map, {}, slower_turns, {}},
      {"gear", slower_backwards, {}, slower_backwards, with([](auto& o) { o.gear = Gear::kReverse; })},
      {"heuristic", map, with([](auto& o) { o.heuristic = Heuristic::kPaperDistance; }), map, {}},
      {"time model", map, with([](auto& o) { o.time_model = TimeModel::kSegments; }), map, {}},
      {"cusp cost", map, {}, map, with([](auto& o) { o.cusp_cost = 1.0; })},
      {"suboptimality", map, with([](auto& o) { o.suboptimality = 2.0; }), map, {}},
      {"wanted time", map, with([](auto& o) { o.faster_than = 1.0; }), map, {}},
      {"expansions", map, with([](auto& o) { o.most_expanded = 3; }), map, {}},
  }};
  test::RandomInputs random(9);
  const double side = world.box().max.x();
  const auto pose = [&] {
    return Pose{random.uniform(1.0, side - 1.0), random.uniform(1.0, side - 1.0), random.uniform(-kPi, kPi)};
  };
  ArrivalSearch search, anew;
  int solved = 0;
  for (int i = 0; i < 30; ++i) {
    const Attachment start{pose(), {}}, goal{pose(), {}};
    for (const Change& change : changes) {
      const SearchResult before = search.find(change.before, {&start, 1}, {&goal, 1}, change.options_before);
      const std::uint64_t most = change.options_before.most_expanded;
      if (most < SearchOptions{}.most_expanded && before.counts.nodes_expanded < most) continue;  // it was a part
      SearchOptions options = change.options;
      const SearchResult expected = anew.find(change.map, {&start, 1}, {&goal, 1}, options);
      options.warm_start = true;
      const SearchResult found = search.find(change.map, {&start, 1}, {&goal, 1}, options);
      ASSERT_EQ(found.path.has_value(), expected.path.has_value()) << change.what << ", query " << i;
      EXPECT_EQ(found.counts.nodes_expanded, expected.counts.nodes_expanded) << change.what << ", query " << i;
      if (!found.path) continue;
      ++solved;
      const Vehicle& driven = change.map.vehicle;
      EXPECT_EQ(speed_profile(*found.path, driven).total_time, speed_profile(*expected.path, driven).total_time)
          << change.what << ", query " << i;
    }
  }
  EXPECT_GT(solved, 40);
}

// The clock ends searches wherever they are, also while they look for the links of a circle.
TEST(ArrivalSearch, FindsAfterACutWhatASearchAnewFinds) {
  const World world =
      random_world({.kind = ClutterKind::kConvex, .obstacles = 150, .vertices = 8, .fill = 0.05, .seed = 3});
  const Vehicle vehicle;
  const Roadmap map = make_map(world, vehicle, {1.3, 2.6}, GraphMode::kLazy);
  test::RandomInputs random(4);
  ArrivalSearch search, anew;
  std::size_t cut = 0;
  for (int query = 0; query < 5; ++query) {
    const Attachment start{random_pose(random, world), {}}, goal{random_pose(random, world), {}};
    const SearchResult expected = anew.find(map, {&start, 1}, {&goal, 1}, {});
    for (int i = 0; i < 100; ++i) {
      if (i % 10 == 0) search.begin_query();
      SearchOptions options;  // begins anew: a whole search would go on to other paths
      for (const double seconds : {2e-6 * i, 5e-6 * i}) {
        options.clock = StopClock(seconds);
        options.warm_start = search.find(map, {&start, 1}, {&goal, 1}, options).interrupted;
        cut += options.warm_start ? 1 : 0;
      }
      options.clock = StopClock();
      const SearchResult found = search.find(map, {&start, 1}, {&goal, 1}, options);
      ASSERT_FALSE(found.interrupted);
      ASSERT_EQ(found.path.has_value(), expected.path.has_value()) << "query " << query << ", cut " << i;
      if (!found.path) continue;
      ASSERT_EQ(speed_profile(*found.path, vehicle).total_time, speed_profile(*expected.path, vehicle).total_time)
          << "query " << query << ", cut " << i;
    }
  }
  EXPECT_GT(cut, 0u);
}

// Around a square below or above, by circles of several radii.
TEST(ArrivalSearch, PathsOfOneWayHaveItsNumber) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  const World world({{test::square(-3.0, -3.0, 6.0), {}}});
  ArrivalSearch search;
  const auto way_at = [&](double height, const std::vector<double>& radii) {
    const Roadmap map = make_map(world, vehicle, radii, GraphMode::kEager);
    const std::vector<Attachment> start{{{-12.0, height, 0.0}, {}}}, goal{{{12.0, height, 0.0}, {}}};
    const SearchResult result = search.find(map, start, goal, {});
    EXPECT_TRUE(result.path);
    return result.way.number;
  };
  const std::vector<double> tightest{1.3}, wider{5.2};
  const std::uint64_t below = way_at(-1.0, tightest), above = way_at(1.0, tightest);
  EXPECT_NE(below, 0u);
  EXPECT_NE(above, below);
  EXPECT_EQ(way_at(-1.0, wider), below);
  EXPECT_EQ(way_at(1.0, wider), above);
  EXPECT_EQ(way_at(8.0, tightest), 0u);
}

}  // namespace
}  // namespace arcway::internal
