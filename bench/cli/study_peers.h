#pragma once

#include "bench/report/peer_results.h"
#include "bench/suites/map_study.h"

namespace arcway::internal::cli {

/// Whether this build has planners of OMPL to compare with.
bool has_peers();

/// arcway and OMPL's planners on the first ten queries of each case, one thread, processor time. After a stop request
/// the result has the queries that were finished before. Precondition: has_peers(), and no query is in both gears, as
/// the peers drive forwards only.
/// @param seconds  of each planner and query.
report::PeerResults run_peers(const bench::MapStudy& study, double seconds, const bench::MapStudyProgress& progress);

}  // namespace arcway::internal::cli
