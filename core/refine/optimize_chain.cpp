#include "core/refine/optimize_chain.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/infinity.h"
#include "core/refine/chain_system.h"

namespace arcway::internal {

namespace {

// Contacts, in lengths of the body.
constexpr double kGrowth = 7e-4;      // growth of the body, so that the result is free
constexpr double kReach = 4.0;        // distance of the path within which contacts are looked for, once
constexpr double kNearContact = 0.7;  // distance within which a contact is a constraint
constexpr double kUnseen = 0.1;       // movement after which a contact that nothing can touch is looked at again
constexpr double kLeastSlack = 1e-3;  // least slack of a constraint at first
constexpr double kOverlap = 3e-4;     // largest overlap of an optimal chain
// Length that a part may drive close to obstacles and still counts as one that keeps the preferred distance.
constexpr double kGrazing = 0.25;
// The barrier falls after steps of nearly full length and of half their length, and rises after very short ones.
constexpr double kFullStep = 0.9, kHalfStep = 0.5, kShortStep = 0.05;
constexpr double kFall = 0.3, kSlowFall = 0.6, kRise = 4.0;
constexpr int kFirstSteps = 3;            // number of steps before the barrier changes
constexpr double kLastBarrier = 1e-6;     // weight of the barrier in the end, as a share of the travel time
constexpr double kLeastGain = 1e-5;       // change of the travel time, as a share, below which a chain is optimal
constexpr double kMostToBoundary = 0.95;  // largest share of a slack that a step may use up
constexpr double kLeastLeft = 0.1;        // share of a length, turn, radius or speed that a step must leave
// A step that is refused is tried again, shorter. If that does not help, a new step is computed with more damping.
constexpr double kShorter = 0.4, kMoreDamping = 10.0;
constexpr int kMostShorter = 2;       // tries of one step
constexpr double kSufficient = 1e-4;  // share of the predicted gain that a step must bring
constexpr double kPenalty = 1.5;      // weight of a residual in the merit function, in multipliers
// Damping is added to the matrix, times the squares of the unknowns' scales: a trust region.
constexpr double kFirstDamping = 1e-2, kLeastDamping = 3e-4, kMostDamping = 1e8;
constexpr double kDampMore = 4.0;   // factor if the matrix has the wrong inertia
constexpr double kDampLess = 6.0;   // divisor if a step brings more than kGoodGain of the predicted gain
constexpr double kDampAgain = 3.0;  // factor if a step brings less than kPoorGain of the predicted gain
constexpr double kGoodGain = 0.4, kPoorGain = 0.1;
constexpr double kMultiplierBand = 10.0;  // largest ratio of a multiplier to barrier / slack, either way

// A constraint, value >= 0, with its slack and multiplier.
struct Row {
  std::size_t of = 0;  // index of the bound; of contacts, behind those of all bounds
  double value = 0.0, trial = 0.0;
  double slack = 0.0, slack_step = 0.0;
  double multiplier = 0.0, penalty = 0.0;
  const Numbers* numbers = nullptr;
  Term::Gradient gradient;
  [[nodiscard]] double residual() const { return value - slack; }
};

}  // namespace

struct ChainOptimizer::Memory {
  ChainSystem system;
  std::vector<Row> rows, next_rows;  // of all bounds and of near contacts
  std::vector<double> clear_until;   // movement of the chain until which each contact is far off
  std::vector<double> gradient, correction, uncorrected;
  std::vector<double> growths;  // of the body, by part of the chain [m]
};

namespace {

class InteriorPoint {
 public:
  InteriorPoint(const ChainQuery& query, ChainOptimizer::Memory& memory)
      : query_(query),
        system_(memory.system),
        rows_(memory.rows),
        next_rows_(memory.next_rows),
        clear_until_(memory.clear_until),
        tensions_(memory.system.tensions),
        gradient_(memory.gradient),
        correction_(memory.correction),
        uncorrected_(memory.uncorrected),
        growths_(memory.growths) {}

  // How turns are cut for it.
  [[nodiscard]] TurnCuts cuts() const {
    return {query_.effort.parts, query_.effort.least_turn, speeds_of(query_.vehicle).widest()};
  }

