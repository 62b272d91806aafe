#include "core/refine/arc_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

#include "arcway/angle.h"
#include "tests/support/arc_chains.h"
#include "tests/support/gear_paths.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

constexpr double kJoinError = 1e-9;  // [m]

struct CircleCase {
  Path path;
  CircleChain chain;
  std::vector<Bitangent> lines;
};

// A path as planners find them: turns to either side, of a few radii, with lines between them.
CircleCase random_circle_case(test::RandomInputs& random) {
  CircleCase result;
  Pose pose{random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), random.uniform(-4.0, 4.0)};
  const Pose start = pose;
  const auto append = [&](double length, double curvature) {
    result.path.push_back({pose, length, curvature});
    pose = result.path.back().end();
  };
  const auto turns = random.integer(2, 6);
  append(random.uniform(0.1, 4.0), 0.0);
  for (std::int64_t i = 0; i < turns; ++i) {
    const double radius = random.uniform(1.3, 5.0), turn = random.uniform(0.01, random.unit() < 0.3 ? 4.0 : 1.5);
    append(radius * turn, (random.unit() < 0.5 ? 1.0 : -1.0) / radius);
    append(random.unit() < 0.3 ? random.uniform(0.01, 0.5) : random.uniform(1.0, 9.0), 0.0);
  }
  result.chain = chain_of(result.path, start, pose).value();
  result.lines = lines_of(result.chain).value();
  return result;
}

constexpr TurnCuts kSomeCuts{3, 0.05, 4.5};

ArcChain random_cut_chain(test::RandomInputs& random) {
  ArcChain cut;
  CircleCase input = random_circle_case(random);
  while (!cut_turns(input.chain, input.lines, kSomeCuts, cut)) input = random_circle_case(random);
  return cut;
}

// How far the equation of a line is from 0.
double line_error(const ArcChain& chain, std::size_t i) {
  const ArcChain::Line& line = chain.lines[i];
  return std::max(test::residual_of(chain, i).norm(), (direction_of(line.heading) - line.ahead).norm());
}

void expect_equations(const ArcChain& chain) {
  for (std::size_t i = 0; i < chain.lines.size(); ++i) {
    EXPECT_LT(line_error(chain, i), kJoinError) << "line " << i;
    if (chain.lines[i].is_tied) {
      EXPECT_EQ(chain.lines[i].length, 0.0);
    }
  }
}

void expect_path_end(const CircleChain& chain, const Pose& goal) {
  const auto lines = lines_of(chain);
  ASSERT_TRUE(lines);
  const Pose end = path_of(chain, *lines).back().end();
  EXPECT_NEAR((end.position() - goal.position()).norm(), 0.0, kJoinError);
  EXPECT_NEAR(wrap_signed(end.heading - goal.heading), 0.0, kJoinError);
}

TEST(ArcChain, CutsTurnsAndKeepsThePath) {
  test::RandomInputs random(1);
  int cut_in_parts = 0, whole = 0, large = 0;
  for (int i = 0; i < 300; ++i) {
    const CircleCase input = random_circle_case(random);
    ArcChain cut;
    ASSERT_TRUE(cut_turns(input.chain, input.lines, kSomeCuts, cut)) << "path " << i;
    expect_equations(cut);
    EXPECT_TRUE(cut.is_drivable());
    std::size_t arc = 0;
    for (std::size_t k = 0; k < input.chain.circles.size(); ++k) {
      const TurnCircle& circle = input.chain.circles[k];
      const double turn = turn_between(input.lines[k].start.heading, input.lines[k + 1].start.heading, circle.side);
      const bool is_whole = turn < kSomeCuts.least || circle.radius >= kSomeCuts.widest;
      const std::size_t parts = is_whole ? 1 : turn > 2.0 ? 4 : 3;
      whole += is_whole;
      large += parts == 4;
      cut_in_parts += parts == 3;
      for (std::size_t part = 0; part < parts; ++part, ++arc) {
        ASSERT_LT(arc, cut.arcs.size());
        EXPECT_EQ(cut.lines[arc].is_tied, part > 0);
        EXPECT_EQ(cut.arcs[arc].sign, sign_of(circle.side));
        EXPECT_NEAR((cut.arcs[arc].center - circle.center).norm(), 0.0, kJoinError);
        EXPECT_NEAR(cut.turn(arc), turn / static_cast<double>(parts), kJoinError);
      }
    }
    ASSERT_EQ(arc, cut.arcs.size());
    CircleChain again;
    circles_of(cut, again);
    ASSERT_EQ(again.circles.size(), input.chain.circles.size()) << "path " << i;
    const Path path = path_of(again, lines_of(again).value());
    EXPECT_NEAR(length_of(path), length_of(input.path), kJoinError) << "path " << i;
    expect_path_end(again, input.chain.goal);
  }
  EXPECT_GT(cut_in_parts, 100);
  EXPECT_GT(whole, 10);
  EXPECT_GT(large, 10);
}

