#include "core/roadmap/build_feasible_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <stop_token>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/planner.h"
#include "core/geometry/predicates.h"
#include "core/roadmap/tangent_edges.h"
#include "tests/support/graph_case.h"
#include "tests/support/plans.h"
#include "tests/support/same_graphs.h"
#include "tests/support/thread_team.h"

namespace arcway::internal {
namespace {

using Arrivals = std::set<std::pair<VertexId, Side>>;

// Where the edges of the reduced graph lead that leave a vertex with its obstacle on one side, and the side of the
// obstacle there.
Arrivals straights_from(const test::GraphCase& c, VertexId from, Side side) {
  Arrivals found;
  for (VertexId u = 0; u < c.visibility.vertex_count(); ++u)
    for (const VertexId v : c.visibility.row(u))
      for (const auto& [a, b] : {std::pair{u, v}, std::pair{v, u}})
        if (a == from && obstacle_side(c.world, a, c.world.vertex(b)) != side)
          found.insert({b, obstacle_side(c.world, b, c.world.vertex(a))});
  return found;
}

struct Stop {
  VertexId vertex, before;
  Side side;
};

// The straights from a circle, with those beside edges. They lead to the far ends of edges of the vertex before on its
// ring, where a path along the circles' bitangents turns around `from`. They also lead to the vertices before those,
// where it turns around them.
std::vector<Stop> straights_beside_edges(const test::GraphCase& c, std::span<const TurnCircle> circles,
                                         const TurnCircle& from) {
  const auto round = [&](VertexId v, Side side) {
    return std::find_if(circles.begin(), circles.end(), [&](const auto& t) { return t.vertex == v && t.side == side; });
  };
  const auto before_on_ring = [&](VertexId v, Side side) {
    const VertexId before = side == Side::kLeft ? c.world.previous(v) : c.world.next(v);
    return straights_from(c, before, side).contains({v, side}) ? before : kNone;
  };
  const auto bends = [&](const TurnCircle& a, const TurnCircle& middle, const TurnCircle& b) {
    const auto arriving = directed_bitangent(a, middle);
    const auto leaving = directed_bitangent(middle, b);
    if (!arriving || !leaving) return false;
    const double turn = sign_of(middle.side) * wrap_signed(leaving->start.heading - arriving->start.heading);
    return turn > 0.0 && turn < 0.5 * kPi;
  };
  std::vector<Stop> stops;
  const auto add = [&](const Stop& stop) {
    for (const Stop& s : stops)
      if (s.vertex == stop.vertex && s.side == stop.side) return;
    stops.push_back(stop);
  };
  for (const auto& [v, side] : straights_from(c, from.vertex, from.side)) add({v, from.vertex, side});
  if (const VertexId before = before_on_ring(from.vertex, from.side); before != kNone)
    for (const auto& [v, side] : straights_from(c, before, from.side))
      if (v != from.vertex && bends(*round(before, from.side), from, *round(v, side))) add({v, before, side});
  for (std::size_t i = 0, count = stops.size(); i < count; ++i) {
    const Stop at = stops[i];
    const VertexId before = before_on_ring(at.vertex, at.side);
    if (before != kNone && before != from.vertex && bends(from, *round(before, at.side), *round(at.vertex, at.side)))
      add({before, at.before, at.side});
  }
  return stops;
}

// The straights from a circle, with those beside edges and those past vertices at which the path along the circles'
// bitangents would turn away.
Arrivals straights_past_others(const test::GraphCase& c, std::span<const TurnCircle> circles, const TurnCircle& from) {
  const auto round = [&](VertexId v, Side side) {
    return *std::find_if(circles.begin(), circles.end(),
                         [&](const auto& t) { return t.vertex == v && t.side == side; });
  };
  Arrivals found;
  std::vector<Stop> open;
  const auto add = [&](const Stop& stop) {
    if (found.insert({stop.vertex, stop.side}).second) open.push_back(stop);
  };
  for (const Stop& stop : straights_beside_edges(c, circles, from)) add(stop);
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto [v, before, side] = open[i];
    const TurnCircle middle = round(v, side);
    const auto line = directed_bitangent(from, middle);
    if (!line) continue;
    for (const auto& next : straights_from(c, v, side)) {
      const auto onwards = directed_bitangent(middle, round(next.first, next.second));
      const bool taut = orientation(c.world.vertex(before), c.world.vertex(v), c.world.vertex(next.first)) !=
                        (side == Side::kLeft ? -1 : 1);
      if (onwards && taut && sign_of(side) * wrap_signed(onwards->start.heading - line->start.heading) < 0.0)
        add({next.first, v, next.second});
    }
  }
  return found;
}

TEST(BuildFeasibleGraph, KeepsWhatIsFreeAndNothingElse) {
  test::GraphCase c;
  c.radii.resize(1);
  const auto built = c.finished();
  const FinishedFeasibleGraph& graph = *built;
  const Footprint body = c.vehicle.footprint(0.5 * c.vehicle.safety_margin());
  const auto free = [&](std::uint32_t circle, double heading) {
    const TurnCircle& t = graph.circles()[circle];
    return c.queries.sweep->free_headings(TurningBody{t.center, t.radius, t.side, body}).contains(heading);
  };
  std::size_t kept = 0, beyond = 0;
  for (std::uint32_t a = 0; a < graph.circles().size(); ++a) {
    const TurnCircle& first = graph.circles()[a];
    const auto direct = straights_from(c, first.vertex, first.side);
    for (const auto& [v, side] : straights_past_others(c, graph.circles(), first))
      for (std::uint32_t b = 0; b < graph.circles().size(); ++b) {
        const TurnCircle& second = graph.circles()[b];
        if (second.vertex != v || second.side != side) continue;
        const auto line = directed_bitangent(first, second);
        if (!line || !free(a, line->start.heading) || !free(b, line->start.heading)) continue;
        if (!c.queries.sweep->straight_free(swept_rectangle(line->start, line->length, body))) continue;
        ++kept;
        beyond += direct.contains({v, side}) ? 0 : 1;
        const auto links = graph.links_from(a);
        EXPECT_TRUE(std::any_of(links.begin(), links.end(), [&](const auto& link) { return link.to == b; }));
      }
  }
  EXPECT_GT(beyond, 0u);
  EXPECT_EQ(graph.links().size(), kept);
  const FeasibleGraphCounts counts = graph.counts();
  EXPECT_EQ(counts.kept, kept);
  EXPECT_EQ(counts.candidates, counts.kept + counts.rejected_overlap + counts.rejected_departure +
                                   counts.rejected_arrival + counts.rejected_straight);
}

// A point passes the second vertex on its way from the first one to the other obstacle; the body does not.
TEST(BuildFeasibleGraph, LeadsRoundTheNextVertexWhereABodyWouldHitIt) {
  const World world({{{{12.0, 12.0}, {2.0, 10.5}, {0.55, 5.0}, {3.0, 0.0}, {12.0, 0.0}}, {}},
                     {{{-12.2, -1.1}, {-12.2, -11.1}, {-1.2, -1.1}}, {}}});
  const Planner planner(world, Vehicle());
  const FinishedFeasibleGraph& graph = *planner.feasible_graph().finished();
  const auto leads = [&](VertexId from, Side departure, VertexId to, Side arrival) {
    return std::any_of(graph.links().begin(), graph.links().end(), [&](const FeasibleLink& link) {
      const TurnCircle& a = graph.circles()[link.from];
      const TurnCircle& b = graph.circles()[link.to];
      return a.vertex == from && a.side == departure && b.vertex == to && b.side == arrival;
    });
  };
  const auto row = planner.visibility_graph().row(1);
  ASSERT_TRUE(std::find(row.begin(), row.end(), 7) != row.end());
  EXPECT_FALSE(leads(1, Side::kLeft, 7, Side::kRight));
  EXPECT_TRUE(leads(2, Side::kLeft, 7, Side::kRight));
  EXPECT_TRUE(leads(7, Side::kLeft, 2, Side::kRight));
}

// Next to a sharp vertex a gentle one is in the way of straights from and to it, but no path turns there.
TEST(BuildFeasibleGraph, LeadsPastVerticesThatNeedNoTurn) {
  // A hill with four corners of 45 degrees, each of a gentle, a sharp and a gentle vertex.
  Ring hill{{16.0, -1.0}, {16.0, 10.0}};
  double heading = 90.0;
  for (int corner = 0; corner < 4; ++corner)
    for (const auto& [turn, edge] : {std::pair{1.5, 0.7}, {42.0, 0.7}, {1.5, corner < 3 ? 8.0 : 11.0}}) {
      heading -= turn;
      hill.push_back(hill.back() + edge * direction_of(heading * kPi / 180.0));
    }
  const World world({{hill, {}}}, Ring{{0, 0}, {52, 0}, {52, 28}, {0, 28}});
  const Planner eager(world, Vehicle());
  const Planner lazy(world, Vehicle(), {.graph_mode = GraphMode::kLazy});
  for (const PlanRequest& request : {PlanRequest{{6, 3, 0}, {46, 3, 0}}, PlanRequest{{46, 3, kPi}, {6, 3, kPi}}}) {
    const PlanResult result = eager.plan(request);
    EXPECT_TRUE(result.solved()) << result.reason;
    test::expect_valid(eager, result);
    EXPECT_EQ(lazy.plan(request).travel_time, result.travel_time);
  }
}

TEST(BuildFeasibleGraph, StopsWhenAsked) {
  const test::GraphCase c;
  std::stop_source stop;
  stop.request_stop();
  const SerialExecutor serial;
  const StoppableExecutor executor(serial, stop.get_token());
  EXPECT_THROW((void)build_feasible_graph(c.inputs(), executor), Canceled);
  EXPECT_THROW((void)build_reduced_visibility_graph(c.world, *c.queries.visibility, executor), Canceled);
}

TEST(BuildFeasibleGraph, AProcessGroupBuildsTheSameGraph) {
  const test::GraphCase c;
  const auto alone = c.finished();
  ASSERT_GT(alone->links().size(), 100u);
  for (const std::size_t size : {2u, 3u, 7u, 500u}) {
    std::mutex mutex;
    test::run_process_group(size, [&](const ProcessGroup& process_group) {
      const auto graph = build_feasible_graph(c.inputs(), SerialExecutor(), process_group);
      const std::scoped_lock lock(mutex);
      if (process_group.rank() % 50 < 3) test::expect_same(*graph, *alone);
    });
  }
}

}  // namespace
}  // namespace arcway::internal
