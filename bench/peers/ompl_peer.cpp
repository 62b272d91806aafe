#include "bench/peers/ompl_peer.h"

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/config.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#if OMPL_VERSION_VALUE >= 2000000
#include <ompl/geometric/planners/informedtrees/EITstar.h>
#include <ompl/geometric/planners/lazyinformedtrees/BLITstar.h>
#define ARCWAY_OMPL_2
#endif
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "arcway/angle.h"
#include "arcway/turning_radii.h"
#include "bench/cpu_clock.h"
#include "bench/peers/shortcut.h"
#include "core/model/body_size.h"

namespace arcway::internal::peers {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

// Attempts in a row without a faster path after which a shortcut is taken for exhausted.
constexpr int kPatience = 200;

// Distance of the poses at which planners check that ask for no motions, as a share of the body's width.
constexpr double kSampleStep = 0.1;

#ifdef ARCWAY_OMPL_2
using DubinsWord = ob::DubinsStateSpace::PathType;
constexpr std::array kOfOmpl2{OmplPlanner::kEitStar, OmplPlanner::kBlitStar};
#else
using DubinsWord = ob::DubinsStateSpace::DubinsPath;
#endif

Pose pose_of(const ob::State* state) {
  const auto* s = state->as<ob::SE2StateSpace::StateType>();
  return {s->getX(), s->getY(), s->getYaw()};
}

/// OMPL's own formulas stop the process by an assertion with an absolute tolerance on maps of a hundred meters.
class DubinsSpace final : public ob::DubinsStateSpace {
 public:
  explicit DubinsSpace(double radius) : ob::DubinsStateSpace(radius) {}

  double distance(const ob::State* from, const ob::State* to) const override {
    return length_of(shortest_dubins_path(pose_of(from), pose_of(to), rho_));
  }
  void interpolate(const ob::State* from, const ob::State* to, double share, ob::State* state) const override {
    const Path path = shortest_dubins_path(pose_of(from), pose_of(to), rho_);
    double rest = share * length_of(path);
    Pose pose = pose_of(share >= 1.0 ? to : from);
    for (const PathSegment& s : path) {
      if (share >= 1.0) break;
      pose = s.at(std::min(rest, s.length));
      rest -= s.length;
      if (rest <= 0.0) break;
    }
    auto* result = state->as<ob::SE2StateSpace::StateType>();
    result->setXY(pose.x, pose.y);
    result->setYaw(wrap_signed(pose.heading));
  }
  // Many parameters because OMPL's interface has them.
  void interpolate(const ob::State* from, const ob::State* to, double share, bool& /*first_time*/, DubinsWord& /*path*/,
                   ob::State* state) const override {
    interpolate(from, to, share, state);
  }
};

class ExactMotionValidator final : public ob::MotionValidator {
 public:
  ExactMotionValidator(const ob::SpaceInformationPtr& si, const Problem& problem)
      : ob::MotionValidator(si),
        sweep_(problem.sweep),
        body_(checked_body(problem.vehicle)),
        radius_(problem.vehicle.min_turning_radius()) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return motion_free(sweep_, body_, shortest_dubins_path(pose_of(from), pose_of(to), radius_));
  }
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(from, to)) return true;
    last_valid.second = 0.0;
    if (last_valid.first != nullptr) si_->copyState(last_valid.first, from);
    return false;
  }

 private:
  const SweepQuery& sweep_;
  Body body_;
  double radius_;
};

/// One problem in OMPL's terms.
class Setup {
 public:
  explicit Setup(const Problem& problem) : problem_(problem) {
    auto space = std::make_shared<DubinsSpace>(problem.vehicle.min_turning_radius());
    ob::RealVectorBounds bounds(2);
    for (unsigned axis = 0; axis < 2; ++axis) {
      bounds.setLow(axis, problem.world.box().min[axis]);
      bounds.setHigh(axis, problem.world.box().max[axis]);
    }
    space->setBounds(bounds);
    information_ = std::make_shared<ob::SpaceInformation>(space);
    information_->setStateValidityChecker([&problem, body = checked_body(problem.vehicle)](const ob::State* state) {
      return pose_free(problem.sweep, body, pose_of(state));
    });
    // EIT* and BLIT* check motions at sampled poses only, whatever the validator of motions.
    information_->setStateValidityCheckingResolution(kSampleStep * body_width(problem.vehicle) /
                                                     space->getMaximumExtent());
    information_->setMotionValidator(std::make_shared<ExactMotionValidator>(information_, problem));
    information_->setup();
    definition_ = std::make_shared<ob::ProblemDefinition>(information_);
    definition_->setStartAndGoalStates(state_of(problem.request.start), state_of(problem.request.goal));
    definition_->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(information_));
  }

  [[nodiscard]] const Problem& problem() const { return problem_; }

  std::shared_ptr<ob::Planner> make(OmplPlanner kind) {
    const std::shared_ptr<ob::Planner> planner = made(kind);
    planner->setProblemDefinition(definition_);
    planner->setup();
    return planner;
  }

  /// Runs on until `seconds` of the clock, or the first exact solution if `stop_at_first`.
  void solve(ob::Planner& planner, const bench::CpuClock& clock, double seconds, bool stop_at_first) {
    planner.solve(ob::PlannerTerminationCondition(
        [&, stop_at_first, seconds] { return clock.seconds() >= seconds || (stop_at_first && has_path(planner)); }));
  }

  [[nodiscard]] std::optional<PeerSolution> solution(const bench::CpuClock& clock) const {
    const ob::PathPtr path = definition_->getSolutionPath();
    // BLIT* hands over a null path if it has none.
    if (path == nullptr || !definition_->hasExactSolution()) return std::nullopt;
    const auto& found = *path->as<og::PathGeometric>();
    PeerSolution solution;
    solution.seconds = clock.seconds();
    Pose from = problem_.request.start;  // unwrapped, as asked for
    for (std::size_t i = 1; i < found.getStateCount(); ++i) {
      const Pose to = pose_of(found.getState(static_cast<unsigned>(i)));
      const Path motion = shortest_dubins_path(from, to, problem_.vehicle.min_turning_radius());
      solution.path.insert(solution.path.end(), motion.begin(), motion.end());
      from = to;
    }
    solution.travel_time = travel_time(solution.path, problem_.vehicle);
    return solution;
  }

  void forget_solutions() { definition_->clearSolutionPaths(); }

 private:
  /// Some planners hand their solution over when they end; until then the finite cost tells of it.
  [[nodiscard]] bool has_path(const ob::Planner& planner) const {
    if (const auto* star = dynamic_cast<const og::RRTstar*>(&planner)) return std::isfinite(star->bestCost().value());
    const auto& progress = planner.getPlannerProgressProperties();
    const auto cost = progress.find("best cost DOUBLE");
    if (cost != progress.end()) return std::isfinite(std::stod(cost->second()));
    return definition_->hasExactSolution();
  }

  [[nodiscard]] std::shared_ptr<ob::Planner> made(OmplPlanner kind) const {
    switch (kind) {
      case OmplPlanner::kInformedRrtStar:
        return std::make_shared<og::InformedRRTstar>(information_);
#ifdef ARCWAY_OMPL_2
      case OmplPlanner::kEitStar:
        return std::make_shared<og::EITstar>(information_);
      case OmplPlanner::kBlitStar:
        return std::make_shared<og::BLITstar>(information_);
#endif
      default:
        return std::make_shared<og::RRTConnect>(information_);
    }
  }

  ob::ScopedState<> state_of(const Pose& pose) const {
    ob::ScopedState<> state(information_);
    auto* s = state->as<ob::SE2StateSpace::StateType>();
    s->setXY(pose.x, pose.y);
    s->setYaw(pose.heading);
    state.enforceBounds();
    return state;
  }

  const Problem& problem_;
  ob::SpaceInformationPtr information_;
  ob::ProblemDefinitionPtr definition_;
};

