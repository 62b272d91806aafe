#include "core/reversing/refine_reversing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "arcway/angle.h"
#include "core/base/infinity.h"
#include "core/collision/motion_free.h"
#include "core/collision/path_cost.h"
#include "core/model/side_radii.h"
#include "core/motion/biarc.h"
#include "core/motion/dubins.h"
#include "core/motion/gear_words.h"
#include "core/motion/speed_profile.h"
#include "core/refine/moves.h"
#include "core/refine/optimize_chain.h"
#include "core/search/push_free.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

namespace {

// Share of the cost that a step must save. 1e-6 takes a sixth more trials for plans that are as fast in the mean.
constexpr double kLeastSaving = 1e-4;
// Share of the cost that a sweep of words, or a round of moves, must save for another one to follow.
constexpr double kWorthRepeating = 0.01;

void append(Path& path, const PathSegment& segment) {
  if (segment.length > 0.0) path.push_back(segment);
}
void append(Path& path, std::span<const PathSegment> more) { path.insert(path.end(), more.begin(), more.end()); }

class ReversingRefiner {
 public:
  ReversingRefiner(const RefineQuery& query, const GearChanges& changes, RefinedPath& result)
      : vehicle_(query.vehicle),
        sweep_(query.sweep),
        sweep_backwards_(query.sweep_backwards != nullptr ? *query.sweep_backwards : query.sweep),
        changes_(changes),
        goal_(query.goal),
        options_(query.options),
        clock_(query.clock),
        world_(query.world),
        outlines_(query.outlines),
        ends_(query.ends),
        zones_(query.speed_zones),
        clearance_(query.clearance_cost),
        result_(result),
        body_(query.vehicle.body(0.5 * query.vehicle.safety_margin())),
        most_cusps_(std::max(changes.most, cusps_of(result.path))),
        most_trials_(query.options.max_trials) {
    cost_ = cost_of(result.path);
    forget_vain_moves();
  }

  void run() {
    most_trials_ = static_cast<std::uint32_t>(kGearRoundsShare * options_.max_trials);
    const Path unrefined = result_.path;
    improve();
    most_trials_ = options_.max_trials;
    take_all(Stage::kFinish, 0);
    escape();
    begin_again(unrefined);
    result_.travel_time = travel_time(result_.path, vehicle_, ends_, profile_, zones_);
  }

 private:
  // Leads to an optimum of the moves that are tried in rounds.
  void improve() {
    for (int round = 0; round < kMostGearRounds && !done(); ++round) {
      if (!take_all(Stage::kImprove, round) || !is_worth_repeating(cost_of_words_)) break;
    }
  }

  // Leaves out gear changes at the optimum of the other moves, and improves what remains.
  void escape() {
    for (int i = 0; i < kMostGearEscapes && !done() && take_all(Stage::kEscape, i); ++i) improve();
  }

  // Leaves out gear changes of the path before refinement, and refines what remains. Refined turns are as tight as
  // allowed, and so cannot be pushed as far.
  void begin_again(const Path& unrefined) {
    if (done() || cusps_of(result_.path) < 2) return;
    Path best = std::exchange(result_.path, unrefined);
    forget_vain_moves();
    const double best_cost = std::exchange(cost_, kInfinity);
    cost_ = cost_of(unrefined);
    take_all(Stage::kEscape, 0);
    if (cusps_of(result_.path) < cusps_of(best)) {
      improve();
      escape();
    }
    if (cost_ < best_cost) return;
    result_.path = std::move(best);
    cost_ = best_cost;
  }

  // A place on the path.
  struct Station {
    std::size_t segment;
    double part;  // of the segment's length
    Pose pose;
    double time;        // when the path gets there, roughly within a segment [s]
    double clearance;   // what driving close to obstacles has cost by then [s]
    std::size_t cusps;  // before it
  };

  // All moves of a stage. Returns whether one helped that another round follows.
  bool take_all(Stage stage, int round) {
    bool again = false;
    for (const GearMoveRow& row : kGearMoves) {
      if (row.stage != stage || (options_.moves & move_bit(row.name)) == 0) continue;
      // What found nothing finds nothing again while the path is the same. All rows of one kind of move are equal.
      std::uint64_t& vain = vain_[row.move.index()];
      if (vain == result_.improvements) continue;
      const bool helps = std::visit([this](const auto& move) { return take(move); }, row.move);
      const bool is_repeated = std::holds_alternative<InsertGearWords>(row.move);  // until it saves next to nothing
      if ((!helps || is_repeated) && !done()) vain = result_.improvements;
      again = again || (helps && round <= row.last_round);
    }
    return again;
  }

