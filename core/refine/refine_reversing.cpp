#include "core/refine/refine_reversing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/path/reeds_shepp.h"
#include "core/path/speed_profile.h"
#include "core/query/motion_free.h"

namespace arcway {

namespace {

// Less than this part of the cost is not worth a step.
constexpr double kSmallestGain = 1e-6;
constexpr int kMostRounds = 4;

void append(Path& path, const PathSegment& segment) {
  if (segment.length > 0.0) path.push_back(segment);
}
void append(Path& path, std::span<const PathSegment> more) { path.insert(path.end(), more.begin(), more.end()); }

class ReversingRefiner {
 public:
  ReversingRefiner(const Vehicle& vehicle, const SweepQuery& sweep, double cusp_cost, const RefineOptions& options,
                   const std::function<bool()>& stop, RefinedPath& result)
      : vehicle_(vehicle),
        sweep_(sweep),
        cusp_cost_(cusp_cost),
        options_(options),
        stop_(stop),
        result_(result),
        body_(vehicle.footprint(0.5 * vehicle.safety_margin())),
        cost_(cost_of(result.path)) {}

  void run() {
    for (int round = 0; round < kMostRounds && !done(); ++round) {
      const bool runs = refine_runs();
      bool words = false;
      while (!done() && insert_word()) words = true;
      if (!words && (!runs || round > 0)) break;
    }
    result_.travel_time = speed_profile(result_.path, vehicle_).total_time;
  }

 private:
  // A place on the path.
  struct Station {
    std::size_t segment;
    double part;  // of the segment's length
    Pose pose;
    double time;        // when the path gets there, roughly within a segment [s]
    std::size_t cusps;  // before it
  };

  [[nodiscard]] bool done() {
    if (stop_ && !result_.interrupted) result_.interrupted = stop_();
    return result_.interrupted || result_.trials >= options_.max_trials;
  }

  [[nodiscard]] double cost_of(const Path& path) const { return travel_cost(path, vehicle_, cusp_cost_); }

  // Takes a free path if it is cheaper.
  bool accept(Path&& path) {
    const double cost = cost_of(path);
    if (!(cost < cost_ * (1.0 - kSmallestGain))) return false;
    cost_ = cost;
    result_.path = std::move(path);
    ++result_.improvements;
    return true;
  }

  [[nodiscard]] std::vector<Station> stations() const {
    const Path& path = result_.path;
    const SpeedProfile profile = speed_profile(path, vehicle_);
    std::vector<Station> stations;
    double time = 0.0;
    std::size_t cusps = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      cusps += i > 0 && path[i].gear != path[i - 1].gear ? 1 : 0;
      stations.push_back({i, 0.0, path[i].start, time, cusps});
      if (path[i].length > 0.5 * vehicle_.min_turning_radius())
        stations.push_back({i, 0.5, path[i].at(0.5 * path[i].length), time + 0.5 * profile.durations[i], cusps});
      time += profile.durations[i];
    }
    if (!path.empty()) stations.push_back({path.size() - 1, 1.0, path.back().end(), time, cusps});
    return stations;
  }

  // The first word that makes the path cheaper, between places far apart first.
  bool insert_word() {
    const std::vector<Station> places = stations();
    for (std::size_t span = places.empty() ? 0 : places.size() - 1; span > 0; --span)
      for (std::size_t i = 0; i + span < places.size() && !done(); ++i)
        if (insert_word(places[i], places[i + span])) return true;
    return false;
  }

  bool insert_word(const Station& from, const Station& to) {
    const double radius = vehicle_.min_turning_radius();
    const double budget = to.time - from.time + (cusp_cost_ * static_cast<double>(to.cusps - from.cusps));
    std::vector<std::pair<double, std::size_t>> words;
    for (std::size_t word = 0; word < kReedsSheppWords; ++word) {
      const double fastest = reeds_shepp_length(word, from.pose, to.pose, radius) / vehicle_.top_speed();
      if (fastest < budget) words.emplace_back(fastest, word);
    }
    std::sort(words.begin(), words.end());
    for (const auto& [fastest, word] : words) {
      if (done()) return false;
      ++result_.trials;
      const auto middle = reeds_shepp_path(word, from.pose, to.pose, radius);
      Path path = spliced(from, *middle, to);
      if (cost_of(path) < cost_ * (1.0 - kSmallestGain) && is_free(*middle) && accept(std::move(path))) return true;
    }
    return false;
  }

  [[nodiscard]] Path spliced(const Station& from, const Path& middle, const Station& to) const {
    const Path& old = result_.path;
    Path path(old.begin(), old.begin() + static_cast<std::ptrdiff_t>(from.segment));
    PathSegment head = old[from.segment];
    head.length *= from.part;
    append(path, head);
    append(path, middle);
    PathSegment tail = old[to.segment];
    tail.start = to.pose;
    tail.length *= 1.0 - to.part;
    append(path, tail);
    append(path, std::span(old).subspan(to.segment + 1));
    return path;
  }

  bool is_free(const Path& motion) {
    for (const PathSegment& s : motion) ++(s.is_line() ? result_.straights_checked : result_.turns_checked);
    return motion_free(sweep_, body_, motion);
  }

  // Refines what lies between two cusps as if it were driven forwards.
  bool refine_runs() {
    Path path;
    const Path& old = result_.path;
    for (std::size_t first = 0; first < old.size();) {
      std::size_t last = first + 1;
      while (last < old.size() && old[last].gear == old[first].gear) ++last;
      const auto run = std::span(old).subspan(first, last - first);
      const bool forward = run.front().gear == Gear::kForward;
      Path driven = forward ? Path(run.begin(), run.end()) : reversed(run);
      if (!done()) driven = refined(driven, forward ? vehicle_ : vehicle_.with_gears_swapped());
      append(path, forward ? driven : reversed(driven));
      first = last;
    }
    return accept(std::move(path));
  }

  Path refined(const Path& run, const Vehicle& vehicle) {
    RefineOptions rest = options_;
    rest.max_trials -= static_cast<std::uint32_t>(result_.trials);
    RefinedPath refined = refine_path(run, run.front().start, run.back().end(), vehicle, sweep_, rest, stop_);
    result_.trials += refined.trials;
    result_.straights_checked += refined.straights_checked;
    result_.turns_checked += refined.turns_checked;
    return std::move(refined.path);
  }

  const Vehicle& vehicle_;
  const SweepQuery& sweep_;
  double cusp_cost_;
  const RefineOptions& options_;
  const std::function<bool()>& stop_;
  RefinedPath& result_;
  Footprint body_;
  double cost_;
};

}  // namespace

RefinedPath refine_reversing_path(const Path& path, const Vehicle& vehicle, const SweepQuery& sweep, double cusp_cost,
                                  const RefineOptions& options, const std::function<bool()>& stop) {
  RefinedPath result;
  result.path = path;
  ReversingRefiner(vehicle, sweep, cusp_cost, options, stop, result).run();
  return result;
}

}  // namespace arcway
