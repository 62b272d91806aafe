#include "arcway/datasets/adversarial_world.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "datasets/generators/layout.h"

namespace arcway {

using namespace internal;
namespace {

using detail::box_ring;
using detail::Layout;

constexpr double kCellSize = 20.0;  // side of a motif's cell [m]; the motif leaves 2 m free on all sides

using Motif = std::vector<Polygon>;

Polygon only(Ring ring) { return {std::move(ring), {}}; }
Polygon box(double left, double bottom, double right, double top) { return only(box_ring(left, bottom, right, top)); }

std::vector<Motif> touching_motifs() {
  return {
      {box(2, 2, 8, 8), box(8, 8, 16, 14)},                              // corner on corner
      {box(2, 2, 8, 18), only({{8, 10}, {12, 6}, {16, 10}, {12, 14}})},  // corner on edge
      {box(2, 2, 8, 12), box(8, 6, 16, 16)},                             // part of an edge
      {only({{10, 10}, {3, 9}, {5, 3}}), only({{10, 10}, {14, 3}, {17, 8}}), only({{10, 10}, {12, 17}, {6, 16}})},
      {only({{2, 2}, {18, 2}, {18, 6}, {8, 6}, {8, 18}, {2, 18}}), only({{8, 6}, {15, 11}, {12, 16}})},  // in a notch
      {only({{10, 10}, {4, 14}, {4, 6}, {10, 10}, {16, 6}, {16, 14}})},  // a ring through a point twice
  };
}

std::vector<Motif> shared_motifs() {
  return {
      {box(2, 2, 10, 10), box(10, 2, 18, 10), box(2, 10, 10, 18), box(10, 10, 18, 18)},
      {only({{10, 10}, {18, 10}, {14, 17}}), only({{10, 10}, {14, 17}, {6, 17}}), only({{10, 10}, {6, 17}, {2, 10}}),
       only({{10, 10}, {2, 10}, {6, 3}}), only({{10, 10}, {6, 3}, {14, 3}}), only({{10, 10}, {14, 3}, {18, 10}})},
      {only({{2, 2}, {18, 2}, {18, 8}, {8, 8}, {8, 18}, {2, 18}}), box(8, 8, 18, 18)},
      {{box_ring(2, 2, 18, 18), {box_ring(6, 6, 14, 14)}}, box(6, 6, 14, 14)},
      {only({{2, 4}, {7, 4}, {4, 15}}), only({{7, 4}, {10, 15}, {4, 15}}), only({{7, 4}, {13, 4}, {10, 15}}),
       only({{13, 4}, {16, 15}, {10, 15}})},
  };
}

std::vector<Motif> nested_motifs() {
  return {
      {box(2, 2, 18, 18), box(5, 5, 9, 9), only({{10, 10}, {16, 11}, {12, 16}})},
      {{box_ring(2, 2, 18, 18), {box_ring(4, 4, 16, 16)}}, box(7, 7, 13, 13)},
      {{box_ring(2, 2, 18, 18), {box_ring(3, 3, 17, 17)}},
       {box_ring(5, 5, 15, 15), {box_ring(6, 6, 14, 14)}},
       box(8, 8, 12, 12)},
      {box(2, 2, 18, 18), only({{2, 2}, {12, 6}, {6, 12}})},  // inside, from a common corner
      {box(2, 2, 18, 18), box(2, 6, 10, 14)},                 // inside, along an edge
      {{box_ring(2, 2, 18, 18), {box_ring(6, 6, 14, 14)}}, box(6, 8, 10, 12), box(10, 14, 12, 16)},
  };
}

std::vector<Motif> holes_motifs() {
  std::vector<Ring> rows;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) rows.push_back(box_ring(3 + 5 * i, 3 + 5 * j, 7 + 5 * i, 7 + 5 * j));
  return {
      {{box_ring(2, 2, 18, 18), std::move(rows)}},
      {{box_ring(2, 2, 18, 18), {box_ring(4, 4, 10, 10), box_ring(10, 10, 16, 16)}}},  // corner on corner
      {{box_ring(2, 2, 18, 18),
        {Ring{{2, 10}, {6, 6}, {6, 14}}, box_ring(9, 5, 16, 15)}}},  // a corner on the outer edge
      {{box_ring(2, 2, 18, 18), {Ring{{2, 2}, {9, 4}, {4, 9}}, Ring{{18, 18}, {11, 16}, {16, 11}}}}},
      {{Ring{{2, 2}, {18, 2}, {18, 10}, {14, 18}, {2, 18}},
        {Ring{{4, 4}, {16, 4}, {16, 6}, {6, 6}, {6, 16}, {4, 16}}, Ring{{9, 9}, {14, 9}, {12, 14}, {9, 12}}}}},
  };
}

std::size_t vertices_of(const Motif& motif) {
  std::size_t count = 0;
  for (const Polygon& polygon : motif) {
    count += polygon.outer.size();
    for (const Ring& hole : polygon.holes) count += hole.size();
  }
  return count;
}

void square_bounds(Layout& layout, double side) { layout.set_bounds(box_ring(0.0, 0.0, side, side)); }

// Random motifs in a square grid, each turned by a random number of quarters.
void lay_out_motifs(Layout& layout, std::span<const Motif> motifs) {
  Random& random = layout.random;
  std::vector<std::size_t> chosen;
  for (std::size_t count = 4; count < layout.wanted; count += vertices_of(motifs[chosen.back()]))
    chosen.push_back(random.below(motifs.size()));
  const std::size_t columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(chosen.size()))));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const Vec2 corner = kCellSize * Vec2(static_cast<double>(i % columns), static_cast<double>(i / columns));
    const std::uint64_t quarters = random.below(4);
    const auto placed = [&](const Ring& ring) {
      Ring result;
      for (Vec2 p : ring) {
        for (std::uint64_t k = 0; k < quarters; ++k) p = Vec2(kCellSize - p.y(), p.x());
        result.push_back(corner + p);
      }
      return result;
    };
    for (const Polygon& polygon : motifs[chosen[i]]) {
      std::vector<Ring> holes;
      for (const Ring& hole : polygon.holes) holes.push_back(placed(hole));
      layout.add(placed(polygon.outer), std::move(holes));
    }
  }
  square_bounds(layout, kCellSize * static_cast<double>(columns));
}

