#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arcway/heading_set.h"

namespace arcway {

/// How many bitangents a feasible visibility graph has, and why others were rejected.
struct FeasibleGraphCounts {
  std::uint64_t circles = 0;          ///< turn circles of convex vertices
  std::uint64_t circles_blocked = 0;  ///< circles without any free heading
  /// Directed pairs of circles around neighbors in the reduced graph. Of a lazy graph, those examined so far.
  std::uint64_t candidates = 0;
  std::uint64_t repeated = 0;            ///< candidates met before, of circles around two vertices
  std::uint64_t kept = 0;                ///< feasible bitangents
  std::uint64_t rejected_overlap = 0;    ///< the circles overlap, so that there is no bitangent
  std::uint64_t rejected_departure = 0;  ///< (7): the body collides on the first circle at that heading
  std::uint64_t rejected_arrival = 0;    ///< (7): the body collides on the second circle at that heading
  std::uint64_t rejected_straight = 0;   ///< (6): the swept rectangle meets an obstacle
};

/// A directed bitangent between two turn circles.
struct FeasibleLink {
  std::uint32_t from;  ///< circle
  std::uint32_t to;    ///< circle
  double heading;      ///< of the bitangent [rad], in [0, 2 pi)
  double length;       ///< [m]
};

/// The counts of FeasibleGraphCounts for the bitangents that leave one circle.
struct LinkCounts {
  std::uint32_t candidates = 0;
  std::uint32_t repeated = 0;
  std::uint32_t overlaps = 0;
  std::uint32_t departures = 0;
  std::uint32_t arrivals = 0;
  std::uint32_t straights = 0;
};

/// An eager feasible visibility graph as flat arrays, in compressed rows of one circle each.
struct FeasibleGraphSnapshot {
  std::vector<std::uint64_t> interval_starts;  ///< circles + 1 offsets into `intervals`
  std::vector<HeadingInterval> intervals;      ///< free headings [rad]
  std::vector<std::uint64_t> link_starts;      ///< circles + 1 offsets into `links`
  std::vector<FeasibleLink> links;             ///< feasible bitangents, by heading, then `to`
  std::vector<LinkCounts> link_counts;         ///< by circle
};

}  // namespace arcway