  void forget_vain_moves() { vain_.fill(kNeverVain); }

  [[nodiscard]] bool done() {
    result_.interrupted = result_.interrupted || clock_.is_over();
    return result_.interrupted || result_.trials >= most_trials_;
  }

  // The cost of a path, or as much of it as tells that it is not cheaper.
  [[nodiscard]] double cost_of(const Path& path) {
    return path_cost(path, vehicle_, {ends_, zones_, clearance_, changes_.cost}, profile_, least_saving());
  }

  // A path is cheaper if it costs less than this.
  [[nodiscard]] double least_saving() const { return cost_ * (1.0 - kLeastSaving); }
  [[nodiscard]] bool is_cheaper(double cost) const { return cost < least_saving(); }

  // Takes a free path if it is cheaper.
  bool accept(const Path& path) {
    const double cost = cost_of(path);
    if (!is_cheaper(cost) || cusps_of(path) > most_cusps_) return false;
    cost_ = cost;
    result_.path = merged(path);
    ++result_.improvements;
    return true;
  }

  [[nodiscard]] std::vector<Station> stations() const {
    const Path& path = result_.path;
    const SpeedProfile profile = speed_profile(path, vehicle_, ends_, zones_);
    std::vector<Station> stations;
    double time = 0.0, clearance = 0.0;
    std::size_t cusps = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      cusps += i > 0 && path[i].gear != path[i - 1].gear ? 1 : 0;
      stations.push_back({i, 0.0, path[i].start, time, clearance, cusps});
      PathSegment half = path[i];
      half.length *= 0.5;
      if (path[i].length > 0.5 * vehicle_.min_turning_radius())
        stations.push_back({i, 0.5, half.end(), time + 0.5 * profile.durations[i],
                            clearance + clearance_cost(clearance_, {&half, 1}), cusps});
      time += profile.durations[i];
      clearance += clearance_cost(clearance_, {&path[i], 1});
    }
    if (!path.empty()) stations.push_back({path.size() - 1, 1.0, path.back().end(), time, clearance, cusps});
    return stations;
  }

  // Whether what has saved this much is tried again.
  [[nodiscard]] bool is_worth_repeating(double cost_before) const {
    return cost_ < (1.0 - kWorthRepeating) * cost_before;
  }

  // Puts words between places of the path until that saves next to nothing.
  bool take(const InsertGearWords& move) {
    bool changed = false;
    for (double before = cost_; !done() && sweep_words(move); before = cost_) {
      changed = true;
      if (!is_worth_repeating(before)) break;
    }
    cost_of_words_ = cost_;
    return changed;
  }

  // Words between places far apart come first. A word that is kept changes the places for later trials.
  bool sweep_words(const InsertGearWords& move) {
    bool changed = false;
    std::vector<Station> places = stations();
    for (std::size_t span = places.empty() ? 0 : places.size() - 1; span > 0 && !done(); span = next_span(span, move)) {
      for (std::size_t i = 0; i + span < places.size() && !done(); ++i) {
        if (!insert_word(move, places[i], places[i + span])) continue;
        changed = true;
        places = stations();
      }
    }
    return changed;
  }

  [[nodiscard]] static std::size_t next_span(std::size_t span, const InsertGearWords& move) {
    return span <= move.every_span ? span - 1 : std::max(move.every_span, span - span / move.span_ratio - 1);
  }

  struct Word {
    double fastest;  // it can be driven, but for its changes of gear [s]
    Path motion;
  };

  bool insert_word(const InsertGearWords& move, const Station& from, const Station& to) {
    for (const Word& word : words_between(move, from, to)) {
      if (done()) return false;
      ++result_.trials;
      const Path path = spliced(from, word.motion, to);
      if (is_cheaper(cost_of(path)) && is_free(word.motion) && accept(path)) return true;
    }
    return false;
  }

