#include "core/refine/chain_contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/infinity.h"

namespace arcway::internal {

namespace {

// Which side of the body is nearest to an obstacle's corner, or which corner of the body to it or to an edge.
enum Kind : std::uint8_t {
  kNothing,
  kBeside,
  kAhead,
  kBehind,
  kInside,  // the inner side, in a turn
  kFrontCorner,
  kRearCorner,
  kSwing,    // a corner of the body swings by an edge, and is nearest on the way
  kAtEntry,  // a corner of the body is nearest to an edge where the arc begins
  kAtExit    // a corner of the body is nearest to an edge where the arc ends
};

// Shares of the body's length.
constexpr double kWrongSide = 0.04;      // overlap of a free chain beyond which a corner is seen from the wrong side
constexpr double kWrongSideLater = 0.4;  // the same overlap, of a chain that has moved
constexpr double kSeen = 2.0;            // distance within which a corner is seen from more parts
// Distance behind an edge beyond which the body faces another edge. A corner of the body may come behind an edge from
// its end: with 0.3 many optimizations ended there, and of 400 driven worlds 29 plans were slower by more than 1 %.
constexpr double kBehindEdge = 0.02;
constexpr double kBentTurn = 3.0;                          // turn from which on its middle says little [rad]
constexpr double kPlaces[] = {0.0, 0.25, 0.5, 0.75, 1.0};  // shares of an arc, where points for its box lie

// A line as a corner sees it.
struct LineView {
  Vec2 center;  // before the line
  const Vec2& ahead;
  Vec2 left;
  double sideways;     // signed radius before the line
  double least, most;  // how far ahead of its beginning it reaches
};
LineView line_at(const ArcChain& chain, std::size_t i) {
  const ArcChain::Line& line = chain.lines[i];
  const double along = line.along();
  const bool is_ahead = line.gear > 0.0;
  return {chain.before(i),       line.ahead, perpendicular(line.ahead), chain.sideways(i), is_ahead ? 0.0 : along,
          is_ahead ? along : 0.0};
}

double norm_of(double x, double y) { return std::sqrt(x * x + y * y); }

// Whether a point of the body passes a place on an arc: seen from the center, the place lies between where the point is
// at the arc's beginning and at its end.
bool passes(const ArcChain& chain, std::size_t arc, const Vec2& from_center, double ahead, double outwards) {
  const double sign = chain.arcs[arc].sign;
  const auto is_ahead = [&](const Vec2& heading) {
    return from_center.dot(outwards * heading + sign * ahead * perpendicular(heading)) >= 0.0;
  };
  const Vec2 &begin = chain.lines[arc].ahead, &end = chain.lines[arc + 1].ahead;
  return chain.arcs[arc].gear > 0.0 ? is_ahead(begin) && !is_ahead(end) : is_ahead(end) && !is_ahead(begin);
}

Box box_of(const ArcChain& chain, std::uint32_t part) {
  Box box;
  const std::size_t i = part / 2;
  if (part % 2 == 0) {
    const LineView line = line_at(chain, i);
    const Vec2 begin = line.center - line.sideways * line.left;
    box.extend(begin + line.least * line.ahead);
    box.extend(begin + line.most * line.ahead);
    return box;
  }
  const ArcChain::Arc& arc = chain.arcs[i];
  const double from = chain.lines[i].heading, turn = chain.lines[i + 1].heading - from;
  for (const double share : kPlaces)
    box.extend(arc.center - arc.sign * arc.radius * perpendicular(direction_of(from + share * turn)));
  const double between = arc.radius * (1.0 - std::cos(std::min(0.125 * std::abs(turn), 1.0)));
  return box.grown(between);
}

}  // namespace

bool ChainContacts::is_seen(const Place& place) const {
  return place.distance >= -kWrongSideLater * body_length() && place.distance < kSeen * body_length();
}

ChainContacts::Place ChainContacts::look_from(const ArcChain& chain, const Corner& corner, std::uint32_t part) const {
  return part % 2 == 0 ? look_from_line(chain, corner, part) : look_from_arc(chain, corner, part);
}

// The distance from the rectangle that the body sweeps.
ChainContacts::Place ChainContacts::look_from_line(const ArcChain& chain, const Corner& corner,
                                                   std::uint32_t part) const {
  const LineView line = line_at(chain, part / 2);
  const Vec2 d = corner.place - line.center;
  const double x = line.ahead.dot(d), y = corner.sign * (line.left.dot(d) + line.sideways);
  // A corner wholly on the other side is not overlapped.
  const double near = beside(corner.sign, part), far = beside(-corner.sign, part);
  const double abeam = -y > far ? -y - far : y - near;
  const double ahead = x - line.most - front(part), behind = line.least - x - rear(part);
  const double most = std::max({abeam, ahead, behind});
  return {part, most == abeam ? kBeside : most == ahead ? kAhead : kBehind, most};
}

// The distance from the ring that the body sweeps, or rather from its inner side and its outer corners.
ChainContacts::Place ChainContacts::look_from_arc(const ArcChain& chain, const Corner& corner,
                                                  std::uint32_t part) const {
  const std::size_t i = part / 2;
  const ArcChain::Arc& arc = chain.arcs[i];
  const Vec2 d = corner.place - arc.center;
  const double r = d.norm();
  Place place{part, kNothing, kInfinity};
  const auto nearer = [&place, part](double distance, Kind kind) {
    if (distance < place.distance) place = {part, kind, distance};
  };
  const double off = r - arc.radius, inwards = beside(arc.sign, part);
  const bool is_abeam = off > -inwards && off < beside(-arc.sign, part);
  const bool is_inside = is_abeam ? corner.sign == arc.sign : off <= -inwards;
  if (is_inside && arc.radius > inwards) {  // else the body covers the center, and leaves no room inside
    if (passes(chain, i, d, 0.0, 1.0)) nearer(arc.radius - r - inwards, kInside);
    return place;
  }
  const double outwards = outwards_on(arc, part);
  if (passes(chain, i, d, front(part), outwards)) nearer(r - norm_of(front(part), outwards), kFrontCorner);
  if (passes(chain, i, d, -rear(part), outwards)) nearer(r - norm_of(rear(part), outwards), kRearCorner);
  return place;
}

ChainContacts::Place ChainContacts::look(const ArcChain& chain, std::size_t contact) const {
  if (contact >= corners_.size()) return look_at(chain, edges_[contact - corners_.size()]);
  const Corner& corner = corners_[contact];
  Place nearest{corner.first, kNothing, kInfinity};
  for (std::uint32_t part = corner.first; part <= corner.last; ++part) {
    const Place place = look_from(chain, corner, part);
    if (place.distance < nearest.distance) nearest = place;
  }
  return nearest;
}

ChainContacts::Place ChainContacts::look_around(const ArcChain& chain, std::size_t contact) {
  if (contact < corners_.size()) {
    Corner& corner = corners_[contact];
    const auto last = static_cast<std::uint32_t>(2 * chain.arcs.size());
    while (corner.first > 0 && is_seen(look_from(chain, corner, corner.first - 1))) --corner.first;
    while (corner.last < last && is_seen(look_from(chain, corner, corner.last + 1))) ++corner.last;
  }
  return look(chain, contact);
}

ChainContacts::Place ChainContacts::look_at(const ArcChain& chain, const Edge& edge) const {
  const std::size_t i = edge.arc;
  const ArcChain::Arc& arc = chain.arcs[i];
  const std::uint32_t part = 2 * edge.arc + 1;
  const double outwards = outwards_on(arc, part);
  Place nearest{part, kNothing, kInfinity};
  const auto look = [&](const Vec2& corner, Kind kind) {
    const double along = edge.along.dot(corner - edge.from), distance = edge.outwards.dot(corner - edge.from);
    const bool faces = along >= 0.0 && along <= edge.length && distance >= -kBehindEdge * body_length();
    if (faces && distance < nearest.distance) nearest = {part, kind, distance};
  };
  if (passes(chain, i, -edge.outwards, edge.ahead, outwards)) {
    look(arc.center - norm_of(edge.ahead, outwards) * edge.outwards, kSwing);
    return nearest;
  }
  for (const Kind kind : {kAtEntry, kAtExit}) {
    const Vec2& heading = chain.lines[kind == kAtEntry ? i : i + 1].ahead;
    look(arc.center + edge.ahead * heading - arc.sign * outwards * perpendicular(heading), kind);
  }
  return nearest;
}

namespace {

// The least and the largest distance of a point from an edge.
struct DistanceRange {
  double least, most;
};
DistanceRange distances(const Vec2& point, const Vec2& from, const Vec2& along, double length) {
  const Vec2 d = point - from;
  const double x = along.dot(d), y = cross(along, d);
  const double beyond = std::max({0.0, -x, x - length});
  return {norm_of(beyond, y), norm_of(std::max(std::abs(x), std::abs(x - length)), y)};
}

}  // namespace

// The corner moves on a circle, and near to where it is in the middle of the arc.
double ChainContacts::room(const ArcChain& chain, std::size_t contact, double near) const {
  if (contact < corners_.size()) return 0.0;
  const Edge& edge = edges_[contact - corners_.size()];
  const ArcChain::Arc& arc = chain.arcs[edge.arc];
  const double outwards = outwards_on(arc, 2 * edge.arc + 1), swing = norm_of(edge.ahead, outwards);
  const double turn = chain.turn(edge.arc);
  const double half = turn < kBentTurn ? 0.5 * swing * turn : kInfinity;
  const Vec2 heading = (chain.lines[edge.arc].ahead + chain.lines[edge.arc + 1].ahead).normalized();
  const Vec2 middle = arc.center + edge.ahead * heading - arc.sign * outwards * perpendicular(heading);
  const double in_front =
      std::min(edge.outwards.dot(arc.center - edge.from) + swing, edge.outwards.dot(middle - edge.from) + half);
  const double behind = kBehindEdge * body_length();
  if (in_front < -behind) return -behind - in_front;
  const DistanceRange of_center = distances(arc.center, edge.from, edge.along, edge.length);
  const double beside = std::max(of_center.least - swing, swing - of_center.most);
  return std::max(beside, distances(middle, edge.from, edge.along, edge.length).least - half) - near;
}

Term ChainContacts::term(const ArcChain& chain, std::size_t contact, const Place& place) const {
  if (contact >= corners_.size()) return edge_term(chain, edges_[contact - corners_.size()], place);
  const Corner& corner = corners_[contact];
  return place.is_on_line() ? line_term(chain, corner, place) : arc_term(chain, corner, place);
}

Term ChainContacts::line_term(const ArcChain& chain, const Corner& corner, const Place& place) const {
  const LineView line = line_at(chain, place.index());
  const Vec2 d = corner.place - line.center;
  const double x = line.ahead.dot(d), y = line.left.dot(d);
  const bool is_beside = place.kind == kBeside;
  double sign = place.kind == kBehind ? -1.0 : 1.0;
  if (is_beside)
    sign = corner.sign * (corner.sign * (y + line.sideways) < -beside(-corner.sign, place.part) ? -1.0 : 1.0);
  // The direction away from the body, and how it turns with the heading.
  const Vec2 away = sign * (is_beside ? line.left : line.ahead);
  const Vec2 turned = perpendicular(away);
  Term term;
  term.value = place.distance;
  auto& g = term.gradient;
  g.segment<2>(kCenterX) = -away;
  g[kHeading] = turned.dot(d);
  term.curve(kHeading, kHeading, -sign * (is_beside ? y : x));
  term.curve(kHeading, kCenterX, -turned.x());
  term.curve(kHeading, kCenterY, -turned.y());
  if (is_beside && place.index() > 0) g[kRadius] = sign * chain.arcs[place.index() - 1].sign;
  if (place.kind == (chain.lines[place.index()].gear > 0.0 ? kAhead : kBehind)) g[kLength] = -1.0;
  return term;
}

namespace {

// Derivatives of the distance of a corner of the body from the center of the turn.
void set_swing(double ahead, double outwards, Term& term) {
  const double swing = norm_of(ahead, outwards);
  term.gradient[kRadius] = -outwards / swing;
  term.curve(kRadius, kRadius, -ahead * ahead / (swing * swing * swing));
}

}  // namespace

Term ChainContacts::arc_term(const ArcChain& chain, const Corner& corner, const Place& place) const {
  const ArcChain::Arc& arc = chain.arcs[place.index()];
  const Vec2 d = corner.place - arc.center;
  const double r = d.norm();
  const Vec2 w = d / r;
  const double sign = place.kind == kInside ? 1.0 : -1.0;
  Term term;
  term.value = place.distance;
  term.gradient.segment<2>(kCenterX) = sign * w;
  term.hessian.block<2, 2>(kCenterX, kCenterX) = -sign / r * (Eigen::Matrix2d::Identity() - w * w.transpose());
  if (place.kind == kInside) {
    term.gradient[kRadius] = 1.0;
  } else {
    set_swing(place.kind == kFrontCorner ? front(place.part) : rear(place.part), outwards_on(arc, place.part), term);
  }
  return term;
}

Term ChainContacts::edge_term(const ArcChain& chain, const Edge& edge, const Place& place) const {
  const ArcChain::Arc& arc = chain.arcs[edge.arc];
  const double outwards = outwards_on(arc, place.part);
  Term term;
  term.value = place.distance;
  term.gradient.segment<2>(kCenterX) = edge.outwards;
  if (place.kind == kSwing) {
    set_swing(edge.ahead, outwards, term);
    return term;
  }
  const bool at_entry = place.kind == kAtEntry;
  const auto heading = at_entry ? kHeading : kNextHeading;
  const Vec2& t = chain.lines[at_entry ? edge.arc : edge.arc + 1].ahead;
  const double along = edge.outwards.dot(t), across = edge.outwards.dot(perpendicular(t));
  term.gradient[kRadius] = -arc.sign * across;
  term.gradient[heading] = edge.ahead * across + arc.sign * outwards * along;
  term.curve(heading, heading, -edge.ahead * along + arc.sign * outwards * across);
  term.curve(heading, kRadius, arc.sign * along);
  return term;
}

bool ChainContacts::find(const ArcChain& chain, const Around& around, const Bodies& bodies) {
  body_ = bodies.body;
  corners_.clear();
  edges_.clear();
  sights_.clear();
  const auto parts = static_cast<std::uint32_t>(2 * chain.arcs.size() + 1);
  growths_.assign(bodies.growths.begin(), bodies.growths.end());
  StopTicker ticker(around.clock);
  for (std::uint32_t part = 0; part < parts; ++part)
    if (!find_near(chain, part, around, ticker)) return false;
  std::ranges::sort(sights_, {}, [](const Sight& s) { return std::pair(s.vertex, s.part); });
  for (std::size_t first = 0; first < sights_.size();) {
    std::size_t last = first + 1;
    while (last < sights_.size() && sights_[last].vertex == sights_[first].vertex &&
           sights_[last].part - sights_[last - 1].part <= 1)
      ++last;
    add_corners(chain, around.world, first, last);
    first = last;
  }
  return true;
}

// Of consecutive parts that a corner is near to: those around the nearest one from which it is seen on the same side,
// then the others on either side of these.
void ChainContacts::add_corners(const ArcChain& chain, const World& world, std::size_t first, std::size_t last) {
  const auto at = [this](std::size_t i) { return sights_.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto nearest =
      static_cast<std::size_t>(std::ranges::min_element(at(first), at(last), {}, &Sight::distance) - sights_.begin());
  const Sight& sight = sights_[nearest];
  if (sight.distance == kInfinity) return;
  Corner corner{world.vertex(sight.vertex), sight.sign, sight.part, sight.part};
  const auto is_on_this_side = [&](std::size_t i) {
    return look_from(chain, corner, sights_[i].part).distance >= -kWrongSide * body_length();
  };
  std::size_t low = nearest, high = nearest + 1;
  while (low > first && is_on_this_side(low - 1)) --low;
  while (high < last && is_on_this_side(high)) ++high;
  corner.first = sights_[low].part;
  corner.last = sights_[high - 1].part;
  corners_.push_back(corner);
  if (low > first + 1) add_corners(chain, world, first, low - 1);
  if (high + 1 < last) add_corners(chain, world, high + 1, last);
}

bool ChainContacts::find_near(const ArcChain& chain, std::uint32_t part, const Around& around, StopTicker& ticker) {
  const World& world = around.world;
  const Box near = box_of(chain, part).grown(around.reach);
  near_.clear();
  // Sums over contacts round by their order.
  around.outlines.as_new().visit_if([&near](const Box& box) { return box.overlaps(near); },
                                    [this](const Outlines::Piece& piece) {
                                      for (std::size_t k = 0; k < piece.edge_count(); ++k)
                                        near_.push_back(piece.first + static_cast<VertexId>(k));
                                      return true;
                                    });
  for (const VertexId v : near_) {
    if (ticker.is_over()) return false;
    if (part % 2 == 1) add_edges(chain, part / 2, around, v);
    if (world.is_convex(v) && near.contains(world.vertex(v))) add_sight(chain, part, world, v);
  }
  return true;
}

void ChainContacts::add_edges(const ArcChain& chain, std::uint32_t arc, const Around& around, VertexId vertex) {
  const World& world = around.world;
  const Vec2 &from = world.vertex(vertex), &to = world.vertex(world.next(vertex));
  const double length = (to - from).norm();
  const Vec2 along = (to - from) / length;
  for (const double ahead : {front(2 * arc + 1), -rear(2 * arc + 1)}) {
    const Edge edge{from, along, -perpendicular(along), length, arc, ahead};
    const Place place = look_at(chain, edge);
    if (place.kind == kNothing || (place.distance >= 0.0 && place.distance < around.reach)) edges_.push_back(edge);
  }
}

void ChainContacts::add_sight(const ArcChain& chain, std::uint32_t part, const World& world, VertexId vertex) {
  const std::size_t i = part / 2;
  if (part % 2 == 0) {
    const LineView line = line_at(chain, i);
    const Vec2 d = world.vertex(vertex) - line.center;
    const double x = line.ahead.dot(d), y = line.left.dot(d) + line.sideways;
    const double beyond = std::max({0.0, line.least - x, x - line.most});
    sights_.push_back({vertex, part, norm_of(beyond, y), y >= 0.0 ? 1.0 : -1.0});
    return;
  }
  const ArcChain::Arc& arc = chain.arcs[i];
  const Vec2 d = world.vertex(vertex) - arc.center;
  const double r = d.norm();
  const double distance = passes(chain, i, d, 0.0, 1.0) ? std::abs(r - arc.radius) : kInfinity;
  sights_.push_back({vertex, part, distance, r < arc.radius ? arc.sign : -arc.sign});
}

}  // namespace arcway::internal
