#include "core/refine/refine_path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "arcway/angle.h"
#include "core/base/infinity.h"
#include "core/base/shortest_text.h"
#include "core/collision/motion_free.h"
#include "core/model/side_radii.h"
#include "core/motion/speed_profile.h"
#include "core/motion/travel_time_lower_bound.h"
#include "core/refine/circle_chain.h"
#include "core/refine/moves.h"
#include "core/refine/optimize_chain.h"
#include "core/refine/tied_turns.h"
#include "core/refine/timed_chain.h"

namespace arcway::internal {

namespace {

constexpr double kSmallestGain = 1e-6;  // share of the travel time that a change must save
constexpr double kTimeSlack = 1e-9;     // share of a travel time, far above its rounding
// Iterations of a loop between two questions to the clock. They take some nanoseconds to some tenths of a microsecond
// each.
constexpr std::uint32_t kIterationsUnasked = 64;

// A place on a straight line of the path.
struct Station {
  std::size_t line;
  double part;  // of the line's length
  Pose pose;
  Vec2 left;
  double time;   // when the path gets there, approximate between the ends of a line [s]
  double speed;  // upper bound there [m/s]
};

}  // namespace

struct PathRefiner::Memory {
  CircleChain first_chain;
  TimedChain chain;
  std::vector<double> radii;
  std::vector<Station> stations;
  HeadingSet headings;
  SpeedProfile profile;
  ChainOptimizer optimizer;
  CircleChain optimized;
  Path optimized_path;
};

PathRefiner::PathRefiner() : memory_(std::make_unique<Memory>()) {}
PathRefiner::~PathRefiner() = default;
PathRefiner::PathRefiner(PathRefiner&&) noexcept = default;
PathRefiner& PathRefiner::operator=(PathRefiner&&) noexcept = default;

namespace {

class Refiner {
 public:
  Refiner(const RefineQuery& query, PathRefiner::Memory& memory, RefinedPath& result)
      : query_(query),
        vehicle_(query.vehicle),
        sweep_(query.sweep),
        options_(query.options),
        clock_(query.clock),
        result_(result),
        body_(query.vehicle.body(0.5 * query.vehicle.safety_margin())),
        smallest_radii_(query.vehicle),
        smallest_(smallest_radii_.smaller()),
        cost_(result.travel_time + clearance_cost(query.clearance_cost, query.path)),
        chain_(memory.chain),
        radii_(memory.radii),
        stations_(memory.stations),
        headings_(memory.headings),
        optimizer_(memory.optimizer),
        optimized_(memory.optimized),
        optimized_path_(memory.optimized_path),
        most_trials_(query.options.max_trials) {}

  void run(CircleChain& chain) {
    widen_rounded(chain);
    if (!chain_.begin(chain, vehicle_, query_.ends, query_.speed_zones, query_.clearance_cost)) return;
    const double straight = (chain.goal.position() - chain.start.position()).norm();
    least_time_ = travel_time_lower_bound(chain.start, chain.goal, straight, vehicle_, false, query_.ends);
    least_cost_ = std::max(query_.lower_bound, least_time_);
    radii_.clear();
    for (double r = smallest_; radii_.empty() || vehicle_.turn_speed(r) > vehicle_.turn_speed(radii_.back()); r *= 2.0)
      radii_.push_back(r);
    if (query_.outlines != nullptr && ChainOptimizer::serves(vehicle_) && optimize()) return;
    for (int i = 0; i < kMostSettled && !done(); ++i) {
      const double before = cost_;
      settle();
      while (!done() && take_first(Stage::kEscape)) settle();
      if (cost_ > (1.0 - kWorthSettling) * before) break;
    }
    take_all(Stage::kFinish);
  }

