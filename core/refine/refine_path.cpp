#include "core/refine/refine_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/geometry/angle.h"
#include "core/path/speed_profile.h"
#include "core/refine/circle_chain.h"

namespace arcway {

namespace {

// Less than this part of the travel time is not worth a step.
constexpr double kSmallestGain = 1e-6;
constexpr double kFirstStep = 1.0;    // of the smallest turning radius
constexpr double kRoughStep = 0.125;  // fine enough to try other turns
constexpr int kFewParts = 2;
constexpr std::array kFinerParts{3, 4, 5};

class Refiner {
 public:
  Refiner(const Vehicle& vehicle, const SweepQuery& sweep, const RefineOptions& options,
          const std::function<bool()>& stop, RefinedPath& result)
      : vehicle_(vehicle),
        sweep_(sweep),
        options_(options),
        stop_(stop),
        result_(result),
        body_(vehicle.footprint(0.5 * vehicle.safety_margin())),
        smallest_(vehicle.min_turning_radius()) {}

  void run(CircleChain chain) {
    // A radius is known by its curvature alone, and may come out too small by rounding.
    for (TurnCircle& circle : chain.circles) circle.radius = std::max(circle.radius, smallest_);
    chain.place_ends();
    auto lines = lines_of(chain);
    if (!lines) return;
    chain_ = std::move(chain);
    lines_ = std::move(*lines);
    for (double r = smallest_; radii_.empty() || vehicle_.turn_speed(r) > vehicle_.turn_speed(radii_.back()); r *= 2.0)
      radii_.push_back(r);
    settle();
    // Words between other places may lead out of a local optimum.
    for (std::size_t i = 0; i < kFinerParts.size() && !done();) {
      if (insert_words(kFinerParts[i])) {
        settle();
        i = 0;
      } else {
        ++i;
      }
    }
  }

 private:
  // A local optimum.
  void settle() {
    bool more = true;
    while (more && !done()) {
      while (!done() && (drop_turns() || rejoin_ends() || merge_turns())) {
      }
      more = slide(kRoughStep);
      more = insert_words(kFewParts) || more;
    }
    slide(options_.smallest_step);
  }

  // A place on a straight line of the path.
  struct Station {
    std::size_t line;
    double part;  // of the line's length
    Pose pose;
    double time;   // when the path gets there; between the ends of a line roughly [s]
    double speed;  // there [m/s]
  };

  [[nodiscard]] bool done() {
    if (stop_ && !result_.interrupted) result_.interrupted = stop_();
    return result_.interrupted || result_.trials >= options_.max_trials;
  }

  // Takes a chain if it is faster and free.
  bool accept(CircleChain&& trial) {
    if (done() || trial.circles.size() < 2 || trial.lead_in < 0.0 || trial.lead_out < 0.0) return false;
    for (const TurnCircle& circle : trial.circles)
      if (circle.radius < smallest_) return false;
    ++result_.trials;
    std::optional<std::vector<Bitangent>> lines = lines_of(trial);
    if (!lines) return false;
    Path path = path_of(trial, *lines);
    const double time = speed_profile(path, vehicle_).total_time;
    if (!(time < result_.travel_time * (1.0 - kSmallestGain)) || !is_free(path)) return false;
    chain_ = std::move(trial);
    lines_ = std::move(*lines);
    result_.path = std::move(path);
    result_.travel_time = time;
    ++result_.improvements;
    return true;
  }

  // Whether the parts that the current path does not have are free, cheapest questions first.
  bool is_free(const Path& path) {
    for (const PathSegment& s : path)
      if (s.is_line() && !is_known(s) && !straight_free(s.start, s.length)) return false;
    for (const PathSegment& s : path)
      if (!s.is_line() && !is_known(s) && !straight_free(s.at(0.5 * s.length), 0.0)) return false;
    for (const PathSegment& s : path)
      if (!s.is_line() && !is_known(s) && !turn_free(s)) return false;
    return true;
  }

