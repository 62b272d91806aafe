#pragma once

#include <string>
#include <vector>

#include "bench/report/document.h"
#include "bench/report/peer_results.h"

namespace arcway::internal::report {

/// Sentences that say in which tasks arcway or a peer is faster, and by how much.
std::vector<std::string> peer_findings(const PeerResults& peers);

/// How arcway's paths compare with those of peers that improve theirs until their time is over, in a sentence for a
/// stranger; empty without any.
std::string planner_comparison(const PeerResults& peers);
/// How long peers take for the visibility graph, in such a sentence.
std::string duel_comparison(const PeerResults& peers);

/// A path counts as slower than another one if its travel time is longer by more than this share. Less is no difference
/// to a vehicle.
inline constexpr double kTravelTimeTolerance = 1e-3;

/// Plots of the ratios over the map's size, as HTML.
std::vector<std::string> duel_figures(const PeerResults& peers);
/// Plots of quality over time, one a setting, as HTML: real vehicles first, then by the number of queries.
std::vector<std::string> planner_figures(const PeerResults& peers);

/// Ratios of the alternating runs, over the size of the map.
Section duels_section(const PeerResults& peers);

/// On how many queries arcway's path is not slower than a peer's, with and without the tolerance; a row each setting
/// and peer. First paths are left out.
Section claims_section(const PeerResults& peers);

/// The queries that a peer alone solves, or with a path that is faster by more than the tolerance.
Section losses_section(const PeerResults& peers);

/// All queries of all worlds: solved, time to the answer, travel times against the bound and the best known.
Section planners_section(const PeerResults& peers);

/// A table of all queries for each world, with the reasons of what is not solved.
Section planners_by_world_section(const PeerResults& peers);

}  // namespace arcway::internal::report
