#pragma once

#include "bench/report/document.h"

namespace arcway::internal::report {

/// The drives of the stage "Live": a row a planner and rate. Without rows where the results have none.
Section live_section(const Results& results);

}  // namespace arcway::internal::report
