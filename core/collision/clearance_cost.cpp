#include "core/collision/clearance_cost.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "arcway/angle.h"

namespace arcway::internal {

namespace {

Box box_around(const Vec2& center, double radius) { return Box{center, center}.grown(radius); }

// The parts of a circle in an area, as headings of F from its lowest to its highest, within [-2 pi, 2 pi].
std::vector<BlockedRange> headings_in(const ZoneArea& area, const Vec2& center, double radius, Side side) {
  const double sign = sign_of(side);
  const Vec2 start = center - sign * radius * perpendicular(direction_of(0.0));
  std::vector<ZoneArea::Stay> stays;
  area.find_stays({{start.x(), start.y(), 0.0}, kTwoPi * radius, sign / radius}, stays);
  std::vector<BlockedRange> headings;
  for (const ZoneArea::Stay& stay : stays) {
    const double from = sign * stay.from / radius, to = sign * stay.to / radius;
    headings.push_back({std::min(from, to), std::max(from, to)});
  }
  return headings;
}

// Whatever two sets of headings have in common.
std::vector<HeadingInterval> common(std::span<const HeadingInterval> headings, std::span<const BlockedRange> ranges) {
  std::vector<HeadingInterval> result;
  for (const BlockedRange& range : ranges)
    for (const HeadingInterval& interval : headings)
      for (const double turns : {-2.0 * kTwoPi, -kTwoPi, 0.0, kTwoPi}) {
        const double low = std::max(range.low, interval.low + turns);
        const double high = std::min(range.high, interval.high + turns);
        if (low >= high) continue;
        const double wrapped = wrap_positive(low);
        result.push_back({wrapped, wrapped + (high - low)});
      }
  return result;
}

}  // namespace

double ClearanceCost::Rule::close_length(const PathSegment& segment) const {
  if (!area) return close.on(segment);
  std::vector<ZoneArea::Stay> stays;
  area->find_stays(segment, stays);
  double sum = 0.0;
  for (const ZoneArea::Stay& stay : stays) {
    PathSegment inside = segment;
    if (stay.from > 0.0) inside.start = segment.at(stay.from);
    inside.length = stay.to - stay.from;
    sum += close.on(inside);
  }
  return sum;
}

bool ClearanceCost::Rule::counts_on(const PathSegment& segment) const {
  if (!area || !(cost > 0.0)) return cost > 0.0;
  std::vector<ZoneArea::Stay> stays;
  area->find_stays(segment, stays);
  return !stays.empty();
}

bool ClearanceCost::Rule::may_count_in(const Box& box) const {
  return cost > 0.0 && (!area || area->box().overlaps(box));
}

std::shared_ptr<const ClearanceCost> ClearanceCost::of(const Vehicle& vehicle,
                                                       const std::shared_ptr<const Outlines>& outlines,
                                                       const std::optional<ClearancePreference>& preference,
                                                       std::span<const Zone> zones) {
  ClearanceCost cost;
  if (preference)
    cost.rules_.push_back({CloseLengths(vehicle, outlines, preference->distance), preference->cost, kNone, {}});
  for (std::uint32_t i = 0; i < zones.size(); ++i)
    if (const auto* rule = std::get_if<KeepClear>(&zones[i].rule))
      cost.rules_.push_back({CloseLengths(vehicle, outlines, rule->distance), rule->cost, i, ZoneArea(zones[i].area)});
  return cost.rules_.empty() ? nullptr : std::make_shared<const ClearanceCost>(std::move(cost));
}

ClearanceCost::ClearanceCost(const Vehicle& vehicle, std::shared_ptr<const Outlines> outlines,
                             const ClearancePreference& preference)
    : rules_{{CloseLengths(vehicle, std::move(outlines), preference.distance), preference.cost, kNone, {}}} {}

bool ClearanceCost::costs_nothing() const {
  return std::ranges::all_of(rules_, [](const Rule& rule) { return rule.cost == 0.0; });
}

double ClearanceCost::of(const PathSegment& segment) const {
  double sum = 0.0;
  for (const Rule& rule : rules_)
    if (rule.cost > 0.0) sum += rule.cost * rule.close_length(segment);
  return sum;
}

double ClearanceCost::of(std::span<const PathSegment> path) const {
  double sum = 0.0;
  for (const PathSegment& segment : path) sum += of(segment);
  return sum;
}

std::vector<ClearanceCost::CloseHeadings> ClearanceCost::close_headings(const Vec2& center, double radius,
                                                                        Side side) const {
  std::vector<CloseHeadings> result;
  for (const Rule& rule : rules_) {
    if (!rule.may_count_in(box_around(center, radius))) continue;
    std::vector<BlockedRange> inside;
    if (rule.area) inside = headings_in(*rule.area, center, radius, side);
    if (rule.area && inside.empty()) continue;
    std::vector<HeadingInterval> headings = rule.close.headings_on({center, radius, side, rule.close.body()});
    if (rule.area) headings = common(headings, inside);
    if (!headings.empty()) result.push_back({rule.cost, std::move(headings)});
  }
  return result;
}

double turn_cost(std::span<const ClearanceCost::CloseHeadings> close, const Turn& turn) {
  double sum = 0.0;
  for (const ClearanceCost::CloseHeadings& of_rule : close)
    sum += of_rule.cost * turn.radius * angle_within(of_rule.headings, turn.heading, turn.side, turn.angle);
  return sum;
}

}  // namespace arcway::internal
