#include "bench/report/least_queries.h"

#include "bench/report/markup.h"

namespace arcway::internal::report {

double solved_queries(const Measurement& m) {
  const auto counter = [&](const char* name) {
    const auto found = m.counters.find(name);
    return found == m.counters.end() ? 0.0 : found->second;
  };
  return m.counters.contains("solved") ? counter("solved") : counter("queries") * counter("solved_share");
}

std::string hidden_rows_text(std::size_t rows) {
  if (rows == 0) return {};
  return count_text(static_cast<double>(rows)) + (rows == 1 ? " row is" : " rows are") + " not shown: fewer than " +
         number_text("%.0f", kLeastQueries) + " queries are solved in " + (rows == 1 ? "it" : "each") +
         ", too few for a median.";
}

}  // namespace arcway::internal::report
