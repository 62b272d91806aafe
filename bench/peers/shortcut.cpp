#include "bench/peers/shortcut.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/motion/dubins.h"

namespace arcway::internal::peers {
namespace {

/// The path from its start to arc length `from`, and the one from arc length `to` to its end.
std::pair<Path, Path> ends_of(const Path& path, double from, double to) {
  std::pair<Path, Path> ends;
  double passed = 0.0;
  for (const PathSegment& s : path) {
    const double before = std::clamp(from - passed, 0.0, s.length);
    const double after = std::clamp(to - passed, 0.0, s.length);
    if (before > 0.0) ends.first.push_back({s.start, before, s.curvature});
    if (after < s.length) ends.second.push_back({s.at(after), s.length - after, s.curvature});
    passed += s.length;
  }
  return ends;
}

}  // namespace

Path shortcut(Path path, const Problem& problem, const ShortcutOptions& options, Random& random) {
  const Body body = checked_body(problem.vehicle);
  double time = travel_time(path, problem.vehicle);
  for (int failures = 0; failures < options.patience && !options.stop(); ++failures) {
    const double length = length_of(path);
    double from = random.uniform(0.0, length), to = random.uniform(0.0, length);
    if (from > to) std::swap(from, to);
    const auto [head, tail] = ends_of(path, from, to);
    if (head.empty() || tail.empty()) continue;

    struct Candidate {
      double time;
      Path whole, word;
    };
    std::vector<Candidate> faster;
    const double radius = options.radii[random.below(options.radii.size())];
    for (const DubinsWord word : kDubinsWords) {
      std::optional<Path> middle = dubins_path(word, head.back().end(), tail.front().start, radius);
      if (!middle) continue;
      Path whole = head;
      whole.insert(whole.end(), middle->begin(), middle->end());
      whole.insert(whole.end(), tail.begin(), tail.end());
      const double candidate_time = travel_time(whole, problem.vehicle);
      if (candidate_time < time) faster.push_back({candidate_time, std::move(whole), std::move(*middle)});
    }
    std::ranges::sort(faster, {}, &Candidate::time);
    for (Candidate& candidate : faster) {
      if (!motion_free(problem.sweep, body, candidate.word)) continue;
      path = std::move(candidate.whole);
      time = candidate.time;
      failures = -1;
      break;
    }
  }
  return path;
}

}  // namespace arcway::internal::peers
