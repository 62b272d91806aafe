#include "core/geometry/simplicity.h"

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/edge_sweep.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {
namespace {

// The edges of a polygon, ring by ring. Where a ring's edges meet there is a chain through that point; an edge that
// passes through a point is a chain as well.
class Chains {
 public:
  explicit Chains(const Polygon& polygon) {
    append(polygon.outer, 0);
    for (std::size_t h = 0; h < polygon.holes.size(); ++h) append(polygon.holes[h], h + 1);
  }

  [[nodiscard]] std::span<const LineSegment> edges() const { return edges_; }
  /// The edge of a chain at a point of it: the one that starts there, or the one that passes.
  [[nodiscard]] std::uint32_t chain_at(const Vec2& p, std::uint32_t e) const {
    return edges_[e].b == p ? following_[e] : e;
  }

  /// The contact of an edge that passes through the vertex at which another one starts.
  [[nodiscard]] RingContact contact(std::uint32_t passing, std::uint32_t starting) const {
    return {places_[passing].ring, places_[passing].index, places_[starting].ring, places_[starting].index};
  }

 private:
  struct Place {
    std::size_t ring, index;
  };

  void append(const Ring& ring, std::size_t ring_index) {
    const auto first = static_cast<std::uint32_t>(edges_.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      places_.push_back({ring_index, i});
      edges_.push_back({ring[i], ring[(i + 1) % ring.size()]});
      following_.push_back(first + static_cast<std::uint32_t>((i + 1) % ring.size()));
    }
  }

  std::vector<LineSegment> edges_;
  std::vector<std::uint32_t> following_;
  std::vector<Place> places_;
};

class ConflictSweep final : public EdgeSweep::Visitor {
 public:
  ConflictSweep(const Chains& chains, std::vector<RingContact>* contacts) : chains_(chains), contacts_(contacts) {}

  bool finds_conflict() { return !EdgeSweep(chains_.edges()).run(*this) || has_conflict_; }

  bool crosses(std::uint32_t /*e*/, std::uint32_t /*f*/) override { return false; }
  void visit(const EdgeSweep::Event& event) override {
    has_conflict_ = has_conflict_ || has_overlap(event.left) || has_overlap(event.right) || chains_cross(event);
    if (contacts_) append_contacts(event);
  }

 private:
  void append_contacts(const EdgeSweep::Event& event) {
    const auto edges = chains_.edges();
    for (const std::uint32_t e : event.left) {
      if (edges[e].a == event.at || edges[e].b == event.at) continue;
      for (const std::uint32_t f : event.ends)
        if (edges[f].a == event.at) contacts_->push_back(chains_.contact(e, f));
    }
  }

  // Edges with a common point, ascending at it: those that leave it the same way are neighbors.
  [[nodiscard]] bool has_overlap(std::span<const std::uint32_t> around) const {
    const auto edges = chains_.edges();
    for (std::size_t i = 0; i + 1 < around.size(); ++i)
      if (relate(edges[around[i]], edges[around[i + 1]]) == SegmentRelation::kOverlapping) return true;
    return false;
  }

  // Chains through a point do not cross if their ends around it nest like brackets.
  bool chains_cross(const EdgeSweep::Event& event) {
    open_.clear();
    const auto meet = [&](std::uint32_t e) {
      const std::uint32_t chain = chains_.chain_at(event.at, e);
      if (!open_.empty() && open_.back() == chain) {
        open_.pop_back();
      } else {
        open_.push_back(chain);
      }
    };
    for (const std::uint32_t e : event.right) meet(e);
    for (auto e = event.left.rbegin(); e != event.left.rend(); ++e) meet(*e);
    return !open_.empty();
  }

  const Chains& chains_;
  std::vector<RingContact>* contacts_;
  std::vector<std::uint32_t> open_;
  bool has_conflict_ = false;
};

// With the outer ring counter-clockwise and the holes clockwise, each place is inside once or not at all.
class NestingSweep final : public EdgeSweep::Visitor {
 public:
  explicit NestingSweep(std::span<const LineSegment> edges) : edges_(edges), depths_(edges, 0) {}

  bool is_nested() { return EdgeSweep(edges_).run(*this) && is_nested_; }

  bool crosses(std::uint32_t /*e*/, std::uint32_t /*f*/) override { return false; }
  void visit(const EdgeSweep::Event& event) override {
    depths_.pass(event);
    for (const std::uint32_t e : event.right)
      is_nested_ = is_nested_ && (depths_.above(e) == 0 || depths_.above(e) == 1);
  }

 private:
  std::span<const LineSegment> edges_;
  SweptDepths depths_;
  bool is_nested_ = true;
};

}  // namespace

bool has_conflict(const Polygon& polygon, std::vector<RingContact>* contacts) {
  return ConflictSweep(Chains(polygon), contacts).finds_conflict();
}

bool holes_are_nested(const Polygon& polygon) {
  std::vector<LineSegment> edges;
  const auto append = [&](const Ring& ring, int wanted_winding) {
    const bool as_given = winding(ring) == wanted_winding;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &p = ring[i], &q = ring[(i + 1) % ring.size()];
      edges.push_back(as_given ? LineSegment{p, q} : LineSegment{q, p});
    }
  };
  append(polygon.outer, 1);
  for (const Ring& hole : polygon.holes) append(hole, -1);
  return NestingSweep(edges).is_nested();
}

}  // namespace arcway::internal
