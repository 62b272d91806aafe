#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "accel/backend/make_queries.h"
#include "arcway/accel/accel_backend.h"
#include "arcway/accel/parallel.h"
#include "arcway/datasets/catalog.h"
#include "arcway/planner.h"
#include "arcway/zone.h"
#include "core/roadmap/finished_feasible_graph.h"

namespace arcway::internal {
namespace {

constexpr const char* kWorlds[] = {"paper", "clutter/convex/n40/m8/f20/s3", "clutter/star/n40/m9/f30/s5",
                                   "clutter/rectangle/n40/f25/s2"};

template <class Value>
void add_bits(const Value& value, std::string& bits) {
  bits.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// All contents of plans, as bits.
std::string plans_of(const Planner& planner, const std::vector<PlanRequest>& requests) {
  std::string bits;
  const auto add = [&bits](const auto& value) { add_bits(value, bits); };
  std::size_t solved = 0;
  for (const PlanRequest& request : requests) {
    const PlanResult result = planner.plan(request);
    solved += result.solved();
    add(result.status);
    add(result.travel_time);
    for (const TimedSegment& s : result.segments) {
      add(s.segment.start.x);
      add(s.segment.start.y);
      add(s.segment.start.heading);
      add(s.segment.length);
      add(s.segment.curvature);
      add(s.duration);
    }
  }
  EXPECT_TRUE(requests.empty() || solved > 0);
  return bits;
}

// All contents of plans and their graphs.
std::string digest(const Planner& planner, const std::vector<PlanRequest>& requests) {
  std::string bits;
  const auto add = [&bits](const auto& value) { add_bits(value, bits); };
  for (const VertexId v : planner.visibility_graph().targets()) add(v);
  const FinishedFeasibleGraph& feasible = *planner.feasible_graph().finished();
  for (const FeasibleGraph::Link& link : feasible.links()) {
    add(link.from);
    add(link.to);
    add(link.heading);
    add(link.length);
  }
  for (std::uint32_t c = 0; c < feasible.circles().size(); ++c)
    for (const HeadingInterval& interval : feasible.free_headings(c).intervals()) add(interval);
  return bits + plans_of(planner, requests);
}

TEST(PlannerAgreement, BackendsAndThreadCountsGiveTheSameBits) {
  const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  for (const std::string name : kWorlds) {
    SCOPED_TRACE(name);
    const World world = catalog_world(name);
    const std::vector<PlanRequest> requests = catalog_queries(name, 5, 1);
    const Vehicle vehicle;
    const Planner reference(world, vehicle);
    const std::string expected = digest(reference, requests), expected_plans = plans_of(reference, requests);
    const QuerySet queries = make_embree_queries(world);
    for (const std::size_t threads : {1u, 2u, 3u, 8u}) {
      const TbbExecutor executor(threads);
      const Planner reference_builder(world, vehicle, backend_of(world, queries, executor));
      EXPECT_TRUE(digest(reference_builder, requests) == expected) << threads;
      for (const GraphBuilder builder : {GraphBuilder::kPairwise, GraphBuilder::kTangentCones}) {
        const Planner planner(world, vehicle, accel_backend(world, executor, {.builder = builder}),
                              {.graph_mode = GraphMode::kEager});
        EXPECT_TRUE(digest(planner, requests) == expected) << threads << ", " << name_of(builder);
      }
      EXPECT_TRUE(plans_of(Planner(world, vehicle, accel_backend(world, executor)), requests) == expected_plans)
          << threads;
    }
  }
}

TEST(PlannerAgreement, OneWayZonesAreObeyedWithTheSameBits) {
  const std::string name = "clutter/rectangle/n40/f25/s2";
  const World open = catalog_world(name);
  const Vec2 low = open.box().min, span = open.box().max - low;
  std::vector<Zone> zones;
  for (int i = 0; i < 8; ++i) {
    const Vec2 middle = low + span.cwiseProduct(Vec2(0.1 + 0.11 * i, 0.1 + 0.1 * (i * 5 % 9)));
    zones.push_back({Polygon::regular(middle, 0.08 * span.norm(), 6), OneWay{0.8 * i - 3.0, 0.9}});
  }
  const World world = open.with_zones(std::move(zones));
  std::vector<PlanRequest> requests = catalog_queries(name, 6, 1);
  for (std::size_t i = 4; i < requests.size(); ++i) requests[i].reverse = true;
  const Planner reference(world, Vehicle{});
  const std::string expected = plans_of(reference, requests);
  EXPECT_TRUE(expected != plans_of(Planner(open, Vehicle{}), requests));
  for (const GraphMode mode : {GraphMode::kEager, GraphMode::kLazy})
    EXPECT_TRUE(plans_of(Planner(world, Vehicle{}, accel_backend(world), {.graph_mode = mode}), requests) == expected);
}

TEST(PlannerAgreement, BuildersShareNothingBetweenThreads) {
  const std::string name = "clutter/star/n40/m9/f30/s5";
  const World world = catalog_world(name);
  const ThreadExecutor threads(3);
  const std::string expected = digest(Planner(world, Vehicle{}), {});
  const QuerySet queries = make_embree_queries(world);
  EXPECT_TRUE(digest(Planner(world, Vehicle{}, backend_of(world, queries, threads)), {}) == expected);
  for (const GraphBuilder builder : {GraphBuilder::kPairwise, GraphBuilder::kTangentCones}) {
    const Planner planner(world, Vehicle{}, accel_backend(world, threads, {.builder = builder}),
                          {.graph_mode = GraphMode::kEager});
    EXPECT_TRUE(digest(planner, {}) == expected) << name_of(builder);
  }
}

TEST(PlannerAgreement, SeveralThreadsPlanOnOnePlanner) {
  const std::string name = "clutter/convex/n40/m8/f20/s3";
  const World world = catalog_world(name);
  const std::vector<PlanRequest> requests = catalog_queries(name, 6, 2);
  const Planner planner(world, Vehicle{}, backend_of(world, make_embree_queries(world), TbbExecutor()));
  const std::string expected = digest(planner, requests);
  std::vector<std::string> found(4);
  std::vector<std::thread> threads;
  for (std::string& result : found) threads.emplace_back([&] { result = digest(planner, requests); });
  for (std::thread& thread : threads) thread.join();
  for (const std::string& result : found) EXPECT_TRUE(result == expected);
}

}  // namespace
}  // namespace arcway::internal
