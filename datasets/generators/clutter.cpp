#include "arcway/datasets/clutter.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/model/pose_text.h"
#include "datasets/generators/layout.h"
#include "datasets/io/random.h"

namespace arcway {

using namespace internal;
namespace {

constexpr std::size_t kMostVertices = std::size_t{1} << 28;  // vertices of all obstacles
constexpr double kLargestSide = 1e9;                         // [m], as far out as the planner takes poses
constexpr double kSlack = 1e-9;                              // [m], so that rounding does not eat into the gap

[[noreturn]] void refuse(const char* parameter, double value, const std::string& limit) {
  throw std::invalid_argument(std::string("clutter: ") + parameter + " is " + shortest_text(value) + ", must be " +
                              limit);
}

void check(const ClutterParameters& p) {
  const bool rectangles = p.kind == ClutterKind::kRectangle;
  if (p.vertices < 3 && !rectangles) refuse("vertices", static_cast<double>(p.vertices), "at least 3");
  if (const std::size_t each = rectangles ? 4 : p.vertices; p.obstacles > kMostVertices / each)
    throw std::invalid_argument("clutter: obstacles is " + std::to_string(p.obstacles) + " with " +
                                std::to_string(each) + " vertices each, at most " + std::to_string(kMostVertices) +
                                " vertices are made");
  if (!(p.fill > 0.0 && p.fill <= 0.6)) refuse("fill", p.fill, "in (0, 0.6]");
  if (!(p.min_gap >= 0.0 && std::isfinite(p.min_gap))) refuse("min_gap", p.min_gap, "finite and not negative");
  if (!(p.min_radius > 0.0 && std::isfinite(p.min_radius))) refuse("min_radius", p.min_radius, "finite and positive");
  if (!(p.max_radius >= p.min_radius && p.max_radius <= 1e6))
    refuse("max_radius", p.max_radius, "at least min_radius and at most 1e6");
}

double area_of(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) twice += cross(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  return 0.5 * twice;
}

// A polygon within the circle of this radius about the origin. `roundness` in [0, 1] takes the chance out of it.
Ring draw_shape(Random& random, const ClutterParameters& p, double radius, double roundness) {
  if (p.kind == ClutterKind::kRectangle) {
    const Vec2 half = Vec2(random.uniform(1.0, 4.0), 1.0).normalized() * radius;
    const Vec2 u = random.unit_vector();
    const Vec2 along = u * half.x(), across = perpendicular(u) * half.y();
    return {along + across, across - along, -along - across, along - across};
  }
  const bool star = p.kind == ClutterKind::kStar || (p.kind == ClutterKind::kMixed && random.below(2) == 0);
  // Gaps below half a turn keep a star simple. A round star keeps some of its dents.
  const double spread = (star ? 0.2 : 0.4) * (1.0 - roundness);
  const double dent = star ? 0.5 * (1.0 - 0.8 * roundness) : 0.0;
  const double phase = random.uniform();
  Ring ring(p.vertices);
  for (std::size_t i = 0; i < p.vertices; ++i) {
    const double turn =
        (static_cast<double>(i) + random.uniform(-spread, spread)) / static_cast<double>(p.vertices) + phase;
    ring[i] = unit_vector_at(turn - std::floor(turn)) * (radius * (1.0 - dent * random.uniform()));
  }
  return ring;
}

// `count` widths of random size, in total 1.
std::vector<double> split(Random& random, std::size_t count) {
  std::vector<double> widths(count);
  double total = 0.0;
  for (double& w : widths) total += w = random.uniform(0.75, 1.25);
  for (double& w : widths) w /= total;
  return widths;
}

// Columns of cells, about as high as wide, that tile [margin, side - margin]^2.
std::vector<Box> cut_cells(Random& random, std::size_t count, double side, double margin) {
  const double inner = side - 2.0 * margin;
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const std::vector<double> widths = split(random, columns);
  std::vector<Box> cells;
  cells.reserve(count);
  double x = margin;
  for (std::size_t column = 0; column < columns; ++column) {
    const std::size_t here = count / columns + (column < count % columns ? 1 : 0);
    const double right = x + widths[column] * inner;
    double y = margin;
    for (const double h : split(random, here)) {
      Box cell;
      cell.min = {x, y};
      cell.max = {right, y += h * inner};
      cells.push_back(cell);
    }
    x = right;
  }
  return cells;
}

// The polygon stretched to fill the box. Affine maps keep it convex or simple.
Ring stretch(const Ring& ring, const Box& box) {
  Box own;
  for (const Vec2& p : ring) own.extend(p);
  const Vec2 factor = (box.max - box.min).cwiseQuotient(own.max - own.min);
  Ring result;
  result.reserve(ring.size());
  for (const Vec2& p : ring) result.push_back(box.min + (p - own.min).cwiseProduct(factor));
  return result;
}

// The two halves of a box beside its diagonal, `gap` apart.
void add_halves(const Box& box, double gap, std::vector<Ring>& rings) {
  const double w = box.max.x() - box.min.x(), h = box.max.y() - box.min.y();
  const double rest = 1.0 - 0.5 * gap * std::sqrt(1.0 / (w * w) + 1.0 / (h * h));
  if (rest <= 0.0) return;
  rings.push_back({box.min, {box.min.x() + rest * w, box.min.y()}, {box.min.x(), box.min.y() + rest * h}});
  rings.push_back({box.max, {box.max.x() - rest * w, box.max.y()}, {box.max.x(), box.max.y() - rest * h}});
}

// Obstacles in cells of a jittered grid, as irregular as the fill allows.
std::vector<Ring> pack(Random& random, const ClutterParameters& p, double side, double gap) {
  const bool rectangles = p.kind == ClutterKind::kRectangle;
  const bool triangles = !rectangles && p.vertices == 3;  // fill but half of a cell: two in each
  const std::vector<Box> cells = cut_cells(random, triangles ? (p.obstacles + 1) / 2 : p.obstacles, side, 0.5 * gap);
  const double wanted = p.fill * side * side;
  double best = 0.0;
  for (const double roundness : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    std::vector<Ring> rings;
    rings.reserve(p.obstacles + 1);
    bool room = true;
    for (Box cell : cells) {
      cell.min.array() += 0.5 * gap;
      cell.max.array() -= 0.5 * gap;
      room = room && (cell.max - cell.min).minCoeff() > 0.0;
      if (!room) break;
      if (triangles) {
        add_halves(cell, gap, rings);
      } else if (rectangles) {
        rings.push_back({cell.min, {cell.max.x(), cell.min.y()}, cell.max, {cell.min.x(), cell.max.y()}});
      } else {
        rings.push_back(stretch(draw_shape(random, p, 1.0, roundness), cell));
      }
    }
    if (!room || rings.size() < p.obstacles) break;
    rings.resize(p.obstacles);
    double area = 0.0;
    for (const Ring& ring : rings) area += area_of(ring);
    best = std::max(best, area / (side * side));
    if (area < wanted) continue;
    const double factor = std::sqrt(wanted / area);
    for (Ring& ring : rings) {  // shrunk within its own box, or triangle
      Vec2 fixed;
      if (triangles) {
        const double u = random.uniform(), v = random.uniform();
        fixed = ring[0] + (u + v < 1.0 ? u : 1.0 - u) * (ring[1] - ring[0]) +
                (u + v < 1.0 ? v : 1.0 - v) * (ring[2] - ring[0]);
      } else {
        Box box;
        for (const Vec2& q : ring) box.extend(q);
        const double u = random.uniform(), v = random.uniform();
        fixed = box.min + Vec2(u, v).cwiseProduct(box.max - box.min);
      }
      for (Vec2& q : ring) q = fixed + factor * (q - fixed);
    }
    return rings;
  }
  throw std::invalid_argument("clutter: cannot reach fill " + shortest_text(p.fill) + " with gap " +
                              shortest_text(p.min_gap) + " m and radii from " + shortest_text(p.min_radius) + " to " +
                              shortest_text(p.max_radius) + " m; reached " + shortest_text(best) +
                              ": use larger radii or a smaller gap");
}

}  // namespace

const char* name_of(ClutterKind kind) {
  switch (kind) {
    case ClutterKind::kConvex:
      return "convex";
    case ClutterKind::kStar:
      return "star";
    case ClutterKind::kMixed:
      return "mixed";
    case ClutterKind::kRectangle:
      return "rectangle";
  }
  return "unknown";
}

Clutter generate_clutter(const ClutterParameters& parameters) {
  check(parameters);
  Random random(parameters.seed);
  std::vector<Ring> rings;
  std::vector<double> radii;
  rings.reserve(parameters.obstacles);
  double area = 0.0;
  for (std::size_t i = 0; i < parameters.obstacles; ++i) {
    radii.push_back(random.uniform(parameters.min_radius, parameters.max_radius));
    rings.push_back(draw_shape(random, parameters, radii.back(), 0.0));
    area += area_of(rings.back());
  }
  const double side = rings.empty() ? 10.0 * parameters.max_radius : std::sqrt(area / parameters.fill);
  if (!(side <= kLargestSide))
    refuse("fill", parameters.fill, "large enough for a square of at most " + shortest_text(kLargestSide) + " m");
  if (!rings.empty()) {
    const double gap = parameters.min_gap + kSlack;
    if (const auto centers = detail::scatter_discs(random, radii, side, gap)) {
      for (std::size_t i = 0; i < rings.size(); ++i)
        for (Vec2& p : rings[i]) p += (*centers)[i];
    } else {
      rings = pack(random, parameters, side, gap);
    }
  }
  Clutter clutter;
  clutter.obstacles.reserve(rings.size());
  for (Ring& ring : rings) clutter.obstacles.push_back({std::move(ring), {}});
  clutter.bounds = {{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}};
  return clutter;
}

World random_world(const ClutterParameters& parameters) {
  Clutter clutter = generate_clutter(parameters);
  return World(std::move(clutter.obstacles), std::move(clutter.bounds));
}

}  // namespace arcway
