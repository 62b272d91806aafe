#include "arcway/datasets/doctor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "arcway/polygon.h"
#include "arcway/world.h"
#include "arcway/zone.h"
#include "core/geometry/predicates.h"
#include "core/model/pose_text.h"
#include "datasets/map/contacts.h"

namespace arcway {

using namespace internal;
namespace {

// Of a coordinate: where the default safety margin of 1 mm is no longer 2^20 units in the last place, which Planner
// asks for.
constexpr double kFar = 0x1p23;

// Pairs of obstacles that are listed, at most, and how many more for each obstacle: some 100 MB where 10^5 obstacles
// lie in each other, which have 5 * 10^9 pairs.
constexpr std::size_t kMostPairs = 100'000, kMostPairsOfEach = 8;

Ring cleaned(const Ring& ring) {
  Ring result = ring;
  result.erase(std::unique(result.begin(), result.end()), result.end());
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

// What a zone asks, in words.
struct RuleText {
  std::string operator()(const KeepOut& rule) const {
    std::string text = rule.vehicles.empty() ? " for all robots" : " for";
    for (const std::string& vehicle : rule.vehicles) text += " " + vehicle;
    return text;
  }
  std::string operator()(const SpeedLimit& rule) const { return " of " + shortest_text(rule.max_speed) + " m/s"; }
  std::string operator()(const OneWay& rule) const {
    return " in direction " + shortest_text(rule.heading) + " rad, to either side " + shortest_text(rule.tolerance) +
           " rad";
  }
  std::string operator()(const KeepClear& rule) const {
    return " of " + shortest_text(rule.distance) + " m; each meter driven closer costs " + shortest_text(rule.cost) +
           " s";
  }
};

class Examiner {
 public:
  explicit Examiner(const MapFile& map) : map_(map) {}

  DoctorReport examine() {
    report_.obstacles = map_.obstacles.size();
    for (std::size_t i = 0; i < map_.obstacles.size(); ++i)
      add_polygon(map_.obstacles[i], i < map_.places.size() ? map_.places[i] : "obstacle " + std::to_string(i));
    bounds_ = polygons_.size();
    if (map_.bounds) add_polygon({*map_.bounds, {}}, map_.bounds_place.empty() ? "bounds" : map_.bounds_place);
    has_bounds_ = polygons_.size() > bounds_;
    look_at_zones();
    compare();
    look_at_coordinates();
    return std::move(report_);
  }

 private:
  void find(FindingKind kind, std::string place, std::optional<Vec2> at, std::string what) {
    report_.findings.push_back({kind, std::move(place), at, std::move(what)});
  }

  void add_polygon(const Polygon& polygon, const std::string& place) {
    if (std::optional<Polygon> clean = usable(polygon, place)) {
      polygons_.push_back(std::move(*clean));
      places_.push_back(place);
    }
  }

  // Zones are listed. Their areas may overlap each other and obstacles, and are not compared.
  void look_at_zones() {
    for (std::size_t i = 0; i < map_.zones.size(); ++i) {
      const Zone& zone = map_.zones[i];
      const std::string place = i < map_.zone_places.size() ? map_.zone_places[i] : "zone " + std::to_string(i);
      find(FindingKind::kZone, place, zone.area.outer.empty() ? std::nullopt : std::optional(zone.area.outer[0]),
           zone_text(zone, i) + std::visit(RuleText{}, zone.rule));
      if (!usable(zone.area, place)) continue;
      try {
        static_cast<void>(World({}).with_zones({zone}));
      } catch (const ZoneError& error) {  // its numbers are all that is left to refuse
        const std::string message = error.what();
        find(FindingKind::kZoneRule, place, std::nullopt, message.substr(zone_text(zone, 0).size() + 2));
      }
    }
  }

  // The polygon without repeated vertices, if World takes it.
  std::optional<Polygon> usable(const Polygon& polygon, const std::string& place) {
    bool usable = true;
    Polygon clean;
    for (std::size_t r = 0; r <= polygon.holes.size(); ++r) {
      const Ring& ring = r == 0 ? polygon.outer : polygon.holes[r - 1];
      const std::string where = polygon.holes.empty() ? place : place + ", ring " + std::to_string(r);
      usable = look_at_ring(ring, where, r == 0 ? 1 : -1) && usable;
      (r == 0 ? clean.outer : clean.holes.emplace_back()) = cleaned(ring);
    }
    if (!usable || !look_at_conflicts(clean, place)) return std::nullopt;
    return clean;
  }

  // Whether the ring may be a polygon's.
  bool look_at_ring(const Ring& ring, const std::string& place, int wanted_winding) {
    report_.vertices += ring.size();
    const auto vertex = [&](std::size_t i) { return place + ", vertex " + std::to_string(i); };
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (is_in_range(ring[i])) continue;
      find(FindingKind::kOutOfRange, vertex(i), std::nullopt, "at " + shortest_text(ring[i]));
      return false;
    }
    for (const Vec2& p : ring) box_.extend(p);
    std::size_t last = ring.size();
    for (; last > 1 && ring[last - 1] == ring[0]; --last) {
      if (last > 2 && ring[last - 2] == ring[last - 1]) continue;
      find(FindingKind::kClosingVertex, vertex(last - 1), ring[0], "repeats the ring's first vertex");
    }
    for (std::size_t i = 1; i < ring.size(); ++i)
      if (ring[i] == ring[i - 1]) find(FindingKind::kRepeatedVertex, vertex(i), ring[i], "repeats the one before");

    const Ring clean = cleaned(ring);
    if (clean.size() < 3) {
      find(FindingKind::kTooFewVertices, place, ring.empty() ? std::nullopt : std::optional(ring[0]),
           std::to_string(clean.size()) + " different vertices");
      return false;
    }
    std::size_t collinear = 0, first = 0;
    for (std::size_t i = 0; i < clean.size(); ++i) {
      const Vec2 &before = clean[i == 0 ? clean.size() - 1 : i - 1], &after = clean[i + 1 < clean.size() ? i + 1 : 0];
      if (before == after || !on_segment(clean[i], {before, after})) continue;
      if (collinear++ == 0) first = i;
    }
    if (collinear > 0) {
      find(FindingKind::kCollinearVertex, place, clean[first],
           std::to_string(collinear) + " of " + std::to_string(clean.size()) + " vertices");
    }
    const int turns = winding(clean);
    if (turns == -wanted_winding) {
      find(FindingKind::kOrientation, place, std::nullopt,
           wanted_winding > 0 ? "outer ring runs clockwise" : "hole runs counter-clockwise");
    }
    return true;
  }

  bool look_at_conflicts(const Polygon& polygon, const std::string& place) {
    const auto edge = [&](std::size_t ring, std::size_t index) {
      return (polygon.holes.empty() ? "edge " : "ring " + std::to_string(ring) + " edge ") + std::to_string(index);
    };
    std::vector<RingContact> contacts;
    const auto conflict = find_conflict(polygon, &contacts);
    if (conflict) {
      const bool crossing = conflict->kind == RingConflict::Kind::kCrossing;
      const bool flat = !crossing && (winding(ring_of(polygon, conflict->ring_a)) == 0 ||
                                      winding(ring_of(polygon, conflict->ring_b)) == 0);
      find(crossing ? FindingKind::kSelfCrossing
           : flat   ? FindingKind::kZeroArea
                    : FindingKind::kEdgesOverlap,
           place, conflict->place,
           edge(conflict->ring_a, conflict->edge_a) + " and " + edge(conflict->ring_b, conflict->edge_b) +
               " of the ring without repeated vertices");
      return false;
    }
    find_self_contacts(polygon, contacts, place);
    if (polygon.holes.empty()) return true;
    try {
      const World alone({polygon});
    } catch (const WorldError& error) {  // holes are all that is left to refuse
      const std::string message = error.what();
      find(FindingKind::kMisplacedHole, place, std::nullopt,
           message.substr(std::min(message.find("ring"), message.size())));
      return false;
    }
    return true;
  }

  // Vertices inside edges of their polygon, and vertices in one place.
  void find_self_contacts(const Polygon& polygon, const std::vector<RingContact>& inside_edges,
                          const std::string& place) {
    const auto name = [&](const char* what, std::size_t ring, std::size_t index) {
      return (polygon.holes.empty() ? "" : "ring " + std::to_string(ring) + " ") + what + " " + std::to_string(index);
    };
    for (const RingContact& contact : inside_edges)
      find(FindingKind::kSelfTouching, place, ring_of(polygon, contact.vertex_ring)[contact.vertex],
           name("vertex", contact.vertex_ring, contact.vertex) + " lies inside " +
               name("edge", contact.edge_ring, contact.edge));
    struct Vertex {
      Vec2 at;
      std::size_t ring, index;
    };
    std::vector<Vertex> vertices;
    for (std::size_t r = 0; r <= polygon.holes.size(); ++r)
      for (std::size_t i = 0; i < ring_of(polygon, r).size(); ++i) vertices.push_back({ring_of(polygon, r)[i], r, i});
    std::ranges::sort(vertices, {}, [](const Vertex& v) { return std::tuple(v.at.x(), v.at.y(), v.ring, v.index); });
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      const Vertex &v = vertices[i - 1], &w = vertices[i];
      if (v.at == w.at)
        find(FindingKind::kSelfTouching, place, v.at,
             name("vertex", v.ring, v.index) + " and " + name("vertex", w.ring, w.index) + " are in one place");
    }
  }

