#pragma once

#include <string>
#include <vector>

#include "bench/report/document.h"
#include "bench/report/study.h"

namespace arcway::internal::report {

/// What a stranger asks first, in plain sentences; one that the results cannot answer is left out.
std::vector<std::string> growth_findings(const Results& results, const std::vector<Study>& studies);

/// How many benchmarks failed and were left out, and how many are noisy and why.
std::vector<std::string> run_findings(const Results& results);

/// The stages of planning: growth with the obstacles, time at 1,000, 10,000 and 100,000 vertices, memory.
Section cost_section(const std::vector<Study>& studies);

/// Plots of the growth with the obstacles and with the vertices of each, as HTML.
std::vector<std::string> growth_figures(const std::vector<Study>& studies);

/// Solved share, reasons, travel times over bound and best known, clearance: a row a set of queries.
Section quality_section(const Results& results);

/// Travel time over the lower bound with the planner's features switched off one by one; a row each, a column a world.
Section ablation_section(const Results& results);

/// Travel time over the number of radii, for robots whose wider turns are faster; a row each.
Section radii_section(const Results& results);

/// Preparing and planning on real maps; a row for each, with what became of the queries.
Section real_maps_section(const Results& results);

}  // namespace arcway::internal::report
