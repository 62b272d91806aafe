#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "accel/backend/make_queries.h"
#include "accel/expansion/tangent_neighbors.h"
#include "accel/graphs/changed_graph.h"
#include "accel/graphs/pairwise_graph.h"
#include "arcway/accel/parallel.h"
#include "arcway/accel/tangent_cone_graph.h"
#include "arcway/accel/visibility_map.h"
#include "arcway/datasets/catalog.h"
#include "arcway/datasets/map_file.h"
#include "arcway/visibility_rows.h"
#include "tests/support/sleeve_graph.h"
#include "tests/support/touching_worlds.h"
#include "tests/support/visibility_oracle.h"

namespace arcway::internal {
namespace {

constexpr std::uint64_t kWorldsInContact = 400;

void expect_rows(const World& world, const VisibilityGraph& graph) {
  const auto rows = rows_of(world, graph);
  const TangentNeighbors neighbors(world);
  const VisibilityMap map(world);
  for (VertexId v = 0; v < world.vertices().size(); ++v) {
    ASSERT_TRUE(std::ranges::equal(neighbors.of(v), rows->of(v))) << v;
    ASSERT_TRUE(std::ranges::equal(map.tangents_from(v), rows->of(v))) << v;
  }
}

// Compares every builder with an oracle that knows no cones.
TEST(SelfContacts, AllBuildersAgreeWithTheOracle) {
  std::size_t contacts = 0, edges = 0;
  for (std::uint64_t seed = 1; seed <= kWorldsInContact; ++seed) {
    SCOPED_TRACE(seed);
    const World world = test::touching_world(seed, 4);
    contacts += world.self_contacts().size();
    const test::VisibilityOracle oracle(world);
    const VisibilityGraph graph = build_reduced_visibility_graph_by_tangent_cones(world);
    edges += graph.edge_count();
    ASSERT_EQ(test::edges_of(graph), oracle.reduced());
    ASSERT_EQ(test::edges_of(build_full_visibility_graph_by_expansion(world)), oracle.full());
    ASSERT_EQ(build_reduced_visibility_graph_by_tangent_cones(world, TbbExecutor(3)), graph);
    ASSERT_EQ(test::graph_by_sleeves(world), graph);
    const QuerySet queries = make_embree_queries(world);
    ASSERT_EQ(build_pairwise_visibility_graph(world, *queries.visibility, SerialExecutor()), graph);
    ASSERT_EQ(test::edges_of(build_full_visibility_graph(world, *queries.visibility)), oracle.full());
    expect_rows(world, graph);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(contacts, 500u);
  EXPECT_GT(edges, 5000u);
}

TEST(SelfContacts, ChangedWorldsKeepTheirs) {
  for (std::uint64_t seed = 1; seed <= kWorldsInContact / 2; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    World world = test::touching_world(seed, 4);
    VisibilityGraph graph = build_reduced_visibility_graph_by_tangent_cones(world);
    for (int step = 0; step < 4; ++step) {
      std::vector<ObstacleId> removed;
      for (ObstacleId o = 0; o < world.obstacle_count(); ++o)
        if (random.integer(1, 3) == 1) removed.push_back(o);
      const World after = world.changed(removed, to_map_file(test::touching_world(random.bits(), 1)).obstacles);
      graph = change_reduced_visibility_graph(graph, after, {world, after, removed}, ThreadExecutor(2));
      ASSERT_EQ(graph, build_reduced_visibility_graph_by_tangent_cones(after));
      const World anew = to_world(to_map_file(after), "anew");
      ASSERT_TRUE(std::ranges::equal(after.self_contacts(), anew.self_contacts()));
      ASSERT_EQ(graph, build_reduced_visibility_graph_by_tangent_cones(anew));
      world = after;
    }
  }
}

// Lines of sight from a hole through the point where it touches the outer ring, and through two such points in a row.
TEST(SelfContacts, LinesLeadThroughThem) {
  const Ring island{{3, 3}, {5, 3}, {5, 5}, {3, 5}};
  const World world({{test::square(0, 0, 8), {{{4, 0}, {7, 7}, {1, 7}}}}, {island, {}}, {test::square(2, -6, 3), {}}});
  ASSERT_EQ(world.self_contacts().size(), 1u);
  const VisibilityGraph graph = build_reduced_visibility_graph_by_tangent_cones(world);
  EXPECT_EQ(test::edges_of(graph), test::VisibilityOracle(world).reduced());
  const auto joins = [&](const Vec2& p, const Vec2& q) {
    for (const auto& [u, v] : test::edges_of(graph))
      if ((world.vertex(u) == p && world.vertex(v) == q) || (world.vertex(u) == q && world.vertex(v) == p)) return true;
    return false;
  };
  EXPECT_TRUE(joins({3, 3}, {5, -3}));
  EXPECT_TRUE(joins({0, 0}, {8, 0}));
}

TEST(SelfContacts, NoEdgeIsLostInTheWorldOfHoles) {
  const World world = catalog_world("adversarial/holes/v250/s3");
  EXPECT_EQ(build_reduced_visibility_graph_by_tangent_cones(world),
            build_reduced_visibility_graph(world, *make_reference_queries(world).visibility));
}

}  // namespace
}  // namespace arcway::internal
