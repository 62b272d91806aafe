#include "core/model/world_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "arcway/angle.h"
#include "arcway/clearance_preference.h"
#include "arcway/vehicle.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/predicates.h"
#include "core/geometry/ray_parity.h"
#include "core/geometry/simplicity.h"
#include "core/model/pose_text.h"

namespace arcway::internal {
namespace {

constexpr std::size_t kMaxVertices = 0x7FFFFFFF;
// Edges examined, per vertex, after which one sweep over all edges decides whether a hole is misplaced.
constexpr std::size_t kPatience = 128;

// What is wrong with the coordinates of a vertex; empty if nothing is.
std::string complaint_about(const Vec2& p) {
  for (const Eigen::Index axis : {0, 1}) {
    const double value = p[axis];
    if (is_in_range(value)) continue;
    std::string what = (axis == 0 ? "x is " : "y is ") + (std::isnan(value) ? "nan" : shortest_text(value));
    if (std::isfinite(value)) {
      what.append(", its magnitude must be 0 or from ").append(shortest_text(kMinMagnitude));
      what.append(" to ").append(shortest_text(kMaxMagnitude));
    }
    return what;
  }
  return {};
}

class RegionCheck {
 public:
  /// @param id  of the region, for errors;  @param name  of it, for their messages.
  RegionCheck(const Polygon& polygon, ObstacleId id, std::string name)
      : polygon_(polygon), id_(id), name_(std::move(name)) {}

  [[nodiscard]] std::vector<RingContact> check() const {
    check_ring(polygon_.outer, 0);
    for (std::size_t h = 0; h < polygon_.holes.size(); ++h) check_ring(polygon_.holes[h], h + 1);
    std::vector<RingContact> contacts;
    check_conflicts(contacts);
    if (!polygon_.holes.empty()) check_holes();
    return contacts;
  }

 private:
  [[noreturn]] void fail(const std::string& place, const std::string& what) const {
    throw WorldError(name_ + place + ": " + what, id_);
  }
  static std::string ring_text(std::size_t ring) { return ", ring " + std::to_string(ring); }
  static std::string vertex_text(std::size_t ring, std::size_t vertex) {
    return ring_text(ring) + ", vertex " + std::to_string(vertex);
  }

  void check_ring(const Ring& ring, std::size_t index) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::string what = complaint_about(ring[i]);
      if (!what.empty()) fail(vertex_text(index, i), what);
    }
    if (ring.size() < 3) {
      fail(ring_text(index), "a ring needs at least 3 vertices, this one has " + std::to_string(ring.size()));
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t next = (i + 1) % ring.size();
      if (ring[i] == ring[next]) {
        fail(vertex_text(index, next), "repeats vertex " + std::to_string(i) + " at " + shortest_text(ring[i]));
      }
    }
  }

  void check_conflicts(std::vector<RingContact>& contacts) const {
    const auto conflict = find_conflict(polygon_, &contacts);
    // A ring without area overlaps or crosses itself; without a crossing, lack of area says it best.
    if (!conflict) return;
    if (conflict->kind == RingConflict::Kind::kOverlap) {
      for (const std::size_t ring : {conflict->ring_a, conflict->ring_b}) {
        if (winding(ring_at(ring)) == 0) fail(ring_text(ring), "the ring has zero area");
      }
    }
    const char* verb = conflict->kind == RingConflict::Kind::kOverlap ? " overlap at " : " cross at ";
    if (conflict->ring_a == conflict->ring_b) {
      fail(ring_text(conflict->ring_a), "edges " + std::to_string(conflict->edge_a) + " and " +
                                            std::to_string(conflict->edge_b) + verb + shortest_text(conflict->place));
    }
    fail("", "ring " + std::to_string(conflict->ring_a) + " edge " + std::to_string(conflict->edge_a) + " and ring " +
                 std::to_string(conflict->ring_b) + " edge " + std::to_string(conflict->edge_b) + verb +
                 shortest_text(conflict->place));
  }

