#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/report/document.h"
#include "bench/report/study.h"

namespace arcway::internal::report {

/// What was planned, how the cost grows and how it compares, in plain words for a stranger. What the results say
/// nothing of is left out.
std::string lead_paragraph(const Inputs& inputs, const std::vector<Study>& studies);

/// A query to show as a picture. Results have no paths, so that it is planned anew.
struct PicturedQuery {
  std::string title;
  std::string vehicle;    ///< name in bench/robots.h, also of a gentle robot; any other is the paper's robot
  std::string world;      ///< catalog name
  std::size_t query = 0;  ///< of the world's random queries with seed 1
  bool any = false;       ///< one of those from `query` on, which shows something
  double seconds = 0.0;   ///< what it took in the results; 0 if they do not say
};

/// A plan of the first real vehicle or, without one, of the paper's robot, and the slowest query of all; empty where
/// the results have no queries.
std::vector<PicturedQuery> pictured_queries(const Inputs& inputs);

}  // namespace arcway::internal::report