 private:
  // Optimizes all turns, once it is roughly known which they are, unless that promises nothing. Returns whether that
  // ends refinement.
  bool optimize() {
    if (query_.at_length) return optimize_at_length();
    most_trials_ = std::min<std::uint64_t>(options_.max_trials, kTrialsBefore);
    do {
      simplify();
    } while (!done() && take_all(Stage::kSlide));
    most_trials_ = options_.max_trials;
    result_.rough_cost = cost_;
    return cost_ > query_.worth_optimizing || take_all(Stage::kOptimize);
  }
  bool optimize_at_length() {
    bool any = false;
    for (int round = 0; round < kMostRounds && !done(); ++round) {
      const double before = cost_;
      most_trials_ = std::min<std::uint64_t>(options_.max_trials, result_.trials + kTrialsBetween);
      simplify();
      most_trials_ = options_.max_trials;
      if (!take_all(Stage::kOptimizeAtLength)) break;
      any = true;
      if (cost_ > (1.0 - kWorthRound) * before) break;
    }
    if (any && may_leave_optimum()) leave_optimum();
    // Where optimizing fails, the turns have mostly been optimized before.
    if (!any) most_trials_ = std::min<std::uint64_t>(options_.max_trials, result_.trials + kTrialsInVain);
    return any;
  }

  // Where turns are slower than lines however wide they are, leaving one out is a jump.
  [[nodiscard]] bool may_leave_optimum() const {
    return vehicle_.turn_speed(kInfinity) < vehicle_.max_speed() || cost_ > kFarFromBound * least_cost_;
  }

  // Tries the moves that change the order of turns, and optimizes again where they help.
  void leave_optimum() {
    const double before = cost_;
    most_trials_ = std::min<std::uint64_t>(options_.max_trials, result_.trials + kTrialsInVain);
    settle();
    while (!done() && take_first(Stage::kEscape)) settle();
    most_trials_ = options_.max_trials;
    if (cost_ < (1.0 - kWorthRound) * before) take_all(Stage::kOptimizeAtLength);
  }

  void simplify() {
    while (!done() && take_first(Stage::kSimplify)) {
    }
  }

  // Leads to a local optimum of the moves.
  void settle() {
    bool more = true;
    while (more && !done()) {
      simplify();
      more = take_all(Stage::kSlide);
      more = take_all(Stage::kImprove) || more;
    }
    take_all(Stage::kSettle);
  }

  // Tries the moves of a stage, one by one until one helps. Returns whether one did.
  bool take_first(Stage stage) {
    for (const MoveRow& row : kMoves)
      if (row.stage == stage && take(row)) return true;
    return false;
  }
  // Tries all moves of a stage. Returns whether one helped.
  bool take_all(Stage stage) {
    bool any = false;
    for (const MoveRow& row : kMoves)
      if (row.stage == stage) any = take(row) || any;
    return any;
  }
  bool take(const MoveRow& row) {
    const auto bit = static_cast<std::uint32_t>(1) << (&row - std::begin(kMoves));
    return (options_.moves & bit) != 0 && std::visit([this](const auto& move) { return take(move); }, row.move);
  }

  [[nodiscard]] bool done() {
    result_.interrupted = result_.interrupted || clock_.is_over();
    return is_over();
  }
  // Whether refinement is over, without a question to the clock. It serves loops whose trials ask the clock.
  [[nodiscard]] bool is_over() const {
    return result_.interrupted || result_.trials >= most_trials_ || cost_ <= (1.0 + kAtBound) * least_cost_;
  }
  // Whether refinement is over, with a question to the clock once in kIterationsUnasked calls. It serves loops that try
  // next to nothing.
  [[nodiscard]] bool done_by_now() { return ++iterations_ % kIterationsUnasked == 0 ? done() : is_over(); }

  [[nodiscard]] const std::vector<TurnCircle>& circles() const { return chain_.chain().circles; }
  [[nodiscard]] const std::vector<Bitangent>& lines() const { return chain_.lines(); }

