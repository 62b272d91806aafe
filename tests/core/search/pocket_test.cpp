#include "core/search/pocket.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "core/planner.h"
#include "datasets/clutter.h"
#include "datasets/random_queries.h"

namespace arcway {
namespace {

using Link = FeasibleGraph::Link;

World dense_world(std::uint64_t seed) {
  return random_world({.kind = ClutterKind::kStar, .obstacles = 25, .vertices = 6, .fill = 0.4, .seed = seed});
}

// From an arrival to a departure by the turn that leads there, within one interval of free headings.
bool turns_to(const FeasibleGraph& graph, std::uint32_t circle, double arrival, double departure) {
  const bool left = graph.circles()[circle].side == Side::kLeft;
  const double from = left ? arrival : departure;
  const double to = left ? departure : arrival;
  for (const HeadingInterval& free : graph.free_headings(circle).intervals())
    for (const double lap : {0.0, kTwoPi}) {
      const double low = from + lap;
      const double high = low + (to >= from ? to - from : to - from + kTwoPi);
      if (low >= free.low && high <= free.high) return true;
    }
  return graph.free_headings(circle).is_full();
}

TEST(LinksTo, AreTheLinksThatEndThere) {
  const World world = dense_world(1);
  const Planner planner(world, Vehicle{});
  const FeasibleGraph& graph = planner.feasible_graph();
  std::vector<std::vector<std::uint32_t>> expected(graph.circles().size());
  for (std::uint32_t i = 0; i < graph.links().size(); ++i) expected[graph.links()[i].to].push_back(i);
  ASSERT_FALSE(graph.links().empty());
  for (std::uint32_t c = 0; c < expected.size(); ++c)
    EXPECT_TRUE(std::ranges::equal(graph.links_to(c), expected[c])) << "circle " << c;
}

TEST(DeparturesTowards, AreThoseThatLeadThereGoingForwards) {
  std::size_t pockets = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const World world = dense_world(seed);
    const Planner planner(world, Vehicle{});
    const FeasibleGraph& graph = planner.feasible_graph();
    const std::span<const Link> links = graph.links();
    for (std::size_t end = 0; end < links.size(); end += 1 + links.size() / 20) {
      std::vector<bool> leads(links.size());
      for (bool grown = true; grown;) {
        grown = false;
        for (std::size_t a = 0; a < links.size(); ++a) {
          if (leads[a]) continue;
          leads[a] =
              links[a].to == links[end].from && turns_to(graph, links[a].to, links[a].heading, links[end].heading);
          for (std::size_t b = 0; b < links.size() && !leads[a]; ++b)
            leads[a] = leads[b] && links[a].to == links[b].from &&
                       turns_to(graph, links[a].to, links[a].heading, links[b].heading);
          grown = grown || leads[a];
        }
      }
      std::multiset<std::pair<std::uint32_t, double>> expected{{links[end].from, links[end].heading}};
      for (std::size_t a = 0; a < links.size(); ++a)
        if (leads[a]) expected.insert({links[a].from, links[a].heading});

      const auto found = departures_towards(graph, {{links[end].from, links[end].heading}}, links.size() + 1);
      ASSERT_TRUE(found);
      std::multiset<std::pair<std::uint32_t, double>> got;
      for (const Departure& d : *found) got.insert({d.circle, d.heading});
      EXPECT_EQ(got, expected) << "seed " << seed << ", link " << end;
      EXPECT_FALSE(departures_towards(graph, {{links[end].from, links[end].heading}}, found->size() - 1));
      pockets += found->size() < links.size() / 2 ? 1 : 0;
    }
  }
  EXPECT_GT(pockets, 0U);  // else the walk could take everything
}

TEST(Pocket, ChangesNoAnswer) {
  std::size_t without_path = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const World world = dense_world(seed);
    const Planner eager(world, Vehicle{});
    const Planner lazy(world, Vehicle{}, {.graph_mode = GraphMode::kLazy});  // which goes forwards alone
    for (const PlanRequest& request :
         random_queries(world, make_reference_queries(world), Vehicle(), {.count = 40, .seed = seed})) {
      const PlanResult a = eager.plan(request);
      const PlanResult b = lazy.plan(request);
      EXPECT_EQ(a.status, b.status) << "seed " << seed << ", start " << request.start.x;
      EXPECT_EQ(a.travel_time, b.travel_time);
      without_path += a.status == PlanStatus::kNoPath ? 1 : 0;
    }
  }
  EXPECT_GT(without_path, 0U);
}

}  // namespace
}  // namespace arcway