  // The words that may make the path cheaper, the fastest first.
  [[nodiscard]] std::vector<Word> words_between(const InsertGearWords& move, const Station& from,
                                                const Station& to) const {
    const double budget = to.time - from.time + changes_.cost * static_cast<double>(to.cusps - from.cusps) +
                          (to.clearance - from.clearance);
    std::vector<Word> words;
    for (const double turn : move.radii) {
      const GearWords between(from.pose, to.pose, SideRadii(vehicle_).times(turn));
      for (std::size_t word = 0; word < kGearWords; ++word) {
        const double fastest = between.length(word, budget * vehicle_.top_speed()) / vehicle_.top_speed();
        if (fastest < budget) words.push_back({fastest, *between.path(word)});
      }
      if (from.cusps == to.cusps) break;
    }
    for (const double ratio : move.ratios) {
      const auto add = [&](const auto& arcs, Gear gear) {
        if (!arcs) return;
        const double fastest = length_of(*arcs) / vehicle_.top_speed();
        if (fastest < budget)
          words.push_back({fastest, gear == Gear::kForward ? Path(arcs->begin(), arcs->end()) : reversed(*arcs)});
      };
      add(biarc(from.pose, to.pose, ratio, SideRadii(vehicle_)), Gear::kForward);
      add(biarc(to.pose, from.pose, ratio, SideRadii(vehicle_)), Gear::kReverse);
    }
    std::ranges::sort(words, {}, &Word::fastest);
    return words;
  }

  // Moves the poses at which the gear changes, by steps that are halved, as long as that makes the path cheaper.
  bool take(const SlideCusps& move) {
    const double radius = vehicle_.min_turning_radius();
    bool slid = false;
    for (double step = move.first_step; step >= options_.smallest_step && !done(); step *= 0.5)
      for (std::size_t cusp = 0; cusp < cusps_of(result_.path); ++cusp)
        // Where the body nearly touches something, only one direction of these may be free.
        for (const int ahead : {1, -1, 0})
          for (const int aside : {1, -1, 0})
            for (const int turn : {1, -1, 0}) {
              const Pose by{step * radius * ahead, step * radius * aside, step * turn};
              while (!done() && slide_cusp(move, cusp, by)) slid = true;
            }
    return slid;
  }

  // The first segments after all changes of gear.
  [[nodiscard]] std::vector<std::size_t> cusps() const {
    const Path& path = result_.path;
    std::vector<std::size_t> found;
    for (std::size_t i = 1; i < path.size(); ++i)
      if (path[i].gear != path[i - 1].gear) found.push_back(i);
    return found;
  }

  // A connection between a place of the path and a cusp that has moved.
  struct Link {
    Station place;
    Path motion;
    std::optional<bool> free = {};
  };

  // Moves one cusp by so much ahead, aside and in heading, if that makes the path cheaper.
  bool slide_cusp(const SlideCusps& move, std::size_t number, const Pose& by) {
    const std::vector<std::size_t> all = cusps();
    if (number >= all.size()) return false;
    const Path& path = result_.path;
    const Pose& old = path[all[number]].start;
    const Vec2 ahead = direction_of(old.heading);
    const Vec2 position = old.position() + by.x * ahead + by.y * perpendicular(ahead);
    const Pose cusp{position.x(), position.y(), old.heading + by.heading};
    const auto at = static_cast<std::ptrdiff_t>(all[number]), end = static_cast<std::ptrdiff_t>(path.size());
    const auto first =
        std::max(at - move.segments_beside, number > 0 ? static_cast<std::ptrdiff_t>(all[number - 1]) : 0);
    const auto last = std::min(at + move.segments_beside,
                               number + 1 < all.size() ? static_cast<std::ptrdiff_t>(all[number + 1]) : end);
    const std::size_t most = move.links_tried;
    return replace_beside(links(first, at, cusp, false, most), links(at, last, cusp, true, most));
  }

  // A Dubins word between a place of the path and a cusp that has moved.
  struct LinkWord {
    std::size_t segment;
    Pose from, to;  // driven forwards
    DubinsWord word;
    double longer;  // than the way so far [m]
  };