  // Takes a change if it makes the path cheaper and the path stays free.
  bool accept(const ChainChange& change) {
    if (done() || change.size_after(circles().size()) < 2 || change.lead_in < 0.0 || change.lead_out < 0.0)
      return false;
    for (std::size_t i = 0; i < change.count; ++i)
      if (change.circles[i].radius < smallest_on(change.circles[i].side)) return false;
    ++result_.trials;
    if (!chain_.lay_out(change)) return false;
    const double enough = cost_ * (1.0 - kSmallestGain) * (1.0 + kTimeSlack);
    if (chain_.cost_after(change, enough) > enough || !are_free(chain_.laid_out())) return false;
    if (!chain_.make(change) || !is_made_cheaper()) return false;
    take_made();
    return true;
  }
  // A turn that falls short of a full circle by next to nothing counts as none, see turn_between. Such a path misses a
  // goal closely behind the start, and is faster than any path can be.
  [[nodiscard]] bool is_made_cheaper() const {
    return chain_.made_cost() < cost_ * (1.0 - kSmallestGain) && chain_.made_time() >= least_time_;
  }
  void take_made() {
    result_.path = chain_.made_path();
    cost_ = chain_.made_cost();
    result_.travel_time = chain_.made_time();
    chain_.take();
    ++result_.improvements;
  }

  // Whether the parts that the current path does not have are free, cheapest questions first. Parts are those of a
  // changed chain, or the segments of a path.
  template <class Parts>
  bool are_free(const Parts& parts) {
    const auto all = [&](bool arcs, const auto& is_part_free) {
      return std::ranges::all_of(parts, [&](const auto& part) {
        if (is_arc(part) != arcs) return true;
        const PathSegment segment = segment_of(part);
        return is_known(segment) || is_part_free(segment);
      });
    };
    return all(false, [&](const PathSegment& line) { return straight_free(line.start, line.length); }) &&
           all(true, [&](const PathSegment& arc) { return straight_free(arc.at(0.5 * arc.length), 0.0); }) &&
           all(true, [&](const PathSegment& arc) { return is_free(arc); });
  }
  static bool is_arc(const TimedChain::Part& part) { return part.is_arc; }
  static bool is_arc(const PathSegment& segment) { return !segment.is_line(); }
  static PathSegment segment_of(const TimedChain::Part& part) { return part.segment(); }
  static const PathSegment& segment_of(const PathSegment& segment) { return segment; }

  [[nodiscard]] bool is_known(const PathSegment& s) const {
    return std::any_of(result_.path.begin(), result_.path.end(), [&s](const PathSegment& k) {
      return k.start.x == s.start.x && k.start.y == s.start.y && k.start.heading == s.start.heading &&
             k.length == s.length && k.curvature == s.curvature;
    });
  }

  bool straight_free(const Pose& from, double length) {
    ++result_.straights_checked;
    return sweep_.straight_free({from, length, body_});
  }

  bool is_free(const PathSegment& arc) {
    ++result_.turns_checked;
    return turn_free(sweep_, body_, arc, headings_);
  }

  bool take(const OptimizeTurns& move) {
    if (done() || !propose(move) || !chain_.make(optimized_) || !is_made_cheaper() || !are_free(chain_.made_path()))
      return false;
    take_made();
    return true;
  }

  // Returns whether there is an optimized chain.
  bool propose(const OptimizeTurns& move) {
    const std::uint64_t bounded = std::max(kMostCircleSteps / circles().size(), kLeastSteps);
    const ChainEffort effort = move.effort_for(vehicle_).within(std::min(bounded, most_trials_ - result_.trials));
    const bool are_chains_served = ChainOptimizer::serves_chains(vehicle_);
    const ChainQuery query{vehicle_, *query_.world, *query_.outlines,     effort,
                           clock_,   query_.ends,   query_.clearance_cost};
    const auto [is_optimized, iterations] = are_chains_served
                                                ? optimizer_.optimize(chain_.chain(), lines(), query, optimized_)
                                                : optimizer_.optimize(result_.path, query, optimized_path_);
    result_.trials += static_cast<std::uint64_t>(iterations);
    if (are_chains_served || !is_optimized) return is_optimized;
    if (!chain_of(optimized_path_, chain_.chain().start, chain_.chain().goal, optimized_)) return false;
    widen_rounded(optimized_);
    return true;
  }