  // Optimizes the chain of the system.
  ChainOptimizer::Result run() {
    const Vehicle& vehicle = query_.vehicle;
    chain().entry = query_.ends.start * query_.ends.start;
    chain().exit = query_.ends.goal * query_.ends.goal;
    const double unit = vehicle.footprint().length();
    find_growths();
    if (!system_.begin(vehicle, {vehicle.footprint(0.5 * vehicle.safety_margin() + kGrowth * unit), growths_},
                       {query_.world, query_.outlines, kReach * unit, query_.clock}))
      return {false, 0};
    begin_barrier();
    int iterations = 0;
    for (; iterations < query_.effort.iterations && !query_.clock.is_over(); ++iterations) {
      evaluate();
      if (iterations == 0) find_tensions();
      if (is_optimal()) break;
      if (iterations >= kFirstSteps) change_barrier();
      if (!take_step()) break;
    }
    resolve_overlaps(system_, query_.clock);
    // What is left to the smallest radius is next to nothing; circles that touch are placed behind it.
    for (ArcChain::Arc& arc : chain().arcs) arc.radius = std::max(arc.radius, system_.tightest.on(arc.sign));
    return {true, iterations};
  }

 private:
  [[nodiscard]] ArcChain& chain() { return system_.chain; }
  [[nodiscard]] const ArcChain& chain() const { return system_.chain; }
  [[nodiscard]] std::size_t bounds() const { return system_.bounds.size(); }

  // Parts that keep a preferred distance, or nearly so, need a body grown by that.
  void find_growths() {
    growths_.clear();
    if (query_.clearance == nullptr) return;
    for (std::uint32_t part = 0; part < 2 * chain().arcs.size() + 1; ++part)
      growths_.push_back(growth_of(segment_of(chain(), part)));
  }

  [[nodiscard]] double growth_of(const PathSegment& segment) const {
    double growth = 0.0;
    for (const ClearanceCost::Rule& rule : query_.clearance->rules()) {
      const bool keeps_it =
          rule.counts_on(segment) && rule.close_length(segment) <= kGrazing * query_.vehicle.footprint().length();
      if (keeps_it) growth = std::max(growth, rule.close.distance() - 0.5 * query_.vehicle.safety_margin());
    }
    return growth;
  }

  void begin_barrier() {
    const double time = time_of(chain());
    first_barrier_ = barrier_ = query_.effort.first_barrier * time;
    last_barrier_ = kLastBarrier * time;
    clear_until_.assign(system_.contacts.size(), 0.0);
    rows_.assign(bounds(), Row{});
    for (std::size_t i = 0; i < bounds(); ++i) {
      Row& row = rows_[i];
      row.of = i;
      row.numbers = &system_.numbers_of(system_.bounds[i]);
      row.value = system_.value(system_.bounds[i], chain()).value;
      begin(row);
    }
  }
  void begin(Row& row) const {
    row.slack = std::max(row.value, kLeastSlack * system_.unit);
    row.multiplier = barrier_ / row.slack;
    row.penalty = 0.0;
  }

  // Of an arc or line.
  [[nodiscard]] const ChainSpeeds& speeds_on(const auto& part) const { return system_.speeds.in(part.gear); }
  [[nodiscard]] double time_of(const ArcChain& of) const {
    double time = 0.0;
    for (std::size_t i = 0; i < of.arcs.size(); ++i) time += arc_time_alone(of, i, speeds_on(of.arcs[i]));
    for (std::size_t i = 0; i < of.lines.size(); ++i)
      if (!of.lines[i].is_tied) time += line_time_alone(of, i, speeds_on(of.lines[i]));
    return time;
  }

