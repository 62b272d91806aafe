#include "datasets/map/contacts.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/geometry/box_tree.h"
#include "core/geometry/crossing_point.h"
#include "core/geometry/edge_sweep.h"
#include "core/geometry/predicates.h"
#include "core/geometry/ray_parity.h"

namespace arcway::internal {
namespace {

constexpr std::size_t kScanEdges = 64;  // up to here a scan beats a tree
// Edges and regions to be looked at for each edge, until a sweep over all edges takes the place of trees over boxes.
constexpr std::size_t kPatience = 128;

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
  // The first vertex of each ring, the outer ring first.
  [[nodiscard]] const std::vector<Vec2>& ring_starts() const { return ring_starts_; }
  // By edge: its ring.
  [[nodiscard]] const std::vector<std::uint32_t>& rings() const { return rings_; }
  [[nodiscard]] const Box& box() const { return box_; }

  // @param looks  how many edges were looked at is added.
  [[nodiscard]] bool contains_strictly(const Vec2& p, std::size_t& looks) const {
    if (!box_.contains(p)) return false;
    RayParity parity(p);
    visit(parity.ray_box(), [&](const LineSegment& edge) {
      ++looks;
      parity.add(edge.a, edge.b);
    });
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
      rings_.push_back(static_cast<std::uint32_t>(ring_starts_.size() - 1));
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
  std::vector<std::uint32_t> rings_;
  std::vector<Vec2> ring_starts_;
  Box box_;
  BoxTree tree_;
};

// What is known about the boundaries of a pair of polygons.
struct Meeting {
  bool first_enters = false;   // the boundary of the first has points strictly inside the second
  bool second_enters = false;  // the boundary of the second has points strictly inside the first
  bool same_side = false;      // along a common piece of boundary both interiors lie on one side
  bool boundaries_meet = false;
  Vec2 place{0.0, 0.0};
};

// The regions that contain a position, as a list that shares its tail with others. The list of a position inside some
// ring is that of the position beside the ring with one region more, or one less.
class Holders {
 public:
  static constexpr std::uint32_t kNobody = 0xFFFFFFFFu;

  [[nodiscard]] std::uint32_t with(std::uint32_t region, std::uint32_t rest) { return add({region, true, rest}); }
  [[nodiscard]] std::uint32_t without(std::uint32_t region, std::uint32_t rest) {
    if (rest != kNobody && links_[rest].holds && links_[rest].region == region) return links_[rest].rest;
    return add({region, false, rest});
  }
  /// @param visit  returns false to end.
  template <class Visitor>
  void visit(std::uint32_t list, Visitor&& visit) const {
    std::vector<std::uint32_t> left_out;
    for (; list != kNobody; list = links_[list].rest) {
      const Link& link = links_[list];
      const auto known = std::find(left_out.begin(), left_out.end(), link.region);
      if (!link.holds) {
        left_out.push_back(link.region);
      } else if (known != left_out.end()) {
        left_out.erase(known);
      } else if (!visit(link.region)) {
        return;
      }
    }
  }

 private:
  struct Link {
    std::uint32_t region;
    bool holds;
    std::uint32_t rest;
  };
  std::uint32_t add(const Link& link) {
    links_.push_back(link);
    return static_cast<std::uint32_t>(links_.size() - 1);
  }

  std::vector<Link> links_;
};

class ContactFinder {
 public:
  ContactFinder(std::span<const Polygon> polygons, std::size_t most) : most_(most) {
    regions_.reserve(polygons.size());
    for (const Polygon& polygon : polygons) regions_.emplace_back(polygon);
    std::vector<Box> boxes;
    for (std::uint32_t r = 0; r < regions_.size(); ++r) {
      boxes.push_back(regions_[r].box());
      for (const LineSegment& edge : regions_[r].edges()) {
        edges_.push_back(edge);
        owners_.push_back(r);
      }
    }
    region_tree_ = BoxTree(boxes);
    boxes.clear();
    for (const LineSegment& edge : edges_) boxes.push_back(box_of(edge));
    edge_tree_ = BoxTree(boxes);
  }

  std::vector<RegionContact> find() {
    looks_left_ = kPatience * edges_.size();
    const auto goes_on = [&] { return looks_left_ > 0 && !is_full(); };
    for (std::uint32_t e = 0; e < edges_.size() && goes_on(); ++e) compare_edge(e, Partners::kLater);
    for (std::uint32_t r = 0; r < regions_.size() && goes_on(); ++r)
      for (const Vec2& start : regions_[r].ring_starts()) find_holders(r, start, region_tree_, nullptr);
    if (looks_left_ == 0) find_by_sweep();
    if (is_full()) complete();
    std::vector<RegionContact> contacts;
    for (const auto& [pair, meeting] : meetings_)
      contacts.push_back({pair.first, pair.second, relation_of(meeting), meeting.boundaries_meet, meeting.place});
    return contacts;
  }

 private:
  friend class ContactSweep;

