#pragma once

#include "bench/figures/figures.h"

namespace arcway::internal::cli {

/// The figures of a drive, planned by the fastest backend of this build.
figures::LiveFigures draw_live_drive();

}  // namespace arcway::internal::cli
