#include "core/refine/join_arcs.h"

#include <array>
#include <cstddef>
#include <utility>

#include "core/collision/motion_free.h"
#include "core/model/merge_motions.h"
#include "core/model/side_radii.h"
#include "core/motion/biarc.h"

namespace arcway::internal {

namespace {

constexpr std::array kBiarcRatios{1.0, 0.5, 2.0};  // ratios of the tangent lengths of biarcs
constexpr double kMoreCost = 1e-3;                 // share by which the cost may rise in all
constexpr double kLonger = 0.02;                   // share by which a biarc may be longer than what it replaces
constexpr std::size_t kFewest = 3;                 // motions that a biarc takes the place of
constexpr std::size_t kMostWork = 4'000'000;       // motions of all paths that are tried, some 10 ns each

}  // namespace

// One path.
class ArcJoiner::Joining {
 public:
  Joining(ArcJoiner& memory, const JoinQuery& query)
      : memory_(memory),
        path_(memory.path_),
        query_(query),
        body_(query.vehicle.body(0.5 * query.vehicle.safety_margin())),
        radii_(query.vehicle) {}

  void run() {
    if (path_.size() < kFewest) return;
    const Pose goal = path_.back().end();
    most_ = (1.0 + kMoreCost) * cost_of(path_);
    for (std::size_t from = 0; from + kFewest <= path_.size(); ++from)
      for (std::size_t to = path_.size(); to >= from + kFewest; --to)
        if (join(from, to, to < path_.size() ? path_[to].start : goal)) break;
    merge_motions(path_);
  }

 private:
  // Replaces the motions [from, to) by a biarc to a pose. Returns whether one will do.
  bool join(std::size_t from, std::size_t to, const Pose& end) {
    const std::span<const PathSegment> before = std::span(path_).subspan(from, to - from);
    const double longest = (1.0 + kLonger) * length_of(before);
    for (const double ratio : kBiarcRatios) {
      work_ += path_.size();
      if (work_ > kMostWork || query_.clock.is_over()) return false;
      const auto arcs = biarc(before.front().start, end, ratio, radii_);
      if (!arcs || length_of(*arcs) > longest) continue;
      Path& joined = memory_.joined_;
      joined.assign(path_.begin(), path_.begin() + static_cast<std::ptrdiff_t>(from));
      joined.insert(joined.end(), arcs->begin(), arcs->end());
      joined.insert(joined.end(), path_.begin() + static_cast<std::ptrdiff_t>(to), path_.end());
      if (cost_of(joined) > most_ || !motion_free(query_.sweep, body_, *arcs, memory_.headings_)) continue;
      std::swap(path_, joined);
      return true;
    }
    return false;
  }

  [[nodiscard]] double cost_of(const Path& path) {
    return path_cost(path, query_.vehicle, query_.costs, memory_.profile_);
  }

  ArcJoiner& memory_;
  Path& path_;
  const JoinQuery& query_;
  Body body_;
  SideRadii radii_;
  double most_ = 0.0;  // cost of the path [s]
  std::size_t work_ = 0;
};

const Path& ArcJoiner::join(std::span<const PathSegment> path, const JoinQuery& query) {
  path_.assign(path.begin(), path.end());
  Joining(*this, query).run();
  return path_;
}

}  // namespace arcway::internal