  // Rings that neither cross nor overlap lie entirely on one side of each other, so that one step
  // along the first edge decides.
  void check_holes() const {
    std::size_t looks_left = kPatience * count_vertices();
    const auto look = [&](std::size_t edges) { looks_left -= std::min(looks_left, edges); };
    std::vector<Box> edge_boxes(polygon_.outer.size());
    for (std::size_t i = 0; i < polygon_.outer.size(); ++i) {
      edge_boxes[i].extend(polygon_.outer[i]);
      edge_boxes[i].extend(polygon_.outer[(i + 1) % polygon_.outer.size()]);
    }
    const BoxTree outer_edges(edge_boxes);
    std::vector<Box> hole_boxes(polygon_.holes.size());
    for (std::size_t h = 0; h < polygon_.holes.size(); ++h) {
      for (const Vec2& p : polygon_.holes[h]) hole_boxes[h].extend(p);
    }
    const BoxTree hole_tree(hole_boxes);

    for (std::size_t h = 0; h < polygon_.holes.size(); ++h) {
      if (looks_left == 0) {
        if (holes_are_nested(polygon_)) return;
        looks_left = std::numeric_limits<std::size_t>::max();  // one is not, and is to be named
      }
      const Ring& hole = polygon_.holes[h];
      StepParity in_outer(hole[0], hole[1]);
      outer_edges.visit_overlaps(in_outer.ray_box(), [&](std::uint32_t i) {
        look(1);
        in_outer.add(polygon_.outer[i], polygon_.outer[(i + 1) % polygon_.outer.size()]);
        return true;
      });
      if (!in_outer.inside()) {
        fail(ring_text(h + 1), "the hole lies outside of its outer ring, vertex 0 at " + shortest_text(hole[0]));
      }
      hole_tree.visit_overlaps(hole_boxes[h], [&](std::uint32_t other) {
        look(polygon_.holes[other].size());
        if (other != h && starts_inside(hole, polygon_.holes[other])) {
          fail(ring_text(h + 1), "the hole lies inside the hole of ring " + std::to_string(other + 1));
        }
        return true;
      });
    }
  }

  static bool starts_inside(const Ring& ring, const Ring& other) {
    StepParity parity(ring[0], ring[1]);
    for (std::size_t i = 0, last = other.size() - 1; i < other.size(); last = i++) parity.add(other[last], other[i]);
    return parity.inside();
  }

  [[nodiscard]] std::size_t count_vertices() const {
    std::size_t count = polygon_.outer.size();
    for (const Ring& hole : polygon_.holes) count += hole.size();
    return count;
  }

  [[nodiscard]] const Ring& ring_at(std::size_t ring) const {
    return ring == 0 ? polygon_.outer : polygon_.holes[ring - 1];
  }

  const Polygon& polygon_;
  ObstacleId id_;
  std::string name_;
};

// What is wrong with the numbers of a rule; empty if nothing is.
struct RuleComplaint {
  std::string operator()(const KeepOut& rule) const {
    return std::ranges::find(rule.vehicles, "") == rule.vehicles.end()
               ? ""
               : "a name of \"vehicles\" is empty; give the robot's name, or no list for all vehicles";
  }
  std::string operator()(const SpeedLimit& rule) const {
    if (rule.max_speed >= kSmallestVehicleNumber && rule.max_speed <= kLargestVehicleNumber) return "";
    return "max_speed is " + number_text(rule.max_speed) + " m/s, must be from " +
           shortest_text(kSmallestVehicleNumber) + " to " + shortest_text(kLargestVehicleNumber) +
           (rule.max_speed == 0.0 ? "; a zone to stay out of is a keepout" : "");
  }
  std::string operator()(const OneWay& rule) const {
    if (!(std::abs(rule.heading) <= kTwoPi)) return complaint("heading", rule.heading, "-2 pi to 2 pi");
    if (!(rule.tolerance >= 0.0 && rule.tolerance <= kPi)) return complaint("tolerance", rule.tolerance, "0 to pi");
    return "";
  }
  std::string operator()(const KeepClear& rule) const {
    constexpr double kMost = ClearancePreference::kMost;
    if (!(rule.distance > 0.0 && rule.distance <= kMost))
      return "distance is " + number_text(rule.distance) + " m, must be above 0 and at most " + shortest_text(kMost) +
             (rule.distance == 0.0 ? "; leave the zone out" : "");
    if (!(rule.cost >= 0.0 && rule.cost <= kMost))
      return "cost is " + number_text(rule.cost) + " s/m, must be from 0 to " + shortest_text(kMost);
    return "";
  }

