#pragma once

#include <optional>
#include <vector>

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "core/attach/attachment_links.h"
#include "core/attach/roadmap.h"

namespace arcway::internal {

/// The radius of the tightest turn that a vehicle drives at a speed [m]; infinity: it drives none.
double tightest_turn(const Vehicle& vehicle, double speed);

/// A start or goal that is passed at a speed.
struct MovingEnd {
  const Roadmap& map;
  const Vehicle& vehicle;  ///< with the speeds of the gear in which paths are driven
  Pose pose;
  Direction direction;
  double speed;  ///< [m/s], >= 0
};

/// How an end that is passed too fast for the smallest turns joins the roadmap; empty if it is slow enough.
///
/// The first attachment is the end's own pose. At the others the vehicle has lost some of its speed; at the last ones
/// it is slow enough for the smallest turns. They lie straight ahead, and on spirals to both sides that are as tight as
/// the speed allows. At a goal the vehicle gains speed on them instead. Circles of attachments are no tighter than the
/// speed there allows. Attachments behind an obstacle are left out.
std::vector<Attachment> fast_attachments(const MovingEnd& end);

/// The way from a moving start to a stop or, at a goal, the way there from a stop: along a line or, where that is not
/// free, on a spiral to either side. The end itself if it is at rest. Nothing if none is free.
std::optional<Attachment> way_to_stop(const MovingEnd& end);

}  // namespace arcway::internal