  [[nodiscard]] bool is_known(const PathSegment& s) const {
    return std::any_of(result_.path.begin(), result_.path.end(), [&s](const PathSegment& k) {
      return k.start.x == s.start.x && k.start.y == s.start.y && k.start.heading == s.start.heading &&
             k.length == s.length && k.curvature == s.curvature;
    });
  }

  bool straight_free(const Pose& from, double length) {
    ++result_.straights_checked;
    return sweep_.straight_free(swept_rectangle(from, length, body_));
  }

  bool turn_free(const PathSegment& arc) {
    const Side side = arc.curvature > 0.0 ? Side::kLeft : Side::kRight;
    const TurnCircle circle = turn_circle(arc.start, 1.0 / std::abs(arc.curvature), side);
    ++result_.turns_checked;
    const HeadingSet free = sweep_.free_headings(TurningBody{circle.center, circle.radius, side, body_});
    return free.reach(arc.start.heading, side) >= arc.length * std::abs(arc.curvature);
  }

  bool drop_turns() {
    bool any = false;
    for (std::size_t span = chain_.circles.size() - 1; span >= 2; --span)
      for (std::size_t i = 0; i + span < chain_.circles.size(); ++i) any |= accept(replaced(i + 1, i + span, {}));
    return any;
  }

  bool rejoin_ends() {
    bool any = false;
    for (std::size_t keep = 1; keep < chain_.circles.size(); ++keep)  // circles from the other end
      for (const bool at_start : {true, false})
        for (const Side side : {Side::kLeft, Side::kRight}) {
          if (keep >= chain_.circles.size()) break;
          CircleChain trial = chain_;
          auto& circles = trial.circles;
          const auto kept = static_cast<std::ptrdiff_t>(keep);
          const TurnCircle turn{{0.0, 0.0}, smallest_, side, kNone};
          if (at_start) {
            circles.erase(circles.begin(), circles.end() - kept);
            circles.insert(circles.begin(), turn);
            trial.lead_in = 0.0;
          } else {
            circles.erase(circles.begin() + kept, circles.end());
            circles.push_back(turn);
            trial.lead_out = 0.0;
          }
          trial.place_ends();
          any |= accept(std::move(trial));
        }
    return any;
  }

  // The chain with the circles [first, last) replaced by others.
  [[nodiscard]] CircleChain replaced(std::size_t first, std::size_t last, std::initializer_list<TurnCircle> by) const {
    CircleChain trial = chain_;
    auto& circles = trial.circles;
    const auto at = circles.erase(circles.begin() + static_cast<std::ptrdiff_t>(first),
                                  circles.begin() + static_cast<std::ptrdiff_t>(last));
    circles.insert(at, by);
    return trial;
  }

  bool merge_turns() {
    bool any = false;
    for (std::size_t span = chain_.circles.size(); span >= 2; --span)
      for (std::size_t i = 0; i + span <= chain_.circles.size(); ++i) any |= merge(i, i + span);
    return any;
  }

  // One circle tangent to the lines before and behind the circles [first, last).
  bool merge(std::size_t first, std::size_t last) {
    const Bitangent& before = lines_[first];
    const Bitangent& behind = lines_[last];
    const double turn = wrap_signed(behind.start.heading - before.start.heading);
    if (std::abs(turn) < 1e-3 || std::abs(turn) > 3.0) return false;
    const Vec2 d = direction_of(before.start.heading);
    const Vec2 e = direction_of(behind.start.heading);
    const Vec2 between = behind.start.position() - before.start.position();
    const double ahead = cross(between, e) / cross(d, e);                 // of the lines' crossing, along `before`
    const double back = behind.length - cross(between, d) / cross(d, e);  // of the far end of `behind` from it
    const double room = std::min(ahead, back);
    const double slope = std::tan(0.5 * std::abs(turn));
    const Side side = turn > 0.0 ? Side::kLeft : Side::kRight;
    for (const double factor : {1.0, 1.5, 2.25, 3.5, 5.0, 8.0, 12.0, 18.0}) {
      const double radius = factor * smallest_;
      if (radius * slope > room) break;
      const Vec2 touch = before.start.position() + (ahead - radius * slope) * d;
      CircleChain trial =
          replaced(first, last, {turn_circle({touch.x(), touch.y(), before.start.heading}, radius, side)});
      if (first == 0) trial.lead_in = ahead - radius * slope;
      if (last == chain_.circles.size()) trial.lead_out = back - radius * slope;
      if (accept(std::move(trial))) return true;
    }
    return false;
  }

