#include "core/attach/close_turns.h"

#include <gtest/gtest.h>

#include <memory>

#include "arcway/angle.h"
#include "core/model/outlines.h"
#include "tests/support/graph_case.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

TEST(CloseTurns, CostAsMuchAsTheirArcs) {
  const test::GraphCase in;
  const std::shared_ptr<const FeasibleGraph> graph = in.finished();
  const auto cost = std::make_shared<const ClearanceCost>(in.vehicle, std::make_shared<const Outlines>(in.world),
                                                          ClearancePreference{.distance = 0.4, .cost = 3.0});
  const CloseTurns turns(graph, cost);
  test::RandomInputs random(6);
  int close = 0, free = 0;
  for (int i = 0; i < 500; ++i) {
    const auto c =
        static_cast<std::uint32_t>(random.integer(0, static_cast<std::int64_t>(graph->circles().size()) - 1));
    const TurnCircle& circle = graph->circles()[c];
    const double heading = random.uniform(-4.0, 4.0), turn = random.uniform(0.0, kTwoPi);
    const PathSegment arc{pose_on(circle, heading), turn * circle.radius, sign_of(circle.side) / circle.radius};
    const double expected = cost->of(arc), found = turns.cost_of(c, heading, turn);
    EXPECT_NEAR(found, expected, 1e-9) << "circle " << c;
    EXPECT_EQ(turns.cost_of(c, heading, turn), found);
    close += found > 0.0 && found < 2.99 * arc.length ? 1 : 0;
    free += found == 0.0 ? 1 : 0;
  }
  EXPECT_GT(close, 100);
  EXPECT_GT(free, 5);
}

}  // namespace
}  // namespace arcway::internal