TEST(ArcChain, LinesThatAreNextToNothingBecomeLonger) {
  const Pose start{0, 0, 0};
  Path path{{start, 2.0, 0.5}};
  for (const auto& [length, curvature] : {std::pair{2.0, -0.5}, {6.0, 0.0}, {2.0, 0.25}})
    path.push_back({path.back().end(), length, curvature});
  const CircleChain chain = chain_of(path, start, path.back().end()).value();
  ArcChain cut;
  ASSERT_TRUE(cut_turns(chain, lines_of(chain).value(), kSomeCuts, cut));
  expect_equations(cut);
  ASSERT_EQ(cut.arcs.size(), 9u);
  for (const std::size_t line : {0u, 3u, 9u}) EXPECT_NEAR(cut.lines[line].length, 2e-3, kJoinError);
  CircleChain again;
  circles_of(cut, again);
  EXPECT_NEAR(again.lead_in, 2e-3, kJoinError);
  EXPECT_NEAR(again.lead_out, 2e-3, kJoinError);
  EXPECT_NEAR(length_of(path_of(again, lines_of(again).value())), length_of(path), 0.02);
  expect_path_end(again, chain.goal);
}

TEST(ArcChain, TurnsOfSeveralRadiiStayTied) {
  const Pose start{1, 2, 0.5};
  Path path{{start, 1.0, 0.0}};
  for (const auto& [length, curvature] :
       {std::pair{2.0, 0.25}, {1.0, 0.5}, {3.0, 0.2}, {9.0, 0.0}, {2.0, -0.3}, {1.0, 0.0}})
    path.push_back({path.back().end(), length, curvature});
  const CircleChain chain = chain_of(path, start, path.back().end()).value();
  ArcChain cut;
  ASSERT_TRUE(cut_turns(chain, lines_of(chain).value(), {1, 0.05, 100.0}, cut));
  ASSERT_EQ(cut.arcs.size(), 4u);
  const bool tied[] = {false, true, true, false, false};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(cut.lines[i].is_tied, tied[i]) << "line " << i;
  expect_equations(cut);
  CircleChain again;
  circles_of(cut, again);
  ASSERT_EQ(again.circles.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(again.circles[i].radius, chain.circles[i].radius, kJoinError);
  EXPECT_NEAR(length_of(path_of(again, lines_of(again).value())), length_of(path), 1e-5);
}

TEST(ArcChain, NothingIsCutWhereNoLineGivesWay) {
  const Pose start{0, 0, 0};
  Path path{{start, 2.0, 0.5}, {PathSegment{start, 2.0, 0.5}.end(), 2.0, 0.2}};
  const CircleChain chain = chain_of(path, start, path.back().end()).value();
  ArcChain cut;
  EXPECT_FALSE(cut_turns(chain, lines_of(chain).value(), kSomeCuts, cut));
}

TEST(ArcChain, LeavesAJoinedChainAsItIs) {
  test::RandomInputs random(2);
  for (int i = 0; i < 100; ++i) {
    const ArcChain chain = random_cut_chain(random);
    ArcChain again = chain;
    ASSERT_TRUE(again.join());
    for (std::size_t k = 0; k < chain.arcs.size(); ++k)
      EXPECT_NEAR((again.arcs[k].center - chain.arcs[k].center).norm(), 0.0, kJoinError);
    for (std::size_t k = 0; k < chain.lines.size(); ++k) {
      EXPECT_NEAR(again.lines[k].length, chain.lines[k].length, kJoinError);
      EXPECT_NEAR(again.lines[k].heading, chain.lines[k].heading, kJoinError);
      EXPECT_NEAR((again.lines[k].ahead - direction_of(again.lines[k].heading)).norm(), 0.0, 1e-15);
    }
  }
}

TEST(ArcChain, JoinsWhatHasMoved) {
  test::RandomInputs random(3);
  int moved = 0;
  for (int i = 0; i < 300; ++i) {
    const ArcChain before = random_cut_chain(random);
    ArcChain chain = before;
    for (ArcChain::Arc& arc : chain.arcs) {
      arc.center += random.point(-0.1, 0.1);
      arc.radius += random.uniform(-0.1, 0.3);
    }
    for (std::size_t k = 0; k < chain.lines.size(); ++k) {
      ArcChain::Line& line = chain.lines[k];
      if (k > 0 && k + 1 < chain.lines.size()) line.heading += random.uniform(-0.01, 0.01);
      if (!line.is_tied) line.length *= random.uniform(0.9, 1.1);
    }
    const ArcChain asked = chain;
    if (!chain.join()) continue;
    ++moved;
    expect_equations(chain);
    EXPECT_EQ(chain.start.position(), before.start.position());
    EXPECT_EQ(chain.goal.position(), before.goal.position());
    EXPECT_EQ(chain.lines.front().heading, before.lines.front().heading);
    EXPECT_EQ(chain.lines.back().heading, before.lines.back().heading);
    for (std::size_t k = 0; k < chain.arcs.size(); ++k) EXPECT_EQ(chain.arcs[k].radius, asked.arcs[k].radius);
    if (!chain.is_drivable()) continue;
    // Tied arcs of different radii are circles of their own, which touch.
    CircleChain circles;
    circles_of(chain, circles);
    ASSERT_EQ(circles.circles.size(), chain.arcs.size());
    for (std::size_t k = 0; k < chain.arcs.size(); ++k) {
      EXPECT_NEAR((circles.circles[k].center - chain.arcs[k].center).norm(), 0.0, kJoinError);
      EXPECT_EQ(circles.circles[k].radius, chain.arcs[k].radius);
    }
    EXPECT_TRUE(lines_of(circles));
  }
  EXPECT_GT(moved, 250);
}

TEST(ArcChain, CutsPathsInBothGears) {
  constexpr double kRadius = 1.3;
  constexpr TurnCuts kCuts{3, 0.05, 72.0};
  test::RandomInputs random(5);
  int stops = 0, longer = 0;
  for (int i = 0; i < 200; ++i) {
    const Path path = test::random_gear_path(random, kRadius, 8.0);
    ArcChain cut;
    ASSERT_TRUE(cut_turns(path, kCuts, cut)) << "path " << i;
    EXPECT_FALSE(cut.is_joined);
    EXPECT_TRUE(cut.is_drivable());
    double open = 0.0;
    for (std::size_t k = 0; k < cut.lines.size(); ++k) {
      cut.lines[k].ahead = direction_of(cut.lines[k].heading);
      EXPECT_EQ(cut.gap(k), test::residual_of(cut, k));
      open = std::max(open, cut.gap(k).norm());
    }
    // Nothing is left out but motions that are next to nothing, and lines are longer by no more.
    EXPECT_LE(open, 3e-3 * kRadius) << "path " << i;
    longer += open > 1e-9;
    for (std::size_t k = 0; k < cut.arcs.size(); ++k) {
      stops += cut.stops_behind(k);
      if (k > 0 && cut.arcs[k].gear == cut.arcs[k - 1].gear) {
        EXPECT_EQ(cut.stops_before(k), cut.stops_behind(k - 1));
      }
    }
    Path driven;
    path_of(cut, driven);
    const Path again = merged(driven);
    EXPECT_EQ(cusps_of(again), cusps_of(path)) << "path " << i;
    EXPECT_NEAR(length_of(again), length_of(path), 6e-3 * kRadius) << "path " << i;
    EXPECT_EQ(again.front().gear, path.front().gear);
    for (std::size_t k = 0; k < again.size(); ++k)
      if (again[k].curvature != 0.0) {
        EXPECT_NEAR(std::abs(again[k].curvature), 1.0 / kRadius, 1e-12);
      }
  }
  EXPECT_GT(stops, 200);
  EXPECT_GT(longer, 50);
}

// Straight on and straight back is a way that no optimum has.
TEST(ArcChain, GoesLessFarWhereItGoesStraightOnAndBack) {
  Path path{{{0.0, 0.0, 0.0}, 2.0, 0.5}};
  for (const auto& [length, curvature, gear] :
       {std::tuple{3.0, 0.0, Gear::kForward}, {1.0, 0.0, Gear::kReverse}, {2.0, -0.5, Gear::kReverse}})
    path.push_back({path.back().end(), length, curvature, gear});
  ArcChain cut;
  ASSERT_TRUE(cut_turns(path, {1, 0.05, 72.0}, cut));
  ASSERT_EQ(cut.arcs.size(), 2u);
  EXPECT_NEAR(cut.lines[1].length, 2.0, 1e-12);
  EXPECT_EQ(cut.lines[1].gear, 1.0);
  EXPECT_FALSE(cut.stops_behind(0));
  EXPECT_TRUE(cut.stops_before(1));
  path[2].length = 4.0;
  ASSERT_TRUE(cut_turns(path, {1, 0.05, 72.0}, cut));
  EXPECT_NEAR(cut.lines[1].length, 1.0, 1e-12);
  EXPECT_EQ(cut.lines[1].gear, -1.0);
  EXPECT_TRUE(cut.stops_behind(0));
  EXPECT_FALSE(cut.stops_before(1));
  // Exactly as far back: the turns touch, in different gears.
  path[2].length = 3.0;
  ASSERT_TRUE(cut_turns(path, {1, 0.05, 72.0}, cut));
  EXPECT_TRUE(cut.lines[1].is_tied);
  EXPECT_EQ(cut.lines[1].gear, 0.0);
  EXPECT_TRUE(cut.stops_behind(0));
  EXPECT_TRUE(cut.stops_before(1));
  EXPECT_FALSE(cut_turns(Path{{{0.0, 0.0, 0.0}, 2.0, 0.0}}, {1, 0.05, 72.0}, cut));
}

// Three groups of three arcs each, with long lines between the groups.
ArcChain chain_of_groups() {
  ArcChain chain;
  chain.start = {0.0, 0.0, 0.0};
  double heading = 0.0;
  for (int group = 0; group < 3; ++group)
    for (int arc = 0; arc < 3; ++arc) {
      chain.lines.push_back({heading, arc == 0 ? 8.0 : 0.0, arc > 0});
      const double radius = arc == 1 ? 1.5 : 2.5;
      chain.arcs.push_back({Vec2::Zero(), radius, 1.0, 1.0, 1.0});
      heading += 0.3;
    }
  chain.lines.push_back({heading, 3.0, false});
  // Places all from the start on, then the goal.
  for (std::size_t i = 0; i < chain.lines.size(); ++i) chain.lines[i].ahead = direction_of(chain.lines[i].heading);
  const auto placed = [&](std::size_t i) -> Vec2 {
    const ArcChain::Line& line = chain.lines[i];
    return chain.before(i) + line.length * line.ahead + chain.offset(i) * perpendicular(line.ahead);
  };
  for (std::size_t i = 0; i < chain.arcs.size(); ++i) chain.arcs[i].center = placed(i);
  const Vec2 end = placed(chain.arcs.size());
  chain.goal = {end.x(), end.y(), heading};
  return chain;
}

TEST(ArcChain, TheTightestArcOfAGroupKeepsItsPlace) {
  const ArcChain before = chain_of_groups();
  expect_equations(before);
  ArcChain chain = before;
  const Vec2 shift(0.3, -0.2);
  chain.arcs[4].center += shift;
  for (const std::size_t follows : {3u, 5u}) chain.arcs[follows].center += Vec2(9.0, 9.0);
  ASSERT_TRUE(chain.join());
  expect_equations(chain);
  for (const std::size_t arc : {3u, 4u, 5u})
    EXPECT_NEAR((chain.arcs[arc].center - before.arcs[arc].center - shift).norm(), 0.0, kJoinError);
  // The other groups hang on start and goal.
  for (const std::size_t arc : {0u, 1u, 2u, 6u, 7u, 8u})
    EXPECT_NEAR((chain.arcs[arc].center - before.arcs[arc].center).norm(), 0.0, kJoinError);
}

TEST(ArcChain, ShortLinesKeepTheirLengthAndLongOnesFollow) {
  ArcChain chain = chain_of_groups();
  // Shorter than 0.7 radii of 2.5 m.
  chain.lines[3].length = 1.7;
  ASSERT_TRUE(chain.join());
  expect_equations(chain);
  EXPECT_EQ(chain.lines[3].length, 1.7);
  chain.lines[3].length = 1.8;
  chain.arcs[4].center += Vec2(0.1, 0.1);
  ASSERT_TRUE(chain.join());
  expect_equations(chain);
  EXPECT_NE(chain.lines[3].length, 1.8);
}

TEST(ArcChain, IsNotJoinedWhereThatIsImpossible) {
  ArcChain overlapping = chain_of_groups();
  overlapping.arcs[4].center = overlapping.arcs[2].center;
  for (const std::size_t arc : {3u, 4u, 5u}) overlapping.arcs[arc].sign = -1.0;
  EXPECT_FALSE(overlapping.join());
  ArcChain tied = chain_of_groups();
  for (std::size_t i = 1; i + 1 < tied.lines.size(); ++i) tied.lines[i].is_tied = true;
  EXPECT_FALSE(tied.join());
}

TEST(ArcChain, HeadingsAreNotWrapped) {
  ArcChain chain = chain_of_groups();
  for (ArcChain::Line& line : chain.lines) line.heading += kTwoPi * 3.0;
  const ArcChain before = chain;
  ASSERT_TRUE(chain.join());
  for (std::size_t i = 0; i < chain.lines.size(); ++i)
    EXPECT_NEAR(chain.lines[i].heading, before.lines[i].heading, kJoinError);
}

TEST(ArcChain, KnowsWhichPartsAreDrivenForwards) {
  const ArcChain chain = chain_of_groups();
  EXPECT_TRUE(chain.is_drivable());
  for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
    ArcChain wrong = chain;
    wrong.lines[i + 1].heading = wrong.lines[i].heading;
    EXPECT_FALSE(wrong.is_drivable());
    wrong = chain;
    wrong.arcs[i].sign = -1.0;
    EXPECT_FALSE(wrong.is_drivable());
  }
  for (std::size_t i = 0; i < chain.lines.size(); ++i) {
    ArcChain wrong = chain;
    wrong.lines[i].length = 0.0;
    EXPECT_EQ(wrong.is_drivable(), chain.lines[i].is_tied);
  }
}

}  // namespace
}  // namespace arcway::internal
