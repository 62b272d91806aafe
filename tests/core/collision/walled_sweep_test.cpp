#include "core/collision/walled_sweep.h"

#include <gtest/gtest.h>

#include "arcway/query_set.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

const Footprint kWalledBody{1.4, 0.1, 0.4, 0.4};

// A wall as an obstacle that is all but without thickness.
Polygon sliver(const LineSegment& wall) {
  const Vec2 aside = 1e-12 * perpendicular(wall.b - wall.a).normalized();
  return {{wall.a, wall.b, wall.b + aside}, {}};
}

TEST(WalledSweep, SaysWhatTheWorldWithTheWallsInItSays) {
  test::RandomInputs random(7);
  int free = 0, blocked = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Polygon> obstacles;
    for (int i = 0; i < 3; ++i) {
      const Vec2 p = random.point(-6.0, 6.0);
      obstacles.push_back({{p, p + Vec2(1.0, 0.0), p + Vec2(0.5, 1.0)}, {}});
    }
    std::vector<LineSegment> walls;
    for (std::int64_t i = random.integer(0, 3); i > 0; --i) walls.push_back({random.point(-6, 6), random.point(-6, 6)});
    std::vector<Polygon> all = obstacles;
    for (const LineSegment& wall : walls) all.push_back(sliver(wall));
    const QuerySet plain = make_reference_queries(World(obstacles));
    const QuerySet solid = make_reference_queries(World(all));
    const WalledSweep walled(plain.sweep, walls);
    for (int i = 0; i < 20; ++i) {
      const Vec2 p = random.point(-7.0, 7.0);
      const SweptRectangle r =
          swept_rectangle({p.x(), p.y(), random.uniform(-3.0, 3.0)}, random.uniform(0, 4), kWalledBody);
      EXPECT_EQ(walled.straight_free(r), solid.sweep->straight_free(r));
      const TurningBody body{p, random.uniform(1.3, 4.0), random.integer(0, 1) == 0 ? Side::kLeft : Side::kRight,
                             kWalledBody};
      const HeadingSet one = walled.free_headings(body);
      const HeadingSet other = solid.sweep->free_headings(body);
      for (int k = 0; k < 50; ++k) {
        const double heading = random.uniform(0.0, 6.28);
        EXPECT_EQ(one.contains(heading), other.contains(heading));
        ++(one.contains(heading) ? free : blocked);
      }
    }
  }
  EXPECT_GT(free, 1000);
  EXPECT_GT(blocked, 1000);
}

}  // namespace
}  // namespace arcway::internal
