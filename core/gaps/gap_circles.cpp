#include "core/gaps/gap_circles.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/executor.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

constexpr double kWidestRadius = 16.0;  // largest radius of an added circle, in smallest radii: wider ones hardly turn
constexpr double kMargins = 3.0;        // safety margins by which the grown body's swept annulus is wider, at most
constexpr double kBeyond = 0.1;         // angle by which a center may lie outside the exterior angle [rad]
constexpr double kSame = 1e-6;          // distance within which two centers count as one [m]
constexpr double kNearGap = 3.0;  // largest distance of a gap straight's circle from its vertices, in outer swept radii
constexpr std::size_t kMostPlaces = 3;  // number of entries, and of exits, on one side of a gap straight

// Circles found so far, as a place may have many gaps with the same circle.
class KnownGaps {
 public:
  bool add(const std::vector<TurnCircle>& circles) {
    std::vector<long long> key;
    for (const TurnCircle& c : circles)
      for (const double x : {c.center.x() / kSame, c.center.y() / kSame, sign_of(c.side)})
        key.push_back(std::llround(x));
    return seen_.insert(std::move(key)).second;
  }

 private:
  std::set<std::vector<long long>> seen_;
};

class GapCircles {
 public:
  GapCircles(const World& world, const Vehicle& vehicle, const SideRadii& radii)
      : world_(world),
        vehicle_(vehicle),
        radii_(radii),
        body_(vehicle.footprint(vehicle.safety_margin())),
        swept_left_(swept(Side::kLeft, radii.left)),
        swept_right_(swept(Side::kRight, radii.right)) {}

  AddedCircles find(const GapMap& gaps, const StopClock& clock) && {
    const double widest = std::max(swept_left_.outer, swept_right_.outer);
    for (const Gap& gap : gaps.gaps()) {
      if (clock.is_over()) throw Canceled("canceled");  // a gap takes up to some ten microseconds
      if (!(gap.width > body_.width() && gap.width <= widest)) continue;
      const Vec2 across = (gap.on_b - gap.on_a) / gap.width;
      const VertexId a = corner_at(gap.edge_a, gap.on_a);
      const VertexId b = corner_at(gap.edge_b, gap.on_b);
      add_around_vertex(a, gap.width, across, b != kNone);
      add_around_vertex(b, gap.width, -across, a != kNone);
      for (const double sign : {1.0, -1.0}) add_gap_straight(gap, sign * perpendicular(across));
    }
    return std::move(found_);
  }

 private:
  // The corner that a point of an edge is; kNone if it lies between two, where edges may go straight on.
  [[nodiscard]] VertexId corner_at(VertexId edge, const Vec2& p) const {
    for (const VertexId v : {edge, world_.next(edge)})
      if (world_.vertex(v) == p && !is_straight(v)) return v;
    return kNone;
  }
  [[nodiscard]] bool is_straight(VertexId v) const {
    return orientation(world_.vertex(world_.previous(v)), world_.vertex(v), world_.vertex(world_.next(v))) == 0;
  }
  // The first corner from a vertex on along its ring, either way.
  [[nodiscard]] VertexId corner_behind(VertexId v) const {
    while (is_straight(v)) v = world_.previous(v);
    return v;
  }
  [[nodiscard]] VertexId corner_ahead(VertexId v) const {
    while (is_straight(v)) v = world_.next(v);
    return v;
  }

  // @param across  from the vertex to what it faces, a vertex or an edge at a right angle to that.
  void add_around_vertex(VertexId v, double width, const Vec2& across, bool faces_vertex) {
    if (v == kNone || !world_.is_graph_vertex(v)) return;
    for (const double sign : {1.0, -1.0})
      for (const Side side : {Side::kLeft, Side::kRight}) {
        if (width >= swept(side).width()) {
          add_in_wide_gap(v, {width, across, faces_vertex}, side, sign);
        } else if (sign > 0.0) {
          add_in_narrow_gap(v, {width, across, faces_vertex}, side);
        }
      }
  }

  // A gap as seen from a vertex beside it.
  struct SeenGap {
    double width;
    Vec2 across;
    bool faces_vertex;
  };

  void add_in_narrow_gap(VertexId v, const SeenGap& gap, Side side) {
    for (const RadiusRange& range : vehicle_.fitting_radii(gap.width - kMargins * vehicle_.safety_margin(), side)) {
      if (range.low > kWidestRadius * radii_.of(side)) return;
      add_around_vertex(v, -swept(side, range.low).inner * gap.across, range.low, side);
    }
  }

  // @param sign  to which side of the line across the gap the center lies.
  void add_in_wide_gap(VertexId v, const SeenGap& gap, Side side, double sign) {
    const auto [inner, outer] = swept(side);
    // The cosine of the angle at the vertex between what it faces and the center.
    const double cosine = gap.faces_vertex
                              ? (inner * inner + gap.width * gap.width - outer * outer) / (2.0 * inner * gap.width)
                              : (gap.width - outer) / inner;
    if (!(std::abs(cosine) < 1.0)) return;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    add_around_vertex(v, inner * (cosine * gap.across + sign * sine * perpendicular(gap.across)), radii_.of(side),
                      side);
  }

