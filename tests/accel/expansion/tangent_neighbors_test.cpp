#include "accel/expansion/tangent_neighbors.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <stdexcept>

#include "arcway/datasets/clutter.h"
#include "arcway/executor.h"
#include "arcway/query_set.h"
#include "arcway/visibility_graph.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

// Both directions of each edge of the reference.
std::vector<std::vector<VertexId>> rows_of(const World& world) {
  const VisibilityGraph graph = build_reduced_visibility_graph(world, *make_reference_queries(world).visibility);
  std::vector<std::vector<VertexId>> rows(world.vertices().size());
  for (VertexId u = 0; u < rows.size(); ++u)
    for (const VertexId v : graph.row(u)) {
      rows[u].push_back(v);
      rows[v].push_back(u);
    }
  for (auto& row : rows) std::sort(row.begin(), row.end());
  return rows;
}

void expect_rows(const World& world) {
  const auto rows = rows_of(world);
  const TangentNeighbors neighbors(world);
  for (VertexId v = 0; v < rows.size(); ++v) ASSERT_EQ(neighbors.of(v), rows[v]) << "vertex " << v;
}

TEST(TangentNeighbors, AreTheRowsOfTheReducedGraph) {
  for (const ClutterKind kind : {ClutterKind::kConvex, ClutterKind::kStar})
    expect_rows(random_world({.kind = kind, .obstacles = 40, .vertices = 8, .fill = 0.3, .seed = 9}));
}

TEST(TangentNeighbors, OfNastyWorlds) {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    SCOPED_TRACE(seed);
    expect_rows(test::nasty_world(seed + 5000, 14));
    if (HasFatalFailure()) return;
  }
}

TEST(TangentNeighbors, RefuseVerticesThatAreNotThere) {
  EXPECT_THROW((void)TangentNeighbors(World({})).of(0), std::out_of_range);
  const World box({{test::square(0, 0, 4), {}}});
  EXPECT_EQ(TangentNeighbors(box).of(0), (std::vector<VertexId>{1, 3}));
  EXPECT_THROW((void)TangentNeighbors(box).of(4), std::out_of_range);
}

// An executor that asks for a stop from a given question on.
class EndingExecutor final : public Executor {
 public:
  explicit EndingExecutor(std::size_t last) : last_(last) {}
  void for_ranges(std::size_t count, std::size_t /*grain*/,
                  const std::function<void(std::size_t, std::size_t)>& body) const override {
    if (count > 0) body(0, count);
  }
  [[nodiscard]] StopClock clock() const override { return StopClock(++asked_ >= last_ ? 0.0 : 1e300); }
  [[nodiscard]] std::size_t asked() const { return asked_; }

 private:
  std::size_t last_;
  mutable std::size_t asked_ = 0;
};

TEST(TangentNeighbors, AskForTheTimeBeforeEachWalkOfASample) {
  constexpr std::size_t kWalks = 256;
  const World box({{test::square(0, 0, 4), {}}});
  const EndingExecutor patient(1'000'000);
  const TangentNeighbors neighbors(box, patient);
  EXPECT_GE(patient.asked(), kWalks);
  const EndingExecutor ending(patient.asked() - kWalks / 2);
  EXPECT_THROW(TangentNeighbors(box, ending), Canceled);
  EXPECT_EQ(ending.asked(), patient.asked() - kWalks / 2);
}

}  // namespace
}  // namespace arcway::internal