/// Turning radii of shortcuts [m], and when the best path is recorded [s].
struct Restarts {
  std::span<const double> radii, times;
};

void run_restarts(Setup& setup, const Restarts& restarts, const bench::CpuClock& clock, Random& random, PeerRun& run) {
  const Problem& problem = setup.problem();
  std::optional<PeerSolution> best;
  std::optional<PeerSolution> next = run.first;
  for (const double time : restarts.times) {
    const auto over = [&] { return clock.seconds() >= time; };
    while (!over()) {
      if (next) {
        next->path = shortcut(std::move(next->path), problem, {restarts.radii, kPatience, over}, random);
        next->travel_time = travel_time(next->path, problem.vehicle);
        next->seconds = clock.seconds();
        if (!best || next->travel_time < best->travel_time) best = std::move(next);
      }
      setup.forget_solutions();
      const std::shared_ptr<ob::Planner> planner = setup.make(OmplPlanner::kRrtConnect);
      setup.solve(*planner, clock, time, true);
      next = setup.solution(clock);
    }
    run.at_time.push_back(best);
  }
}

}  // namespace

std::string name_of(OmplPlanner planner) {
  const auto named = [](const char* name) { return ompl_name() + "_" + name; };
  switch (planner) {
    case OmplPlanner::kRrtConnect:
      return named("rrtconnect");
    case OmplPlanner::kRrtConnectWide:
      return named("rrtconnect_wide");
    case OmplPlanner::kInformedRrtStar:
      return named("informed_rrtstar");
    case OmplPlanner::kEitStar:
      return named("eitstar");
    case OmplPlanner::kBlitStar:
      return named("blitstar");
  }
  return named("unknown");
}

std::span<const OmplPlanner> planners_of_ompl_2() {
#ifdef ARCWAY_OMPL_2
  return kOfOmpl2;
#else
  return {};
#endif
}

PeerRun run_ompl(OmplPlanner kind, const Problem& problem, double first_within, std::span<const double> times,
                 Random& random) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const bench::CpuClock clock(bench::CpuClock::Of::kThread);
  PeerRun run;
  Setup setup(problem);
  const std::shared_ptr<ob::Planner> planner = setup.make(kind);
  setup.solve(*planner, clock, times.empty() ? first_within : std::max(first_within, times.back()), true);
  run.first = setup.solution(clock);
  if (!run.first) {
    run.at_time.resize(times.size());
    return run;
  }
  if (kind == OmplPlanner::kRrtConnect) {
    run_restarts(setup, {std::array{problem.vehicle.min_turning_radius()}, times}, clock, random, run);
  } else if (kind == OmplPlanner::kRrtConnectWide) {
    run_restarts(setup, {turning_radii(problem.vehicle, problem.world), times}, clock, random, run);
  } else {
    for (const double time : times) {
      if (clock.seconds() < time) setup.solve(*planner, clock, time, false);
      run.at_time.push_back(run.first->seconds <= time ? setup.solution(clock) : std::nullopt);
    }
  }
  return run;
}

void seed_ompl(std::uint64_t seed) { ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed)); }

std::string ompl_name() { return OMPL_MAJOR_VERSION < 2 ? "ompl" : "ompl" + std::to_string(OMPL_MAJOR_VERSION); }

std::string ompl_version() {
  return std::to_string(OMPL_MAJOR_VERSION) + "." + std::to_string(OMPL_MINOR_VERSION) + "." +
         std::to_string(OMPL_PATCH_VERSION);
}

}  // namespace arcway::internal::peers
