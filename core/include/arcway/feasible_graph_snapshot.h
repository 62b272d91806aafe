#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arcway/heading_set.h"

namespace arcway {

/// Bitangents in, and why the others are out.
struct FeasibleGraphCounts {
  std::uint64_t circles = 0;          ///< turn circles of convex vertices, see TurnCircles
  std::uint64_t circles_blocked = 0;  ///< those without any free heading
  std::uint64_t candidates = 0;       ///< directed, between circles of the reduced graph's neighbors and beyond;
                                      ///< if lazy, those looked at so far
  std::uint64_t repeated = 0;         ///< those of circles round two vertices that were candidates before
  std::uint64_t kept = 0;
  std::uint64_t rejected_overlap = 0;    ///< no bitangent: circles overlap
  std::uint64_t rejected_departure = 0;  ///< (7): the body collides on the first circle at that heading
  std::uint64_t rejected_arrival = 0;    ///< (7): ... on the second circle
  std::uint64_t rejected_straight = 0;   ///< (6): the swept rectangle meets an obstacle
};

/// A directed bitangent between two turn circles.
struct FeasibleLink {
  std::uint32_t from;  ///< circle
  std::uint32_t to;    ///< circle
  double heading;      ///< [0, 2 pi)
  double length;       ///< [m]
};

/// Bitangents that leave one circle, and why they are out; FeasibleGraphCounts adds them up.
struct LinkCounts {
  std::uint32_t candidates = 0;
  std::uint32_t repeated = 0;
  std::uint32_t overlaps = 0;
  std::uint32_t departures = 0;
  std::uint32_t arrivals = 0;
  std::uint32_t straights = 0;
};

/// All that an eager feasible graph has found out, in compressed rows, one a circle.
struct FeasibleGraphSnapshot {
  std::vector<std::uint64_t> interval_starts;  ///< circles + 1, into `intervals`
  std::vector<HeadingInterval> intervals;      ///< free headings
  std::vector<std::uint64_t> link_starts;      ///< circles + 1, into `links`
  std::vector<FeasibleLink> links;             ///< those kept, by heading, then `to`
  std::vector<LinkCounts> link_counts;         ///< by circle
};

}  // namespace arcway
