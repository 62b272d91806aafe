#include "core/refine/circle_chain.h"

#include <gtest/gtest.h>

#include "arcway/angle.h"
#include "arcway/validation.h"
#include "arcway/world.h"
#include "core/motion/dubins.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

void expect_joined(const Path& path, const Pose& start, const Pose& goal) {
  TimedPath timed;
  timed.segments = path;
  const ValidationReport report = validate(World({}), Vehicle{}, start, goal, timed);
  for (const ValidationIssue& issue : report.issues) ADD_FAILURE() << name_of(issue.violation) << ": " << issue.message;
}

TEST(CircleChain, GivesEveryDubinsWordBack) {
  test::RandomInputs random(3);
  int chains = 0;
  for (int i = 0; i < 2000; ++i) {
    const double side = i % 2 == 0 ? 5.0 : 500.0;
    const auto pose = [&] {
      return Pose{random.uniform(-side, side), random.uniform(-side, side), random.uniform(-7.0, 7.0)};
    };
    const Pose start = pose(), goal = pose();
    for (const DubinsWord word : kDubinsWords) {
      const auto path = dubins_path(word, start, goal, 1.4);
      if (!path) continue;
      const auto chain = chain_of(*path, start, goal);
      if (!chain) continue;  // an arc of the word vanishes
      const auto lines = lines_of(*chain);
      ASSERT_TRUE(lines) << "poses " << i;
      const Path again = path_of(*chain, *lines);
      EXPECT_NEAR(length_of(again), length_of(*path), 1e-6) << "poses " << i;
      expect_joined(again, start, goal);
      ++chains;
    }
  }
  EXPECT_GT(chains, 5000);
}

TEST(CircleChain, KeepsTheStraightsAtBothEnds) {
  const Pose start{1, 2, 0.3};
  Path path{{start, 2.0, 0.0}};
  for (const auto& [length, curvature] : {std::pair{1.0, 0.5}, {3.0, 0.0}, {2.0, -0.25}, {4.0, 0.0}})
    path.push_back({path.back().end(), length, curvature});
  const Pose goal = path.back().end();
  const auto chain = chain_of(path, start, goal);
  ASSERT_TRUE(chain);
  ASSERT_EQ(chain->circles.size(), 2u);
  EXPECT_DOUBLE_EQ(chain->lead_in, 2.0);
  EXPECT_DOUBLE_EQ(chain->lead_out, 4.0);
  const Path again = path_of(*chain, lines_of(*chain).value());
  ASSERT_EQ(again.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_NEAR(again[i].length, path[i].length, 1e-12);
    EXPECT_NEAR(again[i].curvature, path[i].curvature, 1e-12);
  }
  expect_joined(again, start, goal);
}

TEST(CircleChain, NeighboringArcsOfOneCircleCountAsOne) {
  const Pose start{0, 0, 0};
  Path path{{start, 1.0, 0.5}};
  for (const auto& [length, curvature] : {std::pair{0.5, 0.5}, {1.0, -0.5}})
    path.push_back({path.back().end(), length, curvature});
  const auto chain = chain_of(path, start, path.back().end());
  ASSERT_TRUE(chain);
  EXPECT_EQ(chain->circles.size(), 2u);
  const Path again = path_of(*chain, lines_of(*chain).value());
  EXPECT_NEAR(length_of(again), 2.5, 1e-6);
}

TEST(CircleChain, FewerThanTwoCirclesAreNone) {
  const Pose start{0, 0, 0};
  EXPECT_FALSE(chain_of(Path{}, start, start));
  EXPECT_FALSE(chain_of(Path{{start, 3.0, 0.0}}, start, {3, 0, 0}));
  EXPECT_FALSE(chain_of(Path{{start, 3.0, 0.1}}, start, PathSegment{start, 3.0, 0.1}.end()));
}

TEST(CircleChain, OverlappingOppositeCirclesHaveNoPath) {
  CircleChain chain{{0, 0, 0}, {4, 0, 0}, 0.0, 0.0, {}};
  chain.circles = {{{0, 0}, 5.0, Side::kLeft, kNone}, {{0, 0}, 5.0, Side::kRight, kNone}};
  chain.place_ends();
  chain.circles[1].center = {1.0, 4.0};
  EXPECT_FALSE(lines_of(chain));
}

}  // namespace
}  // namespace arcway::internal
