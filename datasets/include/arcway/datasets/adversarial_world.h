#pragma once

#include <cstddef>
#include <cstdint>

#include "arcway/datasets/map_file.h"
#include "arcway/export.h"

namespace arcway {

/// Legal maps made to break predicates and builders. Distances between obstacles that do not touch are a few meters.
enum class AdversarialKind {
  kTouching,     ///< corner on corner, corner on edge, parts of edges, three obstacles in a point, rings with a pinch
  kShared,       ///< whole edges in common: boxes side by side, fans, notches and holes filled exactly
  kCollinear,    ///< rows and columns of equal boxes, half of them with vertices in the middle of their edges
  kNeedles,      ///< nearly parallel triangles meters long, a millimeter to a nanometer wide
  kFar,          ///< a clutter near (8e6, -8e6)
  kNested,       ///< obstacles inside obstacles, inside holes, and holes inside those
  kOverlapping,  ///< stars that cross each other, some of them twice in the same place
  kContacts,     ///< random cells of a grid, each a square of its own
  kHoles,        ///< obstacles with many holes: in rows, touching each other, touching the outer ring
  kSaw,          ///< one obstacle: teeth of 1 m to 3 m around a circle, all seen from the corners of the bounds
  kComb,         ///< one obstacle: teeth side by side whose tips lie on a line
  kSpikes,       ///< one obstacle: needles around a disc, longer than it is wide
  kRings         ///< squares with a hole in each other's holes, all around one point
};
inline constexpr AdversarialKind kAdversarialKinds[] = {
    AdversarialKind::kTouching, AdversarialKind::kShared, AdversarialKind::kCollinear,   AdversarialKind::kNeedles,
    AdversarialKind::kFar,      AdversarialKind::kNested, AdversarialKind::kOverlapping, AdversarialKind::kContacts,
    AdversarialKind::kHoles,    AdversarialKind::kSaw,    AdversarialKind::kComb,        AdversarialKind::kSpikes,
    AdversarialKind::kRings};
/// "touching", "shared", ...
ARCWAY_API const char* name_of(AdversarialKind kind);

struct AdversarialParameters {
  AdversarialKind kind = AdversarialKind::kTouching;
  std::size_t vertices = 1000;  ///< number of vertices, obstacles and bounds together, about; 100 to 10 million
  std::uint64_t seed = 1;
};

/// A map that World takes, with bounds, the same on every platform for the same parameters. From 1,000 vertices on
/// their number is met within 5 %. Coordinates of contacts are whole numbers, so that what should touch does.
/// O(vertices) time and memory.
/// @throws std::invalid_argument naming the parameter, its value and its limit.
ARCWAY_API MapFile generate_adversarial_world(const AdversarialParameters& parameters);

}  // namespace arcway
