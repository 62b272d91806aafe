#include "bench/figures/figures.h"

#include <gtest/gtest.h>

#include <set>

#include "arcway/datasets/paper_example.h"
#include "bench/robots.h"

namespace arcway::internal::figures {
namespace {

TEST(Figures, AreSevenDocumentsWithTheirNumbersInTheCaption) {
  const PaperExample example = paper_example();
  const Planner planner(example.world, Vehicle(example.robot));
  const PlanResult plan = planner.plan({.start = example.start, .goal = example.goal});
  ASSERT_TRUE(plan.solved());
  const Figure figures[] = {visibility_graphs(planner),
                            vehicle_model(planner.vehicle()),
                            radial_sets(planner, plan),
                            minimum_distance_pairs(planner, plan),
                            swept_turn(planner.vehicle(), "figure5"),
                            speed_profiles(planner.vehicle()),
                            feasible_graph_and_motion(planner, plan)};
  std::set<std::string> names;
  for (const Figure& figure : figures) {
    names.insert(figure.name);
    EXPECT_EQ(figure.svg.find("nan"), std::string::npos) << figure.name;
    EXPECT_NE(figure.svg.find("</svg>"), std::string::npos) << figure.name;
  }
  EXPECT_EQ(names.size(), 7u);
  // The point path turns at vertices: one radial set for each of at least two segments.
  const std::string& sets = figures[2].caption;
  EXPECT_NE(sets.find(", ", sets.find("left + right: ")), std::string::npos) << sets;
  EXPECT_NE(figures[4].caption.find("w_s = 1.30"), std::string::npos) << figures[4].caption;
  EXPECT_NE(figures[6].caption.find(digits(plan.travel_time, 2) + " s"), std::string::npos) << figures[6].caption;
}

TEST(Figures, DrawTheSweptAreaOfPolygons) {
  const Vehicle tractor = bench::mowing_tractor().vehicle();
  const Figure figure = swept_turn(tractor, "figure5_tractor");
  EXPECT_EQ(figure.name, "figure5_tractor");
  const double radius = tractor.min_turning_radius(Side::kLeft);
  const double exact = tractor.swept_annulus(Side::kLeft, radius).width();
  EXPECT_NE(figure.caption.find("w_s = " + digits(exact, 2)), std::string::npos) << figure.caption;
  EXPECT_NE(digits(exact, 2), digits(swept_annulus(tractor.footprint(), Side::kLeft, radius).width(), 2));
}

}  // namespace
}  // namespace arcway::internal::figures