  struct Passing {
    double time;
    double speed;
  };
  // When, and how fast, the path gets to both ends of each line.
  [[nodiscard]] std::vector<std::array<Passing, 2>> passings() const {
    const SpeedProfile profile = speed_profile(path_of(chain_, lines_), vehicle_);
    std::vector<std::array<Passing, 2>> result;
    Passing at{0.0, 0.0};
    std::size_t segment = 0;
    const auto drive = [&] {
      at.time += profile.durations[segment++];
      at.speed = profile.speeds[segment];
    };
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (i > 0 && turn_on(i - 1) > 0.0) drive();
      const Passing begin = at;
      if (lines_[i].length > 0.0) drive();
      result.push_back({begin, at});
    }
    return result;
  }

  [[nodiscard]] double turn_on(std::size_t circle) const {
    return turn_between(lines_[circle].start.heading, lines_[circle + 1].start.heading, chain_.circles[circle].side);
  }

  // Words between places that divide each line into equal parts.
  bool insert_words(int parts) {
    const auto ends = passings();
    const double twice = 2.0 * vehicle_.max_acceleration();
    const auto station = [&](std::size_t line, double part) {
      const Bitangent& l = lines_[line];
      const auto& [begin, end] = ends[line];
      const Vec2 p = l.start.position() + part * l.length * direction_of(l.start.heading);
      const double speed =
          std::min({vehicle_.max_speed(), std::sqrt(begin.speed * begin.speed + twice * part * l.length),
                    std::sqrt(end.speed * end.speed + twice * (1.0 - part) * l.length)});
      return Station{line, part, {p.x(), p.y(), l.start.heading}, begin.time + part * (end.time - begin.time), speed};
    };
    std::vector<Station> stations;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      stations.push_back(station(i, 0.0));
      if (lines_[i].length > smallest_)
        for (int k = 1; k < parts; ++k) stations.push_back(station(i, k / static_cast<double>(parts)));
      if (lines_[i].length > 0.0) stations.push_back(station(i, 1.0));
    }
    for (std::size_t span = stations.size() - 1; span > 0; --span)
      for (std::size_t i = 0; i + span < stations.size(); ++i)
        if (stations[i].line < stations[i + span].line && insert_word(stations[i], stations[i + span])) return true;
    return false;
  }

  // Least time for a length between two speeds.
  [[nodiscard]] double time_between(double length, double v1, double v3) const {
    const double a = vehicle_.max_acceleration();
    if (std::abs(v1 * v1 - v3 * v3) >= 2.0 * a * length) return v1 + v3 > 0.0 ? 2.0 * length / (v1 + v3) : 0.0;
    return segment_time(length, v1, vehicle_.max_speed(), v3, a);
  }

  bool insert_word(const Station& from, const Station& to) {
    for (const double radius : radii_)
      for (const Side departure : {Side::kLeft, Side::kRight})
        for (const Side arrival : {Side::kLeft, Side::kRight}) {
          const TurnCircle first = turn_circle(from.pose, radius, departure);
          const TurnCircle second = turn_circle(to.pose, radius, arrival);
          const auto line = directed_bitangent(first, second);
          if (!line) continue;
          const double turn = turn_between(from.pose.heading, line->start.heading, departure) +
                              turn_between(line->start.heading, to.pose.heading, arrival);
          const double fastest = line->length / vehicle_.max_speed() + turn * radius / vehicle_.turn_speed(radius);
          const double straight = time_between(line->length + turn * radius, from.speed, to.speed);
          if (std::max(fastest, straight) >= to.time - from.time) continue;
          CircleChain trial = replaced(from.line, to.line, {first, second});
          if (from.line == 0) trial.lead_in = from.part * chain_.lead_in;
          if (to.line + 1 == lines_.size()) trial.lead_out = (1.0 - to.part) * chain_.lead_out;
          if (accept(std::move(trial))) return true;
        }
    return false;
  }

