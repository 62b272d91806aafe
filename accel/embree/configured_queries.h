#pragma once

#include "accel/make_queries.h"

namespace arcway::embree {

/// As make_embree_queries, on a device made with this configuration, such as "isa=sse2": for tests.
QuerySet make_configured_queries(const World& world, const EmbreeOptions& options, const char* device_config);

}  // namespace arcway::embree
