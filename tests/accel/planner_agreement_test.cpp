#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <string>
#include <thread>
#include <vector>

#include "accel/backend/make_queries.h"
#include "accel/base/parallel.h"
#include "accel/graphs/pairwise_graph.h"
#include "core/planner/planner.h"
#include "datasets/generators/catalogue.h"
#include "tests/support/thread_executor.h"

namespace arcway {
namespace {

constexpr const char* kWorlds[] = {"paper", "clutter/convex/n40/m8/f20/s3", "clutter/star/n40/m9/f30/s5",
                                   "clutter/rectangle/n40/f25/s2"};

// All that a plan and its graphs consist of, as bits.
std::string digest(const Planner& planner, const std::vector<PlanRequest>& requests) {
  std::string bits;
  const auto add = [&bits](const auto& value) { bits.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (const VertexId v : planner.visibility_graph().targets()) add(v);
  const FeasibleGraph& feasible = planner.feasible_graph();
  for (const FeasibleGraph::Link& link : feasible.links()) {
    add(link.from);
    add(link.to);
    add(link.heading);
    add(link.length);
  }
  for (std::uint32_t c = 0; c < feasible.circles().size(); ++c)
    for (const HeadingInterval& interval : feasible.free_headings(c).intervals()) add(interval);
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

TEST(PlannerAgreement, BackendsAndThreadCountsGiveTheSameBits) {
  const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  for (const std::string name : kWorlds) {
    SCOPED_TRACE(name);
    const World world = catalogue_world(name);
    const std::vector<PlanRequest> requests = catalogue_queries(name, 5, 1);
    const Vehicle vehicle;
    const std::string expected = digest(Planner(world, vehicle), requests);
    const QuerySet queries = make_embree_queries(world);
    const auto by_pairs = [](const World& w, const VisibilityQuery& visibility, const Executor& executor) {
      return build_pairwise_visibility_graph(w, visibility, executor);
    };
    for (const std::size_t threads : {1u, 2u, 3u, 8u}) {
      const TbbExecutor executor(threads);
      PlannerOptions options;
      EXPECT_TRUE(digest(Planner(world, vehicle, queries, options, executor), requests) == expected) << threads;
      options.reduced_graph = by_pairs;
      EXPECT_TRUE(digest(Planner(world, vehicle, queries, options, executor), requests) == expected) << threads;
    }
  }
}

TEST(PlannerAgreement, BuildersShareNothingBetweenThreads) {
  const std::string name = "clutter/star/n40/m9/f30/s5";
  const World world = catalogue_world(name);
  const test::ThreadExecutor threads(3);
  const std::string expected = digest(Planner(world, Vehicle{}), {});
  const QuerySet queries = make_embree_queries(world);
  EXPECT_TRUE(digest(Planner(world, Vehicle{}, queries, {}, threads), {}) == expected);
  PlannerOptions options;
  options.reduced_graph = [](const World& w, const VisibilityQuery& visibility, const Executor& executor) {
    return build_pairwise_visibility_graph(w, visibility, executor);
  };
  EXPECT_TRUE(digest(Planner(world, Vehicle{}, queries, options, threads), {}) == expected);
}

TEST(PlannerAgreement, SeveralThreadsPlanOnOnePlanner) {
  const std::string name = "clutter/convex/n40/m8/f20/s3";
  const World world = catalogue_world(name);
  const std::vector<PlanRequest> requests = catalogue_queries(name, 6, 2);
  const Planner planner(world, Vehicle{}, make_embree_queries(world), {}, TbbExecutor());
  const std::string expected = digest(planner, requests);
  std::vector<std::string> found(4);
  std::vector<std::thread> threads;
  for (std::string& result : found) threads.emplace_back([&] { result = digest(planner, requests); });
  for (std::thread& thread : threads) thread.join();
  for (const std::string& result : found) EXPECT_TRUE(result == expected);
}

}  // namespace
}  // namespace arcway