  // A radius is known by its curvature alone, and may come out too small by rounding.
  void widen_rounded(CircleChain& chain) const {
    for (TurnCircle& circle : chain.circles) circle.radius = std::max(circle.radius, smallest_on(circle.side));
    chain.place_ends();
  }

  bool take(const DropTurns&) {
    bool any = false;
    for (std::size_t span = circles().size() - 1; span >= 2; --span)
      for (std::size_t i = 0; i + span < circles().size() && !is_over(); ++i)
        any |= accept(replaced(chain_.chain(), i + 1, i + span));
    return any;
  }

  bool take(const RejoinEnds&) {
    bool any = false;
    for (std::size_t keep = 1; keep < circles().size() && !is_over(); ++keep)  // circles from the other end
      for (const bool at_start : {true, false})
        for (const Side side : {Side::kLeft, Side::kRight}) {
          const std::size_t size = circles().size();
          if (keep >= size) break;
          ChainChange change = at_start ? replaced(chain_.chain(), 0, size - keep,
                                                   {chain_.chain().first_circle(0.0, smallest_on(side), side)})
                                        : replaced(chain_.chain(), keep, size,
                                                   {chain_.chain().last_circle(0.0, smallest_on(side), side)});
          (at_start ? change.lead_in : change.lead_out) = 0.0;
          any |= accept(change);
        }
    return any;
  }

  bool take(const MergeTurns& move) {
    if (move.all) return !done_by_now() && merge(0, circles().size(), move);
    bool any = false;
    for (std::size_t span = circles().size(); span >= 2; --span)
      for (std::size_t i = 0; i + span <= circles().size() && !done_by_now(); ++i) any |= merge(i, i + span, move);
    return any;
  }

  // Replaces the circles [first, last) by one circle, tangent to the lines before and behind them.
  bool merge(std::size_t first, std::size_t last, const MergeTurns& move) {
    const Bitangent before = lines()[first];
    const Bitangent behind = lines()[last];
    const double turn = wrap_signed(behind.start.heading - before.start.heading);
    if (std::abs(turn) < move.least_turn || std::abs(turn) > move.most_turn) return false;
    const Vec2 d = direction_of(before.start.heading);
    const Vec2 e = direction_of(behind.start.heading);
    const Vec2 between = behind.start.position() - before.start.position();
    const double ahead = cross(between, e) / cross(d, e);                 // of the lines' crossing, along `before`
    const double back = behind.length - cross(between, d) / cross(d, e);  // of the far end of `behind` from it
    const double room = std::min(ahead, back);
    const double slope = std::tan(0.5 * std::abs(turn));
    const Side side = turn > 0.0 ? Side::kLeft : Side::kRight;
    for (const double factor : move.radii) {
      const double radius = factor * smallest_on(side);
      if (radius * slope > room) break;
      const Vec2 touch = before.start.position() + (ahead - radius * slope) * d;
      ChainChange change = replaced(chain_.chain(), first, last,
                                    {turn_circle({touch.x(), touch.y(), before.start.heading}, radius, side)});
      if (first == 0) change.lead_in = ahead - radius * slope;
      if (last == circles().size()) change.lead_out = back - radius * slope;
      // A chain has two circles at least: the vehicle does not turn on the goal's one.
      if (move.all) {
        change.circles[change.count++] = chain_.chain().last_circle(0.0, smallest_on(side), side);
        change.lead_out = 0.0;
      }
      if (accept(change)) return true;
    }
    return false;
  }

  // Words lead from places on one line to places on another.
  bool take(const InsertWords& move) {
    find_stations(move);
    for (std::size_t span = stations_.size() - 1; span > 0 && !is_over(); --span)
      for (std::size_t i = 0; i + span < stations_.size() && !done_by_now(); ++i)
        if (stations_[i].line < stations_[i + span].line && insert_word(stations_[i], stations_[i + span])) return true;
    return false;
  }

