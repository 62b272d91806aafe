#include "arcway/plan_batch.h"

#include <gtest/gtest.h>

#include <limits>
#include <stop_token>
#include <string>

#include "arcway/datasets/clutter.h"
#include "arcway/datasets/plan_io.h"
#include "arcway/datasets/random_queries.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

struct Batch {
  World world = random_world({.kind = ClutterKind::kStar, .obstacles = 25, .vertices = 6, .fill = 0.2, .seed = 4});
  Planner planner{world, Vehicle{}};
  std::vector<PlanRequest> requests;
  Batch() {
    requests = random_queries(world, make_reference_queries(world), planner.vehicle(), {.count = 40, .seed = 9});
    requests.push_back({requests[0].start, requests[0].start});
    requests.push_back({{1e6, 1e6, 0}, {-1e6, 1e6, 0}});
  }
};

// Everything but times.
std::string bits_of(PlanResult result) {
  result.statistics.search_seconds = result.statistics.refine_seconds = result.statistics.lower_bound_seconds =
      result.statistics.profile_seconds = result.statistics.total_seconds = result.statistics.first_path_seconds = 0.0;
  return plan_to_json(result, 0) + result.reason;
}

TEST(PlanBatch, IsThePlanOfEachQueryInOrderForAnyNumberOfThreads) {
  const Batch c;
  std::vector<std::string> expected;
  for (const PlanRequest& request : c.requests) {
    const PlanResult result = c.planner.plan(request);
    if (result.solved()) test::expect_valid(c.planner, result);
    expected.push_back(bits_of(result));
  }
  for (const std::size_t threads : {1u, 2u, 3u, 8u}) {
    const std::vector<PlanResult> results = plan_batch(c.planner, c.requests, ThreadExecutor(threads));
    ASSERT_EQ(results.size(), expected.size());
    for (std::size_t i = 0; i < results.size(); ++i) EXPECT_EQ(bits_of(results[i]), expected[i]) << threads << " " << i;
  }
  EXPECT_TRUE(plan_batch(c.planner, {}, SerialExecutor()).empty());
}

TEST(PlanBatch, TellsHowManyQueriesAreDone) {
  const Batch c;
  std::vector<std::uint64_t> done;
  const auto note = [&](const Progress& progress) {
    EXPECT_EQ(std::string(progress.stage), "queries");
    EXPECT_EQ(progress.total, c.requests.size());
    done.push_back(progress.done);
  };
  static_cast<void>(plan_batch(c.planner, c.requests, ThreadExecutor(3), {.progress = note}));
  ASSERT_FALSE(done.empty());
  EXPECT_EQ(done.back(), c.requests.size());
}

TEST(PlanBatch, QueriesNotBegunWhenItIsStoppedAreCanceled) {
  const Batch c;
  std::stop_source stop;
  const auto stop_after_five = [&](const Progress& progress) {
    if (progress.done == 5) stop.request_stop();
  };
  const std::vector<PlanResult> results =
      plan_batch(c.planner, c.requests, SerialExecutor(), {.stop = stop.get_token(), .progress = stop_after_five});
  ASSERT_EQ(results.size(), c.requests.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(results[i].status == PlanStatus::kCanceled, i >= 5) << i;
    EXPECT_EQ(results[i].goal.x, c.requests[i].goal.x);
    EXPECT_EQ(results[i].reason.find("the batch was canceled") == 0, i >= 5);
  }
}

TEST(PlanBatch, ARequestThatIsNoneIsNamed) {
  Batch c;
  c.requests[7].start.x = std::numeric_limits<double>::quiet_NaN();
  c.requests[11].goal.heading = std::numeric_limits<double>::infinity();
  try {
    static_cast<void>(plan_batch(c.planner, c.requests, ThreadExecutor(2)));
    ADD_FAILURE() << "no exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).rfind("request 7: start pose", 0), 0u) << error.what();
  }
}

}  // namespace
}  // namespace arcway::internal
