#pragma once

#include "arcway/path.h"

namespace arcway::internal {

/// Drives a path in fewer segments, in its own memory: see merged.
void merge_motions(Path& path);

}  // namespace arcway::internal
