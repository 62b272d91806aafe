#include "core/search/surroundings.h"

#include <algorithm>

#include "core/search/effort.h"
#include "core/search/forward_tree.h"

namespace arcway::internal {

namespace {

enum class End { kOut, kDry, kLimit };

struct Growth {
  End end;
  std::size_t poses;
};

// Grows a tree outwards: poses far from the root take their turns first.
Growth grow(const PathEnd& end, const Pose& root, const TreePass& pass, std::size_t most, const StopClock& clock) {
  const double dead_end = dead_end_radius(end.map);
  ForwardTree tree(end.map, root, end.direction, pass, [&](const Pose& pose) {
    return kTree.greed * (dead_end - (pose.position() - root.position()).norm());
  });
  std::size_t poses = 0;
  for (; poses < most; ++poses) {
    if (tree.extent() >= dead_end || clock.is_over()) return {End::kOut, poses};
    if (!tree.expand()) return {End::kDry, poses};
  }
  return {End::kLimit, poses};
}

}  // namespace

double dead_end_radius(const Roadmap& map) {
  return kTree.dead_end * std::max(map.vehicle.min_turning_radius(), map.body.front + map.body.rear);
}

ExploredSurroundings explore_surroundings(const Roadmap& map, const Pose& root, Direction direction,
                                          const SurroundingsEffort& effort, const StopClock& clock) {
  const PathEnd end{map, direction};
  const Growth coarse = grow(end, root, effort.coarse, effort.poses, clock);
  if (coarse.end != End::kDry) return {Surroundings::kOpen, coarse.poses};
  if (coarse.poses > effort.small) return {Surroundings::kDeadEnd, coarse.poses};
  const auto most = static_cast<std::size_t>(effort.more * static_cast<double>(coarse.poses)) + 1;
  const Growth fine = grow(end, root, effort.fine, most, clock);
  return {fine.end == End::kDry ? Surroundings::kClosed : Surroundings::kOpen, coarse.poses + fine.poses};
}

}  // namespace arcway::internal