void lay_out_collinear(Layout& layout) {
  constexpr double kBox = 4.0, kPitch = 10.0;
  const std::size_t boxes = (layout.wanted - 4) / 6;  // 8 vertices or 4
  const std::size_t columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(boxes))));
  detail::Selection marked(boxes / 2, boxes);
  for (std::size_t i = 0; i < boxes; ++i) {
    const double x = kPitch * static_cast<double>(i % columns) + 3.0,
                 y = kPitch * static_cast<double>(i / columns) + 3.0;
    const double h = 0.5 * kBox, w = kBox;
    if (marked.take(layout.random)) {
      layout.add(
          {{x, y}, {x + h, y}, {x + w, y}, {x + w, y + h}, {x + w, y + w}, {x + h, y + w}, {x, y + w}, {x, y + h}});
    } else {
      layout.add(box_ring(x, y, x + w, y + w));
    }
  }
  square_bounds(layout, kPitch * static_cast<double>(columns));
}

void lay_out_needles(Layout& layout) {
  constexpr double kCell = 24.0;
  constexpr std::size_t kNeedles = 3;  // in a cell, a few meters apart
  Random& random = layout.random;
  const std::size_t cells = (layout.wanted - 4) / (3 * kNeedles);
  const std::size_t columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(cells))));
  for (std::size_t i = 0; i < cells; ++i) {
    const Vec2 center = kCell * Vec2(static_cast<double>(i % columns) + 0.5, static_cast<double>(i / columns) + 0.5);
    const Vec2 u = random.unit_vector(), v(-u.y(), u.x());
    for (const double offset : {-6.0, 0.0, 6.0}) {
      const double length = random.uniform(14.0, 20.0), tilt = random.uniform(-1e-6, 1e-6);
      const double width = std::ldexp(1.0, -10 - static_cast<int>(random.below(21)));
      const Vec2 base = center + offset * v - 0.5 * length * u;
      layout.add({base, base + length * u + tilt * v, base + width * v});
    }
  }
  square_bounds(layout, kCell * static_cast<double>(columns));
}

