#include "core/roadmap/feasible_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "core/gaps/gap_circles.h"
#include "core/gaps/vehicle_gaps.h"
#include "core/geometry/predicates.h"
#include "core/roadmap/tangent_edges.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

struct Case {
  World world = random_world({.kind = ClutterKind::kStar, .obstacles = 20, .vertices = 6, .fill = 0.3, .seed = 5});
  Vehicle vehicle;
  QuerySet queries = make_reference_queries(world);
  VisibilityGraph visibility = build_reduced_visibility_graph(world, *queries.visibility);
  std::vector<double> radii = {vehicle.min_turning_radius(), 2.0 * vehicle.min_turning_radius()};
  [[nodiscard]] FeasibleGraph graph(GraphMode mode) const {
    return FeasibleGraph(world, vehicle, visibility, queries, radii, SerialExecutor(), mode);
  }
};

std::vector<FeasibleGraph::Link> kept_links(const FeasibleGraph& graph) {
  std::vector<FeasibleGraph::Link> kept;
  for (std::uint32_t c = 0; c < graph.circles().size(); ++c) {
    const auto links = graph.links_from(c);
    for (std::size_t i = 0; i < links.size(); ++i)
      if (graph.is_kept(c, i)) kept.push_back(links[i]);
  }
  return kept;
}

void expect_same(std::span<const FeasibleGraph::Link> a, std::span<const FeasibleGraph::Link> b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].from, b[i].from);
    EXPECT_EQ(a[i].to, b[i].to);
    EXPECT_EQ(a[i].heading, b[i].heading);
    EXPECT_EQ(a[i].length, b[i].length);
  }
}

using Arrivals = std::set<std::pair<VertexId, Side>>;

