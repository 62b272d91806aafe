#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "arcway/stop_clock.h"
#include "core/attach/roadmap.h"
#include "core/base/huge_pages.h"
#include "core/roadmap/turn_circle.h"

namespace arcway::internal {

/// A pose from which, or to which, the search connects to the graph.
struct Attachment {
  Pose pose;
  Path connection;  ///< from the start to `pose`, or from `pose` to the goal; empty for start and goal themselves
  /// Another attachment's circle to this side passes through `pose`, so that it has all straights of this one's.
  std::optional<Side> shared = {};
};

/// Which end of the path.
enum class Direction { kFromStart, kToGoal };

/// One of the circles by which a attachment joins the graph.
struct AttachmentCircle {
  std::uint32_t attachment;
  TurnCircle circle;
  double heading;  ///< of the attachment's pose
  double reach;    ///< how far the circle is free from there [rad], backwards for goals; negative: not at all
};

/// A straight between a attachment's circle and one of the graph. The body is free on the attachment's circle; the
/// graph's circle and the swept rectangle remain to be checked.
struct AttachmentLink {
  std::uint32_t attachment_circle;
  std::uint32_t circle;
  Bitangent line;
  double turn;  ///< on the attachment's circle [rad]
};

/// Appends the left and right circles of every radius for each attachment from the `first` on, of the smallest for
/// those with a connection; none that another attachment has as well. O(attachments * radii) heading sets, each in
/// `headings`, whose memory is used again.
/// @param clock  ends that before all attachments have theirs.
void append_circles(const Roadmap& map, std::span<const Attachment> attachments, std::size_t first, Direction direction,
                    HeadingSet& headings, std::vector<AttachmentCircle>& circles, const StopClock& clock = {});

/// How long a path may be between a attachment and the other end of the path, and how many straights it may join by.
struct LengthLimit {
  Vec2 other_end;
  double length;  ///< [m]; infinity: as long as it likes
  std::size_t most_links = std::numeric_limits<std::size_t>::max();
};

/// Appends the straights between circles[index] and the graph, but for some that are certainly blocked, or on no path
/// within the limit. Looks only at circles of pieces of outline that those nearer by do not hide. Of more straights
/// than the limit allows, those to the nearest pieces are kept.
/// @param pieces  memory.
void append_links(const Roadmap& map, std::span<const AttachmentCircle> circles, std::uint32_t index,
                  Direction direction, const LengthLimit& limit, std::vector<std::uint32_t>& pieces,
                  HugeVector<AttachmentLink>& links);

}  // namespace arcway::internal