void lay_out_far(Layout& layout) {
  // Near 1e7, and within 2^23, where the default safety margin still is many units in the last place.
  const Vec2 offset(8e6, -8e6);
  Clutter clutter = generate_clutter(
      {.kind = ClutterKind::kMixed, .obstacles = (layout.wanted - 4) / 8, .vertices = 8, .seed = layout.random.next()});
  for (Polygon& polygon : clutter.obstacles) {
    for (Vec2& p : polygon.outer) p += offset;
    layout.add(std::move(polygon.outer));
  }
  for (Vec2& p : clutter.bounds) p += offset;
  layout.set_bounds(std::move(clutter.bounds));
}

void lay_out_overlapping(Layout& layout) {
  constexpr std::size_t kVertices = 8;
  Random& random = layout.random;
  const std::size_t stars = (layout.wanted - 4) / kVertices;
  const double side = 14.0 * std::sqrt(static_cast<double>(stars));
  Ring ring;
  for (std::size_t i = 0; i < stars; ++i) {
    if (i == 0 || random.below(10) != 0) {  // else the last one again
      ring.clear();
      const double x = random.uniform(9.0, side - 9.0), y = random.uniform(9.0, side - 9.0);
      for (std::size_t k = 0; k < kVertices; ++k) {
        const double turn = (static_cast<double>(k) + random.uniform(0.0, 0.8)) / static_cast<double>(kVertices);
        ring.push_back(Vec2(x, y) + random.uniform(3.0, 8.0) * unit_vector_at(turn));
      }
    }
    layout.add(ring);
  }
  square_bounds(layout, side);
}

void lay_out_contacts(Layout& layout) {
  constexpr double kSquare = 4.0;
  const std::size_t squares = (layout.wanted - 4) / 4;
  const std::size_t columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(squares) / 0.25)));
  detail::Selection blocked(squares, columns * columns);
  for (std::size_t i = 0; i < columns * columns; ++i) {
    if (!blocked.take(layout.random)) continue;
    const double x = kSquare * static_cast<double>(i % columns), y = kSquare * static_cast<double>(i / columns);
    layout.add(box_ring(x, y, x + kSquare, y + kSquare));
  }
  square_bounds(layout, kSquare * static_cast<double>(columns));
}

constexpr double kToothPitch = 4.0;
constexpr double kClearance = 10.0;  // between one large obstacle and the bounds

// Tips on a circle, and between them vertices nearer to its center.
template <class Inner>
void lay_out_teeth(Layout& layout, const Inner& inner_radius) {
  const std::size_t teeth = (layout.wanted - 4) / 2;
  const double radius = kToothPitch * static_cast<double>(teeth) / kTwoPi;
  const double middle = radius + kClearance;
  Ring ring;
  for (std::size_t i = 0; i < 2 * teeth; ++i) {
    const Vec2 u = unit_vector_at(static_cast<double>(i) / static_cast<double>(2 * teeth));
    ring.push_back(Vec2(middle, middle) + (i % 2 == 0 ? radius : inner_radius(radius)) * u);
  }
  layout.add(std::move(ring));
  square_bounds(layout, 2.0 * middle);
}