 private:
  static std::string number_text(double value) { return std::isnan(value) ? "nan" : shortest_text(value); }
  static std::string complaint(const char* what, double value, const char* range) {
    const std::string number = number_text(value);
    return std::string(what) + " is " + number + " rad, must be from " + range +
           (std::isfinite(value) ? "; if " + number + " is in degrees, write " + shortest_text(value * kPi / 180.0)
                                 : std::string());
  }
};

// An obstacle a zone that is a keep-out, or none.
void require_keep_outs(const WorldSnapshot& snapshot) {
  if (snapshot.keep_outs.empty()) return;
  const std::size_t zones = snapshot.zones.size();
  const std::size_t obstacles = snapshot.region_rings.size() - (snapshot.has_bounds ? 2 : 1);
  if (snapshot.keep_outs.size() != zones)
    throw SnapshotError(SnapshotArray::kKeepOuts, snapshot.keep_outs.size(),
                        "there are " + std::to_string(zones) + " zones");
  for (std::size_t i = 0; i < zones; ++i) {
    const std::uint32_t obstacle = snapshot.keep_outs[i];
    if (obstacle == kNone) continue;
    if (obstacle >= obstacles)
      throw SnapshotError(SnapshotArray::kKeepOuts, i, "there is no obstacle " + std::to_string(obstacle));
    if (!std::holds_alternative<KeepOut>(snapshot.zones[i].rule))
      throw SnapshotError(SnapshotArray::kKeepOuts, i, zone_text(snapshot.zones[i], i) + " is no keep-out");
  }
}

void require_self_contacts(const WorldSnapshot& snapshot) {
  const std::size_t n = snapshot.vertices.size();
  std::vector<std::uint32_t> previous(n);
  for (std::size_t v = 0; v < n; ++v) previous[snapshot.next[v]] = static_cast<std::uint32_t>(v);
  for (std::size_t i = 0; i < snapshot.self_contacts.size(); ++i) {
    const std::uint32_t e = snapshot.self_contacts[i].edge, v = snapshot.self_contacts[i].vertex;
    const auto fail = [&](const char* what) {
      throw SnapshotError(SnapshotArray::kSelfContacts, i,
                          "vertex " + std::to_string(v) + ", edge " + std::to_string(e) + what);
    };
    if (e >= n || v >= n) fail(": there is no such vertex");
    if (i > 0 && std::pair(snapshot.self_contacts[i - 1].edge, snapshot.self_contacts[i - 1].vertex) >= std::pair(e, v))
      fail(": not in order");
    const LineSegment edge{snapshot.vertices[e], snapshot.vertices[snapshot.next[e]]};
    if (!on_open_segment(snapshot.vertices[v], edge)) fail(": the vertex does not lie inside the edge");
    for (const std::uint32_t beside : {previous[v], snapshot.next[v]})
      if (orientation(edge.a, edge.b, snapshot.vertices[beside]) <= 0) fail(": its ring is not on the edge's left");
  }
}

// Ascending starts of rows within [0, count), each of at least `least`.
void require_starts(SnapshotArray array, std::span<const std::uint32_t> starts, std::size_t count, std::size_t least) {
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const std::size_t end = i + 1 < starts.size() ? starts[i + 1] : count;
    if (i == 0 && starts[0] != 0) throw SnapshotError(array, 0, "the first one is " + std::to_string(starts[0]));
    if (starts[i] > count || end > count || end < starts[i] + least)
      throw SnapshotError(array, i + 1 < starts.size() ? i + 1 : i,
                          std::to_string(starts[i]) + " is followed by " + std::to_string(end) + ", at least " +
                              std::to_string(least) + " more and at most " + std::to_string(count) + " are expected");
  }
}

