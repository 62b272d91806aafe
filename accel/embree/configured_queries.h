#pragma once

#include <cstddef>

#include "accel/embree/embree_options.h"
#include "arcway/query_set.h"
#include "arcway/world.h"

namespace arcway::internal::embree {

/// make_embree_queries for tests: on a device with this configuration, such as "isa=sse2". Boxes hold several edges in
/// worlds of more than `many_edges` edges.
QuerySet make_configured_queries(const World& world, const EmbreeOptions& options, const char* device_config,
                                 std::size_t many_edges);

}  // namespace arcway::internal::embree
