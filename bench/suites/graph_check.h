#pragma once

#include <cstddef>

#include "arcway/visibility_graph.h"
#include "arcway/world.h"

namespace arcway::internal::bench {

/// Whether a reduced visibility graph is right. Up to 4,000 vertices it is compared with the reference's graph. Above
/// that, `rows` random rows are compared with the definition. Their lines of sight are decided by brute force up to
/// 100,000 vertices, and beyond by Embree if this build has it.
bool is_reduced_graph(const World& world, const VisibilityGraph& graph, std::size_t rows = 8);
/// Whether a full visibility graph is right; compared with the reference's graph up to 1,100 vertices.
bool is_full_graph(const World& world, const VisibilityGraph& graph, std::size_t rows = 8);

}  // namespace arcway::internal::bench
