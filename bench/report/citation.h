#pragma once

#include <string>

#include "bench/report/results.h"

namespace arcway::internal::report {

/// BibTeX of the library and of the paper whose method it builds on, as CITATION.cff has them. Year and commit are
/// those of the results.
std::string citation(const Results& results);

}  // namespace arcway::internal::report
