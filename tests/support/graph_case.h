#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "core/roadmap/build_feasible_graph.h"
#include "core/roadmap/lazy_feasible_graph.h"

namespace arcway::internal::test {

/// A world of some obstacles, and what a feasible graph of it is built from.
struct GraphCase {
  explicit GraphCase(const World& w) : world(w) {}
  explicit GraphCase(const ClutterParameters& clutter =
                         {.kind = ClutterKind::kStar, .obstacles = 20, .vertices = 6, .fill = 0.3, .seed = 5})
      : world(random_world(clutter)) {}

  [[nodiscard]] FeasibleGraphInputs inputs() const {
    return {world, vehicle, rows_of(world, visibility), queries, radii};
  }
  [[nodiscard]] std::shared_ptr<const FinishedFeasibleGraph> finished() const {
    return build_feasible_graph(inputs(), SerialExecutor());
  }
  [[nodiscard]] std::shared_ptr<const LazyFeasibleGraph> lazy() const {
    return std::make_shared<const LazyFeasibleGraph>(inputs(), SerialExecutor());
  }

  World world;
  Vehicle vehicle = Vehicle();
  QuerySet queries = make_reference_queries(world);
  VisibilityGraph visibility = build_reduced_visibility_graph(world, *queries.visibility);
  std::vector<double> radii = {vehicle.min_turning_radius(), 2.0 * vehicle.min_turning_radius()};
};

/// Has a lazy graph find out everything.
inline std::vector<FeasibleLink> kept_links(const FeasibleGraph& graph) {
  std::vector<FeasibleLink> kept;
  for (std::uint32_t c = 0; c < graph.circles().size(); ++c) {
    const auto links = graph.links_from(c);
    for (std::size_t i = 0; i < links.size(); ++i)
      if (graph.is_kept(c, i)) kept.push_back(links[i]);
  }
  return kept;
}

inline void expect_same(std::span<const FeasibleLink> a, std::span<const FeasibleLink> b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].from, b[i].from);
    EXPECT_EQ(a[i].to, b[i].to);
    EXPECT_EQ(a[i].heading, b[i].heading);
    EXPECT_EQ(a[i].length, b[i].length);
  }
}

/// All counts of two graphs.
inline void expect_same(const FeasibleGraphCounts& a, const FeasibleGraphCounts& b) {
  EXPECT_EQ(a.circles, b.circles);
  EXPECT_EQ(a.circles_blocked, b.circles_blocked);
  EXPECT_EQ(a.candidates, b.candidates);
  EXPECT_EQ(a.repeated, b.repeated);
  EXPECT_EQ(a.kept, b.kept);
  EXPECT_EQ(a.rejected_overlap, b.rejected_overlap);
  EXPECT_EQ(a.rejected_departure, b.rejected_departure);
  EXPECT_EQ(a.rejected_arrival, b.rejected_arrival);
  EXPECT_EQ(a.rejected_straight, b.rejected_straight);
}

}  // namespace arcway::internal::test
