#include "bench/report/citation.h"

namespace arcway::internal::report {

std::string citation(const Results& results) {
  const std::string commit = context_value(results.context, "commit"), date = context_value(results.context, "date");
  constexpr std::size_t kYear = 4;  // digits
  std::string text =
      "@software{arcway,\n"
      "  title   = {arcway},\n"
      "  author  = {{The arcway maintainers}},\n"
      "  version = {0.1.0},\n"
      "  license = {Apache-2.0}";
  if (date.size() > kYear) text += ",\n  year    = {" + date.substr(0, kYear) + "}";
  if (!commit.empty()) text += ",\n  note    = {commit " + commit + "}";
  return text +
         "\n}\n\n"
         "@article{jiang1997time,\n"
         "  title   = {Time-optimal smooth-path motion planning for a mobile robot with kinematic constraints},\n"
         "  author  = {Jiang, K. and Seneviratne, L. D. and Earles, S. W. E.},\n"
         "  journal = {Robotica},\n"
         "  volume  = {15},\n"
         "  year    = {1997}\n"
         "}\n";
}

}  // namespace arcway::internal::report
