#include "core/roadmap/circle_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

#include "arcway/angle.h"
#include "tests/support/graph_case.h"

namespace arcway::internal {
namespace {

TEST(CircleChecks, RefusesRadiiThatAreNotAscendingAndPositive) {
  test::GraphCase c;
  EXPECT_NO_THROW(CircleChecks(c.inputs(), SerialExecutor()));
  for (const std::vector<double>& radii : {std::vector<double>{}, {2.0, 1.0}, {1.0, 1.0}, {-1.0}, {1.0, HUGE_VAL}}) {
    c.radii = radii;
    EXPECT_THROW(CircleChecks(c.inputs(), SerialExecutor()), std::invalid_argument);
  }
}

TEST(CircleChecks, TurnsWideRoundTheVertexOnly) {
  const test::GraphCase c;
  const CircleChecks checks(c.inputs(), SerialExecutor());
  const std::span<const TurnCircle> circles = checks.circles().all();
  const Footprint body = c.vehicle.footprint(0.5 * c.vehicle.safety_margin());
  std::size_t free = 0;
  for (std::uint32_t i = 0; i < circles.size(); ++i) {
    const TurnCircle& circle = circles[i];
    if (circle.radius == c.radii[0]) continue;
    const double at_vertex = heading_at_vertex(c.world, circle);
    EXPECT_NEAR((pose_on(circle, at_vertex).position() - c.world.vertex(circle.vertex)).norm(),
                0.5 * c.vehicle.parameters().width + c.vehicle.safety_margin(), 1e-9);
    const HeadingSet all = c.queries.sweep->free_headings(TurningBody{circle.center, circle.radius, circle.side, body});
    const HeadingSet kept = checks.free_headings(i);
    EXPECT_EQ(kept.empty(), !all.contains(at_vertex));
    if (kept.empty()) continue;
    ++free;
    EXPECT_TRUE(kept.contains(at_vertex));
    EXPECT_LE(kept.reach(at_vertex, Side::kLeft), all.reach(at_vertex, Side::kLeft) + 1e-12);
    EXPECT_LE(kept.reach(at_vertex, Side::kLeft), 0.6 * kPi);
    EXPECT_LE(kept.reach(at_vertex, Side::kRight), 0.6 * kPi);
  }
  EXPECT_GT(free, 10u);
}

TEST(CircleChecks, AnswerManyAtOnceAsOneByOne) {
  const test::GraphCase c;
  const CircleChecks checks(c.inputs(), SerialExecutor());
  const std::vector<std::uint32_t> circles{7, 3, 8, 0, 41};
  std::vector<HeadingSet> found(circles.size());
  checks.free_headings(circles, found);
  std::size_t blocked = 0;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const HeadingSet one = checks.free_headings(circles[i]);
    ASSERT_EQ(found[i].intervals().size(), one.intervals().size());
    for (std::size_t k = 0; k < one.intervals().size(); ++k) {
      EXPECT_EQ(found[i].intervals()[k].low, one.intervals()[k].low);
      EXPECT_EQ(found[i].intervals()[k].high, one.intervals()[k].high);
    }
    const LinkRow row = checks.departures(circles[i], one, {});
    std::vector<std::uint8_t> free(row.links.size());
    checks.are_free(row.links, free);
    for (std::size_t k = 0; k < free.size(); ++k) {
      EXPECT_EQ(checks.is_free(row.links[k]), free[k] != 0);
      EXPECT_TRUE(one.contains(row.links[k].heading));
      blocked += free[k] ? 0 : 1;
    }
  }
  EXPECT_GT(blocked, 0u);
}

}  // namespace
}  // namespace arcway::internal
