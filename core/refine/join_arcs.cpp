#include "core/refine/join_arcs.h"

#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "core/collision/motion_free.h"
#include "core/model/side_radii.h"
#include "core/motion/biarc.h"
#include "core/motion/speed_profile.h"

namespace arcway::internal {

namespace {

constexpr std::array kBiarcRatios{1.0, 0.5, 2.0};  // ratios of the tangent lengths of biarcs
constexpr double kMoreCost = 1e-3;                 // share by which the cost may rise in all
constexpr double kLonger = 0.02;                   // share by which a biarc may be longer than what it replaces
constexpr std::size_t kFewest = 3;                 // motions that a biarc takes the place of
constexpr std::size_t kMostWork = 4'000'000;       // motions of all paths that are tried, some 10 ns each

class ArcJoiner {
 public:
  ArcJoiner(Path path, const Vehicle& vehicle, const SweepQuery& sweep, const StopClock& clock, const PathCosts& costs)
      : path_(std::move(path)),
        vehicle_(vehicle),
        sweep_(sweep),
        body_(vehicle.body(0.5 * vehicle.safety_margin())),
        radii_(vehicle),
        clock_(clock),
        costs_(costs) {}

  Path run() {
    if (path_.size() < kFewest) return std::move(path_);
    const Pose goal = path_.back().end();
    most_ = (1.0 + kMoreCost) * path_cost(path_, vehicle_, costs_, profile_);
    for (std::size_t from = 0; from + kFewest <= path_.size(); ++from)
      for (std::size_t to = path_.size(); to >= from + kFewest; --to)
        if (join(from, to, to < path_.size() ? path_[to].start : goal)) break;
    return merged(path_);
  }

 private:
  // Replaces the motions [from, to) by a biarc to a pose. Returns whether one will do.
  bool join(std::size_t from, std::size_t to, const Pose& end) {
    const std::span<const PathSegment> before = std::span(path_).subspan(from, to - from);
    const double longest = (1.0 + kLonger) * length_of(before);
    for (const double ratio : kBiarcRatios) {
      work_ += path_.size();
      if (work_ > kMostWork || clock_.is_over()) return false;
      const auto arcs = biarc(before.front().start, end, ratio, radii_);
      if (!arcs || length_of(*arcs) > longest) continue;
      joined_.assign(path_.begin(), path_.begin() + static_cast<std::ptrdiff_t>(from));
      joined_.insert(joined_.end(), arcs->begin(), arcs->end());
      joined_.insert(joined_.end(), path_.begin() + static_cast<std::ptrdiff_t>(to), path_.end());
      if (path_cost(joined_, vehicle_, costs_, profile_) > most_ || !motion_free(sweep_, body_, *arcs)) continue;
      std::swap(path_, joined_);
      return true;
    }
    return false;
  }

  Path path_, joined_;
  const Vehicle& vehicle_;
  const SweepQuery& sweep_;
  Body body_;
  SideRadii radii_;
  const StopClock& clock_;
  PathCosts costs_;
  double most_ = 0.0;  // cost of the path [s]
  std::size_t work_ = 0;
  SpeedProfile profile_;
};

}  // namespace

Path join_arcs(Path path, const Vehicle& vehicle, const SweepQuery& sweep, const StopClock& clock,
               const PathCosts& costs) {
  return ArcJoiner(std::move(path), vehicle, sweep, clock, costs).run();
}

}  // namespace arcway::internal
