#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/attach/search_map.h"
#include "core/base/huge_pages.h"
#include "core/base/stop_clock.h"
#include "core/roadmap/turn_circle.h"

namespace [[gnu::visibility("default")]] arcway {

/// A pose from which, or to which, the search connects to the graph.
struct Terminal {
  Pose pose;
  Path connection;  ///< from the start to `pose`, or from `pose` to the goal; empty for start and goal themselves
  /// Another terminal's circle to this side passes through `pose`, so that it has all straights of this one's.
  std::optional<Side> shared = {};
};

/// Which end of the path.
enum class Direction { kFromStart, kToGoal };

/// One of the circles by which a terminal joins the graph.
struct TerminalCircle {
  std::uint32_t terminal;
  TurnCircle circle;
  double heading;  ///< of the terminal's pose
  double reach;    ///< how far the circle is free from there [rad], backwards for goals; negative: not at all
};

/// A straight between a terminal's circle and one of the graph. The body is free on the terminal's circle; the graph's
/// circle and the swept rectangle remain to be checked.
struct TerminalLink {
  std::uint32_t terminal_circle;
  std::uint32_t circle;
  Bitangent line;
  double turn;  ///< on the terminal's circle [rad]
};

/// Appends the left and right circles of every radius for each terminal from the `first` on, of the smallest for those
/// with a connection; none that another terminal has as well.
/// O(terminals * radii) heading sets, each in `headings`, whose memory is used again.
/// @param clock  ends that before all terminals have theirs.
void append_circles(const SearchMap& map, std::span<const Terminal> terminals, std::size_t first, Direction direction,
                    HeadingSet& headings, std::vector<TerminalCircle>& circles, const StopClock& clock = {});

/// How long a path may be between a terminal and the other end of the path, and how many straights it may join by.
struct WayLimit {
  Vec2 other_end;
  double length;  ///< [m]; infinity: as long as it likes
  std::size_t most_links = std::numeric_limits<std::size_t>::max();
};

/// Appends the straights between circles[index] and the graph, but for some that are certainly blocked, or on no path
/// within the limit. Looks only at circles of pieces of outline that those nearer by do not hide. Of more straights
/// than the limit allows, those to the nearest pieces are kept.
/// @param pieces  memory.
void append_links(const SearchMap& map, std::span<const TerminalCircle> circles, std::uint32_t index,
                  Direction direction, const WayLimit& limit, std::vector<std::uint32_t>& pieces,
                  HugeVector<TerminalLink>& links);

}  // namespace arcway
