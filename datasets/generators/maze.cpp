#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "datasets/generators/layout.h"

namespace arcway::internal::detail {
namespace {

constexpr double kCell = 4.0;
constexpr double kHalfWall = 0.25;
constexpr double kVerticesPerCell = 1.37;  // measured; hardly depends on the size

constexpr std::array<int, 4> kStepX{1, 0, -1, 0}, kStepY{0, 1, 0, -1};  // directions counter-clockwise
constexpr std::uint8_t bit(std::size_t direction) { return static_cast<std::uint8_t>(1u << (direction & 3)); }

// Walls between posts: `walls` of a post holds the directions in which a wall leaves it.
class Maze {
 public:
  Maze(Random& random, std::size_t size) : n_(size), walls_((size + 1) * (size + 1), 0) {
    for (std::size_t y = 0; y <= n_; ++y)
      for (std::size_t x = 0; x <= n_; ++x) {
        if (x < n_) add(x, y, 0);
        if (y < n_) add(x, y, 1);
      }
    carve(random);
    open_dead_ends(random);
  }

  // The outline of the walls beside the first wall that has not been followed yet; the wall on its left. Empty if
  // there are no more.
  Ring next_outline() {
    for (; post_ < walls_.size(); ++post_) {
      if (walls_[post_] == 0) continue;
      for (std::size_t d = 0; d < 4; ++d)
        if ((walls_[post_] & bit(d)) != 0) return follow(post_, d);
    }
    return {};
  }
  // The outlines of the frame, which are taken first.
  Ring outer_outline() { return follow(0, 0); }
  Ring inner_outline() { return follow(n_, 2); }

 private:
  [[nodiscard]] std::size_t post(std::size_t x, std::size_t y) const { return y * (n_ + 1) + x; }
  [[nodiscard]] std::size_t ahead(std::size_t p, std::size_t d) const {
    return post(p % (n_ + 1) + static_cast<std::size_t>(kStepX[d]), p / (n_ + 1) + static_cast<std::size_t>(kStepY[d]));
  }
  void add(std::size_t x, std::size_t y, std::size_t d) {
    walls_[post(x, y)] |= bit(d);
    walls_[ahead(post(x, y), d)] |= bit(d + 2);
  }
  void remove(std::size_t p, std::size_t d) {
    walls_[p] &= static_cast<std::uint8_t>(~bit(d));
    walls_[ahead(p, d)] &= static_cast<std::uint8_t>(~bit(d + 2));
  }
  // The wall on side d of a cell: a post and a direction.
  struct Wall {
    std::size_t post, direction;
  };
  [[nodiscard]] Wall side(std::size_t x, std::size_t y, std::size_t d) const {
    switch (d) {
      case 0:
        return {post(x + 1, y), 1};
      case 1:
        return {post(x, y + 1), 0};
      case 2:
        return {post(x, y), 1};
      default:
        return {post(x, y), 0};
    }
  }
  [[nodiscard]] bool has_neighbor(std::size_t x, std::size_t y, std::size_t d) const {
    return d == 0 ? x + 1 < n_ : d == 1 ? y + 1 < n_ : d == 2 ? x > 0 : y > 0;
  }

