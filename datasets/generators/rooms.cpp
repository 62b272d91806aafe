#include <algorithm>
#include <cmath>

#include "datasets/generators/layout.h"

namespace arcway::internal::detail {
namespace {

constexpr double kHalfRoomWall = 0.15;
constexpr double kHalfDoor = 1.1;
constexpr std::size_t kVerticesPerRoom = 18;  // a cross of walls and one table and a half

std::vector<double> lines(Random& random, std::size_t rooms) {
  std::vector<double> places{0.0};
  for (std::size_t i = 0; i < rooms; ++i) places.push_back(places.back() + random.uniform(7.0, 13.0));
  return places;
}

// Middle of the door in each piece of each inner wall: [line - 1][piece].
std::vector<std::vector<double>> doors(Random& random, std::size_t walls, const std::vector<double>& across) {
  std::vector<std::vector<double>> places(walls);
  for (auto& wall : places) {
    for (std::size_t i = 0; i + 1 < across.size(); ++i)
      wall.push_back(across[i] + random.uniform(0.4, 0.6) * (across[i + 1] - across[i]));
  }
  return places;
}

// Rooms between lines across, with doors in the walls on the inner lines.
struct Plan {
  std::vector<double> x, y;
  std::vector<std::vector<double>> vertical;    // in the wall at x[i + 1]: y of the doors
  std::vector<std::vector<double>> horizontal;  // in the wall at y[j + 1]: x of the doors
  [[nodiscard]] std::size_t rooms_across() const { return x.size() - 1; }
};

Plan plan_of(Random& random, std::size_t wanted) {
  const auto n =
      std::max<std::size_t>(2, static_cast<std::size_t>(std::sqrt(static_cast<double>(wanted) / kVerticesPerRoom)));
  Plan plan;
  plan.x = lines(random, n);
  plan.y = lines(random, n);
  plan.vertical = doors(random, n - 1, plan.y);
  plan.horizontal = doors(random, n - 1, plan.x);
  return plan;
}

// The outer walls and the stubs of the inner ones that start there.
Ring bounds_of(const Plan& plan) {
  constexpr double t = kHalfRoomWall;
  const auto& [x, y, vertical, horizontal] = plan;
  const std::size_t n = plan.rooms_across();
  Ring bounds;
  const auto turn = [&](double px, double py) { bounds.emplace_back(px, py); };
  turn(x[0], y[0]);
  for (std::size_t i = 1; i < n; ++i) {
    const double tip = vertical[i - 1].front() - kHalfDoor;
    turn(x[i] - t, y[0]), turn(x[i] - t, tip), turn(x[i] + t, tip), turn(x[i] + t, y[0]);
  }
  turn(x[n], y[0]);
  for (std::size_t j = 1; j < n; ++j) {
    const double tip = horizontal[j - 1].back() + kHalfDoor;
    turn(x[n], y[j] - t), turn(tip, y[j] - t), turn(tip, y[j] + t), turn(x[n], y[j] + t);
  }
  turn(x[n], y[n]);
  for (std::size_t i = n; i-- > 1;) {
    const double tip = vertical[i - 1].back() + kHalfDoor;
    turn(x[i] + t, y[n]), turn(x[i] + t, tip), turn(x[i] - t, tip), turn(x[i] - t, y[n]);
  }
  turn(x[0], y[n]);
  for (std::size_t j = n; j-- > 1;) {
    const double tip = horizontal[j - 1].front() - kHalfDoor;
    turn(x[0], y[j] + t), turn(tip, y[j] + t), turn(tip, y[j] - t), turn(x[0], y[j] - t);
  }
  return bounds;
}

// Where two inner walls meet: a cross that ends at the four doors around it.
void add_crosses(const Plan& plan, Layout& layout) {
  constexpr double t = kHalfRoomWall;
  const auto& [x, y, vertical, horizontal] = plan;
  for (std::size_t i = 1; i < plan.rooms_across(); ++i) {
    for (std::size_t j = 1; j < plan.rooms_across(); ++j) {
      const double left = horizontal[j - 1][i - 1] + kHalfDoor, right = horizontal[j - 1][i] - kHalfDoor;
      const double bottom = vertical[i - 1][j - 1] + kHalfDoor, top = vertical[i - 1][j] - kHalfDoor;
      const double cx = x[i], cy = y[j];
      layout.add({{left, cy - t},
                  {cx - t, cy - t},
                  {cx - t, bottom},
                  {cx + t, bottom},
                  {cx + t, cy - t},
                  {right, cy - t},
                  {right, cy + t},
                  {cx + t, cy + t},
                  {cx + t, top},
                  {cx - t, top},
                  {cx - t, cy + t},
                  {left, cy + t}});
    }
  }
}

// Tables in the quarters of the rooms, clear of the doors; none in the first and the last room.
void add_tables(const Plan& plan, Layout& layout) {
  const std::vector<double>&x = plan.x, &y = plan.y;
  const std::size_t n = plan.rooms_across();
  Selection tables(std::min(layout.missing() / 4, 4 * (n * n - 2)), 4 * (n * n - 2));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (i + j == 0 || i + j == 2 * (n - 1)) continue;
      for (const double u : {0.25, 0.75}) {
        for (const double v : {0.25, 0.75}) {
          if (!tables.take(layout.random)) continue;
          const Vec2 center(x[i] + u * (x[i + 1] - x[i]), y[j] + v * (y[j + 1] - y[j]));
          layout.add(rectangle_ring(center, layout.random.unit_vector(), 0.75, 0.4));
        }
      }
    }
  }
}

}  // namespace

void lay_out_rooms(Layout& layout) {
  const Plan plan = plan_of(layout.random, layout.wanted);
  layout.set_bounds(bounds_of(plan));
  add_crosses(plan, layout);
  add_tables(plan, layout);
  const std::vector<double>&x = plan.x, &y = plan.y;
  const std::size_t n = plan.rooms_across();
  layout.map.start = Pose{0.5 * x[1], 0.5 * y[1], 0.0};
  layout.map.goal = Pose{0.5 * (x[n - 1] + x[n]), 0.5 * (y[n - 1] + y[n]), 0.0};
}

}  // namespace arcway::internal::detail
