#include "accel/expansion/tangent_neighbors.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

#include "accel/expansion/contact_edges.h"
#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/tangent_cone_expansion.h"
#include "accel/expansion/triangle_blocks.h"
#include "accel/expansion/worthwhile_fans.h"

namespace arcway::internal {

struct TangentNeighbors::Data {
  Data(const World& of, const Executor& executor)
      : world(of), triangulation(world, executor), node_of(world.vertices().size(), kNone) {
    triangulation.list_left_edges();
    fans = worthwhile_fans(triangulation, executor);
    for (std::uint32_t n = 0; n < triangulation.nodes().size(); ++n) node_of[triangulation.nodes()[n].vertex] = n;
    through_contacts = both_ways(edges_through_contacts(world, triangulation));
  }
  [[nodiscard]] const TriangleBlocks& known_blocks() const {
    std::call_once(made_blocks, [this] { blocks.emplace(triangulation); });
    return *blocks;
  }

  World world;
  FreeSpaceTriangulation triangulation;
  LongFans fans;
  std::vector<std::uint32_t> node_of;  // by vertex
  EdgeList through_contacts;
  mutable std::once_flag made_blocks;
  mutable std::optional<TriangleBlocks> blocks;  // made when first asked for
};

TangentNeighbors::TangentNeighbors(const World& world, const Executor& executor)
    : data_(std::make_unique<const Data>(world, executor)) {}
TangentNeighbors::~TangentNeighbors() = default;
TangentNeighbors::TangentNeighbors(TangentNeighbors&&) noexcept = default;
TangentNeighbors& TangentNeighbors::operator=(TangentNeighbors&&) noexcept = default;

std::vector<VertexId> TangentNeighbors::of(VertexId vertex) const {
  if (vertex >= data_->node_of.size())
    throw std::out_of_range("tangent neighbors: vertex " + std::to_string(vertex) + ", the world has " +
                            std::to_string(data_->node_of.size()));
  std::vector<VertexId> row = tangent_neighbors(data_->triangulation, data_->node_of[vertex], &data_->fans);
  add_missing(data_->through_contacts, vertex, row);
  return row;
}

OpenedTriangulation TangentNeighbors::opened() const {
  return OpenedTriangulation(data_->triangulation, &data_->known_blocks());
}

bool TangentNeighbors::cover(std::span<const Box> places) const {
  return std::ranges::all_of(places, [&](const Box& place) { return data_->known_blocks().hull_contains(place); });
}

std::uint32_t TangentNeighbors::node_of(VertexId vertex) const { return data_->node_of[vertex]; }

}  // namespace arcway::internal
