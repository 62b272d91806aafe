#include "core/reversing/gear_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "core/collision/path_cost.h"
#include "core/model/outlines.h"
#include "core/motion/clearance.h"

namespace arcway::internal {
namespace {

double nothing_ahead(const Pose&) { return 0.0; }

TEST(GearTree, WaysAreFreeJoinedAndAsDearAsTheyTake) {
  const World world = random_world({.obstacles = 30, .vertices = 6, .fill = 0.3, .seed = 4});
  const Outlines outlines(world);
  const Vehicle vehicle;
  const double cusp_cost = 0.02;
  GearTree tree({2.0, 2.0, 0.7}, vehicle, outlines, {8.0, true, cusp_cost}, nothing_ahead);
  double last = 0.0;
  for (int i = 0; i < 300; ++i) {
    const auto node = tree.expand();
    ASSERT_TRUE(node);
    EXPECT_GE(tree[*node].cost, last);  // the cheapest first
    last = tree[*node].cost;
  }
  bool cusps = false;
  for (std::uint32_t node = 1; node < tree.size(); node += 7) {
    const Path path = tree.path_from_root(node);
    for (std::size_t i = 1; i < path.size(); ++i) {
      EXPECT_EQ(path[i].start.x, path[i - 1].end().x);
      EXPECT_EQ(path[i].start.heading, path[i - 1].end().heading);
    }
    for (const PathSegment& s : path) EXPECT_GT(clearance_along(s, vehicle.footprint(), world).distance, 0.0);
    EXPECT_EQ(path.back().end().x, tree[node].pose.x);
    EXPECT_LE(tree[node].cost, path_cost(path, vehicle, {.cusp_cost = cusp_cost}) + 1e-9);  // need not stop there
    EXPECT_NEAR(path_cost(tree.path_to_root(node), vehicle, {.cusp_cost = cusp_cost}),
                path_cost(path, vehicle, {.cusp_cost = cusp_cost}), 1e-9);
    cusps = cusps || cusps_of(path) > 0;
  }
  EXPECT_TRUE(cusps);
}

TEST(GearTree, CountsTheCostOfCusps) {
  const Vehicle vehicle;
  const Outlines outlines(World({}));
  constexpr double kCuspCost = 20.0;  // more than the drives take
  GearTree tree({2.0, 2.0, 0.7}, vehicle, outlines, {8.0, true, kCuspCost}, nothing_ahead);
  for (int i = 0; i < 20; ++i) {
    const auto node = tree.expand();
    ASSERT_TRUE(node);
    EXPECT_TRUE(tree.has_room({tree[*node].pose, 100.0, 1.0 / vehicle.min_turning_radius(), Gear::kReverse}));
  }
  int cusps = 0;
  for (std::uint32_t node = 1; node < tree.size(); ++node) {
    const int count = static_cast<int>(cusps_of(tree.path_from_root(node)));
    EXPECT_EQ(std::floor(tree[node].cost / kCuspCost), count);
    cusps += count;
  }
  EXPECT_GT(cusps, 10);
}

TEST(GearTree, HasNoMotionWhereThereIsNoRoom) {
  const Vehicle vehicle;
  const Footprint body = vehicle.footprint(vehicle.safety_margin());
  const World cell(
      {}, Ring{{-body.rear, -body.right}, {body.front, -body.right}, {body.front, body.left}, {-body.rear, body.left}});
  const Outlines outlines(cell);
  GearTree tree({0.0, 0.0, 0.0}, vehicle, outlines, {64.0, true, 0.0}, nothing_ahead);
  EXPECT_EQ(tree.expand(), GearTree::kRoot);
  EXPECT_FALSE(tree.has_room({{0.0, 0.0, 0.0}, 0.01, 0.0, Gear::kForward}));
  EXPECT_EQ(tree.expand(), std::nullopt);
  EXPECT_EQ(tree.size(), 1u);
  EXPECT_EQ(tree.least_estimate(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace arcway::internal
