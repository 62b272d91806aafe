#include "core/search/route_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "arcway/angle.h"
#include "core/gaps/vehicle_gaps.h"

namespace arcway::internal {

namespace {

// How far from an avoided path cells are near it, in widths of the body, and by how much steps to them count as longer.
// Of 72 driven worlds, trees find the fastest paths with these: factors of 1.25 and 2, and 1 and 3 widths, are worse.
constexpr double kAvoidedWidths = 2.0;
constexpr float kAvoidedFactor = 1.5F;
constexpr double kCellsAcross = 4.0;   // cells in a body's width: a gap that lets the body through has a row of cells
constexpr double kAround = 4.0;        // width of the border around the outlines, in body lengths and turning radii
constexpr double kStraight = 2.3;      // length of straight motions [cells]: each heading leads to a cell of its own
constexpr double kPartsOfACell = 4.0;  // samples a cell at which the cells of a motion are found
constexpr double kLeastTurn = 0.05;    // least length of a motion that turns [cells]: no turn is free
constexpr double kTighter = 0.9;  // radius of turns as a share of the vehicle's, for what rounding to cells takes away
constexpr std::uint8_t kRight = 1, kUp = 2;
constexpr std::array<int, 3> kTurns{-1, 0, 1};  // of motions, in headings
constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr std::uint32_t kAsked = 1024;   // cells between two questions to the clock
constexpr float kDiagonal = 1.42F;       // length of a diagonal step [cells], rounded up
constexpr float kBucket = 0.5F;          // range of lengths within which cells may be visited in any order [cells]
constexpr float kMostBuckets = 1000.0F;  // largest number of buckets; they are wider where motions are long

constexpr std::size_t kPart = std::size_t{1} << 13;  // elements taken between two questions to the clock

// Fills an array with as many equal elements. Empty if the clock is over before.
template <class T>
void assign_until(std::vector<T>& array, std::size_t size, const T& value, const StopClock& clock) {
  array.clear();
  array.reserve(size);
  while (array.size() < size && !clock.is_over()) array.resize(std::min(size, array.size() + kPart), value);
  if (array.size() < size) array.clear();
}

struct Waiting {
  float length;
  std::uint32_t cell;
};

/// Cells by length, roughly the nearest first, in a ring of buckets [Dial 1969]. Cells of one bucket come in any order,
/// so that a cell may be found again by a shorter route. The lengths are the same in the end, and sooner than in order.
class NearestFirst {
 public:
  /// @param longest  largest difference of the lengths of a cell that is pushed and of the one popped last.
  explicit NearestFirst(float longest)
      : width_(std::max(kBucket, longest / kMostBuckets)), buckets_(static_cast<std::size_t>(longest / width_) + 3) {}

  void push(const Waiting& cell) {
    buckets_[static_cast<std::size_t>(cell.length / width_) % buckets_.size()].push_back(cell);
    ++size_;
  }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  Waiting pop() {
    while (buckets_[now_].empty()) now_ = (now_ + 1) % buckets_.size();
    const Waiting cell = buckets_[now_].back();
    buckets_[now_].pop_back();
    --size_;
    return cell;
  }

