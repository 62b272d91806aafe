#include "bench/figures/figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "arcway/datasets/paper_example.h"
#include "bench/robots.h"
#ifdef ARCWAY_WITH_ACCEL
#include "arcway/accel/accel_backend.h"
#endif

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

// Values of all animations of an element.
std::vector<std::size_t> value_counts(const std::string& svg, std::string_view animation) {
  std::vector<std::size_t> counts;
  for (std::size_t at = svg.find(animation); at != std::string::npos; at = svg.find(animation, at + 1)) {
    const std::size_t from = svg.find("values=\"", at) + 8, to = svg.find('"', from);
    counts.push_back(1 + static_cast<std::size_t>(std::count(svg.begin() + static_cast<std::ptrdiff_t>(from),
                                                             svg.begin() + static_cast<std::ptrdiff_t>(to), ';')));
  }
  return counts;
}

TEST(Figures, AnimateADriveByElementsOfSvgAlone) {
#ifdef ARCWAY_WITH_ACCEL
  const auto make_backend = [](const World& world) { return accel_backend(world, kSerialExecutor); };
#else
  const auto make_backend = [](const World& world) { return reference_backend(world); };
#endif
  const LiveFigures live = live_drive(make_backend);
  EXPECT_EQ(live.animation.name, "live");
  EXPECT_EQ(live.moments.name, "live_moments");
  const std::string& svg = live.animation.svg;
  for (const char* refused : {"<script", "href", "url(", "nan", "inf"})
    EXPECT_EQ(svg.find(refused), std::string::npos) << refused;
  // A value a cycle; what glides ends with one more.
  for (const std::size_t count : value_counts(svg, "<animate ")) EXPECT_EQ(count, 150U);
  const std::vector<std::size_t> gliding = value_counts(svg, "<animateTransform ");
  for (const std::size_t count : gliding) EXPECT_EQ(count, 151U);
  EXPECT_GT(gliding.size(), 3U);  // the vehicle takes two
  EXPECT_NE(svg.find("opacity\" dur"), std::string::npos);
  EXPECT_EQ(live.moments.svg.find("<animate"), std::string::npos);
  EXPECT_EQ(live_drive(make_backend).animation.svg, svg);
}

}  // namespace
}  // namespace arcway::internal::figures