  void add_around_vertex(VertexId v, const Vec2& to_center, double radius, Side side) {
    const Vec2& corner = world_.vertex(v);
    const Vec2 back = (world_.vertex(world_.previous(v)) - corner).normalized();
    const Vec2 ahead = (world_.vertex(world_.next(v)) - corner).normalized();
    const double exterior = kPi - std::abs(std::atan2(cross(ahead, back), ahead.dot(back)));
    const Vec2 bisector = turn_circle(world_, v, radius, side, body_).center - corner;
    const double shift = std::atan2(std::abs(cross(bisector, to_center)), bisector.dot(to_center));
    if (shift > 0.5 * exterior + kBeyond) return;
    const TurnCircle circle{corner + to_center, radius, side, v};
    if (!known_.add({circle})) return;
    found_.around_vertices.push_back(circle);
  }

  // A vertex beside a gap straight, in the frame of its line: x ahead of the gap's middle, y to the left.
  struct Beside {
    VertexId vertex;
    double x, y;
    bool at_gap;  // one end of the gap, or of the edge that this lies on
  };

  [[nodiscard]] SweptAnnulus swept(Side side, double radius) const {
    return vehicle_.swept_annulus(side, radius, vehicle_.safety_margin());
  }
  [[nodiscard]] const SweptAnnulus& swept(Side side) const { return side == Side::kLeft ? swept_left_ : swept_right_; }

  // The line along which F passes a gap straight.
  struct GateLine {
    Vec2 middle, along;
  };

  void add_gap_straight(const Gap& gap, const Vec2& along) {
    const Vec2 middle = 0.5 * (gap.on_a + gap.on_b) - 0.5 * (body_.left - body_.right) * perpendicular(along);
    std::vector<Beside> beside;
    const auto add = [&](VertexId v, bool at_gap) {
      const Vec2 d = world_.vertex(v) - middle;
      beside.push_back({v, d.dot(along), cross(along, d), at_gap});
    };
    for (const auto& [edge, end] : {std::pair(gap.edge_a, gap.on_a), std::pair(gap.edge_b, gap.on_b)}) {
      const VertexId v = corner_at(edge, end);
      if (v == kNone) {
        add(corner_behind(edge), true);
        add(corner_ahead(world_.next(edge)), true);
      } else {
        add(v, true);
        add(corner_behind(world_.previous(v)), false);
        add(corner_ahead(world_.next(v)), false);
      }
    }
    GapStraight straight;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      add_places(beside, side, 1.0, {middle, along}, straight.exits);
      add_places(beside, side, -1.0, {middle, along}, straight.entries);
    }
    if (straight.entries.empty() || straight.exits.empty()) return;
    std::vector<TurnCircle> all = straight.entries;
    all.insert(all.end(), straight.exits.begin(), straight.exits.end());
    if (!known_.add(all)) return;
    found_.gap_straights.push_back(std::move(straight));
  }

  // Adds circles tangent to a gap straight, in the order in which their turns begin. Seen backwards, a path turns off
  // where it turned on.
  // @param forwards  1 for exits, -1 for entries.
  void add_places(const std::vector<Beside>& beside, Side side, double forwards, const GateLine& line,
                  std::vector<TurnCircle>& circles) const {
    struct Place {
      double x;
      const Beside* contact;
    };
    const double radius = radii_.of(side);
    const auto [inner, outer] = swept(side);
    const double corner = std::hypot(forwards > 0.0 ? body_.rear : body_.front, radius + body_.beside(opposite(side)));
    double first = -INFINITY;
    std::vector<Place> places;
    for (const Beside& b : beside) {
      const double x = forwards * b.x, y = sign_of(side) * b.y;
      const double lag =
          y > 0.0 ? inner * inner - (radius - y) * (radius - y) : corner * corner - (radius - y) * (radius - y);
      if (lag <= 0.0) continue;
      places.push_back({x - std::copysign(std::sqrt(lag), y), &b});
      if (b.at_gap && y > 0.0) first = std::max(first, places.back().x);
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.x < b.x; });
    std::size_t count = 0;
    double last = -INFINITY;
    for (const Place& place : places) {
      if (place.x < first || place.x <= last + kSame || count == kMostPlaces) continue;
      const Vec2 center =
          line.middle + forwards * place.x * line.along + sign_of(side) * radius * perpendicular(line.along);
      const double far = kNearGap * outer;
      const auto near = [&](VertexId v) {
        return v != kNone && world_.is_graph_vertex(v) && (world_.vertex(v) - center).norm() < far ? v : kNone;
      };
      const VertexId own = near(place.contact->vertex);
      const VertexId other = near(vertex_across(beside, *place.contact));
      if (own == kNone && other == kNone) continue;
      last = place.x;
      ++count;
      circles.push_back({center, radius, side, own != kNone ? own : other, own != kNone ? other : kNone});
    }
  }

  // The vertex on the other side that is nearest along the line; kNone if there is none that has circles.
  [[nodiscard]] VertexId vertex_across(const std::vector<Beside>& beside, const Beside& contact) const {
    const Beside* nearest = nullptr;
    for (const Beside& b : beside)
      if (b.y * contact.y <= 0.0 && world_.is_graph_vertex(b.vertex) &&
          (!nearest || std::abs(b.x - contact.x) < std::abs(nearest->x - contact.x)))
        nearest = &b;
    return nearest ? nearest->vertex : kNone;
  }

  const World& world_;
  const Vehicle& vehicle_;
  SideRadii radii_;
  Footprint body_;
  SweptAnnulus swept_left_, swept_right_;
  KnownGaps known_;
  AddedCircles found_;
};

}  // namespace

AddedCircles find_gap_circles(const World& world, const GapMap& gaps, const Vehicle& vehicle, const SideRadii& radii,
                              const StopClock& clock) {
  return GapCircles(world, vehicle, radii).find(gaps, clock);
}

}  // namespace arcway::internal