  void find_stations(const InsertWords& move) {
    stations_.clear();
    for (std::size_t i = 0; i < lines().size(); ++i) {
      const double length = lines()[i].length;
      const auto first = stations_.size();
      stations_.push_back(station(i, 0.0));
      if (length > smallest_)
        for (int k = 1; k < move.parts; ++k) stations_.push_back(station(i, k / static_cast<double>(move.parts)));
      for (const double radii : move.near_ends) {
        const double part = radii * smallest_ / length;
        if (!(part < move.near)) break;
        stations_.push_back(station(i, part));
        stations_.push_back(station(i, 1.0 - part));
      }
      if (length > 0.0) stations_.push_back(station(i, 1.0));
      std::sort(stations_.begin() + static_cast<std::ptrdiff_t>(first), stations_.end(),
                [](const Station& a, const Station& b) { return a.part < b.part; });
    }
  }

  [[nodiscard]] Station station(std::size_t line, double part) const {
    const double twice = 2.0 * vehicle_.max_acceleration();
    const Bitangent& l = lines()[line];
    const auto begin = chain_.begin_of(line), end = chain_.end_of(line);
    const Vec2 ahead = direction_of(l.start.heading);
    const Vec2 p = l.start.position() + part * l.length * ahead;
    const double speed = std::min({vehicle_.max_speed(), std::sqrt(begin.speed * begin.speed + twice * part * l.length),
                                   std::sqrt(end.speed * end.speed + twice * (1.0 - part) * l.length)});
    return {
        line, part, {p.x(), p.y(), l.start.heading}, perpendicular(ahead), begin.time + part * (end.time - begin.time),
        speed};
  }

  // Least time for a length between two speeds.
  [[nodiscard]] double time_between(double length, double v1, double v3) const {
    const double a = vehicle_.max_acceleration();
    if (std::abs(v1 * v1 - v3 * v3) >= 2.0 * a * length) return v1 + v3 > 0.0 ? 2.0 * length / (v1 + v3) : 0.0;
    return segment_time(length, v1, vehicle_.max_speed(), v3, a);
  }

  [[nodiscard]] double smallest_on(Side side) const { return smallest_radii_.of(side); }

  // Length and time of two turns.
  [[nodiscard]] std::pair<double, double> turns_of(double r0, double turn0, double r1, double turn1) const {
    if (r0 == r1) {
      const double length = (turn0 + turn1) * r0;
      return {length, length / vehicle_.turn_speed(r0)};
    }
    return {turn0 * r0 + turn1 * r1, turn0 * r0 / vehicle_.turn_speed(r0) + turn1 * r1 / vehicle_.turn_speed(r1)};
  }

  bool insert_word(const Station& from, const Station& to) {
    const double saved = chain_.end_of(to.line).clearance_cost - chain_.begin_of(from.line).clearance_cost;  // at most
    const double budget = to.time - from.time + saved;
    // Most pairs are told from the distance alone.
    const double distance = (to.pose.position() - from.pose.position()).norm();
    const double least = std::max(distance / vehicle_.max_speed(), time_between(distance, from.speed, to.speed));
    if (least > budget * (1.0 + kTimeSlack)) return false;
    const double longest = budget * (1.0 + kTimeSlack) * vehicle_.max_speed();  // line of a word
    for (const double radius : radii_)
      for (const Side departure : {Side::kLeft, Side::kRight})
        for (const Side arrival : {Side::kLeft, Side::kRight}) {
          const double r0 = std::max(radius, smallest_on(departure)), r1 = std::max(radius, smallest_on(arrival));
          const TurnCircle first{from.pose.position() + sign_of(departure) * r0 * from.left, r0, departure, kNone};
          const TurnCircle second{to.pose.position() + sign_of(arrival) * r1 * to.left, r1, arrival, kNone};
          const double offset = departure == arrival ? 0.0 : r0 + r1;
          const double square = (second.center - first.center).squaredNorm() - offset * offset;
          if (square > longest * longest) continue;
          const auto line = directed_bitangent(first, second);
          if (!line) continue;
          const double turn0 = turn_between(from.pose.heading, line->start.heading, departure);
          const double turn1 = turn_between(line->start.heading, to.pose.heading, arrival);
          const auto [turns, time] = turns_of(r0, turn0, r1, turn1);
          const double fastest = line->length / vehicle_.max_speed() + time;
          const double straight = time_between(line->length + turns, from.speed, to.speed);
          if (std::max(fastest, straight) >= budget) continue;
          ChainChange change = replaced(chain_.chain(), from.line, to.line, {first, second});
          if (from.line == 0) change.lead_in *= from.part;
          if (to.line + 1 == lines().size()) change.lead_out *= 1.0 - to.part;
          if (accept(change)) return true;
        }
    return false;
  }