  // Values and derivatives of all at the current chain.
  void evaluate() {
    system_.matrix.reset(system_.unknowns.size());
    gradient_.assign(system_.unknowns.size(), 0.0);
    time_ = 0.0;
    for (std::size_t i = 0; i < chain().arcs.size(); ++i)
      evaluate(arc_time(chain(), i, speeds_on(chain().arcs[i])), system_.unknowns.of_arc(i));
    for (std::size_t i = 0; i < chain().lines.size(); ++i)
      if (!chain().lines[i].is_tied)
        evaluate(line_time(chain(), i, speeds_on(chain().lines[i])), system_.unknowns.of_line(i));
    for (std::size_t i = 0; i < bounds(); ++i) evaluate(system_.bounds[i], rows_[i]);
    evaluate_contacts();
    for (const Row& row : rows_) add_square(*row.numbers, row.gradient, row.multiplier / row.slack, system_.matrix);
    system_.unknowns.add_equations(chain(), tensions_, ChainSystem::kStiffness, system_.matrix);
  }
  void evaluate(const Term& time, const Numbers& numbers) {
    time_ += time.value;
    add(numbers, time.gradient, 1.0, gradient_);
    add(numbers, time.hessian, 1.0, system_.matrix);
  }
  void evaluate(const Bound& bound, Row& row) {
    const auto [value, gradient] = system_.value(bound, chain());
    row.value = value;
    row.gradient = gradient;
    if (bound.limit == Limit::kSpeedUp || bound.limit == Limit::kBrake)
      add(*row.numbers, length_curvature(chain(), bound.index), -row.multiplier, system_.matrix);
    if (bound.limit == Limit::kEntry || bound.limit == Limit::kExit) {
      const auto radius = static_cast<std::size_t>((*row.numbers)[kRadius]);
      system_.matrix.add(radius, radius, -row.multiplier * speed_curvature(bound, chain(), system_.speeds_on(bound)));
    }
  }
  // Rows of contacts begin when they come near, and end when they are far off.
  void evaluate_contacts() {
    next_rows_.clear();
    std::size_t known = bounds();  // the first row of this contact or of a later one
    for (std::size_t contact = 0; contact < clear_until_.size(); ++contact) {
      while (known < rows_.size() && rows_[known].of < bounds() + contact) ++known;
      if (moved_ < clear_until_[contact]) continue;
      const ChainContacts::Place place = system_.contacts.look_around(chain(), contact);
      const double near = kNearContact * system_.unit;
      if (place.distance >= near) {
        const double unseen = kUnseen * system_.unit;
        clear_until_[contact] =
            moved_ + (place.distance < kInfinity ? place.distance - near
                                                 : std::max(unseen, system_.contacts.room(chain(), contact, near)));
        continue;
      }
      const bool was_near = known < rows_.size() && rows_[known].of == bounds() + contact;
      Row& row = next_rows_.emplace_back(was_near ? rows_[known] : Row{});
      row.of = bounds() + contact;
      const Term term = system_.contacts.term(chain(), contact, place);
      row.value = place.distance;
      row.numbers = &system_.numbers_at(place);
      row.gradient = term.gradient;
      if (!was_near) begin(row);
      add(*row.numbers, term.hessian, -row.multiplier, system_.matrix);
    }
    rows_.resize(bounds());
    rows_.insert(rows_.end(), next_rows_.begin(), next_rows_.end());
  }

  // The tensions at the beginning, from one solution without any.
  void find_tensions() {
    set_right();
    if (!factorize()) return;
    solve();
    take_tensions(1.0);
    evaluate();
  }
  void take_tensions(double share) {
    for (std::size_t i = 0; i < tensions_.size(); ++i)
      tensions_[i] += share * (system_.unknowns.tension(i, system_.step) - tensions_[i]);
  }

  [[nodiscard]] bool is_optimal() const {
    if (barrier_ > last_barrier_ || gain_ > kLeastGain * time_) return false;
    return std::ranges::all_of(rows_, [&](const Row& row) { return row.value > -kOverlap * system_.unit; });
  }
  void change_barrier() {
    if (share_ < kShortStep) barrier_ = std::min(first_barrier_, kRise * barrier_);
    if (share_ > kHalfStep) barrier_ = std::max(last_barrier_, (share_ > kFullStep ? kFall : kSlowFall) * barrier_);
  }

