#include "core/motion/motion_phases.h"

#include "core/motion/speed_profile.h"

namespace arcway::internal {
namespace {

/// Phases shorter than this share of the way from rest to the peak and back come from rounding of speeds near the peak.
/// A unit in the last place of the speed makes up to 2e-16 of that way.
constexpr double kRoundingShare = 1e-14;

}  // namespace

MotionPhases::MotionPhases(const TimedSegment& timed, double top_speed, double acceleration) {
  const double length = timed.segment.length, v1 = timed.speed_in, v3 = timed.speed_out;
  if (!(length > 0.0)) return;
  const auto [peak, accelerating, holding, braking] = segment_phases(length, v1, top_speed, v3, acceleration);
  const double rounding = kRoundingShare * peak * peak / acceleration;
  for (const Phase& phase : {Phase{accelerating, v1, peak}, Phase{holding, peak, peak}, Phase{braking, peak, v3}})
    if (phase.length > rounding) phases_[count_++] = phase;
  if (count_ == 0) phases_[count_++] = {length, v1, v3};
  // A motion that claims a little more than the vehicle can accelerate has one phase, over all of its length.
  if (count_ == 1) phases_[0].length = length;
  phases_[0].speed_in = v1;
  phases_[count_ - 1].speed_out = v3;
}

}  // namespace arcway::internal