  bool slide(double last_step) {
    bool any = false;
    for (double step = kFirstStep; step >= last_step && !done(); step *= 0.5) {
      bool moved = true;
      for (int round = 0; moved && round < 8 && !done(); ++round) {
        moved = false;
        for (std::size_t i = 0; i < chain_.circles.size(); ++i)
          moved |= (i == 0 || i + 1 == chain_.circles.size()) ? slide_end(i, step) : slide_middle(i, step);
        any |= moved;
      }
    }
    return any;
  }

  bool slide_end(std::size_t i, double step) {
    bool any = false;
    for (const double lead : {0.0, step * smallest_, -step * smallest_})
      for (const double grow : {0.0, step, -0.5 * step}) {
        CircleChain trial = chain_;
        double& length = i == 0 ? trial.lead_in : trial.lead_out;
        double& radius = trial.circles[i].radius;
        const double longer = std::max(0.0, length + lead);
        const double larger = std::max(smallest_, radius * (1.0 + grow));
        if (longer == length && larger == radius) continue;
        length = longer;
        radius = larger;
        trial.place_ends();
        any |= accept(std::move(trial));
      }
    return any;
  }

  bool slide_middle(std::size_t i, double step) {
    struct Move {
      double inwards, around, grow;
    };
    static constexpr std::array<Move, 13> kMoves = {{{1, 0, 0},
                                                     {0, 1, 0},
                                                     {0, -1, 0},
                                                     {1, 1, 0},
                                                     {1, -1, 0},
                                                     {0, 0, 1},
                                                     {0, 0, -0.5},
                                                     {-1, 0, 0},
                                                     {0, 1, 1},
                                                     {0, -1, 1},
                                                     {1, 0, 1},
                                                     {-1, 0, 1},
                                                     {-1, 0, -0.5}}};
    bool any = false;
    for (const Move& move : kMoves) {
      CircleChain trial = chain_;
      TurnCircle& c = trial.circles[i];
      const double middle = lines_[i].start.heading + sign_of(c.side) * 0.5 * turn_on(i);
      const Vec2 ahead = direction_of(middle);
      const Vec2 inwards = sign_of(c.side) * perpendicular(ahead);
      const double length = step * smallest_;
      const double larger = std::max(smallest_, c.radius * (1.0 + step * move.grow));
      const double inner = swept_annulus(body_, c.radius).inner;
      const double angle = sign_of(c.side) * move.around * length / std::max(inner, 0.5 * smallest_);
      const Vec2 pivot = c.center - inner * inwards;
      const Vec2 turned = std::cos(angle) * inwards + std::sin(angle) * perpendicular(inwards);
      c.center = pivot + (swept_annulus(body_, larger).inner + move.inwards * length) * turned;
      c.radius = larger;
      any |= accept(std::move(trial));
    }
    return any;
  }

  const Vehicle& vehicle_;
  const SweepQuery& sweep_;
  const RefineOptions& options_;
  const std::function<bool()>& stop_;
  RefinedPath& result_;
  Footprint body_;
  double smallest_;
  std::vector<double> radii_;
  CircleChain chain_;
  std::vector<Bitangent> lines_;
};

}  // namespace

RefinedPath refine_path(const Path& path, const Pose& start, const Pose& goal, const Vehicle& vehicle,
                        const SweepQuery& sweep, const RefineOptions& options, const std::function<bool()>& stop) {
  RefinedPath result;
  result.path = path;
  result.travel_time = speed_profile(path, vehicle).total_time;
  if (auto chain = chain_of(path, start, goal)) Refiner(vehicle, sweep, options, stop, result).run(std::move(*chain));
  return result;
}

}  // namespace arcway
