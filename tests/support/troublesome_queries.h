#pragma once

#include <cmath>
#include <vector>

#include "arcway/sweep_query.h"
#include "arcway/world.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::test {

/// Worlds and questions that look for trouble: whole multiples of a power of two, so that collinear triples, touching
/// and overlapping obstacles, common vertices and axis-parallel walls abound, at any size and any place.
class TroublesomeQueries {
 public:
  /// @param size    of the map [m], a power of two.
  /// @param offset  of its lower left corner [m], a multiple of size / 64.
  TroublesomeQueries(std::uint64_t seed, double size, double offset)
      : random_(seed), unit_(size / kCells), offset_(offset), world_(make_world()) {}

  [[nodiscard]] const World& world() const { return world_; }
  RandomInputs& random() { return random_; }

  LineSegment segment() {
    switch (random_.integer(0, 8)) {
      case 0: {  // axis-parallel, perhaps along walls
        const Vec2 a = any_point();
        const Vec2 b = any_point();
        return random_.integer(0, 1) == 0 ? LineSegment{a, {b.x(), a.y()}} : LineSegment{a, {a.x(), b.y()}};
      }
      case 1: {
        const Vec2 a = grid_point();
        const Vec2 b = grid_point();
        return random_.integer(0, 1) == 0 ? LineSegment{a, {b.x(), a.y()}} : LineSegment{a, {a.x(), b.y()}};
      }
      case 2: {  // axis-parallel from a vertex
        const Vec2 a = vertex();
        const Vec2 b = any_point();
        return random_.integer(0, 1) == 0 ? LineSegment{a, {b.x(), a.y()}} : LineSegment{{a.x(), b.y()}, a};
      }
      case 3:
        return {vertex(), vertex()};
      case 4:
        return {any_point(), vertex()};
      case 5: {  // along an edge, shorter or longer; also through its ends
        const LineSegment& e = edge();
        const double s = 0.25 * static_cast<double>(random_.integer(-8, 12));
        const double t = 0.25 * static_cast<double>(random_.integer(-8, 12));
        return {e.a + s * (e.b - e.a), e.a + t * (e.b - e.a)};
      }
      case 6: {  // short
        const Vec2 a = any_point();
        return {a, a + std::ldexp(unit_, -static_cast<int>(random_.integer(0, 30))) * random_.point(-1.0, 1.0)};
      }
      case 7: {  // far out
        const Vec2 a = any_point();
        return {a, a + std::ldexp(unit_, static_cast<int>(random_.integer(6, 60))) * random_.point(-1.0, 1.0)};
      }
      default:
        return {any_point(), any_point()};
    }
  }

  Vec2 point() {
    switch (random_.integer(0, 5)) {
      case 0: {
        const LineSegment& e = edge();
        return 0.5 * (e.a + e.b);
      }
      case 1:  // middle of a cell: as near to one wall as to the other
        return grid_point() + Vec2(0.5 * unit_, 0.5 * unit_);
      case 2: {
        const double range = std::ldexp(unit_, static_cast<int>(random_.integer(0, 40)));
        return any_point() + random_.point(-range, range);
      }
      default:
        return any_point();
    }
  }

  Footprint body() {
    const double length = unit_ * random_.uniform(0.1, 8.0);
    const double rear = random_.uniform(-0.2, 1.0) * length;
    const double width = unit_ * std::exp(random_.uniform(-4.0, 2.0));
    const double right = random_.integer(0, 1) == 0 ? width : random_.uniform(-0.2, 2.2) * width;
    return {length - rear, rear, 2.0 * width - right, right};
  }

  SweptRectangle rectangle() {
    if (random_.integer(0, 2) == 0) {  // axis-parallel on the grid: sides along walls, corners on vertices
      const Vec2 a = grid_point();
      const Vec2 b = a + unit_ * random_.grid_point(1, 8);
      return {a, Vec2(b.x(), a.y()), b, Vec2(a.x(), b.y())};
    }
    const Vec2 at = point();
    const Pose pose{at.x(), at.y(), random_.integer(0, 3) == 0 ? 0.0 : random_.uniform(0.0, kTwoPi)};
    return swept_rectangle(pose, unit_ * std::exp(random_.uniform(-4.0, 4.0)), body());
  }

  TurningBody turning_body() {
    return {point(), unit_ * random_.uniform(0.1, 8.0), random_.integer(0, 1) == 0 ? Side::kLeft : Side::kRight,
            body()};
  }

 private:
  static constexpr std::int64_t kCells = 64;

  Vec2 at_cell(const Vec2& cell) const { return Vec2(offset_, offset_) + unit_ * cell; }
  Vec2 grid_point() { return at_cell(random_.grid_point(-4, kCells + 4)); }
  Vec2 vertex() { return world_.vertex(static_cast<VertexId>(random_.integer(0, last_vertex()))); }
  const LineSegment& edge() { return world_.edges()[static_cast<std::size_t>(random_.integer(0, last_vertex()))]; }
  Vec2 any_point() {
    const std::int64_t kind = random_.integer(0, 2);
    if (kind == 0) return vertex();
    return kind == 1 ? grid_point() : at_cell(random_.point(-4.0, static_cast<double>(kCells) + 4.0));
  }
  [[nodiscard]] std::int64_t last_vertex() const { return static_cast<std::int64_t>(world_.vertices().size()) - 1; }

  World make_world() {
    std::vector<Polygon> obstacles;
    const std::int64_t count = random_.integer(1, 24);
    for (std::int64_t i = 0; i < count; ++i) {
      const Vec2 low = random_.grid_point(0, kCells - 10);
      const Vec2 size = random_.grid_point(2, 10);
      const Vec2 high = low + size;
      switch (random_.integer(0, 3)) {
        case 0:
          obstacles.push_back({{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}});
          break;
        case 1:  // collinear vertices on its sides
          obstacles.push_back({{low, {low.x() + 1, low.y()}, {high.x(), low.y()}, {high.x(), low.y() + 1}, high}, {}});
          break;
        case 2: {  // a frame: a hole within
          if (size.minCoeff() < 4) continue;
          const Vec2 in = low + Vec2(1, 1);
          const Vec2 out = high - Vec2(1, 1);
          obstacles.push_back({{low, {high.x(), low.y()}, high, {low.x(), high.y()}},
                               {{in, {in.x(), out.y()}, out, {out.x(), in.y()}}}});
          break;
        }
        default:
          obstacles.push_back({random_star(random_, low + 0.5 * size, 1.0, 5.0, 7), {}});
          break;
      }
    }
    if (obstacles.empty()) obstacles.push_back({square(8, 8, 4), {}});
    for (Polygon& obstacle : obstacles) {
      for (Vec2& p : obstacle.outer) p = at_cell(p);
      for (Ring& hole : obstacle.holes)
        for (Vec2& p : hole) p = at_cell(p);
    }
    if (random_.integer(0, 1) == 0) return World(std::move(obstacles));
    Ring bounds;
    for (const Vec2& p : square(0, 0, kCells)) bounds.push_back(at_cell(p));
    return World(std::move(obstacles), std::move(bounds));
  }

  RandomInputs random_;
  double unit_;
  double offset_;
  World world_;
};

}  // namespace arcway::internal::test
