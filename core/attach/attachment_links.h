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

/// A pose from which a search joins the roadmap, or to which it leads from there.
struct Attachment {
  Pose pose;
  Path connection;  ///< from the start to `pose`, or from `pose` to the goal; empty for start and goal themselves
  /// Set if the circle of another attachment to this side passes through `pose`. That circle then has all straights of
  /// this one's.
  std::optional<Side> shared = {};
  double tightest = 0.0;  ///< least radius of its circles [m]; infinity: it has none
};

/// The end of the path that a function works at.
enum class Direction { kFromStart, kToGoal };

/// A circle by which an attachment joins the roadmap: it starts at the attachment's pose.
struct AttachmentCircle {
  std::uint32_t attachment;
  TurnCircle circle;
  double heading;  ///< of the attachment's pose [rad]
  double reach;    ///< free turn from there [rad], backwards for goals; negative: not even the pose is free
};

/// A straight between a circle of an attachment and a circle of the roadmap. The body is free on the attachment's
/// circle. The roadmap's circle and the swept rectangle remain to be checked.
struct AttachmentLink {
  std::uint32_t attachment_circle;
  std::uint32_t circle;
  Bitangent line;
  double turn;  ///< on the attachment's circle [rad]
};

/// Limits for the straights of one attachment.
struct LengthLimit {
  /// The other end of the path [m]. Straights on no path of at most `length` [m] between it and the attachment are left
  /// out.
  Vec2 other_end;
  double length;  ///< [m]; infinity: no limit
  std::size_t most_links = std::numeric_limits<std::size_t>::max();
};

/// Whether no straight is left out for there are too many.
inline bool is_all(const LengthLimit& limit) { return limit.most_links == std::numeric_limits<std::size_t>::max(); }
/// Whether straights between a circle of the attachment and another one are on no path within the limit.
bool is_beyond(const LengthLimit& limit, const TurnCircle& own, const TurnCircle& other);

/// One end of the paths on a roadmap.
struct PathEnd {
  const Roadmap& map;
  Direction direction;
  std::size_t radii = std::numeric_limits<std::size_t>::max();  ///< of its circles, from the smallest on
  StopClock clock = {};                                         ///< may end the finding of circles and straights
};

/// Finds circles and straights by which attachments join the roadmap. Memory is kept for the next call.
class AttachmentLinks {
 public:
  /// Appends the circles of all attachments from `first` on: left and right ones of the end's radii, or of the smallest
  /// radius for attachments with a connection. Radii below an attachment's tightest one are replaced by that. Circles
  /// that another attachment has too are left out. If the clock is over before, some attachments have none.
  /// O(attachments * radii) heading sets.
  void append_circles(const PathEnd& end, std::span<const Attachment> attachments, std::size_t first,
                      std::vector<AttachmentCircle>& circles);

  /// Appends the straights between circles[index] and the roadmap. Those are left out that are certainly blocked, or on
  /// no path within the limit. Only circles at pieces of outline that nearer ones do not hide are examined. Of more
  /// straights than the limit allows, those to the nearest pieces are kept.
  /// @return false, and none is appended, if the clock is over before all are found.
  bool append_links(const PathEnd& end, std::span<const AttachmentCircle> circles, std::uint32_t index,
                    const LengthLimit& limit, HugeVector<AttachmentLink>& links);

  /// A piece of outline near a circle.
  struct NearPiece {
    double distance;      ///< of its box from the circle's center [m]
    VertexId first;       ///< see Outlines::Piece
    std::uint32_t index;  ///< among the outlines
  };

 private:
  HeadingSet headings_;            // memory
  std::vector<NearPiece> pieces_;  // memory
};

}  // namespace arcway::internal