  // Where neither boundary enters the other's interior, the interiors are disjoint or equal, and equal ones have the
  // same side of their common boundary.
  static RegionRelation relation_of(const Meeting& meeting) {
    if (meeting.first_enters && meeting.second_enters) return RegionRelation::kOverlapping;
    if (meeting.first_enters) return RegionRelation::kFirstInside;
    if (meeting.second_enters) return RegionRelation::kSecondInside;
    return meeting.same_side ? RegionRelation::kEqual : RegionRelation::kTouching;
  }

  [[nodiscard]] bool is_full() const { return meetings_.size() >= most_; }
  void look(std::size_t count) { looks_left_ -= std::min(looks_left_, count); }

  enum class Partners { kAll, kLater };
  // With the edges of other regions.
  void compare_edge(std::uint32_t e, Partners partners) {
    const Box around = box_of(edges_[e]);
    const auto is_near = [&](const Box& box) {
      look(1);
      return box.overlaps(around);
    };
    edge_tree_.visit_if(is_near, [&](std::uint32_t f) {
      if (owners_[e] < owners_[f]) compare(edges_[e], owners_[e], edges_[f], owners_[f]);
      if (owners_[e] > owners_[f] && partners == Partners::kAll) compare(edges_[f], owners_[f], edges_[e], owners_[e]);
      return !is_full();
    });
  }

  // @param first  of a pair, before the second.
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

  // Rings that no boundary meets lie inside or outside as a whole: those of a region, by their starts.
  // @param tree  of boxes of regions. @param names  of these, by their places in the tree; null: their own.
  void find_holders(std::uint32_t r, const Vec2& start, const BoxTree& tree, const std::vector<std::uint32_t>* names) {
    Box at;
    at.extend(start);
    tree.visit_overlaps(at, [&](std::uint32_t i) {
      const std::uint32_t other = names ? (*names)[i] : i;
      std::size_t looks = 1;
      if (other != r && regions_[other].contains_strictly(start, looks)) add_holder(r, other, start);
      look(looks);
      return !is_full();
    });
  }
  void add_holder(std::uint32_t r, std::uint32_t other, const Vec2& start) {
    const auto pair = std::minmax(r, other);
    const bool known = meetings_.contains(pair);
    Meeting& meeting = meetings_[pair];
    (r < other ? meeting.first_enters : meeting.second_enters) = true;
    if (!known) meeting.place = start;
  }

  void find_by_sweep();
  void complete();

  std::size_t most_;
  std::vector<Region> regions_;
  std::vector<LineSegment> edges_;
  std::vector<std::uint32_t> owners_;  // by edge
  BoxTree edge_tree_, region_tree_;
  std::size_t looks_left_ = 0;  // at edges and regions, about
  std::map<std::pair<std::uint32_t, std::uint32_t>, Meeting> meetings_;
};

// Finds the edges of different regions that meet, from left to right, and the region that holds each ring that meets no
// other one. Of two regions that cross, one is left out.
class ContactSweep final : public EdgeSweep::Visitor {
 public:
  explicit ContactSweep(ContactFinder& finder)
      : finder_(finder),
        is_left_out_(finder.regions_.size(), false),
        has_come_before_(finder.regions_.size(), false),
        sides_(finder.edges_, 0) {
    for (std::uint32_t r = 0; r < finder.regions_.size(); ++r) {
      for (std::size_t i = 0; i < finder.regions_[r].ring_starts().size(); ++i) rings_.push_back({r, i});
      for (const std::uint32_t ring : finder.regions_[r].rings()) {
        const auto last = static_cast<std::uint32_t>(rings_.size() - finder.regions_[r].ring_starts().size());
        ring_of_.push_back(last + ring);
      }
    }
  }

  // Without the regions left out, nothing crosses: then what is below a ring is known.
  void run() {
    sweep();
    if (std::ranges::find(is_left_out_, true) != is_left_out_.end()) sweep();
    for (const std::uint32_t r : order_)
      rings_[r].is_alone =
          rings_[r].is_alone && (rings_[r].below == EdgeSweep::kNoEdge || rings_[rings_[r].below].is_alone);
  }

  // A ring: its region, its number there, and the regions that contain what lies beside it.
  struct Ring {
    std::uint32_t region;
    std::size_t index;
    std::uint32_t below = EdgeSweep::kNoEdge;  // ring
    std::uint32_t holders = Holders::kNobody;
    bool is_alone = false;  // neither it nor a ring on whose account its holders are known meets another ring
  };
  [[nodiscard]] const std::vector<Ring>& rings() const { return rings_; }
  [[nodiscard]] const Holders& holders() const { return holders_; }
  [[nodiscard]] const std::vector<bool>& is_left_out() const { return is_left_out_; }