 private:
  float width_;
  std::vector<std::vector<Waiting>> buckets_;
  std::size_t now_ = 0, size_ = 0;
};

}  // namespace

RouteField::RouteField(const Roadmap& map, const RouteQuery& query, const StopClock& clock)
    : frame_(query.frame), ahead_(direction_of(query.frame.heading)), to_(query.to) {
  lay_out(map, query.most_cells, clock);
  add_walls(map, clock);
  if (!query.avoided.empty()) avoid(query.avoided, kAvoidedWidths * map.body.width() / size_, clock);
  spread(clock);
}

Vec2 RouteField::in_grid(const Vec2& p) const {
  const Vec2 d = p - frame_.position();
  return (Vec2(ahead_.dot(d), cross(ahead_, d)) - corner_) / size_;
}

void RouteField::lay_out(const Roadmap& map, std::size_t most_cells, const StopClock& clock) {
  Box box;
  StopTicker ticker(clock);
  const auto extend = [&](const Vec2& p) { box.extend(in_grid(p)); };
  for (std::uint32_t i = 0; i < map.outlines->size() && !ticker.is_over(); ++i)
    if (map.outlines->has(i))
      for (const Vec2& p : (*map.outlines)[i].points) extend(p);
  extend(frame_.position());
  extend(to_.position());
  const double around = kAround * (map.body.length() + map.vehicle.min_turning_radius());
  box = box.grown(around);
  const Vec2 extent = box.max - box.min;
  size_ =
      std::max(map.body.width() / kCellsAcross, std::sqrt(extent.x() * extent.y() / static_cast<double>(most_cells)));
  corner_ = box.min;
  width_ = static_cast<std::int64_t>(extent.x() / size_) + 2;
  height_ = static_cast<std::int64_t>(extent.y() / size_) + 2;
  assign_until(cells_, static_cast<std::size_t>(width_ * height_), {kNever, 0}, clock);
  if (cells_.empty()) width_ = height_ = 0;
}

void RouteField::add_walls(const Roadmap& map, const StopClock& clock) {
  StopTicker ticker(clock);
  for (std::uint32_t i = 0; i < map.outlines->size() && !ticker.is_over(); ++i) {
    if (!map.outlines->has(i)) continue;
    const Outlines::Piece piece = (*map.outlines)[i];
    for (std::size_t k = 0; k < piece.edge_count(); ++k) add_wall(piece.points[k], piece.points[k + 1]);
  }
  const double hopeless = map.gaps->widest_hopeless();
  const GapMap* gaps = map.gaps->map(clock);
  if (!gaps) return;
  for (const Gap& gap : gaps->gaps()) {
    if (gap.width > hopeless || ticker.is_over()) break;
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

bool RouteField::is_free(std::int64_t x, std::int64_t y, int dx, int dy) const {
  if (dx == 0 || dy == 0) return is_open(x, y, dx, dy);
  return (is_open(x, y, dx, 0) && is_open(x + dx, y, 0, dy)) || (is_open(x, y, 0, dy) && is_open(x, y + dy, dx, 0));
}

// Makes steps to cells near paths count as longer.
// @param within  [cells].
void RouteField::avoid(std::span<const Path> paths, double within, const StopClock& clock) {
  assign_until(factors_, cells_.size(), 1.0F, clock);
  if (factors_.empty()) return;
  StopTicker ticker(clock);
  std::vector<bool> is_near(cells_.size(), false);  // the path
  std::vector<std::size_t> near;
  const auto visit_near = [&](const Vec2& p) {
    const auto low = [&](double at) { return static_cast<std::int64_t>(std::ceil(at - within)); };
    const auto high = [&](double at) { return static_cast<std::int64_t>(std::floor(at + within)); };
    for (std::int64_t y = low(p.y()); y <= high(p.y()); ++y)
      for (std::int64_t x = low(p.x()); x <= high(p.x()); ++x) {
        if (!has(x, y) || (Vec2(static_cast<double>(x), static_cast<double>(y)) - p).norm() > within) continue;
        const auto cell = static_cast<std::size_t>(y * width_ + x);
        if (!is_near[cell]) near.push_back(cell);
        is_near[cell] = true;
      }
  };
  for (const Path& path : paths) {
    for (const PathSegment& s : path) {
      const int parts = 1 + static_cast<int>(s.length / size_);
      for (int i = 0; i <= parts && !ticker.is_over(); ++i)
        visit_near(in_grid(s.at(s.length * (static_cast<double>(i) / parts)).position()));
    }
    for (const std::size_t cell : near) {
      factors_[cell] *= kAvoidedFactor;
      largest_factor_ = std::max(largest_factor_, factors_[cell]);
      is_near[cell] = false;
    }
    near.clear();
  }
}

// The cells at the corners around a place, and how far they are.
template <class Visit>
void RouteField::visit_around(const Vec2& p, Visit&& visit) {
  const auto x0 = static_cast<std::int64_t>(std::floor(p.x())), y0 = static_cast<std::int64_t>(std::floor(p.y()));
  for (const std::int64_t x : {x0, x0 + 1})
    for (const std::int64_t y : {y0, y0 + 1})
      visit(x, y, (Vec2(static_cast<double>(x), static_cast<double>(y)) - p).norm());
}

void RouteField::spread(const StopClock& clock) {
  NearestFirst open(largest_factor_ * kDiagonal);
  const auto reach = [&](std::int64_t x, std::int64_t y, float length) {
    Cell& cell = at(x, y);
    if (length >= cell.length) return;
    cell.length = length;
    open.push({length, static_cast<std::uint32_t>(y * width_ + x)});
  };
  visit_around(in_grid(to_.position()), [&](std::int64_t x, std::int64_t y, double far) {
    if (has(x, y)) reach(x, y, static_cast<float>(far));
  });
  for (std::uint32_t i = 0; !open.empty(); ++i) {
    if (i % kAsked == 0 && clock.is_over()) break;
    const Waiting here = open.pop();
    const std::int64_t x = here.cell % width_, y = here.cell / width_;
    if (here.length > at(x, y).length) continue;
    longest_ = std::max(longest_, here.length * size_);
    for (const int dx : {-1, 0, 1})
      for (const int dy : {-1, 0, 1}) {
        if ((dx == 0 && dy == 0) || !has(x + dx, y + dy) || !is_free(x, y, dx, dy)) continue;
        const float step = dx != 0 && dy != 0 ? std::sqrt(2.0F) : 1.0F;
        reach(x + dx, y + dy, here.length + factor_at(x + dx, y + dy) * step);
      }
  }
}

double RouteField::without_turns(const Vec2& from) const {
  double least = std::numeric_limits<double>::infinity();
  visit_around(in_grid(from), [&](std::int64_t x, std::int64_t y, double far) {
    if (has(x, y)) least = std::min(least, static_cast<double>(at(x, y).length) + far);
  });
  return std::isfinite(least) ? least * size_ : longest_ + (to_.position() - from).norm();
}

double RouteField::heading_in_grid(double heading) const {
  return wrap_positive(heading - frame_.heading) / kTwoPi * kHeadings;
}

// A motion from a heading: straight to a cell that lies about ahead, or an arc to the next heading.
// @param radius  of arcs [cells].
RouteField::Motion RouteField::motion(int heading, int turn, double radius) {
  const double from = kTwoPi * heading / kHeadings, by = kTwoPi * turn / kHeadings;
  Motion result{turn, 0.0F, {}};
  const auto reached = [&](double share) -> Vec2 {
    if (turn == 0) return share * kStraight * direction_of(from);
    const double bend = turn > 0 ? radius : -radius, now = from + share * by;
    return bend * Vec2(std::sin(now) - std::sin(from), std::cos(from) - std::cos(now));
  };
  const double length = turn == 0 ? kStraight : radius * std::abs(by);
  const int parts = 1 + static_cast<int>(kPartsOfACell * length);
  std::array<int, 2> last{0, 0};
  for (int i = 1; i <= parts; ++i) {
    const Vec2 p = reached(static_cast<double>(i) / parts);
    const std::array<int, 2> cell{static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))};
    if (cell == last) continue;
    result.steps.push_back({cell[0] - last[0], cell[1] - last[1]});
    last = cell;
  }
  result.length = static_cast<float>(turn == 0 ? std::hypot(last[0], last[1]) : std::max(length, kLeastTurn));
  return result;
}

void RouteField::heed_turns(double radius, const StopClock& clock) {
  if (clock.is_over()) return;
  std::array<std::array<Motion, kTurns.size()>, kHeadings> motions;
  for (int heading = 0; heading < kHeadings; ++heading)
    for (std::size_t k = 0; k < kTurns.size(); ++k)
      motions[static_cast<std::size_t>(heading)][k] = motion(heading, kTurns[k], kTighter * radius / size_);
  assign_until(lengths_, cells_.size() * kHeadings, kNever, clock);
  if (lengths_.empty()) return;
  float longest_motion = kDiagonal, longest = 0.0F;
  for (const auto& of_heading : motions)
    for (const Motion& m : of_heading) longest_motion = std::max(longest_motion, m.length);
  NearestFirst open(largest_factor_ * longest_motion);
  const auto reach = [&](std::int64_t x, std::int64_t y, int heading, float length) {
    const auto state = static_cast<std::uint32_t>((y * width_ + x) * kHeadings + heading);
    if (length >= lengths_[state]) return;
    lengths_[state] = length;
    open.push({length, state});
  };
  const int to = static_cast<int>(heading_in_grid(to_.heading));
  visit_around(in_grid(to_.position()), [&](std::int64_t x, std::int64_t y, double far) {
    for (const int heading : {to, to + 1})
      if (has(x, y)) reach(x, y, heading % kHeadings, static_cast<float>(far));
  });
  for (std::uint32_t i = 0; !open.empty(); ++i) {
    if (i % kAsked == 0 && clock.is_over()) break;
    const Waiting here = open.pop();
    if (here.length > lengths_[here.cell]) continue;
    longest = std::max(longest, here.length);
    const int heading = static_cast<int>(here.cell % kHeadings);
    const std::int64_t cell = here.cell / kHeadings;
    for (std::size_t k = 0; k < kTurns.size(); ++k) {  // of the motion that leads here
      const int before = (heading - kTurns[k] + kHeadings) % kHeadings;
      const Motion& m = motions[static_cast<std::size_t>(before)][k];
      std::int64_t x = cell % width_, y = cell / width_;
      bool free = true;
      for (auto step = m.steps.rbegin(); step != m.steps.rend() && free; ++step) {
        const int dx = -(*step)[0], dy = -(*step)[1];
        free = has(x + dx, y + dy) && is_free(x, y, dx, dy);
        x += dx;
        y += dy;
      }
      if (free) reach(x, y, before, here.length + factor_at(x, y) * m.length);
    }
  }
  longest_with_turns_ = longest * size_;
}

double RouteField::operator()(const Pose& from) const {
  if (lengths_.empty()) return without_turns(from.position());
  double least = std::numeric_limits<double>::infinity();
  const int low = static_cast<int>(heading_in_grid(from.heading));
  visit_around(in_grid(from.position()), [&](std::int64_t x, std::int64_t y, double far) {
    if (!has(x, y)) return;
    for (const int heading : {low % kHeadings, (low + 1) % kHeadings})
      least = std::min(
          least, static_cast<double>(lengths_[static_cast<std::size_t>((y * width_ + x) * kHeadings + heading)]) + far);
  });
  return std::isfinite(least) ? least * size_ : longest_with_turns_ + without_turns(from.position());
}

}  // namespace arcway::internal
