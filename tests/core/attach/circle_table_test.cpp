#include "core/attach/circle_table.h"

#include <gtest/gtest.h>

#include <bit>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "arcway/turning_radii.h"
#include "core/roadmap/feasible_graph.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

TEST(CircleTable, SaysWhatTheGraphSays) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}});
  test::RandomInputs random(4);
  constexpr double kSlack = 1e-3;
  int inside = 0, outside = 0, ruled_out = 0;
  for (const ClutterKind kind : {ClutterKind::kConvex, ClutterKind::kStar})
    for (const GraphMode mode : {GraphMode::kEager, GraphMode::kLazy}) {
      const World world = random_world({.kind = kind, .obstacles = 30, .vertices = 8, .fill = 0.4, .seed = 5});
      const Planner planner(world, vehicle, {.graph_mode = mode});
      const FeasibleGraph& graph = planner.feasible_graph();
      const CircleTable table(graph);
      EXPECT_FALSE(table.has_one_radius());
      for (std::uint32_t c = 0; c < graph.circles().size(); ++c) {
        const TurnCircle& circle = graph.circles()[c];
        const CircleTable::Circle same = table.circle(c);
        EXPECT_EQ(same.center, circle.center);
        EXPECT_EQ(same.radius, circle.radius);
        EXPECT_EQ(same.side, circle.side);
        EXPECT_EQ(table.links_from(c).data(), graph.links_from(c).data());
        EXPECT_EQ(table.links_from(c).size(), graph.links_from(c).size());
        std::vector<double> headings{0.0, random.uniform(0.0, kTwoPi), random.uniform(0.0, kTwoPi)};
        for (const HeadingInterval& free : graph.free_headings(c).intervals())
          headings.insert(headings.end(), {free.low, free.high, 0.5 * (free.low + free.high)});
        for (const double heading : headings) {
          const double reach = table.reach(c, heading);
          EXPECT_EQ(reach, graph.free_headings(c).reach(heading, circle.side)) << "circle " << c << " at " << heading;
          EXPECT_EQ(reach >= 0.0, graph.free_headings(c).contains(heading));
          const double about = wrap_positive(heading + random.uniform(-1.0, 1.0) * kSlack);
          EXPECT_TRUE(reach < 0.0 || table.may_be_free(c, about, kSlack)) << "circle " << c << " at " << heading;
          EXPECT_TRUE(reach < 0.0 || (table.free_sectors(c) & sectors_of(heading, heading)) != 0);
          ruled_out += table.may_be_free(c, about, kSlack) ? 0 : 1;
          ++(reach < 0.0 ? outside : inside);
        }
      }
    }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
  EXPECT_GT(ruled_out, 300);
}

TEST(Sectors, HoldTheHeadingsOfTheirRange) {
  test::RandomInputs random(6);
  for (int i = 0; i < 10000; ++i) {
    const double low = random.uniform(-3.0 * kPi, 3.0 * kPi), width = random.unit() * kTwoPi;
    const Sectors sectors = sectors_of(low, low + width);
    const double inside = low + random.unit() * width;
    EXPECT_NE(sectors & sectors_of(inside, inside), 0u);
    EXPECT_LE(std::popcount(sectors), static_cast<int>(width * (64.0 / kTwoPi)) + 2);
  }
  EXPECT_EQ(sectors_of(-0.01, 0.01), (Sectors{1} << 63) | 1);
  EXPECT_EQ(sectors_of(1.0, 1.0 + kTwoPi), kAllSectors);
}

TEST(CircleTable, KnowsThatThereIsOneRadius) {
  const World world = random_world({.obstacles = 10, .vertices = 8, .fill = 0.3, .seed = 5});
  const Planner planner(world, Vehicle());
  EXPECT_TRUE(CircleTable(planner.feasible_graph()).has_one_radius());
}

}  // namespace
}  // namespace arcway::internal