  void visit(const EdgeSweep::Event& event) override {
    for (const std::uint32_t e : event.right) {
      if (is_begun_[ring_of_[e]]) continue;
      is_begun_[ring_of_[e]] = true;
      order_.push_back(ring_of_[e]);
      begin(rings_[ring_of_[e]], event.below);
    }
    here_.assign(event.left.begin(), event.left.end());
    here_.insert(here_.end(), event.right.begin(), event.right.end());
    const auto owner = [&](std::uint32_t e) { return finder_.owners_[e]; };
    std::ranges::sort(here_, {}, [&](std::uint32_t e) { return ring_of_[e]; });  // sorts by owner, too
    if (here_.empty() || ring_of_[here_.front()] == ring_of_[here_.back()]) return;
    for (const std::uint32_t e : here_) rings_[ring_of_[e]].is_alone = false;
    if (owner(here_.front()) == owner(here_.back())) return;
    for (std::size_t i = 0; i < here_.size(); ++i)
      for (std::size_t k = i + 1; k < here_.size() && !finder_.is_full(); ++k)
        if (owner(here_[i]) != owner(here_[k]))
          finder_.compare(finder_.edges_[here_[i]], owner(here_[i]), finder_.edges_[here_[k]], owner(here_[k]));
  }
  // One of two crossing regions is left out, unless one of them is already. A region for which another one was left out
  // stays, if possible.
  bool crosses(std::uint32_t e, std::uint32_t f) override {
    std::uint32_t stays = finder_.owners_[e], goes = finder_.owners_[f];
    if (has_come_before_[goes]) std::swap(stays, goes);
    if (!is_left_out_[stays] && !is_left_out_[goes]) is_left_out_[goes] = has_come_before_[stays] = true;
    return true;
  }
  [[nodiscard]] bool is_left_out(std::uint32_t edge) const override { return is_left_out_[finder_.owners_[edge]]; }

 private:
  void sweep() {
    for (Ring& ring : rings_) ring = {ring.region, ring.index};
    is_begun_.assign(rings_.size(), false);
    order_.clear();
    holders_ = {};
    EdgeSweep(finder_.edges_).run(*this);
  }

  // Just above an edge of another ring is the place beside that ring, or the one inside of it.
  void begin(Ring& ring, std::uint32_t below) {
    ring.is_alone = true;
    if (below == EdgeSweep::kNoEdge) return;
    const Ring& other = rings_[ring.below = ring_of_[below]];
    const bool is_hole = other.index > 0;
    ring.holders = other.holders;
    if (sides_.is_region_above(below) == is_hole) return;
    ring.holders = is_hole ? holders_.without(other.region, other.holders) : holders_.with(other.region, other.holders);
  }

  ContactFinder& finder_;
  std::vector<bool> is_left_out_;      // by region
  std::vector<bool> has_come_before_;  // by region: another one was left out on its account
  SweptDepths sides_;
  std::vector<Ring> rings_;             // by region
  std::vector<std::uint32_t> ring_of_;  // by edge
  std::vector<bool> is_begun_;          // by ring
  std::vector<std::uint32_t> order_;    // rings from left to right
  Holders holders_;
  std::vector<std::uint32_t> here_;
};

void ContactFinder::find_by_sweep() {
  meetings_.clear();
  ContactSweep sweep(*this);
  sweep.run();
  std::vector<std::uint32_t> left_out;
  std::vector<Box> boxes;
  for (std::uint32_t r = 0; r < regions_.size(); ++r) {
    if (!sweep.is_left_out()[r]) continue;
    left_out.push_back(r);
    boxes.push_back(regions_[r].box());
  }
  const BoxTree left_out_tree(boxes);
  for (std::uint32_t e = 0; e < edges_.size() && !is_full(); ++e)
    if (sweep.is_left_out()[owners_[e]]) compare_edge(e, Partners::kAll);
  for (const ContactSweep::Ring& ring : sweep.rings()) {
    if (is_full()) break;
    const Vec2& start = regions_[ring.region].ring_starts()[ring.index];
    if (!ring.is_alone) {
      find_holders(ring.region, start, region_tree_, nullptr);
      continue;
    }
    sweep.holders().visit(ring.holders, [&](std::uint32_t other) {
      if (other != ring.region) add_holder(ring.region, other, start);
      return !is_full();
    });
    find_holders(ring.region, start, left_out_tree, &left_out);
  }
}

// Finds what is missing of the pairs that are known, where not all rings have been looked at.
void ContactFinder::complete() {
  std::size_t looks = 0;
  for (auto& [pair, meeting] : meetings_) {
    const Region &first = regions_[pair.first], &second = regions_[pair.second];
    for (const Vec2& start : first.ring_starts())
      meeting.first_enters = meeting.first_enters || second.contains_strictly(start, looks);
    for (const Vec2& start : second.ring_starts())
      meeting.second_enters = meeting.second_enters || first.contains_strictly(start, looks);
  }
}

}  // namespace

std::vector<RegionContact> find_contacts(std::span<const Polygon> polygons, std::size_t most) {
  return ContactFinder(polygons, most).find();
}

}  // namespace arcway::internal
