#pragma once

#include <cstddef>
#include <string>

#include "bench/report/results.h"

namespace arcway::internal::report {

/// A median over fewer queries than these says little. Rows with one are not shown.
inline constexpr double kLeastQueries = 10.0;

/// How many queries of a benchmark are solved: its counter `solved`, or `solved_share` of `queries`; 0 without either.
double solved_queries(const Measurement& m);

/// "2 rows are not shown: fewer than 10 queries are solved in each, too few for a median." Empty for none.
std::string hidden_rows_text(std::size_t rows);

}  // namespace arcway::internal::report