  // The shortest connections between a moved cusp and the far ends of segments before or after it, in their gear.
  std::vector<Link> links(std::ptrdiff_t first, std::ptrdiff_t last, const Pose& cusp, bool after,
                          std::size_t most) const {
    std::vector<LinkWord> words;
    double length = 0.0;
    for (std::ptrdiff_t i = 0; i < last - first; ++i) {
      const auto segment = static_cast<std::size_t>(after ? first + i : last - 1 - i);
      const PathSegment& s = result_.path[segment];
      const Pose place = after ? s.end() : s.start;
      const bool towards_cusp = after != (s.gear == Gear::kForward);
      const Pose &from = towards_cusp ? place : cusp, &to = towards_cusp ? cusp : place;
      length += s.length;
      for (const DubinsWord word : kDubinsWords) {
        const double word_length = dubins_length(word, from, to, SideRadii(vehicle_));
        if (word_length < kInfinity) words.push_back({segment, from, to, word, word_length - length});
      }
    }
    std::stable_sort(words.begin(), words.end(),
                     [](const LinkWord& a, const LinkWord& b) { return a.longer < b.longer; });
    if (words.size() > most) words.resize(most);
    std::vector<Link> found;
    for (const LinkWord& w : words) {
      const PathSegment& s = result_.path[w.segment];
      const Path forwards = *dubins_path(w.word, w.from, w.to, SideRadii(vehicle_));
      found.push_back({{w.segment, after ? 1.0 : 0.0, after ? s.end() : s.start, 0.0, 0.0, 0},
                       s.gear == Gear::kForward ? forwards : reversed(forwards)});
    }
    return found;
  }

