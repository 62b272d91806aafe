#include "datasets/map/contacts.h"

#include <map>
#include <utility>

#include "core/geometry/box_tree.h"
#include "core/geometry/crossing_point.h"
#include "core/geometry/predicates.h"
#include "core/geometry/ray_parity.h"

namespace arcway {
namespace {

constexpr std::size_t kScanEdges = 64;  // up to here a scan beats a tree

// Whether b - a and d - c, known to be parallel, point the same way.
bool same_way(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return a.x() != b.x() ? (a.x() < b.x()) == (c.x() < d.x()) : (a.y() < b.y()) == (c.y() < d.y());
}

// A polygon's edges with its interior on their left.
class Region {
 public:
  explicit Region(const Polygon& polygon) {
    add(polygon.outer, 1);
    for (const Ring& hole : polygon.holes) add(hole, -1);
    if (edges_.size() <= kScanEdges) return;
    std::vector<Box> boxes;
    for (const LineSegment& edge : edges_) boxes.push_back(box_of(edge));
    tree_ = BoxTree(boxes);
  }

  [[nodiscard]] const std::vector<LineSegment>& edges() const { return edges_; }
  [[nodiscard]] const std::vector<Vec2>& ring_starts() const { return ring_starts_; }
  [[nodiscard]] const Box& box() const { return box_; }

  [[nodiscard]] bool contains_strictly(const Vec2& p) const {
    if (!box_.contains(p)) return false;
    RayParity parity(p);
    visit(parity.ray_box(), [&](const LineSegment& edge) { parity.add(edge.a, edge.b); });
    return parity.location() == PointLocation::kInside;
  }

  // Whether the way from a point of the boundary towards another one starts inside.
  [[nodiscard]] bool is_entered(const Vec2& p, const Vec2& towards) const {
    Box at;
    at.extend(p);
    bool along_edge = false;
    visit(at, [&](const LineSegment& edge) {
      if (!on_segment(p, edge) || orientation(edge.a, edge.b, towards) != 0) return;
      if ((p != edge.b && same_way(p, towards, edge.a, edge.b)) ||
          (p != edge.a && same_way(p, towards, edge.b, edge.a)))
        along_edge = true;
    });
    if (along_edge) return false;
    StepParity parity(p, towards);
    visit(parity.ray_box(), [&](const LineSegment& edge) { parity.add(edge.a, edge.b); });
    return parity.inside();
  }

 private:
  void add(const Ring& ring, int wanted_winding) {
    const bool as_given = winding(ring) == wanted_winding;
    ring_starts_.push_back(ring.front());
    for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) {
      edges_.push_back(as_given ? LineSegment{ring[last], ring[i]} : LineSegment{ring[i], ring[last]});
      box_.extend(ring[i]);
    }
  }
  template <class Visitor>
  void visit(const Box& where, Visitor&& visitor) const {
    if (tree_.size() == 0) {
      for (const LineSegment& edge : edges_) visitor(edge);
      return;
    }
    tree_.visit_overlaps(where, [&](std::uint32_t i) {
      visitor(edges_[i]);
      return true;
    });
  }

  std::vector<LineSegment> edges_;
  std::vector<Vec2> ring_starts_;
  Box box_;
  BoxTree tree_;
};

// What the boundaries of a pair were seen to do.
struct Meeting {
  bool first_enters = false;   // the first one's boundary has points strictly inside of the second
  bool second_enters = false;  // and the other way round
  bool same_side = false;      // along a common piece of boundary both interiors lie on one side
  bool boundaries_meet = false;
  Vec2 place{0.0, 0.0};
};

class ContactFinder {
 public:
  explicit ContactFinder(std::span<const Polygon> polygons) {
    regions_.reserve(polygons.size());
    for (const Polygon& polygon : polygons) regions_.emplace_back(polygon);
  }

  std::vector<RegionContact> find() {
    compare_edges();
    compare_starts();
    std::vector<RegionContact> contacts;
    for (const auto& [pair, meeting] : meetings_)
      contacts.push_back({pair.first, pair.second, relation_of(meeting), meeting.boundaries_meet, meeting.place});
    return contacts;
  }

 private:
  // Where neither boundary enters the other's interior, the interiors are disjoint or equal, and equal ones have the
  // same side of their common boundary.
  static RegionRelation relation_of(const Meeting& meeting) {
    if (meeting.first_enters && meeting.second_enters) return RegionRelation::kOverlapping;
    if (meeting.first_enters) return RegionRelation::kFirstInside;
    if (meeting.second_enters) return RegionRelation::kSecondInside;
    return meeting.same_side ? RegionRelation::kEqual : RegionRelation::kTouching;
  }

  void compare_edges() {
    std::vector<LineSegment> edges;
    std::vector<std::uint32_t> owners;
    std::vector<Box> boxes;
    for (std::uint32_t r = 0; r < regions_.size(); ++r) {
      for (const LineSegment& edge : regions_[r].edges()) {
        edges.push_back(edge);
        owners.push_back(r);
        boxes.push_back(box_of(edge));
      }
    }
    const BoxTree tree(boxes);
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      tree.visit_overlaps(boxes[i], [&](std::uint32_t j) {
        if (owners[i] < owners[j]) compare(edges[i], owners[i], edges[j], owners[j]);
        return true;
      });
    }
  }

  void compare(const LineSegment& e, std::uint32_t first, const LineSegment& f, std::uint32_t second) {
    const SegmentRelation relation = relate(e, f);
    if (relation == SegmentRelation::kDisjoint) return;
    const bool known = meetings_.contains({first, second});
    Meeting& meeting = meetings_[{first, second}];
    meeting.boundaries_meet = true;
    if (relation == SegmentRelation::kCrossing) {
      meeting.first_enters = meeting.second_enters = true;
      if (!known) meeting.place = crossing_point(e, f);
      return;
    }
    if (relation == SegmentRelation::kOverlapping)
      meeting.same_side = meeting.same_side || same_way(e.a, e.b, f.a, f.b);
    for (const Vec2* p : {&e.a, &e.b, &f.a, &f.b}) {
      if (!on_segment(*p, e) || !on_segment(*p, f)) continue;
      if (!known) meeting.place = *p;
      for (const Vec2* end : {&e.a, &e.b})
        if (!meeting.first_enters && *p != *end) meeting.first_enters = regions_[second].is_entered(*p, *end);
      for (const Vec2* end : {&f.a, &f.b})
        if (!meeting.second_enters && *p != *end) meeting.second_enters = regions_[first].is_entered(*p, *end);
    }
  }

  // Rings that no boundary meets lie inside or outside as a whole.
  void compare_starts() {
    std::vector<Box> boxes;
    for (const Region& region : regions_) boxes.push_back(region.box());
    const BoxTree tree(boxes);
    for (std::uint32_t r = 0; r < regions_.size(); ++r) {
      for (const Vec2& start : regions_[r].ring_starts()) {
        Box at;
        at.extend(start);
        tree.visit_overlaps(at, [&](std::uint32_t other) {
          if (other == r || !regions_[other].contains_strictly(start)) return true;
          const auto pair = std::minmax(r, other);
          const bool known = meetings_.contains(pair);
          Meeting& meeting = meetings_[pair];
          (r < other ? meeting.first_enters : meeting.second_enters) = true;
          if (!known) meeting.place = start;
          return true;
        });
      }
    }
  }

  std::vector<Region> regions_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Meeting> meetings_;
};

}  // namespace

std::vector<RegionContact> find_contacts(std::span<const Polygon> polygons) { return ContactFinder(polygons).find(); }

}  // namespace arcway
