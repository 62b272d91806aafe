#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/report/document.h"
#include "bench/report/study.h"

namespace arcway::internal::report {

/// The place in the kept set (bench/robots.h) of the vehicle that a name of a benchmark or setting begins with. All
/// other names are of the paper's robot; their rank is the number of real vehicles.
std::size_t vehicle_rank(std::string_view name);

/// What plans of real vehicles cost and how good they are; that nothing was measured of them, if so.
std::string vehicle_finding(const Results& results);

/// Plots of the growth of a plan with the obstacles, a curve for each vehicle, as HTML.
std::vector<std::string> vehicle_figures(const std::vector<Study>& studies);

/// The kept set, the paper's robot last: its numbers, and its plans in worlds of its size.
Section vehicles_section(const Results& results, const std::vector<Study>& studies);

}  // namespace arcway::internal::report
