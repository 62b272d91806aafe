#include "core/search/backward_reachable_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/planner.h"
#include "core/attach/attachment_links.h"
#include "core/attach/roadmap.h"
#include "core/roadmap/build_feasible_graph.h"

namespace arcway::internal {
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
  for (const GraphMode mode : {GraphMode::kEager, GraphMode::kLazy}) {
    const Planner planner(world, Vehicle{}, {.graph_mode = mode});
    const CircleTable circles(planner.feasible_graph());
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> expected(circles.size());
    for (std::uint32_t c = 0; c < circles.size(); ++c)
      for (std::uint32_t i = 0; i < circles.links_from(c).size(); ++i)
        expected[circles.links_from(c)[i].to].emplace_back(c, i);
    for (std::uint32_t c = 0; c < circles.size(); ++c) {
      std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
      for (const CircleTable::LinkOf& link : circles.links_to(c)) found.emplace_back(link.circle, link.index);
      EXPECT_EQ(found, expected[c]) << "circle " << c;
    }
  }
}

TEST(DeparturesTowards, AreThoseThatLeadThereGoingForwards) {
  std::size_t small_sets = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const World world = dense_world(seed);
    const Planner planner(world, Vehicle{});
    const FinishedFeasibleGraph& graph = *planner.feasible_graph().finished();
    const CircleTable circles(graph);
    const Planner lazy(world, Vehicle{}, {.graph_mode = GraphMode::kLazy});
    const CircleTable lazy_circles(lazy.feasible_graph());
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

      const auto sorted = [](const std::vector<Departure>& departures) {
        std::multiset<std::pair<std::uint32_t, double>> all;
        for (const Departure& d : departures) all.insert({d.circle, d.heading});
        return all;
      };
      const auto found = backward_reachable_set(circles, {{links[end].from, links[end].heading}}, links.size() + 1);
      ASSERT_TRUE(found);
      EXPECT_EQ(sorted(*found), expected) << "seed " << seed << ", link " << end;
      EXPECT_FALSE(backward_reachable_set(circles, {{links[end].from, links[end].heading}}, found->size() - 1));
      const auto lazily =
          backward_reachable_set(lazy_circles, {{links[end].from, links[end].heading}}, links.size() + 1);
      ASSERT_TRUE(lazily);
      EXPECT_EQ(sorted(*lazily), expected) << "seed " << seed << ", link " << end;
      small_sets += found->size() < links.size() / 2 ? 1 : 0;
    }
  }
  EXPECT_GT(small_sets, 0U);  // else the walk could take everything
}

// Whether the links of an eager graph lead from one pose to the other, going forwards alone.
bool is_reachable(const Roadmap& map, const PlanRequest& request) {
  AttachmentLinks links;
  std::vector<AttachmentCircle> starts, goals;
  HugeVector<AttachmentLink> start_links, goal_links;
  const Attachment start{request.start, {}}, goal{request.goal, {}};
  const LengthLimit anywhere{request.goal.position(), std::numeric_limits<double>::infinity()};
  const PathEnd at_start{map, Direction::kFromStart}, at_goal{map, Direction::kToGoal};
  links.append_circles(at_start, {&start, 1}, 0, starts);
  links.append_circles(at_goal, {&goal, 1}, 0, goals);
  for (std::uint32_t i = 0; i < starts.size(); ++i) links.append_links(at_start, starts, i, anywhere, start_links);
  for (std::uint32_t i = 0; i < goals.size(); ++i) links.append_links(at_goal, goals, i, anywhere, goal_links);
  const auto is_free = [&](const AttachmentLink& link) {
    return map.queries.sweep->straight_free(swept_rectangle(link.line.start, link.line.length, map.body));
  };

  std::vector<std::pair<std::uint32_t, double>> arrivals;
  for (const AttachmentLink& link : start_links)
    if (is_free(link)) arrivals.emplace_back(link.circle, link.line.start.heading);
  std::set<const Link*> taken;
  for (std::size_t i = 0; i < arrivals.size(); ++i) {
    const auto [circle, heading] = arrivals[i];
    for (const AttachmentLink& link : goal_links)
      if (link.circle == circle && turns_to(*map.graph, circle, heading, link.line.start.heading) && is_free(link))
        return true;
    for (const Link& link : map.graph->links_from(circle))
      if (turns_to(*map.graph, circle, heading, link.heading) && taken.insert(&link).second)
        arrivals.emplace_back(link.to, link.heading);
  }
  return false;
}

TEST(BackwardReachableSet, ChangesNoAnswer) {
  std::size_t without_path = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const World world = dense_world(seed);
    const PlannerOptions options{.maneuver_poses = 0, .gap_circles = false, .refinement = {.max_trials = 0}};
    const Planner eager(world, Vehicle{}, options);
    PlannerOptions lazily = options;
    lazily.graph_mode = GraphMode::kLazy;
    const Planner lazy(world, Vehicle{}, lazily);
    auto graph = build_feasible_graph(
        {world, eager.vehicle(), eager.visibility_rows(), eager.queries(), eager.options().radii}, SerialExecutor());
    const Roadmap map(world, eager.vehicle(), eager.queries(), eager.options().radii, std::move(graph),
                      std::make_shared<const Outlines>(world));
    for (const PlanRequest& request :
         random_queries(world, make_reference_queries(world), Vehicle(), {.count = 40, .seed = seed})) {
      const PlanResult a = eager.plan(request);
      const PlanResult b = lazy.plan(request);
      EXPECT_EQ(a.status, b.status) << "seed " << seed << ", start " << request.start.x;
      EXPECT_EQ(a.travel_time, b.travel_time);
      const bool direct = a.solved() && a.segments.size() <= 3;  // by one word
      EXPECT_TRUE(direct || a.solved() == is_reachable(map, request))
          << "seed " << seed << ", start " << request.start.x;
      without_path += a.status == PlanStatus::kNoPath ? 1 : 0;
    }
  }
  EXPECT_GT(without_path, 0U);
}

}  // namespace
}  // namespace arcway::internal