  // Makes parts of turns wider, where wider turns are faster.
  bool take(const WidenTurns& move) {
    if (radii_.size() < 2) return false;
    bool any = false;
    for (std::size_t i = 0; i < circles().size() && !is_over(); ++i)
      for (const bool leaving : {true, false}) any |= widen(i, leaving, move);
    any |= pinch(0, move);
    any |= pinch(circles().size() - 1, move);
    return any;
  }

  bool widen(std::size_t i, bool leaving, const WidenTurns& move) {
    const std::size_t other = leaving ? i + 1 : i - 1;
    if (other >= circles().size() || chain_.turn_on(i) < move.least_turn) return false;
    if (are_tied(chain_.chain(), lines(), std::min(i, other))) return step(i, leaving, move);
    for (const double share : move.shares)
      for (const double factor : move.factors)
        if (accept(widened(chain_.chain(), lines(), {i, leaving, share}, factor))) return true;
    return false;
  }

  // Puts a turn of a radius between those of a tight turn and of a wider one beside it.
  bool step(std::size_t i, bool leaving, const WidenTurns& move) {
    const std::size_t wide = leaving ? i + 1 : i - 1;
    const double ratio = circles()[wide].radius / circles()[i].radius;
    if (wide == 0 || wide + 1 == circles().size() || ratio < move.least_ratio) return false;
    if (are_tied(chain_.chain(), lines(), leaving ? wide : wide - 1)) return false;
    for (const double share : move.step_shares)
      if (accept(stepped(chain_.chain(), lines(), {i, leaving, share}, std::sqrt(ratio) * circles()[i].radius)))
        return true;
    return false;
  }

  // Makes the turn at an end of the path tight: the vehicle is slow there, so that this costs little.
  bool pinch(std::size_t i, const WidenTurns& move) {
    const double radius = circles()[i].radius, smallest = smallest_on(circles()[i].side);
    if (radius <= smallest) return false;
    for (const double turn : move.end_turns)
      for (const double factor : move.end_factors)
        if (accept(pinched(chain_.chain(), i, smallest, turn, std::max(factor * radius, move.least_beside * smallest))))
          return true;
    return false;
  }

  bool take(const SlideCircles& move) {
    const double last_step = move.last_step > 0.0 ? move.last_step : options_.smallest_step;
    bool any = false;
    for (double step = move.first_step; step >= last_step && !done(); step *= 0.5) {
      bool moved = true;
      for (int iteration = 0; moved && iteration < move.most_iterations && !done(); ++iteration) {
        moved = false;
        for (std::size_t i = 0; i < circles().size() && !is_over(); ++i) moved |= slide_circle(i, step, move);
        any |= moved;
      }
    }
    return any;
  }

  bool slide_circle(std::size_t i, double step, const SlideCircles& move) {
    if (i == 0 || i + 1 == circles().size()) return slide_end(i, step, move);
    return is_tied(chain_.chain(), lines(), i) ? slide_tied(i, step, move) : slide_middle(i, step, move.steps);
  }

  bool slide_tied(std::size_t i, double step, const SlideCircles& move) {
    bool any = false;
    for (const double turn : {0.0, move.tied_turn * step, -move.tied_turn * step})
      for (const double growth : move.growths) {
        const double grow = growth * step;
        if ((turn == 0.0 && grow == 0.0) || !is_tied(chain_.chain(), lines(), i)) continue;
        any |= accept(retied(chain_.chain(), lines(), i, turn, circles()[i].radius * (1.0 + grow)));
      }
    return any;
  }

