#include "accel/expansion/tangent_neighbours.h"

#include <stdexcept>
#include <string>

#include "accel/expansion/contact_edges.h"
#include "accel/expansion/sight_map.h"
#include "accel/expansion/wedge_walk.h"

namespace arcway {

struct TangentNeighbours::Data {
  Data(const World& of, const Executor& executor)
      : world(of), map(world, executor), node_of(world.vertices().size(), kNone) {
    map.list_left_edges();
    fans = worthwhile_fans(map, executor);
    for (std::uint32_t n = 0; n < map.nodes().size(); ++n) node_of[map.nodes()[n].vertex] = n;
    through_contacts = both_ways(edges_through_contacts(world, map));
  }
  World world;
  SightMap map;
  LongFans fans;
  std::vector<std::uint32_t> node_of;  // by vertex
  EdgeList through_contacts;
};

TangentNeighbours::TangentNeighbours(const World& world, const Executor& executor)
    : data_(std::make_unique<const Data>(world, executor)) {}
TangentNeighbours::~TangentNeighbours() = default;
TangentNeighbours::TangentNeighbours(TangentNeighbours&&) noexcept = default;
TangentNeighbours& TangentNeighbours::operator=(TangentNeighbours&&) noexcept = default;

std::vector<VertexId> TangentNeighbours::of(VertexId vertex) const {
  if (vertex >= data_->node_of.size())
    throw std::out_of_range("tangent neighbours: vertex " + std::to_string(vertex) + ", the world has " +
                            std::to_string(data_->node_of.size()));
  std::vector<VertexId> row = tangent_neighbours(data_->map, data_->node_of[vertex], &data_->fans);
  add_missing(data_->through_contacts, vertex, row);
  return row;
}

}  // namespace arcway