  static const Ring& ring_of(const Polygon& polygon, std::size_t ring) {
    return ring == 0 ? polygon.outer : polygon.holes[ring - 1];
  }

  void compare() {
    std::vector<bool> meets_bounds(polygons_.size(), false);
    const std::size_t most = kMostPairs + kMostPairsOfEach * polygons_.size();
    const std::vector<RegionContact> contacts = find_contacts(polygons_, most);
    for (const RegionContact& contact : contacts) {
      const std::string pair = places_[contact.first] + " and " + places_[contact.second];
      if (has_bounds_ && contact.second == bounds_) {
        meets_bounds[contact.first] = contact.relation != RegionRelation::kTouching;
        if (contact.relation == RegionRelation::kOverlapping || contact.relation == RegionRelation::kSecondInside)
          find(FindingKind::kCrossesBounds, places_[contact.first], contact.place, "parts lie outside");
        continue;
      }
      switch (contact.relation) {
        case RegionRelation::kTouching:
          find(FindingKind::kTouching, pair, contact.place, "touch");
          break;
        case RegionRelation::kOverlapping:
          find(FindingKind::kOverlap, pair, contact.place, "have area in common");
          break;
        case RegionRelation::kFirstInside:
          find(FindingKind::kContainment, pair, contact.place, "the first one lies inside");
          break;
        case RegionRelation::kSecondInside:
          find(FindingKind::kContainment, pair, contact.place, "the second one lies inside");
          break;
        case RegionRelation::kEqual:
          find(FindingKind::kDuplicate, pair, contact.place, "are the same region");
          break;
      }
    }
    if (contacts.size() >= most) {
      find(FindingKind::kUnlistedPairs, "", std::nullopt,
           "after " + std::to_string(most) + " pairs obstacles were compared no further");
      return;
    }
    if (!has_bounds_) return;
    for (std::size_t i = 0; i < bounds_; ++i)
      if (!meets_bounds[i]) find(FindingKind::kOutsideBounds, places_[i], polygons_[i].outer[0], "all of it");
  }

