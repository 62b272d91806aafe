#include "core/planner/strategy_text.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>

#include "arcway/angle.h"
#include "core/base/shortest_text.h"
#include "core/planner/strategy.h"

namespace arcway::internal {

namespace {

// To a ten-thousandth: 0.07 is 7 %, whatever doubles make of it.
std::string percent(double share) { return shortest_text(std::round(1e6 * share) / 1e4) + " %"; }

const char* text_of(Known known) {
  switch (known) {
    case Known::kAnything:
      return "";
    case Known::kNoPath:
      return "no path yet";
    case Known::kPath:
      return "a path";
    case Known::kEasierPath:
      return "a path, the first one not of narrow trees of the body";
    case Known::kForwardPath:
      return "a forward path";
    case Known::kByManeuvers:
      return "a forward path by maneuvers";
    case Known::kPathElsewhere:
      return "a forward path, none of the tightest radii";
    case Known::kNarrowPath:
      return "a path of narrow trees only";
    case Known::kGearChanges:
      return "only a path with changes of gear";
  }
  return "";
}

const char* text_of(On on) {
  switch (on) {
    case On::kAllRadii:
      return "all radii";
    case On::kTightest:
      return "the tightest radii";
  }
  return "";
}

// A weight of the estimate of the rest of the route, if it is not the usual one.
std::string weight_text(double weight, double usual) {
  return weight == usual ? "" : ", weight of the rest " + shortest_text(weight);
}

struct StepText {
  std::string operator()(const JoinBySingleArcs& step) const {
    return std::string("join the roadmap of ") + text_of(step.on) + " by single arcs" +
           (step.end_radii == kEveryRadius ? "" : " of " + std::to_string(step.end_radii) + " radii");
  }
  std::string operator()(const FindSoon& step) const {
    return "join the roadmap of the tightest radii by single arcs of " + std::to_string(step.end_radii) +
           " radii, in haste: by a path that takes at most " + percent(step.suboptimality) + " longer";
  }
  std::string operator()(const JoinByNarrowPlaces& step) const {
    return std::string("join the roadmap of ") + text_of(step.on) + " with circles in gaps by single arcs";
  }
  std::string operator()(const JoinByManeuvers& step) const {
    return std::string("join the roadmap of ") + text_of(step.on) +
           " by maneuvers at the end in trouble: " + std::to_string(step.effort.first) + " poses, then all, then " +
           std::to_string(step.effort.sparse_factor) + " times as many sparse ones";
  }
  std::string operator()(const JoinByManeuversAndNarrowPlaces& step) const {
    return std::string("join the roadmap of ") + text_of(step.on) + " with circles in gaps by maneuvers of " +
           std::to_string(step.poses) + " poses";
  }
  std::string operator()(const ProveBottleneck&) const { return "prove that the widest route is too narrow"; }
  std::string operator()(const ProveDeadEnd& step) const {
    return "prove a dead end: " + std::to_string(step.effort.max_checks) + " boxes, halved " +
           std::to_string(step.effort.halvings) + " times";
  }
  std::string operator()(const ProveEnclosure& step) const {
    return "prove an enclosure: " + std::to_string(step.boxes) + " boxes of a size";
  }
  std::string operator()(const GrowTrees& step) const {
    return "grow trees of forward motions, " + percent(step.share) + " of the poses, " +
           std::to_string(step.passes.size()) + (step.passes.size() == 1 ? " pass" : " passes") + " from cells of 1/" +
           shortest_text(1.0 / step.passes.front().finest) + " body length on" +
           (step.explores_surroundings ? ", unless an end is closed in" : "");
  }
  std::string operator()(const GrowSlimTrees& step) const {
    return "grow trees of a body " + percent(kSlimBodies[step.body]) + " narrower" +
           (step.when == WhenSlim::kClosedOrRefused ? ", if an end is closed in or paths were not pushed free"
                                                    : ", unless an end is closed in") +
           ", and push their paths off what the body touches";
  }
  std::string operator()(const RaiseLowerBound&) const { return "raise the lower bound"; }
  std::string operator()(const FollowZoneRoutes& step) const {
    return "follow the fastest routes of a point, and of one in zones " + shortest_text(step.slower.back()) +
           " times as slow";
  }
  std::string operator()(const FollowOneWayRoutes& step) const {
    return "follow routes through and around one-way zones, at most " + std::to_string(step.most);
  }
  std::string operator()(const TryManeuvers& step) const {
    return "search again, with maneuvers of " + std::to_string(step.poses) + " sparse poses at both ends";
  }
  std::string operator()(const TryNarrowPlaces&) const { return "search again, with circles in gaps"; }
  std::string operator()(const TryOtherLastCircle& step) const {
    return "search again, without the path's last circle; slower by at most " + percent(step.slower);
  }
  std::string operator()(const TryOtherFirstCircle& step) const {
    return "search again, without the path's first circle; slower by at most " + percent(step.slower);
  }
  std::string operator()(const TryOtherTurns& step) const {
    return "search again, for a vehicle of " + shortest_text(step.factor) + " x lateral acceleration";
  }
  std::string operator()(const TryOtherRadii& step) const {
    return std::string(step.radii == 1 ? "search again, with the first radius"
                                       : "search again, with the first " + std::to_string(step.radii) + " radii") +
           ", for a vehicle of " + shortest_text(step.factor) + " x lateral acceleration, unless that takes " +
           percent(step.slower) + " longer than the best path";
  }
  std::string operator()(const TryOtherSides& step) const {
    return "search again, without turning around an obstacle of the best path as that does: at most " +
           std::to_string(step.most) + " times, with the first " + std::to_string(step.radii) +
           " radii, for a vehicle of " + shortest_text(step.factor) + " x lateral acceleration, unless that takes " +
           percent(step.slower) + " longer than the best path";
  }
  std::string operator()(const RefineBest& step) const {
    const std::string fewer =
        std::isfinite(step.fewer_arcs_gap) ? "; in fewer arcs with a gap > " + percent(step.fewer_arcs_gap) : "";
    return "refine the best path further, and the second best one if it costs at most " + percent(step.close) +
           " more" + fewer;
  }
  std::string operator()(const JoinArcs&) const { return "drive the best path in fewer arcs, and refine it further"; }
  std::string operator()(const JoinBackwards&) const { return "join the roadmap by single arcs, driven backwards"; }
  std::string operator()(const JoinBetweenGears& step) const {
    std::string few;
    if (step.few)
      few = ", or " + std::to_string(step.few->attachments.most) + " beside a path of trees or on a map of more than " +
            std::to_string(step.few->vertices) + " vertices,";
    return "join the roadmap by motions in both gears: " + std::to_string(step.attachments.most) + few +
           " poses of each end, cells of 1/" + shortest_text(step.attachments.cells) + " turning radius";
  }
  std::string operator()(const GrowGearTrees& step) const {
    return "grow trees in both gears: " + std::to_string(step.poses) + " poses";
  }
  std::string operator()(const PlanParts& step) const {
    return "plan " + std::to_string(step.forward_parts) + " parts of the path again, " +
           std::to_string(step.parts.size()) + " in both gears, in a narrow place or, if hard to find, with a gap > " +
           percent(step.forwards_gap) + ", in both gears > " + percent(step.both_gears_gap);
  }
  std::string operator()(const PlanPartsQuickly& step) const {
    return "plan up to " + std::to_string(step.parts.size()) + " parts of the path again by the quick rows, until " +
           std::to_string(step.most_failed) + " in a row bring nothing";
  }
  std::string operator()(const TryOtherWays& step) const {
    return "grow trees of a slim body and of the body that keep off the paths so far, in " +
           std::to_string(step.rounds) + " rounds";
  }
  std::string operator()(const TryOtherWaysInBothGears& step) const {
    return "grow trees in both gears of a slim body that keep off the paths so far: " + std::to_string(step.rounds) +
           " rounds of " + std::to_string(step.poses) + " poses";
  }
  std::string operator()(const GrowNarrowGearTrees& step) const {
    return "grow trees in both gears for narrow places: " + std::to_string(step.poses) + " poses";
  }
  std::string operator()(const GrowSlimGearTrees& step) const {
    return "grow trees in both gears for narrow places, of slim bodies, and push their paths free: " +
           std::to_string(step.poses) + " poses" + weight_text(step.rest_weight, kRestWeight) +
           (step.again ? ", again, for a path cheaper than the refined one" : "");
  }
  std::string operator()(const PlanSlimBody& step) const {
    return "plan for a body " + percent(kSlimPlan) + " narrower, " +
           (step.first_tree_share == 1.0
                ? ""
                : "with several radii by fewer poses of the first trees, beside the roadmap, ") +
           "and push its path off what the body touches";
  }
  std::string operator()(const RefineBothGears&) const { return "refine the cheapest path of the rows in both gears"; }
};

}  // namespace

std::string text_of(const When& when) {
  std::string text = text_of(when.known);
  const auto add = [&text](bool holds, const std::string& what) {
    if (holds) text += (text.empty() ? "" : ", ") + what;
  };
  add(when.driving == Driving::kForwards, "forwards only");
  add(when.driving == Driving::kBothGears, "both gears");
  add(when.radii == Radii::kTightest, "one radius");
  add(when.radii == Radii::kSeveral, "several radii");
  add(when.care == Care::kThorough, "one radius and refined");
  add(when.care == Care::kQuick, "several radii or unrefined");
  add(when.has_speed_limits, "zones limit the speed");
  add(when.has_one_way, "zones limit directions");
  add(when.refines && when.care != Care::kThorough, "refined");
  add(when.gap > 0.0, "gap > " + percent(when.gap));
  const bool is_of_gears = when.driving == Driving::kBothGears;  // the gap, not the best gap
  add(when.best_gap > 0.0 && (is_of_gears || when.best_gap > when.gap), "best gap > " + percent(when.best_gap));
  add(std::isfinite(when.most_gap), "best gap up to " + percent(when.most_gap));
  add(when.most_tree_poses < std::numeric_limits<std::uint64_t>::max(),
      when.most_tree_poses == 0 ? "no trees so far"
                                : "up to " + std::to_string(when.most_tree_poses) + " poses of trees so far");
  add(when.most_vertices < std::numeric_limits<std::size_t>::max(),
      "a map of up to " + std::to_string(when.most_vertices) + " vertices");
  add(when.gap_counts_zones, "what zones add counts");
  add(when.tight_end > 0.0,
      "an end turns less than " + shortest_text(std::round(when.tight_end * 1800.0 / kPi) / 10.0) + " degrees");
  return text.empty() ? "always" : text;
}

std::string text_of(const Step& step) { return std::visit(StepText{}, step); }

std::string text_of(const Trials& trials) {
  if (trials.several == 1.0 && trials.tightest == 1.0) return "";
  if (trials.tightest == trials.several) return shortest_text(trials.several) + " x";
  return shortest_text(trials.several) + " x, with several radii";
}

}  // namespace arcway::internal