void lay_out_comb(Layout& layout) {
  constexpr double kHeight = 40.0, kBack = 2.0;
  const std::size_t teeth = (layout.wanted - 6) / 2;
  Ring ring{{kClearance, kClearance}};
  const double length = kToothPitch * static_cast<double>(teeth);
  ring.push_back({kClearance + length, kClearance});
  for (std::size_t i = teeth; i-- > 0;) {
    const double x = kClearance + kToothPitch * static_cast<double>(i);
    ring.push_back({x + 0.5 * kToothPitch, kClearance + kHeight});
    ring.push_back({x, kClearance + kBack + layout.random.uniform(0.0, 1.0)});
  }
  layout.add(std::move(ring));
  square_bounds(layout, 2.0 * kClearance + std::max(length, kHeight));
}

void lay_out_rings(Layout& layout) {
  constexpr double kPitch = 8.0;
  const std::size_t rings = (layout.wanted - 4) / 8;
  const double middle = kPitch * static_cast<double>(rings + 1) + kClearance;
  const auto ring_at = [&](double r) {
    return Ring{{middle + r, middle}, {middle, middle + r}, {middle - r, middle}, {middle, middle - r}};
  };
  for (std::size_t i = 0; i < rings; ++i) {
    const double r = kPitch * static_cast<double>(i + 1);
    layout.add(ring_at(r + layout.random.uniform(2.0, 4.0)), {ring_at(r)});
  }
  square_bounds(layout, 2.0 * middle);
}

}  // namespace

const char* name_of(AdversarialKind kind) {
  switch (kind) {
    case AdversarialKind::kTouching:
      return "touching";
    case AdversarialKind::kShared:
      return "shared";
    case AdversarialKind::kCollinear:
      return "collinear";
    case AdversarialKind::kNeedles:
      return "needles";
    case AdversarialKind::kFar:
      return "far";
    case AdversarialKind::kNested:
      return "nested";
    case AdversarialKind::kOverlapping:
      return "overlapping";
    case AdversarialKind::kContacts:
      return "contacts";
    case AdversarialKind::kHoles:
      return "holes";
    case AdversarialKind::kSaw:
      return "saw";
    case AdversarialKind::kComb:
      return "comb";
    case AdversarialKind::kSpikes:
      return "spikes";
    case AdversarialKind::kRings:
      return "rings";
  }
  return "unknown";
}

MapFile generate_adversarial_world(const AdversarialParameters& parameters) {
  detail::check_vertices(name_of(parameters.kind), parameters.vertices);
  Layout layout(parameters.vertices, parameters.seed);
  switch (parameters.kind) {
    case AdversarialKind::kTouching:
      lay_out_motifs(layout, touching_motifs());
      break;
    case AdversarialKind::kShared:
      lay_out_motifs(layout, shared_motifs());
      break;
    case AdversarialKind::kCollinear:
      lay_out_collinear(layout);
      break;
    case AdversarialKind::kNeedles:
      lay_out_needles(layout);
      break;
    case AdversarialKind::kFar:
      lay_out_far(layout);
      break;
    case AdversarialKind::kNested:
      lay_out_motifs(layout, nested_motifs());
      break;
    case AdversarialKind::kOverlapping:
      lay_out_overlapping(layout);
      break;
    case AdversarialKind::kContacts:
      lay_out_contacts(layout);
      break;
    case AdversarialKind::kHoles:
      lay_out_motifs(layout, holes_motifs());
      break;
    case AdversarialKind::kSaw:
      lay_out_teeth(layout, [&](double radius) { return radius - layout.random.uniform(1.0, 3.0); });
      break;
    case AdversarialKind::kComb:
      lay_out_comb(layout);
      break;
    case AdversarialKind::kSpikes:
      lay_out_teeth(layout, [&](double radius) { return radius * layout.random.uniform(0.3, 0.4); });
      break;
    case AdversarialKind::kRings:
      lay_out_rings(layout);
      break;
  }
  return std::move(layout.map);
}

}  // namespace arcway
