#pragma once

#include <vector>

#include "accel/expansion/contact_edges.h"
#include "accel/expansion/edge_list.h"
#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/long_fans.h"
#include "accel/expansion/sleeves.h"
#include "accel/graphs/cone_edges.h"
#include "arcway/executor.h"
#include "arcway/visibility_graph.h"
#include "arcway/world.h"

namespace arcway::internal::test {

/// The reduced visibility graph by tangent-cone expansion that crosses all sleeves and fans in one step, however short.
inline VisibilityGraph graph_by_sleeves(const World& world, Diagonals shortened = Diagonals::kAll) {
  FreeSpaceTriangulation triangulation(world, SerialExecutor(), shortened);
  triangulation.list_left_edges();
  const Sleeves sleeves(triangulation, 1);
  const LongFans fans(triangulation, 1);
  std::vector<EdgeList> lists =
      cone_edges({triangulation, sleeves, fans}, {0, triangulation.nodes().size()}, SerialExecutor());
  add_missing(edges_through_contacts(world, triangulation), lists);
  return graph_of(world.vertices().size(), lists, SerialExecutor());
}

}  // namespace arcway::internal::test