  // Depth first: long winding ways.
  void carve(Random& random) {
    std::vector<bool> seen(n_ * n_, false);
    std::vector<std::size_t> stack{0};
    seen[0] = true;
    while (!stack.empty()) {
      const std::size_t x = stack.back() % n_, y = stack.back() / n_;
      std::array<std::size_t, 4> ways{};
      std::size_t count = 0;
      for (std::size_t d = 0; d < 4; ++d)
        if (has_neighbor(x, y, d) && !seen[neighbor(x, y, d)]) ways[count++] = d;
      if (count == 0) {
        stack.pop_back();
        continue;
      }
      const std::size_t d = ways[random.below(count)];
      const Wall wall = side(x, y, d);
      remove(wall.post, wall.direction);
      seen[neighbor(x, y, d)] = true;
      stack.push_back(neighbor(x, y, d));
    }
  }
  [[nodiscard]] std::size_t neighbor(std::size_t x, std::size_t y, std::size_t d) const {
    return (y + static_cast<std::size_t>(kStepY[d])) * n_ + x + static_cast<std::size_t>(kStepX[d]);
  }
  // Three dead ends of four become part of a loop.
  void open_dead_ends(Random& random) {
    for (std::size_t y = 0; y < n_; ++y) {
      for (std::size_t x = 0; x < n_; ++x) {
        std::array<std::size_t, 4> closed{};
        std::size_t walls = 0, count = 0;
        for (std::size_t d = 0; d < 4; ++d) {
          const Wall wall = side(x, y, d);
          if ((walls_[wall.post] & bit(wall.direction)) == 0) continue;
          ++walls;
          if (has_neighbor(x, y, d)) closed[count++] = d;
        }
        if (walls < 3 || count == 0 || random.below(4) == 0) continue;
        const Wall wall = side(x, y, closed[random.below(count)]);
        remove(wall.post, wall.direction);
      }
    }
  }

  // Follows the walls with the free side on the right, turning right wherever it can. Each wall passed is taken off the
  // post that it leaves from, as it has then been followed from there.
  Ring follow(std::size_t p, std::size_t d) {
    Ring ring;
    std::vector<Wall> followed;
    const std::size_t first_post = p, first_direction = d;
    do {
      followed.push_back({p, d});
      p = ahead(p, d);
      std::size_t e = d + 3;  // right of d
      while (!stands(p, e & 3)) ++e;
      e &= 3;
      const Vec2 place(kCell * static_cast<double>(p % (n_ + 1)), kCell * static_cast<double>(p / (n_ + 1)));
      const auto corner = [&](std::size_t a, std::size_t b) {
        ring.push_back(place + kHalfWall * Vec2(kStepX[a & 3] + kStepX[b & 3], kStepY[a & 3] + kStepY[b & 3]));
      };
      if (e == ((d + 2) & 3)) {  // round the end of the wall
        corner(d + 3, d);
        corner(d, d + 1);
      } else if (e != d) {
        corner(d + 3, e + 3);
      }
      d = e;
    } while (p != first_post || d != first_direction);
    for (const Wall& wall : followed) walls_[wall.post] &= static_cast<std::uint8_t>(~bit(wall.direction));
    return ring;
  }
  // A wall between two posts stands as long as one of its two sides has not been followed.
  [[nodiscard]] bool stands(std::size_t p, std::size_t d) const {
    const std::size_t x = p % (n_ + 1), y = p / (n_ + 1);
    const bool inside = d == 0 ? x < n_ : d == 1 ? y < n_ : d == 2 ? x > 0 : y > 0;
    return inside && ((walls_[p] & bit(d)) != 0 || (walls_[ahead(p, d)] & bit(d + 2)) != 0);
  }

  std::size_t n_;
  std::vector<std::uint8_t> walls_;
  std::size_t post_ = 0;
};

}  // namespace

void lay_out_maze(Layout& layout) {
  const double cells = static_cast<double>(layout.wanted) / kVerticesPerCell;
  const auto n = std::max<std::size_t>(3, static_cast<std::size_t>(std::floor(std::sqrt(cells) + 0.5)));
  Maze maze(layout.random, n);
  maze.outer_outline();
  layout.set_bounds(maze.inner_outline());
  for (Ring ring = maze.next_outline(); !ring.empty(); ring = maze.next_outline()) layout.add(std::move(ring));
  const double last = kCell * (static_cast<double>(n) - 0.5);
  layout.map.start = Pose{0.5 * kCell, 0.5 * kCell, 0.0};
  layout.map.goal = Pose{last, last, 0.0};
}

}  // namespace arcway::internal::detail
