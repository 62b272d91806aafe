#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "arcway/datasets/map_file.h"
#include "arcway/export.h"
#include "arcway/vec2.h"

namespace arcway {

enum class FindingKind {
  kClosingVertex,    ///< a ring that repeats its first vertex at its end, more often than its format wants
  kRepeatedVertex,   ///< consecutive vertices in one place
  kCollinearVertex,  ///< a vertex on the straight line between its neighbors
  kOrientation,      ///< a clockwise outer ring, a counter-clockwise hole
  kTooFewVertices,   ///< fewer than three different ones
  kOutOfRange,       ///< a coordinate that is not finite, or out of the exact range of vec2.h
  kZeroArea,         ///< a ring without area
  kSelfCrossing,     ///< edges of one polygon that cross
  kEdgesOverlap,     ///< edges of one polygon that run along each other
  kSelfTouching,     ///< rings of one polygon that touch each other or themselves
  kMisplacedHole,    ///< a hole outside of its outer ring or inside another hole
  kOverlap,          ///< obstacles that have area in common
  kContainment,      ///< an obstacle inside another one
  kDuplicate,        ///< the same region twice
  kTouching,         ///< obstacles that touch
  kCrossesBounds,    ///< an obstacle that sticks out of the bounds
  kOutsideBounds,    ///< an obstacle that lies outside of them
  kUnlistedPairs,    ///< more pairs that touch, overlap or lie in each other than are listed
  kDegrees,          ///< coordinates that are degrees by the file, or look like degrees
  kFarFromOrigin,    ///< coordinates so large that doubles are coarse
  kZone,             ///< a zone, whatever it is
  kZoneRule          ///< a zone with numbers or names that World refuses
};
/// "self-crossing", "overlap", ...
ARCWAY_API const char* name_of(FindingKind kind);
/// What planning does with it, a sentence.
ARCWAY_API const char* consequence_of(FindingKind kind);
/// Whether planning refuses the map for it, of robots with the default safety margin.
ARCWAY_API bool is_refused(FindingKind kind);

struct Finding {
  FindingKind kind;
  std::string place;       ///< "feature 3, ring 1, vertex 12"; empty if it is the whole map
  std::optional<Vec2> at;  ///< where that is
  std::string what;        ///< what was found there
};

struct ARCWAY_API DoctorReport {
  std::vector<Finding> findings;  ///< ring by ring, zone by zone, then pair by pair, then the map
  std::size_t obstacles = 0;
  std::size_t vertices = 0;  ///< as written
  /// Whether planning takes the map as it is.
  [[nodiscard]] bool plans() const;
};

/// What is unusual or wrong in a map, with its place and what planning does with it. Works on maps that World refuses;
/// polygons that it would refuse are not compared with others. All decisions are exact but kDegrees and
/// kFarFromOrigin, which are thresholds. O(n log n) where few edges cross, and in the number of findings. Of n
/// obstacles 100,000 + 8 n pairs are listed at most.
/// @param map  rings as written: see VectorOptions::as_written.
ARCWAY_API DoctorReport examine(const MapFile& map);

/// The map as World can take it at best without moving a vertex: closing and repeated vertices dropped, outer rings
/// counter-clockwise and holes clockwise.
ARCWAY_API MapFile without_repetitions(MapFile map);

}  // namespace arcway
