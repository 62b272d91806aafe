#pragma once

#include <cstddef>

#include "accel/embree/embree_options.h"
#include "arcway/query_set.h"
#include "arcway/world.h"

namespace arcway::internal::embree {

/// As make_embree_queries, on a device made with this configuration, such as "isa=sse2", and with boxes that hold
/// several edges in worlds of more than so many: for tests.
QuerySet make_configured_queries(const World& world, const EmbreeOptions& options, const char* device_config,
                                 std::size_t many_edges);

}  // namespace arcway::internal::embree
