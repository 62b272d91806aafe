#pragma once

#include <cstddef>
#include <cstdint>

#include "arcway/datasets/map_file.h"
#include "arcway/export.h"

namespace arcway {

/// Maps laid out like places that vehicles drive in. Sizes suit a robot about 1 m wide and 2 m long.
enum class StructuredKind {
  kWarehouse,  ///< rows of racks with aisles between them, some racks missing or short, pallets in the cross aisles
  kParking,    ///< double rows of bays, four of five taken by cars that are not quite straight, curbs at the ends
  kRooms,      ///< rooms of different size, a door in every wall, tables
  kMaze,       ///< a maze with loops: long walls of many corners, the outermost ones part of the bounds
  kCity,       ///< blocks between streets that are not quite parallel: houses, L-shapes, courtyards, ponds
  kIslands,    ///< smooth closed curves of different size, drawn with many vertices
  kCorridor,   ///< parallel corridors joined at alternating ends, between long rough walls
  kCoastline   ///< one island with all the vertices, its coast rough at every scale
};
inline constexpr StructuredKind kStructuredKinds[] = {
    StructuredKind::kWarehouse, StructuredKind::kParking, StructuredKind::kRooms,    StructuredKind::kMaze,
    StructuredKind::kCity,      StructuredKind::kIslands, StructuredKind::kCorridor, StructuredKind::kCoastline};
/// "warehouse", "parking", ...
ARCWAY_API const char* name_of(StructuredKind kind);

struct StructuredParameters {
  StructuredKind kind = StructuredKind::kWarehouse;
  std::size_t vertices = 1000;  ///< number of vertices, obstacles and bounds together, about; 100 to 10 million
  std::uint64_t seed = 1;
};

/// A valid map with bounds, start and goal, the same on every platform for the same parameters. From 1,000 vertices on
/// their number is met within 5 %. Start and goal are free for the paper's robot, and a disc of 0.9 m radius can
/// move from one to the other. O(vertices) time and memory.
/// @throws std::invalid_argument naming the parameter, its value and its limit.
ARCWAY_API MapFile generate_structured_world(const StructuredParameters& parameters);

}  // namespace arcway