  // Replaces what lies before and after a cusp, if that makes the path cheaper.
  bool replace_beside(std::vector<Link> before, std::vector<Link> after) {
    const auto may_be_free = [](const Link& link) { return link.free.value_or(true); };
    const auto check = [this](Link& link) {
      if (!link.free) link.free = is_free(link.motion);
      return *link.free;
    };
    for (Link& to : before)
      for (Link& from : after) {
        if (done()) return false;
        if (!may_be_free(to) || !may_be_free(from)) continue;
        ++result_.trials;
        Path middle = to.motion;
        append(middle, from.motion);
        const Path changed = spliced(to.place, middle, from.place);
        if (is_cheaper(cost_of(changed)) && check(to) && check(from)) return accept(changed);
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

  // What lies between two cusps, or between a cusp and an end.
  struct Run {
    std::size_t first, end;  // segments
    double length;
  };

  [[nodiscard]] std::vector<Run> runs() const {
    const Path& path = result_.path;
    std::vector<Run> found;
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (i == 0 || path[i].gear != path[i - 1].gear) found.push_back({i, i, 0.0});
      found.back().end = i + 1;
      found.back().length += path[i].length;
    }
    return found;
  }

  // Leaves out runs, the shortest first.
  bool take(const DropGearChanges& move) {
    if (outlines_ == nullptr) return false;
    const double longest = move.longest * (vehicle_.min_turning_radius() + vehicle_.footprint().length());
    bool changed = false;
    std::size_t failed = 0;
    double shortest = 0.0;  // shorter ones have been tried
    while (!done() && failed < move.most_failed) {
      const std::vector<Run> all = runs();
      const auto next = next_run(all, shortest);
      if (!next || all[*next].length > longest) break;
      shortest = all[*next].length;
      if (drop_run(move, all, *next)) {
        changed = true;
      } else {
        ++failed;
      }
    }
    return changed;
  }

  // The shortest run between two gear changes that is longer than a length.
  [[nodiscard]] static std::optional<std::size_t> next_run(const std::vector<Run>& runs, double length) {
    std::optional<std::size_t> next;
    for (std::size_t i = 1; i + 1 < runs.size(); ++i)
      if (runs[i].length > length && (!next || runs[i].length < runs[*next].length)) next = i;
    return next;
  }

  // Replaces some runs by all but one of them, pushed free.
  bool drop_run(const DropGearChanges& move, const std::vector<Run>& all, std::size_t number) {
    ++result_.trials;
    const Path& old = result_.path;
    const std::size_t first = all[number - std::min(number, move.runs_beside)].first;
    const std::size_t end = all[std::min(number + move.runs_beside, all.size() - 1)].end;
    Path rest;
    append(rest, std::span(old).subspan(first, all[number].first - first));
    append(rest, std::span(old).subspan(all[number].end, end - all[number].end));
    const Pose to = end < old.size() ? old[end].start : goal_;
    const auto pushed = push_free(rest, to, {vehicle_, body_, *outlines_, sweep_}, clock_);
    if (!pushed) return false;
    Path path(old.begin(), old.begin() + static_cast<std::ptrdiff_t>(first));
    append(path, *pushed);
    append(path, std::span(old).subspan(end));
    return accept(path);
  }

  // Optimizes all turns at once, and the places of changes of gear with them.
  bool take(const OptimizeTurns& move) {
    if (outlines_ == nullptr || !ChainOptimizer::serves(vehicle_) || done()) return false;
    const ChainEffort effort = move.effort_for(vehicle_).within(most_trials_ - result_.trials);
    const auto [is_optimized, iterations] = optimizer_.optimize(
        result_.path, {vehicle_, *world_, *outlines_, effort, clock_, ends_, clearance_}, optimized_);
    result_.trials += static_cast<std::uint64_t>(iterations);
    return is_optimized && is_cheaper(cost_of(optimized_)) && is_free(optimized_) && accept(optimized_);
  }

  // Refines what lies between two cusps as if it were driven forwards.
  bool take(const RefineRuns&) {
    Path path;
    const Path& old = result_.path;
    for (std::size_t first = 0; first < old.size();) {
      std::size_t last = first + 1;
      while (last < old.size() && old[last].gear == old[first].gear) ++last;
      const auto run = std::span(old).subspan(first, last - first);
      const bool forward = run.front().gear == Gear::kForward;
      Path driven = forward ? Path(run.begin(), run.end()) : reversed(run);
      const EndSpeeds ends{first == 0 ? ends_.start : 0.0, last == old.size() ? ends_.goal : 0.0};
      if (!done())
        driven = forward ? refined(driven, Gear::kForward, ends) : refined(driven, Gear::kReverse, ends.reversed());
      append(path, forward ? driven : reversed(driven));
      first = last;
    }
    return accept(path);
  }

  // A run that is driven in a gear, described as if it were driven forwards.
  Path refined(const Path& run, Gear gear, const EndSpeeds& ends) {
    const Vehicle vehicle = gear == Gear::kForward ? vehicle_ : vehicle_.with_gears_swapped();
    RefineOptions rest = options_;
    rest.max_trials -= static_cast<std::uint32_t>(result_.trials);
    RefinedPath refined = refine_path({.path = run,
                                       .start = run.front().start,
                                       .goal = run.back().end(),
                                       .vehicle = vehicle,
                                       .sweep = gear == Gear::kForward ? sweep_ : sweep_backwards_,
                                       .options = rest,
                                       .clock = clock_,
                                       .world = world_,
                                       .outlines = outlines_,
                                       .at_length = true,
                                       .ends = ends,
                                       .speed_zones = zones_,
                                       .clearance_cost = clearance_});
    result_.trials += refined.trials;
    result_.straights_checked += refined.straights_checked;
    result_.turns_checked += refined.turns_checked;
    return std::move(refined.path);
  }

  const Vehicle& vehicle_;
  const SweepQuery& sweep_;
  const SweepQuery& sweep_backwards_;
  GearChanges changes_;
  Pose goal_;
  const RefineOptions& options_;
  const StopClock& clock_;
  const World* world_;
  const Outlines* outlines_;
  EndSpeeds ends_;
  const SpeedZones* zones_;
  const ClearanceCost* clearance_;
  SpeedProfile profile_;  // memory
  ChainOptimizer optimizer_;
  Path optimized_;
  RefinedPath& result_;
  Body body_;
  std::size_t most_cusps_;
  std::uint64_t most_trials_;  // until the next stage
  double cost_ = kInfinity;
  double cost_of_words_ = kInfinity;  // of the path when words were last put in
  // By kind of move, the number of improvements when it last found nothing.
  static constexpr std::uint64_t kNeverVain = std::numeric_limits<std::uint64_t>::max();
  std::array<std::uint64_t, std::variant_size_v<GearMove>> vain_;
};

}  // namespace

RefinedPath refine_reversing_path(const RefineQuery& query, const GearChanges& changes) {
  require_refinement(query.options);
  RefinedPath result;
  result.path = query.path;
  ReversingRefiner(query, changes, result).run();
  return result;
}

}  // namespace arcway::internal
