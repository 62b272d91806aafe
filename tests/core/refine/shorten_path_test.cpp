#include "core/refine/shorten_path.h"

#include <gtest/gtest.h>

#include "arcway/query_set.h"
#include "arcway/world.h"
#include "core/motion/speed_profile.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

// Many short turns to either side, along a line.
Path weaving(double radius, int turns) {
  Path path;
  Pose at{0.0, 0.0, 0.0};
  for (int i = 0; i < turns; ++i) {
    const double side = i % 4 == 0 || i % 4 == 3 ? 1.0 : -1.0;
    path.push_back({at, 0.3 * radius, side / radius});
    at = path.back().end();
  }
  return path;
}

double time_of(const Path& path, const Vehicle& vehicle) { return speed_profile(path, vehicle).total_time; }

TEST(ShortenPath, StraightensWhatWeavesInTheOpen) {
  const World world({{{{0.0, 50.0}, {1.0, 50.0}, {1.0, 51.0}}, {}}});
  const Vehicle vehicle;
  const QuerySet queries = make_reference_queries(world);
  const Path path = weaving(2.0 * vehicle.min_turning_radius(), 16);
  const Path shorter = shorten_path(path, vehicle, *queries.sweep, 1000, {});
  EXPECT_LT(time_of(shorter, vehicle), 0.95 * time_of(path, vehicle));
  test::expect_valid(world, vehicle, path.front().start, path.back().end(), shorter);
}

TEST(ShortenPath, StaysFree) {
  const Vehicle vehicle;
  const Path path = weaving(2.0 * vehicle.min_turning_radius(), 16);
  const Vec2 middle = path[8].start.position();
  // A post that the weaving path passes, and a straight one would not.
  const double beside = 0.5 * vehicle.parameters().width + 0.02;
  const Vec2 post = middle - beside * perpendicular(direction_of(path[8].start.heading));
  const World world({{{post, post + Vec2(0.1, -0.1), post + Vec2(-0.1, -0.1)}, {}}});
  const QuerySet queries = make_reference_queries(world);
  const Path shorter = shorten_path(path, vehicle, *queries.sweep, 1000, {});
  EXPECT_LE(time_of(shorter, vehicle), time_of(path, vehicle));
  test::expect_valid(world, vehicle, path.front().start, path.back().end(), shorter);
}

TEST(ShortenPath, CanBeStopped) {
  const World world({{{{0.0, 50.0}, {1.0, 50.0}, {1.0, 51.0}}, {}}});
  const Vehicle vehicle;
  const QuerySet queries = make_reference_queries(world);
  const Path path = weaving(2.0, 16);
  EXPECT_EQ(shorten_path(path, vehicle, *queries.sweep, 1000, StopClock(0.0)).size(), path.size());
}

}  // namespace
}  // namespace arcway::internal