// Where the edges of the reduced graph lead that leave a vertex with its obstacle on one side, and the side of the
// obstacle there.
Arrivals straights_from(const Case& c, VertexId from, Side side) {
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

// The same; to the far ends of edges of the vertex before on its ring, where a path along the circles' bitangents turns
// round `from`; and to the vertices before those, where it turns round them.
std::vector<Stop> straights_beside_edges(const Case& c, std::span<const TurnCircle> circles, const TurnCircle& from) {
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

// The same, and further on past vertices at which the path along the circles' bitangents would turn away.
Arrivals straights_past_others(const Case& c, std::span<const TurnCircle> circles, const TurnCircle& from) {
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

TEST(FeasibleGraph, KeepsWhatIsFreeAndNothingElse) {
  Case c;
  c.radii.resize(1);
  const FeasibleGraph graph = c.graph(GraphMode::kEager);
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

TEST(FeasibleGraph, TurnsWideRoundTheVertexOnly) {
  const Case c;
  const FeasibleGraph graph = c.graph(GraphMode::kEager);
  const Footprint body = c.vehicle.footprint(0.5 * c.vehicle.safety_margin());
  std::size_t free = 0;
  for (std::uint32_t i = 0; i < graph.circles().size(); ++i) {
    const TurnCircle& circle = graph.circles()[i];
    if (circle.radius == c.radii[0]) continue;
    const double at_vertex = heading_at_vertex(c.world, circle);
    EXPECT_NEAR((pose_on(circle, at_vertex).position() - c.world.vertex(circle.vertex)).norm(),
                0.5 * c.vehicle.parameters().width + c.vehicle.safety_margin(), 1e-9);
    const HeadingSet all = c.queries.sweep->free_headings(TurningBody{circle.center, circle.radius, circle.side, body});
    const HeadingSet& kept = graph.free_headings(i);
    EXPECT_EQ(kept.empty(), !all.contains(at_vertex));
    if (kept.empty()) continue;
    ++free;
    EXPECT_TRUE(kept.contains(at_vertex));
    EXPECT_LE(kept.reach(at_vertex, Side::kLeft), all.reach(at_vertex, Side::kLeft) + 1e-12);
    EXPECT_LE(kept.reach(at_vertex, Side::kLeft), 0.6 * kPi);
    EXPECT_LE(kept.reach(at_vertex, Side::kRight), 0.6 * kPi);
  }
  EXPECT_GT(free, 10u);
}

TEST(FeasibleGraph, IsTheSameWhenChecksWaitUntilTheyAreAskedFor) {
  const Case c;
  const FeasibleGraph eager = c.graph(GraphMode::kEager);
  const FeasibleGraph lazy = c.graph(GraphMode::kLazy);
  EXPECT_EQ(lazy.counts().kept, 0u);
  EXPECT_EQ(lazy.counts().candidates, 0u);
  expect_same(kept_links(lazy), eager.links());
  for (std::uint32_t circle = 0; circle < eager.circles().size(); ++circle) {
    const auto a = eager.free_headings(circle).intervals();
    const auto b = lazy.free_headings(circle).intervals();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].low, b[i].low);
  }
  EXPECT_EQ(lazy.counts().candidates, eager.counts().candidates);
  EXPECT_EQ(lazy.counts().kept, eager.counts().kept);
  EXPECT_EQ(lazy.counts().circles_blocked, eager.counts().circles_blocked);
  EXPECT_EQ(lazy.counts().rejected_overlap, eager.counts().rejected_overlap);
  EXPECT_EQ(lazy.counts().rejected_departure, eager.counts().rejected_departure);
  EXPECT_EQ(lazy.counts().rejected_arrival, eager.counts().rejected_arrival);
  EXPECT_EQ(lazy.counts().rejected_straight, eager.counts().rejected_straight);
}

// A point passes the second vertex on its way from the first one to the other obstacle; the body does not.
TEST(FeasibleGraph, LeadsRoundTheNextVertexWhereABodyWouldHitIt) {
  const World world({{{{12.0, 12.0}, {2.0, 10.5}, {0.55, 5.0}, {3.0, 0.0}, {12.0, 0.0}}, {}},
                     {{{-12.2, -1.1}, {-12.2, -11.1}, {-1.2, -1.1}}, {}}});
  const Planner planner(world, Vehicle());
  const FeasibleGraph& graph = planner.feasible_graph();
  const auto leads = [&](VertexId from, Side departure, VertexId to, Side arrival) {
    return std::any_of(graph.links().begin(), graph.links().end(), [&](const FeasibleGraph::Link& link) {
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
TEST(FeasibleGraph, LeadsPastVerticesThatNeedNoTurn) {
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

TEST(FeasibleGraph, AnswersManyThreadsAtOnce) {
  const Case c;
  const FeasibleGraph eager = c.graph(GraphMode::kEager);
  const FeasibleGraph lazy = c.graph(GraphMode::kLazy);
  std::vector<std::vector<FeasibleGraph::Link>> kept(4);
  std::vector<std::thread> threads;
  for (auto& links : kept) threads.emplace_back([&lazy, &links] { links = kept_links(lazy); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& links : kept) expect_same(links, eager.links());
}

TEST(FeasibleGraph, StopsWhenAsked) {
  const Case c;
  std::stop_source stop;
  stop.request_stop();
  const SerialExecutor serial;
  const StoppableExecutor executor(serial, stop.get_token());
  EXPECT_THROW(FeasibleGraph(c.world, c.vehicle, c.visibility, c.queries, c.radii, executor), Canceled);
  EXPECT_THROW((void)build_reduced_visibility_graph(c.world, *c.queries.visibility, executor), Canceled);
}

TEST(FeasibleGraph, KeepsItsStraightsAmongMoreCircles) {
  Case c;
  c.world = random_world({.kind = ClutterKind::kStar, .obstacles = 30, .vertices = 8, .fill = 0.45, .seed = 3});
  c.queries = make_reference_queries(c.world);
  c.visibility = build_reduced_visibility_graph(c.world, *c.queries.visibility);
  const FeasibleGraph base = c.graph(GraphMode::kEager);
  const AddedCircles added =
      find_gap_circles(c.world, VehicleGaps(c.world, c.vehicle, c.radii[0]).map(), c.vehicle, c.radii[0]);
  ASSERT_FALSE(added.around_vertices.empty());
  ASSERT_FALSE(added.gap_straights.empty());
  const FeasibleGraph more(base, c.vehicle, added);
  const std::size_t count = base.circles().size();
  const TurnCircles& circles = more.turn_circles();
  ASSERT_EQ(circles.base_count(), count);
  std::size_t gap_straight_circles = 0;
  for (const GapStraight& straight : added.gap_straights)
    gap_straight_circles += straight.entries.size() + straight.exits.size();
  ASSERT_EQ(more.circles().size(), count + 2 * added.around_vertices.size() + gap_straight_circles);

  const Footprint body = c.vehicle.footprint(0.5 * c.vehicle.safety_margin());
  std::vector<FeasibleGraph::Link> among_base;
  std::size_t onto = 0, through = 0, off = 0, round = 0;
  for (const FeasibleGraph::Link& link : kept_links(more)) {
    if (link.from < count && link.to < count) {
      among_base.push_back(link);
      continue;
    }
    EXPECT_TRUE(c.queries.sweep->straight_free(
        swept_rectangle(pose_on(more.circles()[link.from], link.heading), link.length, body)));
    EXPECT_TRUE(more.free_headings(link.from).contains(link.heading));
    EXPECT_TRUE(more.free_headings(link.to).contains(link.heading));
    const bool from_gap_straight = circles.is_of_gap_straight(link.from),
               to_gap_straight = circles.is_of_gap_straight(link.to);
    const bool in_gap_straight = from_gap_straight && !circles.is_exit(link.from);
    EXPECT_EQ(in_gap_straight,
              to_gap_straight &&
                  circles.is_exit(link.to));  // an entry leads to its gap straight's exits, and nothing else does
    (in_gap_straight ? through : to_gap_straight ? onto : from_gap_straight ? off : round) += 1;
  }
  expect_same(among_base, base.links());
  for (const std::size_t kind : {onto, through, off, round}) EXPECT_GT(kind, 0u);
}

}  // namespace
}  // namespace arcway::internal