  bool slide_end(std::size_t i, double step, const SlideCircles& move) {
    bool any = false;
    for (const double lead : {0.0, step * smallest_, -step * smallest_})
      for (const double growth : move.growths) {
        const CircleChain& chain = chain_.chain();
        const TurnCircle& old = circles()[i];
        const double length = i == 0 ? chain.lead_in : chain.lead_out;
        const double longer = std::max(0.0, length + lead);
        const double larger = std::max(smallest_on(old.side), old.radius * (1.0 + growth * step));
        if (longer == length && larger == old.radius) continue;
        ChainChange change = shifted(
            chain, lines(), i,
            i == 0 ? chain.first_circle(longer, larger, old.side) : chain.last_circle(longer, larger, old.side));
        (i == 0 ? change.lead_in : change.lead_out) = longer;
        any |= accept(change);
      }
    return any;
  }

  bool slide_middle(std::size_t i, double step, std::span<const CircleStep> steps) {
    bool any = false;
    for (const CircleStep& move : steps) {
      TurnCircle c = circles()[i];
      const Vec2 ahead = direction_of(lines()[i].start.heading + sign_of(c.side) * move.at * chain_.turn_on(i));
      const Vec2 inwards = sign_of(c.side) * perpendicular(ahead);
      const double length = step * smallest_;
      const double larger = std::max(smallest_on(c.side), c.radius * (1.0 + step * move.grow));
      const double inner = swept_annulus(body_, c.side, c.radius).inner;
      const double angle = sign_of(c.side) * move.around * length / std::max(inner, 0.5 * smallest_);
      const Vec2 pivot = c.center - inner * inwards;
      const Vec2 turned = std::cos(angle) * inwards + std::sin(angle) * perpendicular(inwards);
      c.center = pivot + (swept_annulus(body_, c.side, larger).inner + move.inwards * length) * turned +
                 move.along * length * ahead;
      c.radius = larger;
      any |= accept(shifted(chain_.chain(), lines(), i, c));
    }
    return any;
  }

  const RefineQuery& query_;
  const Vehicle& vehicle_;
  const SweepQuery& sweep_;
  const RefineOptions& options_;
  const StopClock& clock_;
  RefinedPath& result_;
  Body body_;
  SideRadii smallest_radii_;
  double smallest_;          // the smaller one of these [m]
  double cost_;              // of the path: its travel time, plus that of driving close to obstacles [s]
  double least_time_ = 0.0;  // lower bound of the time of all paths [s]
  double least_cost_ = 0.0;  // lower bound of their cost [s]
  std::uint32_t iterations_ = 0;
  TimedChain& chain_;
  std::vector<double>& radii_;
  std::vector<Station>& stations_;
  HeadingSet& headings_;
  ChainOptimizer& optimizer_;
  CircleChain& optimized_;
  Path& optimized_path_;
  std::uint64_t most_trials_;
};

}  // namespace

void require_refinement(const RefineOptions& options) {
  if (!(options.smallest_step > 0.0 && std::isfinite(options.smallest_step)))
    throw std::invalid_argument("refinement: smallest step is " + shortest_text(options.smallest_step) +
                                " of the turning radius, must be positive and finite");
}

void PathRefiner::refine(const RefineQuery& query, RefinedPath& result) {
  require_refinement(query.options);
  result.path = query.path;
  result.trials = result.improvements = result.straights_checked = result.turns_checked = 0;
  result.interrupted = false;
  result.rough_cost = 0.0;
  result.travel_time = travel_time(query.path, query.vehicle, query.ends, memory_->profile, query.speed_zones);
  if (chain_of(query.path, query.start, query.goal, memory_->first_chain))
    Refiner(query, *memory_, result).run(memory_->first_chain);
}

RefinedPath refine_path(const RefineQuery& query) {
  RefinedPath result;
  PathRefiner().refine(query, result);
  return result;
}

bool optimizes_turns(const Vehicle& vehicle, const RefineOptions& options) {
  return (options.moves & move_bit("optimize turns")) != 0 && ChainOptimizer::serves(vehicle);
}

}  // namespace arcway::internal