void require_zone(const Zone& zone, std::size_t index) {
  const std::string name = zone_text(zone, index);
  const std::string complaint = std::visit(RuleComplaint{}, zone.rule);
  if (!complaint.empty()) throw ZoneError(name + ": " + complaint, index);
  try {
    static_cast<void>(RegionCheck(zone.area, 0, name).check());
  } catch (const WorldError& error) {
    throw ZoneError(error.what(), index);
  }
}

}  // namespace

std::size_t vertex_count_of(std::span<const Polygon> polygons) {
  std::size_t count = 0;
  for (const Polygon& polygon : polygons) {
    count += polygon.outer.size();
    for (const Ring& hole : polygon.holes) count += hole.size();
  }
  return count;
}

void require_vertex_count(std::size_t count, ObstacleId obstacles) {
  if (count > kMaxVertices)
    throw WorldError(
        "the map has " + std::to_string(count) + " vertices, at most " + std::to_string(kMaxVertices) + " fit",
        obstacles);
}

std::vector<RingContact> require_region(const Polygon& polygon, ObstacleId id, bool is_bounds) {
  return RegionCheck(polygon, id, is_bounds ? "bounds" : "obstacle " + std::to_string(id)).check();
}

void require_zones(std::span<const Zone> zones) {
  for (std::size_t i = 0; i < zones.size(); ++i) require_zone(zones[i], i);
}

void require_world(const WorldSnapshot& snapshot) {
  const std::size_t n = snapshot.vertices.size();
  if (n > kMaxVertices)
    throw SnapshotError(SnapshotArray::kVertices, kMaxVertices,
                        "there are " + std::to_string(n) + ", at most " + std::to_string(kMaxVertices) + " fit");
  const auto require_size = [&](SnapshotArray array, std::size_t size) {
    if (size != n) throw SnapshotError(array, size, "there are " + std::to_string(n) + " vertices");
  };
  require_size(SnapshotArray::kNext, snapshot.next.size());
  require_size(SnapshotArray::kCovered, snapshot.covered.size());
  require_starts(SnapshotArray::kRingStarts, snapshot.ring_starts, n, 3);
  if (snapshot.ring_starts.empty() && n > 0) throw SnapshotError(SnapshotArray::kRingStarts, 0, "missing");
  if (snapshot.region_rings.empty()) throw SnapshotError(SnapshotArray::kRegionRings, 0, "missing");
  const std::span region_rings(snapshot.region_rings);
  require_starts(SnapshotArray::kRegionRings, region_rings.first(region_rings.size() - 1), region_rings.back(), 1);
  if (region_rings.back() != snapshot.ring_starts.size())
    throw SnapshotError(SnapshotArray::kRegionRings, region_rings.size() - 1,
                        std::to_string(region_rings.back()) + " at the end, there are " +
                            std::to_string(snapshot.ring_starts.size()) + " rings");
  if (snapshot.has_bounds && region_rings.size() < 2)
    throw SnapshotError(SnapshotArray::kRegionRings, 0, "there are no bounds");

  std::vector<bool> reached(n);
  for (std::size_t region = 0; region + 1 < region_rings.size(); ++region) {
    const std::size_t first = snapshot.ring_starts[region_rings[region]];
    const std::size_t last =
        region_rings[region + 1] < snapshot.ring_starts.size() ? snapshot.ring_starts[region_rings[region + 1]] : n;
    for (std::size_t v = first; v < last; ++v) {
      const std::string complaint = complaint_about(snapshot.vertices[v]);
      if (!complaint.empty()) throw SnapshotError(SnapshotArray::kVertices, v, complaint);
      const std::size_t w = snapshot.next[v];
      if (w < first || w >= last || reached[w])
        throw SnapshotError(SnapshotArray::kNext, v, std::to_string(w) + " is of another region or follows twice");
      if (snapshot.vertices[v] == snapshot.vertices[w])
        throw SnapshotError(SnapshotArray::kNext, v, std::to_string(w) + " is at the same place");
      reached[w] = true;
      if (snapshot.covered[v] > 1) throw SnapshotError(SnapshotArray::kCovered, v, std::to_string(snapshot.covered[v]));
    }
  }
  if (!snapshot.self_contacts.empty()) require_self_contacts(snapshot);
  require_zones(snapshot.zones);
  require_keep_outs(snapshot);
}

}  // namespace arcway::internal
