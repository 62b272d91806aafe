#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arcway/export.h"
#include "arcway/polygon.h"
#include "arcway/world.h"

namespace arcway {

enum class ClutterKind {
  kConvex,    ///< vertices on a circle, strictly convex
  kStar,      ///< radius jittered vertex by vertex: simple, with reflex vertices (from 4 vertices on)
  kMixed,     ///< each obstacle convex or star, by chance
  kRectangle  ///< rectangles of any heading and aspect 1 to 4; `vertices` is ignored (4)
};
/// "convex", "star", "mixed", "rectangle".
ARCWAY_API const char* name_of(ClutterKind kind);

struct ClutterParameters {
  ClutterKind kind = ClutterKind::kConvex;
  std::size_t obstacles = 100;  ///< up to 2^28 vertices in all
  std::size_t vertices = 8;     ///< vertices of each obstacle, >= 3
  double fill = 0.2;            ///< sum of the obstacles' areas / area of the bounds, met to rounding; in (0, 0.6],
                                ///< and not so small that the bounds are longer than 1e9 m
  double min_gap = 0.2;         ///< at least this between two obstacles, and between obstacle and bounds [m]
  double min_radius = 2.0;      ///< smallest radius of the circumscribed circles [m], uniform
  double max_radius = 8.0;      ///< [m]
  std::uint64_t seed = 1;
};

struct Clutter {
  std::vector<Polygon> obstacles;  ///< outer rings counter-clockwise, no holes
  Ring bounds;                     ///< a square with its lower left corner at the origin, counter-clockwise
};

/// Disjoint random obstacles in a square, the same on every platform for the same parameters. O(obstacles * vertices).
///
/// 1. Each obstacle is drawn on its own. The square's side follows from the sum of their areas and `fill`.
/// 2. Obstacles are placed at random, largest first, where their circumscribed circles keep the gap.
/// 3. A field too full for that (from a fill of about 0.35) is packed instead. The same square is cut into a jittered
///    grid, and each obstacle is drawn again and stretched to its cell, as irregular as the fill allows. Rectangles are
///    then axis-parallel and triangles right-angled, and the radii only set the scale.
/// @throws std::invalid_argument naming the parameter, its value and its limit, or saying that fill and gap exclude
///   each other.
ARCWAY_API Clutter generate_clutter(const ClutterParameters& parameters);

/// The clutter as a World, bounds included.
ARCWAY_API World random_world(const ClutterParameters& parameters);

}  // namespace arcway
