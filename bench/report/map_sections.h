#pragma once

#include <string>
#include <vector>

#include "bench/report/document.h"
#include "bench/report/results.h"

namespace arcway::internal::report {

/// Whether results are those of `arcway bench`, on maps and for robots of anyone's.
bool is_of_own_maps(const Results& results);

/// The setting of a comparison with peers on such a map: "car on yard".
std::string own_setting(const std::string& robot, const std::string& map);
/// Whether a setting is of such a comparison.
bool is_own_setting(const std::string& setting);

/// For each robot and map: how many queries are solved, what a plan costs and how good it is.
std::vector<std::string> own_map_findings(const Results& results);

/// A plot of quality over time: for each robot and map the first path and the plan, as HTML.
std::vector<std::string> own_map_figures(const Results& results);

/// The cost of each stage, from the graphs to the plan; a row a robot and map.
Section own_cost_section(const Results& results);

/// What became of the queries, how good the plans are and how long they take; a row a robot and map.
Section own_quality_section(const Results& results);

}  // namespace arcway::internal::report
