#include "core/search/route_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/passage/vehicle_gaps.h"
#include "core/search/open_list.h"

namespace arcway {

namespace {

constexpr double kCellsAcross = 4.0;  // of a body's width: a passage that lets it through has a row of cells
constexpr double kAround = 4.0;       // rows around the outlines, in body lengths and turning radii
constexpr std::uint8_t kRight = 1, kUp = 2;
constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr std::uint32_t kAsked = 1024;  // cells between two questions whether to stop

struct Waiting {
  float length;
  std::uint32_t cell;
  friend bool before(const Waiting& a, const Waiting& b) {
    return a.length != b.length ? a.length < b.length : a.cell < b.cell;
  }
};

}  // namespace

RouteField::RouteField(const SearchMap& map, const Pose& frame, const Vec2& place, std::size_t most_cells,
                       const std::function<bool()>& stop)
    : frame_(frame), ahead_(direction_of(frame.heading)), place_(place) {
  lay_out(map, most_cells);
  add_walls(map);
  spread(stop);
}

Vec2 RouteField::in_grid(const Vec2& p) const {
  const Vec2 d = p - frame_.position();
  return (Vec2(ahead_.dot(d), cross(ahead_, d)) - corner_) / size_;
}

void RouteField::lay_out(const SearchMap& map, std::size_t most_cells) {
  Box box;
  const auto extend = [&](const Vec2& p) { box.extend(in_grid(p)); };
  for (std::uint32_t i = 0; i < map.outlines->size(); ++i)
    for (const Vec2& p : (*map.outlines)[i].points) extend(p);
  extend(frame_.position());
  extend(place_);
  const double around = kAround * (map.body.front + map.body.rear + map.vehicle.min_turning_radius());
  box = box.grown(around);
  const Vec2 extent = box.max - box.min;
  size_ = std::max(2.0 * map.body.half_width / kCellsAcross,
                   std::sqrt(extent.x() * extent.y() / static_cast<double>(most_cells)));
  corner_ = box.min;
  width_ = static_cast<std::int64_t>(extent.x() / size_) + 2;
  height_ = static_cast<std::int64_t>(extent.y() / size_) + 2;
  cells_.assign(static_cast<std::size_t>(width_ * height_), {kNever, 0});
}

void RouteField::add_walls(const SearchMap& map) {
  for (std::uint32_t i = 0; i < map.outlines->size(); ++i) {
    const Outlines::Piece piece = (*map.outlines)[i];
    for (std::size_t k = 0; k < piece.edge_count(); ++k) add_wall(piece.points[k], piece.points[k + 1]);
  }
  const double hopeless = widest_hopeless_gap(map.vehicle);
  for (const Gap& gap : map.gaps->map().gaps()) {
    if (gap.width > hopeless) break;
    add_wall(gap.on_a, gap.on_b);
  }
}

// Blocks the steps between cells that a segment crosses.
void RouteField::add_wall(const Vec2& a, const Vec2& b) {
  const Vec2 p = in_grid(a), d = in_grid(b) - p;
  const auto block = [&](double across_from, double rise, double along_from, double run, std::int64_t rows,
                         std::int64_t columns, auto&& cell) {
    const auto first = static_cast<std::int64_t>(std::ceil(std::max(0.0, std::min(across_from, across_from + rise))));
    const double last = std::min(static_cast<double>(rows - 1), std::max(across_from, across_from + rise));
    for (std::int64_t row = first; static_cast<double>(row) <= last; ++row) {
      const double t = rise == 0.0 ? 0.0 : (static_cast<double>(row) - across_from) / rise;
      const auto column = static_cast<std::int64_t>(std::floor(along_from + t * run));
      if (column >= 0 && column + 1 < columns) cell(row, column);
    }
  };
  block(p.y(), d.y(), p.x(), d.x(), height_, width_,
        [&](std::int64_t row, std::int64_t column) { at(column, row).walls |= kRight; });
  block(p.x(), d.x(), p.y(), d.y(), width_, height_,
        [&](std::int64_t row, std::int64_t column) { at(row, column).walls |= kUp; });
}

// Whether a step from a cell along one axis crosses nothing.
bool RouteField::is_open(std::int64_t x, std::int64_t y, int dx, int dy) const {
  const std::int64_t low_x = dx < 0 ? x - 1 : x, low_y = dy < 0 ? y - 1 : y;
  return (at(low_x, low_y).walls & (dx != 0 ? kRight : kUp)) == 0;
}

void RouteField::spread(const std::function<bool()>& stop) {
  OpenList<Waiting> open;
  const auto reach = [&](std::int64_t x, std::int64_t y, float length) {
    Cell& cell = at(x, y);
    if (length >= cell.length) return;
    cell.length = length;
    open.push({length, static_cast<std::uint32_t>(y * width_ + x)});
  };
  const Vec2 place = in_grid(place_);
  const auto x0 = static_cast<std::int64_t>(place.x()), y0 = static_cast<std::int64_t>(place.y());
  for (const std::int64_t x : {x0, x0 + 1})
    for (const std::int64_t y : {y0, y0 + 1})
      if (has(x, y))
        reach(x, y, static_cast<float>((Vec2(static_cast<double>(x), static_cast<double>(y)) - place).norm()));
  for (std::uint32_t i = 0; !open.empty(); ++i) {
    if (i % kAsked == 0 && stop && stop()) break;
    const Waiting here = open.pop();
    const std::int64_t x = here.cell % width_, y = here.cell / width_;
    if (here.length > at(x, y).length) continue;
    longest_ = here.length * size_;
    for (const int dx : {-1, 0, 1})
      for (const int dy : {-1, 0, 1}) {
        if ((dx == 0 && dy == 0) || !has(x + dx, y + dy)) continue;
        const bool is_diagonal = dx != 0 && dy != 0;
        const bool free = is_diagonal ? (is_open(x, y, dx, 0) && is_open(x + dx, y, 0, dy)) ||
                                            (is_open(x, y, 0, dy) && is_open(x, y + dy, dx, 0))
                                      : is_open(x, y, dx, dy);
        if (free) reach(x + dx, y + dy, here.length + (is_diagonal ? std::sqrt(2.0F) : 1.0F));
      }
  }
}

double RouteField::operator()(const Vec2& from) const {
  const Vec2 p = in_grid(from);
  const auto x0 = static_cast<std::int64_t>(std::floor(p.x())), y0 = static_cast<std::int64_t>(std::floor(p.y()));
  double least = std::numeric_limits<double>::infinity();
  for (const std::int64_t x : {x0, x0 + 1})
    for (const std::int64_t y : {y0, y0 + 1})
      if (has(x, y))
        least = std::min(least, static_cast<double>(at(x, y).length) +
                                    (Vec2(static_cast<double>(x), static_cast<double>(y)) - p).norm());
  return std::isfinite(least) ? least * size_ : longest_ + (place_ - from).norm();
}

}  // namespace arcway
