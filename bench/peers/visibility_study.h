#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "bench/report/peer_results.h"

namespace arcway::internal::peers {

struct VisibilityStudyOptions {
  std::vector<std::size_t> obstacles{10, 100, 1000, 10000};  ///< numbers of obstacles of 10 vertices each, fill 0.3
  std::size_t repetitions = 7;
  double limit = 20.0;  ///< leaves out what one of both would take longer for, judged by the size before [s]
};

/// Compares lines of sight and visibility graphs by arcway with those by brute force and, where this program has it,
/// CGAL. Both sides run in turn with one thread each; against CGAL's triangulation arcway also runs with two. Results
/// are compared before; a difference leaves an error in place of times.
/// @param progress  receives the name of the next step.
std::vector<report::Duel> visibility_study(const VisibilityStudyOptions& options,
                                           const std::function<void(const std::string&)>& progress);

}  // namespace arcway::internal::peers