  void look_at_coordinates() {
    if (box_.empty()) return;
    const std::string from_to = "coordinates from " + shortest_text(box_.min) + " to " + shortest_text(box_.max);
    if (map_.frame == CoordinateFrame::kDegrees ||
        (map_.frame == CoordinateFrame::kUnstated && looks_like_degrees(box_)))
      find(FindingKind::kDegrees, "", box_.min, from_to);
    const double largest = std::max(box_.max.cwiseAbs().maxCoeff(), box_.min.cwiseAbs().maxCoeff());
    if (largest >= kFar) {
      const double unit = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
      find(FindingKind::kFarFromOrigin, "", box_.min,
           from_to + ", where neighboring doubles are " + shortest_text(unit) + " m apart");
    }
  }

  const MapFile& map_;
  DoctorReport report_;
  Box box_;
  std::vector<Polygon> polygons_;  // those that World would take, without repeated vertices; the bounds last
  std::vector<std::string> places_;
  std::size_t bounds_ = 0;
  bool has_bounds_ = false;
};

}  // namespace

const char* name_of(FindingKind kind) {
  switch (kind) {
    case FindingKind::kClosingVertex:
      return "closing vertex";
    case FindingKind::kRepeatedVertex:
      return "repeated vertex";
    case FindingKind::kCollinearVertex:
      return "collinear vertices";
    case FindingKind::kOrientation:
      return "orientation";
    case FindingKind::kTooFewVertices:
      return "too few vertices";
    case FindingKind::kOutOfRange:
      return "out of range";
    case FindingKind::kZeroArea:
      return "zero area";
    case FindingKind::kSelfCrossing:
      return "self-crossing";
    case FindingKind::kEdgesOverlap:
      return "overlapping edges";
    case FindingKind::kSelfTouching:
      return "touches itself";
    case FindingKind::kMisplacedHole:
      return "misplaced hole";
    case FindingKind::kOverlap:
      return "overlap";
    case FindingKind::kContainment:
      return "containment";
    case FindingKind::kDuplicate:
      return "duplicate";
    case FindingKind::kTouching:
      return "touching";
    case FindingKind::kCrossesBounds:
      return "crosses the bounds";
    case FindingKind::kUnlistedPairs:
      return "unlisted pairs";
    case FindingKind::kOutsideBounds:
      return "outside the bounds";
    case FindingKind::kDegrees:
      return "degrees";
    case FindingKind::kFarFromOrigin:
      return "far from the origin";
    case FindingKind::kZone:
      return "zone";
    case FindingKind::kZoneRule:
      return "zone refused";
  }
  return "unknown";
}

