#pragma once

#include <string>
#include <vector>

#include "bench/report/document.h"

namespace arcway::internal::cli {

/// Pictures of a plan and of the slowest query of the results, as HTML. Results have no paths, so that both are planned
/// anew: the plans are the same, as they depend on nothing but world, vehicle and query.
std::vector<std::string> report_pictures(const report::Inputs& inputs);

}  // namespace arcway::internal::cli
