#include "arcway/accel/tangent_cone_graph.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "accel/expansion/contact_edges.h"
#include "accel/expansion/edge_list.h"
#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/sleeves.h"
#include "accel/expansion/tangent_cone_expansion.h"
#include "accel/expansion/worthwhile_fans.h"
#include "accel/graphs/cone_edges.h"
#include "core/base/bytes.h"

namespace arcway {

using namespace internal;

namespace {

// Exchanges edges between the processes and sums up their counters.
void exchange(std::vector<EdgeList>& parts, ExpansionCounts& sum, const ProcessGroup& process_group) {
  std::string bytes;
  append_bytes(bytes, sum.steps);
  append_bytes(bytes, sum.candidates);
  for (const EdgeList& part : parts)
    for (const auto& [u, v] : part) append_bytes(bytes, std::array<VertexId, 2>{u, v});
  parts.clear();
  sum = {};
  for (std::string_view rest : process_group.gather(std::move(bytes))) {
    sum.steps += take_bytes<std::uint64_t>(rest);
    sum.candidates += take_bytes<std::uint64_t>(rest);
    EdgeList part;
    for (const auto& [u, v] : take_bytes<std::array<VertexId, 2>>(rest, rest.size() / sizeof(std::array<VertexId, 2>)))
      part.emplace_back(u, v);
    parts.push_back(std::move(part));
  }
}

// The triangulation that all nodes are expanded through, with its long fans.
struct TriangulatedWorld {
  FreeSpaceTriangulation triangulation;
  LongFans fans;
};

// Where expansions are long, shorter diagonals are worth a second triangulation.
TriangulatedWorld triangulated(const World& world, const Executor& executor) {
  constexpr double kManySteps = 100.0;
  TriangulatedWorld made{FreeSpaceTriangulation(world, executor, Diagonals::kLong), {}};
  if (steps_per_node(made.triangulation, executor) > kManySteps) {
    made.triangulation = FreeSpaceTriangulation(world, executor, Diagonals::kAll);
    made.fans = worthwhile_fans(made.triangulation, executor);
  }
  return made;
}

}  // namespace

VisibilityGraph build_reduced_visibility_graph_by_tangent_cones(const World& world, const Executor& executor,
                                                                TangentConeStatistics* statistics,
                                                                const ProcessGroup& process_group) {
  std::vector<EdgeList> parts;
  ExpansionCounts sum;
  EdgeList through_contacts;
  {
    auto [triangulation, fans] = triangulated(world, executor);  // freed before the rows are made
    if (statistics) *statistics = {triangulation.half_edges().size() / 3, 0, 0, triangulation.invalid_count()};
    executor.begin_stage("lines of sight");
    const Sleeves sleeves = worthwhile_sleeves(world, triangulation, executor);
    const auto [first, last] = process_group.share_of(triangulation.nodes().size());
    parts = cone_edges({triangulation, sleeves, fans}, {first, last}, executor, &sum);
    if (!world.self_contacts().empty()) triangulation.list_left_edges();
    through_contacts = edges_through_contacts(world, triangulation);
  }
  if (process_group.size() > 1) exchange(parts, sum, process_group);
  add_missing(std::move(through_contacts), parts);
  if (statistics) {
    statistics->steps = sum.steps;
    statistics->candidates = sum.candidates;
  }
  return graph_of(world.vertices().size(), parts, executor);
}

}  // namespace arcway
