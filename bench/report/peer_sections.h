#pragma once

#include <string>
#include <vector>

#include "bench/report/document.h"
#include "bench/report/peer_results.h"

namespace arcway::internal::report {

/// Sentences that say in which tasks arcway or a peer is faster, and by how much.
std::vector<std::string> peer_findings(const PeerResults& peers);

/// Plots of the ratios over the map's size, and of quality over time, as HTML.
std::vector<std::string> peer_figures(const PeerResults& peers);

/// Ratios of the alternating runs, over the size of the map.
Section duels_section(const PeerResults& peers);

/// All queries of all worlds: solved, time to the answer, travel times against the bound and the best known.
Section planners_section(const PeerResults& peers);

/// A table of all queries for each world, with the reasons of what is not solved.
Section planners_by_world_section(const PeerResults& peers);

}  // namespace arcway::internal::report
