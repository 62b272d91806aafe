#pragma once

#include <cstddef>

#include "arcway/visibility_graph.h"
#include "arcway/world.h"

namespace arcway::internal::bench {

/// Whether a reduced visibility graph is the right one. Up to 4,000 vertices: compared with the reference's, whole.
/// Above: `rows` of its rows, chosen at random, against the definition; lines of sight by brute force up to 100,000
/// vertices, by Embree beyond if this build has it.
bool is_reduced_graph(const World& world, const VisibilityGraph& graph, std::size_t rows = 8);
/// The same for the full visibility graph; whole up to 1,100 vertices.
bool is_full_graph(const World& world, const VisibilityGraph& graph, std::size_t rows = 8);

}  // namespace arcway::internal::bench
