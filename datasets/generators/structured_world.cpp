#include "arcway/datasets/structured_world.h"

#include <utility>

#include "datasets/generators/layout.h"

namespace arcway {

using namespace internal;

const char* name_of(StructuredKind kind) {
  switch (kind) {
    case StructuredKind::kWarehouse:
      return "warehouse";
    case StructuredKind::kParking:
      return "parking";
    case StructuredKind::kRooms:
      return "rooms";
    case StructuredKind::kMaze:
      return "maze";
    case StructuredKind::kCity:
      return "city";
    case StructuredKind::kIslands:
      return "islands";
    case StructuredKind::kCorridor:
      return "corridor";
    case StructuredKind::kCoastline:
      return "coastline";
  }
  return "unknown";
}

MapFile generate_structured_world(const StructuredParameters& parameters) {
  detail::check_vertices(name_of(parameters.kind), parameters.vertices);
  detail::Layout layout(parameters.vertices, parameters.seed);
  switch (parameters.kind) {
    case StructuredKind::kWarehouse:
      lay_out_warehouse(layout);
      break;
    case StructuredKind::kParking:
      lay_out_parking(layout);
      break;
    case StructuredKind::kRooms:
      lay_out_rooms(layout);
      break;
    case StructuredKind::kMaze:
      lay_out_maze(layout);
      break;
    case StructuredKind::kCity:
      lay_out_city(layout);
      break;
    case StructuredKind::kIslands:
      lay_out_islands(layout);
      break;
    case StructuredKind::kCorridor:
      lay_out_corridor(layout);
      break;
    case StructuredKind::kCoastline:
      lay_out_coastline(layout);
      break;
  }
  return std::move(layout.map);
}

}  // namespace arcway
