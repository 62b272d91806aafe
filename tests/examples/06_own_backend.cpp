// example
#include <arcway/planner.h>

#include <iostream>
#include <memory>

// A sweep query of one's own: a one-way lane that the robot may only drive along +x, beside the obstacles of the map.
class OneWayLane final : public arcway::SweepQuery {
 public:
  OneWayLane(std::shared_ptr<const arcway::SweepQuery> obstacles, const arcway::Box& lane)
      : obstacles_(std::move(obstacles)), lane_(lane) {}

 private:
  // Corners of a swept rectangle are counter-clockwise from the rear right one.
  void do_straight_free(std::span<const arcway::SweptRectangle> rectangles,
                        std::span<std::uint8_t> free) const override {
    obstacles_->straight_free(rectangles, free);
    for (std::size_t i = 0; i < rectangles.size(); ++i)
      if (is_against(rectangles[i])) free[i] = 0;
  }
  // Bodies that are no rectangles.
  void do_straight_free(std::span<const arcway::StraightBody> bodies, std::span<std::uint8_t> free) const override {
    obstacles_->straight_free(bodies, free);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (is_against(arcway::swept_rectangle(bodies[i].from, bodies[i].length, bodies[i].body))) free[i] = 0;
  }
  // No turns within the lane.
  void do_free_headings(std::span<const arcway::TurningBody> bodies,
                        std::span<arcway::HeadingSet> result) const override {
    obstacles_->free_headings(bodies, result);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (lane_.distance_to(bodies[i].center) < bodies[i].radius + bodies[i].body.front) result[i] = {};
  }
  [[nodiscard]] bool is_against(const arcway::SweptRectangle& rectangle) const {
    arcway::Box swept;
    for (const arcway::Vec2& corner : rectangle) swept.extend(corner);
    return rectangle[1].x() < rectangle[0].x() && swept.overlaps(lane_);
  }
  std::shared_ptr<const arcway::SweepQuery> obstacles_;
  arcway::Box lane_;
};

int main() {
  const arcway::World world({arcway::Polygon::rectangle({5, -2}, {45, 2})});
  arcway::QuerySet queries = arcway::make_reference_queries(world);
  queries.sweep = std::make_shared<OneWayLane>(queries.sweep, arcway::Box{{5, 3}, {45, 6}});
  const arcway::Backend backend = arcway::backend_of(world, queries, arcway::kSerialExecutor);
  const arcway::PlanResult there = arcway::plan(backend, arcway::Vehicle{}, {.start = {0, 4, 0}, .goal = {50, 4, 0}});
  const arcway::PlanResult back =
      arcway::plan(backend, arcway::Vehicle{}, {.start = {50, 4, arcway::kPi}, .goal = {0, 4, arcway::kPi}});
  std::cout << there << '\n' << back << '\n';
  return there.length < 51.0 && back.length > 51.0 ? 0 : 1;
}
// end
