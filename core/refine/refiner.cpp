#include "core/refine/refiner.h"

#include <algorithm>
#include <iterator>
#include <variant>

#include "core/base/infinity.h"
#include "core/motion/travel_time_lower_bound.h"

namespace arcway::internal {

namespace {

constexpr double kSmallestGain = 1e-6;  // share of the travel time that a change must save
// Iterations of a loop between two questions to the clock. They take some nanoseconds to some tenths of a microsecond
// each.
constexpr std::uint32_t kIterationsUnasked = 64;

// Parts of a changed chain and the segments of a path, asked alike.
bool is_arc(const TimedChain::Part& part) { return part.is_arc; }
bool is_arc(const PathSegment& segment) { return !segment.is_line(); }
PathSegment segment_of(const TimedChain::Part& part) { return part.segment(); }
const PathSegment& segment_of(const PathSegment& segment) { return segment; }

}  // namespace

Refiner::Refiner(const RefineQuery& query, PathRefiner::Memory& memory, RefinedPath& result)
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

void Refiner::run(CircleChain& chain) {
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

bool Refiner::optimize() {
  if (query_.at_length) return optimize_at_length();
  most_trials_ = std::min<std::uint64_t>(options_.max_trials, kTrialsBefore);
  do {
    simplify();
  } while (!done() && take_all(Stage::kSlide));
  most_trials_ = options_.max_trials;
  return take_all(Stage::kOptimize);
}

bool Refiner::optimize_at_length() {
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

bool Refiner::may_leave_optimum() const {
  return vehicle_.turn_speed(kInfinity) < vehicle_.max_speed() || cost_ > kFarFromBound * least_cost_;
}

void Refiner::leave_optimum() {
  const double before = cost_;
  most_trials_ = std::min<std::uint64_t>(options_.max_trials, result_.trials + kTrialsInVain);
  settle();
  while (!done() && take_first(Stage::kEscape)) settle();
  most_trials_ = options_.max_trials;
  if (cost_ < (1.0 - kWorthRound) * before) take_all(Stage::kOptimizeAtLength);
}

void Refiner::simplify() {
  while (!done() && take_first(Stage::kSimplify)) {
  }
}

void Refiner::settle() {
  bool more = true;
  while (more && !done()) {
    simplify();
    more = take_all(Stage::kSlide);
    more = take_all(Stage::kImprove) || more;
  }
  take_all(Stage::kSettle);
}

bool Refiner::take_first(Stage stage) {
  for (const MoveRow& row : kMoves)
    if (row.stage == stage && take(row)) return true;
  return false;
}

bool Refiner::take_all(Stage stage) {
  bool any = false;
  for (const MoveRow& row : kMoves)
    if (row.stage == stage) any = take(row) || any;
  return any;
}

bool Refiner::take(const MoveRow& row) {
  const auto bit = static_cast<std::uint32_t>(1) << (&row - std::begin(kMoves));
  return (options_.moves & bit) != 0 && std::visit([this](const auto& move) { return take(move); }, row.move);
}

bool Refiner::done() {
  result_.interrupted = result_.interrupted || clock_.is_over();
  return is_over();
}

bool Refiner::is_over() const {
  return result_.interrupted || result_.trials >= most_trials_ || cost_ <= (1.0 + kAtBound) * least_cost_;
}

bool Refiner::done_by_now() { return ++iterations_ % kIterationsUnasked == 0 ? done() : is_over(); }

template <class Parts>
bool Refiner::are_free(const Parts& parts) {
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

bool Refiner::accept(const ChainChange& change) {
  if (done() || change.size_after(circles().size()) < 2 || change.lead_in < 0.0 || change.lead_out < 0.0) return false;
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

bool Refiner::is_made_cheaper() const {
  return chain_.made_cost() < cost_ * (1.0 - kSmallestGain) && chain_.made_time() >= least_time_;
}

void Refiner::take_made() {
  result_.path = chain_.made_path();
  cost_ = chain_.made_cost();
  result_.travel_time = chain_.made_time();
  chain_.take();
  ++result_.improvements;
}

bool Refiner::is_known(const PathSegment& s) const {
  return std::any_of(result_.path.begin(), result_.path.end(), [&s](const PathSegment& k) {
    return k.start.x == s.start.x && k.start.y == s.start.y && k.start.heading == s.start.heading &&
           k.length == s.length && k.curvature == s.curvature;
  });
}

bool Refiner::straight_free(const Pose& from, double length) {
  ++result_.straights_checked;
  return sweep_.straight_free({from, length, body_});
}

bool Refiner::is_free(const PathSegment& arc) {
  ++result_.turns_checked;
  return turn_free(sweep_, body_, arc, headings_);
}

bool Refiner::take(const OptimizeTurns& move) {
  if (done() || !propose(move) || !chain_.make(optimized_) || !is_made_cheaper() || !are_free(chain_.made_path()))
    return false;
  take_made();
  return true;
}

bool Refiner::propose(const OptimizeTurns& move) {
  const std::uint64_t bounded = std::max(kMostCircleSteps / circles().size(), kLeastSteps);
  const ChainEffort effort = move.effort_for(vehicle_).within(std::min(bounded, most_trials_ - result_.trials));
  const bool are_chains_served = ChainOptimizer::serves_chains(vehicle_);
  const ChainQuery query{vehicle_, *query_.world, *query_.outlines, effort, clock_, query_.ends, query_.clearance_cost};
  const auto [is_optimized, iterations] = are_chains_served
                                              ? optimizer_.optimize(chain_.chain(), lines(), query, optimized_)
                                              : optimizer_.optimize(result_.path, query, optimized_path_);
  result_.trials += static_cast<std::uint64_t>(iterations);
  if (are_chains_served || !is_optimized) return is_optimized;
  if (!chain_of(optimized_path_, chain_.chain().start, chain_.chain().goal, optimized_)) return false;
  widen_rounded(optimized_);
  return true;
}

void Refiner::widen_rounded(CircleChain& chain) const {
  for (TurnCircle& circle : chain.circles) circle.radius = std::max(circle.radius, smallest_on(circle.side));
  chain.place_ends();
}

}  // namespace arcway::internal
