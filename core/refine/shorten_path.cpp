#include "core/refine/shorten_path.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "core/collision/motion_free.h"
#include "core/model/side_radii.h"
#include "core/motion/biarc.h"
#include "core/motion/dubins.h"
#include "core/motion/speed_profile.h"

namespace arcway::internal {

namespace {

constexpr std::array kRadii{1.0, 2.0, 4.0};          // radii of Dubins words, in smallest turning radii
constexpr std::array kTangentRatios{1.0, 0.5, 2.0};  // ratios of the tangent lengths of biarcs
constexpr double kSmallestSaving = 1e-4;             // share of the cost that a change must save

class Shortener {
 public:
  // Many parameters because these are those of shorten_path.
  Shortener(Path path, const Vehicle& vehicle, const SweepQuery& sweep, std::size_t max_trials, const StopClock& clock,
            const PathCosts& costs)
      : path_(std::move(path)),
        vehicle_(vehicle),
        sweep_(sweep),
        body_(vehicle.body(0.5 * vehicle.safety_margin())),
        trials_left_(max_trials),
        clock_(clock),
        costs_(costs) {
    cost_ = cost_of(path_);
  }

  Path run() {
    for (bool shorter = true; std::exchange(shorter, false) && !done();) {
      find_places();
      for (std::size_t i = 0; i + 1 < places_.size() && !done(); ++i)
        while (shorten_from(i) && !done()) {
          shorter = true;
          find_places();
        }
    }
    return std::move(path_);
  }

 private:
  // A place on the path, at a length along a segment.
  struct Place {
    std::size_t segment;
    double along;  // [m]
    Pose pose;
  };

  [[nodiscard]] bool done() const { return trials_left_ == 0 || clock_.is_over(); }

  double cost_of(const Path& path) { return path_cost(path, vehicle_, costs_, profile_); }

  void find_places() {
    places_.clear();
    for (std::size_t i = 0; i < path_.size(); ++i)
      for (const double share : {0.0, 0.5}) {
        const double along = share * path_[i].length;
        places_.push_back({i, along, path_[i].at(along)});
      }
    if (!path_.empty()) places_.push_back({path_.size() - 1, path_.back().length, path_.back().end()});
  }

  // Tries to join a place to a later one, the last one first.
  bool shorten_from(std::size_t i) {
    for (std::size_t j = places_.size() - 1; i < places_.size() && j > i + 1 && !done(); --j) {
      const Place &from = places_[i], &to = places_[j];
      const SideRadii radii(vehicle_);
      for (const double ratio : kTangentRatios) {
        const auto arcs = biarc(from.pose, to.pose, ratio, radii);
        if (arcs && take(from, to, *arcs)) return true;
      }
      for (const double wider : kRadii)
        for (const DubinsWord word : kDubinsWords) {
          const auto between = dubins_word(word, from.pose, to.pose, radii.times(wider));
          if (between && take(from, to, between->segments())) return true;
        }
    }
    return false;
  }

  // Replaces the part between two places, if that is faster and free.
  bool take(const Place& from, const Place& to, std::span<const PathSegment> between) {
    if (done()) return false;
    --trials_left_;
    shorter_.assign(path_.begin(), path_.begin() + static_cast<std::ptrdiff_t>(from.segment));
    const PathSegment &first = path_[from.segment], &last = path_[to.segment];
    if (from.along > 0.0) shorter_.push_back({first.start, from.along, first.curvature});
    shorter_.insert(shorter_.end(), between.begin(), between.end());
    if (to.along < last.length) shorter_.push_back({to.pose, last.length - to.along, last.curvature});
    shorter_.insert(shorter_.end(), path_.begin() + static_cast<std::ptrdiff_t>(to.segment) + 1, path_.end());
    const double cost = cost_of(shorter_);
    if (!(cost < (1.0 - kSmallestSaving) * cost_) || !motion_free(sweep_, body_, between)) return false;
    path_ = merged(shorter_);
    cost_ = cost;
    return true;
  }

  Path path_, shorter_;
  const Vehicle& vehicle_;
  const SweepQuery& sweep_;
  Body body_;
  std::size_t trials_left_;
  const StopClock& clock_;
  PathCosts costs_;
  double cost_ = 0.0;
  std::vector<Place> places_;
  SpeedProfile profile_;
};

}  // namespace

// Many parameters because most callers leave out the end speeds.
Path shorten_path(Path path, const Vehicle& vehicle, const SweepQuery& sweep, std::size_t max_trials,
                  const StopClock& clock, const PathCosts& costs) {
  return Shortener(std::move(path), vehicle, sweep, max_trials, clock, costs).run();
}

}  // namespace arcway::internal