  void set_right() {
    auto& right = system_.right;
    right = gradient_;
    for (const Row& row : rows_)
      add(*row.numbers, row.gradient, (row.multiplier * row.residual() - barrier_) / row.slack, right);
    for (double& value : right) value = -value;
  }
  [[nodiscard]] bool factorize() {
    for (; damping_ <= kMostDamping; damping_ *= kDampMore)
      if (system_.matrix.factorize(system_.unknowns.inverse_squares(), damping_, system_.unknowns.equations()))
        return true;
    return false;
  }
  void solve() {
    system_.step = system_.right;
    system_.matrix.solve(system_.step);
    set_slack_steps();
  }
  void set_slack_steps() {
    for (Row& row : rows_) row.slack_step = along(*row.numbers, row.gradient, system_.step) + row.residual();
  }

  bool take_step() {
    set_right();
    for (; factorize(); damping_ *= kMoreDamping) {
      solve();
      if (try_step()) return true;
    }
    return false;
  }

  bool try_step() {
    double slope = 0.0;
    for (std::size_t i = 0; i < gradient_.size(); ++i)
      if (!system_.unknowns.is_tension(i)) slope += gradient_[i] * system_.step[i];
    for (Row& row : rows_) {
      row.penalty = std::max(row.penalty, kPenalty * std::abs(next_multiplier(row)));
      slope -= barrier_ * row.slack_step / row.slack + row.penalty * std::abs(row.residual());
    }
    const double before = merit(time_, &Row::value, 0.0);
    double share = longest_share();
    for (int tries = 0; tries < kMostShorter; ++tries, share *= kShorter) {
      const auto is_taken = [&] {
        const double time = time_of(system_.trial);
        const double gain = before - merit(time, &Row::trial, share), predicted = -slope * share;
        if (!(gain >= kSufficient * predicted)) return false;
        accept(share, time, predicted > 0.0 ? gain / predicted : 1.0);
        return true;
      };
      if (!system_.move(share)) continue;
      look_at_trial();
      if (is_taken()) return true;
      if (tries > 0) continue;
      uncorrected_ = system_.step;
      if (correct(share) && is_taken()) return true;
      system_.step = uncorrected_;
      set_slack_steps();
    }
    return false;
  }
  [[nodiscard]] double next_multiplier(const Row& row) const {
    return (barrier_ - row.multiplier * row.slack_step) / row.slack;
  }

  // The longest share of the step that keeps all strictly inside.
  [[nodiscard]] double longest_share() const {
    double share = 1.0;
    const auto keep = [&share](double value, double change, double least) {
      if (value + share * change < least * value) share = (least - 1.0) * value / change;
    };
    const auto change = [this](int number) { return part_of(system_.step, number); };
    for (const Row& row : rows_) keep(row.slack, row.slack_step, 1.0 - kMostToBoundary);
    for (std::size_t i = 0; i < chain().arcs.size(); ++i) {
      const Numbers& at = system_.unknowns.of_arc(i);
      const ArcChain::Arc& arc = chain().arcs[i];
      keep(arc.entry, change(at[kEntry]), kLeastLeft);
      keep(arc.exit, change(at[kExit]), kLeastLeft);
      keep(arc.radius, change(at[kRadius]), kLeastLeft);
      keep(chain().turn(i), arc.turning() * (change(at[kNextHeading]) - change(at[kHeading])), kLeastLeft);
    }
    for (std::size_t i = 0; i < chain().lines.size(); ++i)
      if (!chain().lines[i].is_tied)
        keep(chain().lines[i].length, change(system_.unknowns.of_line(i)[kLength]), kLeastLeft);
    return share;
  }

  // Time, barrier, and what the residuals cost, after a share of the step.
  [[nodiscard]] double merit(double time, double Row::*value, double share) const {
    double sum = time;
    for (const Row& row : rows_) {
      const double slack = row.slack + share * row.slack_step;
      sum += row.penalty * std::abs(row.*value - slack) - barrier_ * std::log(slack);
    }
    return sum;
  }
  void look_at_trial() {
    for (Row& row : rows_) {
      if (row.of < bounds()) {
        row.trial = system_.value(system_.bounds[row.of], system_.trial).value;
      } else {
        // All distances beyond that of a constraint are equally good.
        const double far = std::max(kNearContact * system_.unit, row.slack + row.slack_step);
        row.trial = std::min(far, system_.contacts.look(system_.trial, row.of - bounds()).distance);
      }
    }
  }

