#include "core/search/route_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "arcway/angle.h"
#include "arcway/query_set.h"
#include "core/roadmap/lazy_feasible_graph.h"
#include "tests/support/boxes.h"

namespace arcway::internal {

using test::box_ring;

namespace {

// A wall with a gap in its middle, which ends in the open above.
RouteField field_behind_a_wall(double gap) {
  const World world({{box_ring(9.0, -20.0, 10.0, -0.5 * gap), {}}, {box_ring(9.0, 0.5 * gap, 10.0, 20.0), {}}},
                    box_ring(-5.0, -20.0, 30.0, 30.0));
  const Vehicle vehicle;
  const QuerySet queries = make_reference_queries(world);
  const std::vector<double> radii{vehicle.min_turning_radius()};
  auto graph = std::make_shared<const LazyFeasibleGraph>(
      FeasibleGraphInputs{world, vehicle, rows_of(world, build_reduced_visibility_graph(world, *queries.visibility)),
                          queries, radii},
      SerialExecutor());
  const Roadmap map(world, vehicle, queries, radii, std::move(graph), std::make_shared<const Outlines>(world));
  return {map, {0.0, 0.0, 0.3}, {20.0, 0.0, 0.0}, 100'000, {}};
}

TEST(RouteField, LeadsThroughGapsThatAreWideEnough) {
  EXPECT_NEAR(field_behind_a_wall(1.0)({0.0, 0.0, 0.0}), 20.0, 2.0);
}

TEST(RouteField, LeadsRoundGapsThatAreTooNarrow) {
  const double round = 2.0 * std::hypot(9.5, 20.0);
  EXPECT_NEAR(field_behind_a_wall(0.7)({0.0, 0.0, 0.0}), round, 0.1 * round);
}

// A vehicle that faces away from the goal has to turn around first.
TEST(RouteField, HeedsTurns) {
  RouteField field = field_behind_a_wall(1.0);
  EXPECT_NEAR(field({0.0, 0.0, kPi}), 20.0, 2.0);
  field.heed_turns(1.3, {});
  EXPECT_NEAR(field({0.0, 0.0, 0.0}), 20.0, 2.0);
  EXPECT_GT(field({0.0, 0.0, kPi}), 21.5);
}

TEST(RouteField, EndsAtThePlace) { EXPECT_NEAR(field_behind_a_wall(1.0)({20.0, 0.0, 0.0}), 0.0, 0.5); }

}  // namespace
}  // namespace arcway::internal
