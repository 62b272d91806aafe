#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/model/outlines.h"
#include "core/refine/chain_terms.h"

namespace arcway::internal {

/// What the body may come to touch as a chain moves: corners of obstacles beside the path, and edges that the outer
/// corners of the body swing towards. Each contact has a smooth distance, which is positive where it is free; together
/// they say what the body sweeps, up to rounding. Only what begins near the path is known. Which side a corner is
/// passed on is decided once, on a free path; a body that overlaps it later is pushed back there.
class ChainContacts {
 public:
  /// Where a contact's distance is the least: a part of the path, and a place of the body there. Part 2 i is line i,
  /// part 2 i + 1 is arc i.
  struct Place {
    std::uint32_t part = 0;
    std::uint8_t kind = 0;
    double distance = 0.0;  ///< infinite where nothing can be touched [m]
    [[nodiscard]] bool is_on_line() const { return part % 2 == 0; }
    [[nodiscard]] std::size_t index() const { return part / 2; }  ///< of the line or arc
  };

  /// The body on each part of a path: a rectangle, and how far it is grown on some parts.
  struct Bodies {
    Bodies(const Footprint& b, std::span<const double> g = {}) : body(b), growths(g) {}
    Footprint body;
    std::span<const double> growths;  ///< by part [m]; empty: none
  };
  /// Where contacts are looked for.
  struct Around {
    const World& world;
    const Outlines& outlines;  ///< of the world
    double reach;              ///< distance from the path [m]
    StopClock clock = {};
  };
  /// Finds all contacts of a free chain. False, and some are missing, if the clock is over before.
  [[nodiscard]] bool find(const ArcChain& chain, const Around& around, const Bodies& bodies);

  [[nodiscard]] std::size_t size() const { return corners_.size() + edges_.size(); }
  /// The least distance of a contact.
  [[nodiscard]] Place look(const ArcChain& chain, std::size_t contact) const;
  /// The least distance in a chain that has moved: a corner may be seen from more parts of the path than before.
  Place look_around(const ArcChain& chain, std::size_t contact);
  /// How far a chain must move at least before a contact that nothing can touch now comes to lie nearer than `near`.
  /// Corners are not looked at: 0.
  [[nodiscard]] double room(const ArcChain& chain, std::size_t contact, double near) const;
  /// The distance at such a place, with its derivatives by the numbers of that line or arc.
  [[nodiscard]] Term term(const ArcChain& chain, std::size_t contact, const Place& place) const;

 private:
  // A corner of an obstacle, and the consecutive parts of the path that may touch it.
  struct Corner {
    Vec2 place;
    double sign;  // +1: it lies to the left of the path
    std::uint32_t first, last;
  };
  // An edge of an obstacle, and the arc on which a corner of the body swings towards it.
  struct Edge {
    Vec2 from, along, outwards;  // unit vectors
    double length;
    std::uint32_t arc;
    double ahead;  // of the reference point: where the body's corner is [m], negative for the rear one
  };
  // A corner near one part of the path.
  struct Sight {
    std::uint32_t vertex, part;
    double distance;  // of the path, infinite where it is not abeam
    double sign;
  };

  // Those of one part; false if the clock is over.
  [[nodiscard]] bool find_near(const ArcChain& chain, std::uint32_t part, const Around& around, StopTicker& ticker);
  void add_sight(const ArcChain& chain, std::uint32_t part, const World& world, VertexId vertex);
  void add_edges(const ArcChain& chain, std::uint32_t arc, const Around& around, VertexId vertex);
  void add_corners(const ArcChain& chain, const World& world, std::size_t first, std::size_t last);
  [[nodiscard]] Place look_from(const ArcChain& chain, const Corner& corner, std::uint32_t part) const;
  [[nodiscard]] Place look_from_line(const ArcChain& chain, const Corner& corner, std::uint32_t part) const;
  [[nodiscard]] Place look_from_arc(const ArcChain& chain, const Corner& corner, std::uint32_t part) const;
  [[nodiscard]] Place look_at(const ArcChain& chain, const Edge& edge) const;
  [[nodiscard]] Term line_term(const ArcChain& chain, const Corner& corner, const Place& place) const;
  [[nodiscard]] Term arc_term(const ArcChain& chain, const Corner& corner, const Place& place) const;
  [[nodiscard]] Term edge_term(const ArcChain& chain, const Edge& edge, const Place& place) const;
  [[nodiscard]] bool is_seen(const Place& place) const;
  [[nodiscard]] double body_length() const { return body_.length(); }
  [[nodiscard]] double growth(std::uint32_t part) const { return growths_.empty() ? 0.0 : growths_[part]; }
  // How far the body on a part reaches to the left, by a sign of +1, or to the right; ahead and behind.
  [[nodiscard]] double beside(double sign, std::uint32_t part) const {
    return (sign > 0.0 ? body_.left : body_.right) + growth(part);
  }
  [[nodiscard]] double front(std::uint32_t part) const { return body_.front + growth(part); }
  [[nodiscard]] double rear(std::uint32_t part) const { return body_.rear + growth(part); }
  // How far its outer side lies from the center of an arc.
  [[nodiscard]] double outwards_on(const ArcChain::Arc& arc, std::uint32_t part) const {
    return arc.radius + beside(-arc.sign, part);
  }

  Footprint body_{};
  std::vector<double> growths_;  // by part [m]; empty: none
  std::vector<Corner> corners_;
  std::vector<Edge> edges_;
  std::vector<Sight> sights_;
  std::vector<VertexId> near_;
};

}  // namespace arcway::internal