const char* consequence_of(FindingKind kind) {
  switch (kind) {
    case FindingKind::kClosingVertex:
    case FindingKind::kRepeatedVertex:
      return "dropped when the file is read";
    case FindingKind::kCollinearVertex:
      return "kept; not convex, so no path turns there";
    case FindingKind::kOrientation:
      return "read as if it ran the other way";
    case FindingKind::kTooFewVertices:
    case FindingKind::kOutOfRange:
    case FindingKind::kZeroArea:
    case FindingKind::kSelfCrossing:
    case FindingKind::kEdgesOverlap:
    case FindingKind::kMisplacedHole:
    case FindingKind::kZoneRule:
      return "the map is refused";
    case FindingKind::kSelfTouching:
      return "kept; a line of sight may pass there, a body cannot";
    case FindingKind::kOverlap:
      return "taken as one region; vertices strictly inside another obstacle take no part";
    case FindingKind::kContainment:
      return "kept; its vertices strictly inside the other obstacle take no part";
    case FindingKind::kDuplicate:
      return "kept; both block, which costs time and changes nothing";
    case FindingKind::kTouching:
      return "a line of sight may pass where they touch, a body cannot";
    case FindingKind::kCrossesBounds:
      return "cut off at the bounds; vertices strictly outside take no part";
    case FindingKind::kUnlistedPairs:
      return "planning takes all of them; --repair joins them";
    case FindingKind::kOutsideBounds:
      return "blocks nothing, as nothing is free outside";
    case FindingKind::kDegrees:
      return "taken as meters; longitude and latitude are projected with --lonlat";
    case FindingKind::kFarFromOrigin:
      return "refused unless the robot's safety margin is 2^20 of these steps or more; move the map to the origin";
    case FindingKind::kZone:
      return "obeyed; a keep-out is an obstacle for the robots that it names, or for all";
  }
  return "";
}

bool is_refused(FindingKind kind) {
  switch (kind) {
    case FindingKind::kTooFewVertices:
    case FindingKind::kOutOfRange:
    case FindingKind::kZeroArea:
    case FindingKind::kSelfCrossing:
    case FindingKind::kEdgesOverlap:
    case FindingKind::kMisplacedHole:
    case FindingKind::kFarFromOrigin:
    case FindingKind::kZoneRule:
      return true;
    default:
      return false;
  }
}

bool DoctorReport::plans() const {
  return std::ranges::none_of(findings, [](const Finding& finding) { return is_refused(finding.kind); });
}

DoctorReport examine(const MapFile& map) { return Examiner(map).examine(); }

MapFile without_repetitions(MapFile map) {
  const auto clean = [](Ring& ring, int wanted_winding) {
    ring = cleaned(ring);
    if (ring.size() >= 3 && winding(ring) == -wanted_winding) std::reverse(ring.begin(), ring.end());
  };
  for (Polygon& polygon : map.obstacles) {
    clean(polygon.outer, 1);
    for (Ring& hole : polygon.holes) clean(hole, -1);
  }
  for (Zone& zone : map.zones) {
    clean(zone.area.outer, 1);
    for (Ring& hole : zone.area.holes) clean(hole, -1);
  }
  if (map.bounds) clean(*map.bounds, 1);
  return map;
}

}  // namespace arcway
