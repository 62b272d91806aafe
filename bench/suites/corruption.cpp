#include "bench/suites/corruption.h"

#include <utility>
#include <vector>

namespace arcway::internal::bench {
namespace {

bool& switched_on() {
  static bool on = false;
  return on;
}

class CorruptQuery final : public VisibilityQuery, public DistanceQuery, public SweepQuery {
 public:
  explicit CorruptQuery(QuerySet right) : right_(std::move(right)) {}

 private:
  static void flip(std::span<std::uint8_t> answers) {
    if (!answers.empty()) answers.front() ^= 1u;
  }
  void do_visible(std::span<const LineSegment> segments, std::span<std::uint8_t> visible) const override {
    right_.visibility->visible(segments, visible);
    flip(visible);
  }
  void do_closest(std::span<const Vec2> points, std::span<ClosestPoint> result) const override {
    right_.distance->closest(points, result);
    if (!result.empty()) result.front().distance += 1.0;
  }
  void do_closer_than(std::span<const Vec2> points, std::span<const double> distances,
                      std::span<std::uint8_t> closer) const override {
    right_.distance->closer_than(points, distances, closer);
    flip(closer);
  }
  void do_containing(std::span<const Vec2> points, std::span<ObstacleId> result) const override {
    right_.distance->containing(points, result);
    if (!result.empty()) result.front() ^= 1u;
  }
  void do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const override {
    right_.sweep->straight_free(rectangles, free);
    flip(free);
  }
  void do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const override {
    right_.sweep->straight_free(bodies, free);
    flip(free);
  }
  void do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const override {
    right_.sweep->free_headings(bodies, result);
    if (!result.empty()) result.front() = result.front().empty() ? HeadingSet::full() : HeadingSet();
  }

  QuerySet right_;
};

}  // namespace

bool corrupting() { return switched_on(); }
void set_corrupting(bool on) { switched_on() = on; }

VisibilityGraph corrupted(const VisibilityGraph& graph) {
  if (graph.edge_count() == 0) return graph;
  std::vector<std::uint64_t> starts(graph.row_starts().begin(), graph.row_starts().end());
  std::vector<VertexId> targets(graph.targets().begin(), graph.targets().end());
  const std::size_t dropped = targets.size() / 2;
  targets.erase(targets.begin() + static_cast<std::ptrdiff_t>(dropped));
  for (std::uint64_t& start : starts) start -= start > dropped;
  return {std::move(starts), std::move(targets)};
}

QuerySet corrupted(QuerySet queries) {
  const auto corrupt = std::make_shared<const CorruptQuery>(std::move(queries));
  return {corrupt, corrupt, corrupt};
}

}  // namespace arcway::internal::bench