  // A second-order correction: the residuals after the step are taken into account. Returns whether it can be made.
  bool correct(double share) {
    correction_.assign(system_.step.size(), 0.0);
    const auto residual = [share](const Row& row) { return row.trial - (row.slack + share * row.slack_step); };
    for (const Row& row : rows_)
      add(*row.numbers, row.gradient, -row.multiplier * residual(row) / row.slack, correction_);
    system_.matrix.solve(correction_);
    for (Row& row : rows_) {
      row.slack_step += (along(*row.numbers, row.gradient, correction_) + residual(row)) / share;
      if (row.slack + share * row.slack_step < (1.0 - kMostToBoundary) * row.slack) return false;
    }
    for (std::size_t i = 0; i < correction_.size(); ++i) system_.step[i] += correction_[i] / share;
    if (!system_.move(share)) return false;
    look_at_trial();
    return true;
  }

  void accept(double share, double time, double quality) {
    for (Row& row : rows_) {
      const double change = next_multiplier(row) - row.multiplier;
      const bool is_too_far = row.multiplier + change < (1.0 - kMostToBoundary) * row.multiplier;
      const double most = is_too_far ? kMostToBoundary * row.multiplier / -change : 1.0;
      row.multiplier += std::min(share, most) * change;
      row.slack += share * row.slack_step;
      // A larger slack lowers the barrier. Chains that are joined gain nothing by that.
      if (!chain().is_joined) row.slack = std::max(row.slack, row.trial);
      const double central = barrier_ / row.slack;
      row.multiplier = std::clamp(row.multiplier, central / kMultiplierBand, central * kMultiplierBand);
    }
    take_tensions(share);
    share_ = share;
    gain_ = std::abs(time_ - time);
    moved_ += system_.movement();
    std::swap(system_.chain, system_.trial);
    if (quality > kGoodGain) damping_ = std::max(kLeastDamping, damping_ / kDampLess);
    if (quality < kPoorGain) damping_ *= kDampAgain;
  }

  const ChainQuery& query_;
  ChainSystem& system_;
  std::vector<Row>&rows_, &next_rows_;
  std::vector<double>& clear_until_;
  std::vector<Vec2>& tensions_;
  std::vector<double>&gradient_, &correction_, &uncorrected_, &growths_;
  double time_ = 0.0;  // of the chain, at its speeds [s]
  double barrier_ = 0.0, first_barrier_ = 0.0, last_barrier_ = 0.0;
  double damping_ = kFirstDamping;
  double share_ = 0.0, gain_ = 0.0, moved_ = 0.0;  // of the last step; by all steps
};

}  // namespace

ChainOptimizer::ChainOptimizer() : memory_(std::make_unique<Memory>()) {}
ChainOptimizer::~ChainOptimizer() = default;
ChainOptimizer::ChainOptimizer(ChainOptimizer&&) noexcept = default;
ChainOptimizer& ChainOptimizer::operator=(ChainOptimizer&&) noexcept = default;

bool ChainOptimizer::serves_chains(const Vehicle& vehicle) { return has_chain_speeds(vehicle); }
bool ChainOptimizer::serves(const Vehicle& vehicle) { return has_gear_speeds(vehicle); }

ChainOptimizer::Result ChainOptimizer::optimize(const CircleChain& chain, std::span<const Bitangent> lines,
                                                const ChainQuery& query, CircleChain& optimized) {
  InteriorPoint method(query, *memory_);
  if (!cut_turns(chain, lines, method.cuts(), memory_->system.chain)) return {false, 0};
  const Result result = method.run();
  if (result.is_optimized) circles_of(memory_->system.chain, optimized);
  return result;
}

ChainOptimizer::Result ChainOptimizer::optimize(std::span<const PathSegment> path, const ChainQuery& query,
                                                Path& optimized) {
  InteriorPoint method(query, *memory_);
  ChainSystem& system = memory_->system;
  if (!cut_turns(path, method.cuts(), system.chain)) return {false, 0};
  const Result result = method.run();
  if (!result.is_optimized || !system.settle()) return {false, result.iterations};
  path_of(system.chain, optimized);
  return result;
}

}  // namespace arcway::internal
