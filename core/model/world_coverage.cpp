#include "core/model/world_coverage.h"

#include <optional>
#include <utility>

#include "core/geometry/edge_sweep.h"

namespace arcway {
namespace {

// Of the regions just below a point the ones with an edge there have the point on their boundary; all others hold it.
class Sweeper final : public EdgeSweep::Visitor {
 public:
  Sweeper(std::span<const LineSegment> edges, std::span<const ObstacleId> region_of, ObstacleId bounds)
      : edges_(edges),
        region_of_(region_of),
        bounds_(bounds),
        is_left_out_(region_of.empty() ? 0 : region_of.back() + std::size_t{1}),
        seen_at_(is_left_out_.size(), 0) {}

  Coverage run() {
    // What crosses is left out while the sweep goes on. Then nothing that is left crosses.
    sweep();
    if (has_crossings_) sweep();
    Coverage coverage{std::move(covered_), {}};
    for (ObstacleId region = 0; region < is_left_out_.size(); ++region)
      if (is_left_out_[region]) coverage.left_over.push_back(region);
    return coverage;
  }

  void visit(const EdgeSweep::Event& event) override {
    if (depths_->below(event) > touching_below(event))
      for (const std::uint32_t e : event.ends)
        if (edges_[e].a == event.at) covered_[e] = true;
    depths_->pass(event);
  }

  bool crosses(std::uint32_t e, std::uint32_t f) override {
    is_left_out_[region_of_[e]] = is_left_out_[region_of_[f]] = true;
    return has_crossings_ = true;
  }
  [[nodiscard]] bool is_left_out(std::uint32_t edge) const override { return is_left_out_[region_of_[edge]]; }

 private:
  void sweep() {
    covered_.assign(edges_.size(), false);
    depths_.emplace(edges_, bounds_ != kNone && !is_left_out_[bounds_] ? 1 : 0);
    EdgeSweep(edges_).run(*this);
  }

  // Regions with an edge at the point that lie just below it: the first of a region's edges around the point,
  // counter-clockwise from there, tells.
  std::int32_t touching_below(const EdgeSweep::Event& event) {
    ++events_;
    std::int32_t count = 0;
    const auto take = [&](std::uint32_t e, bool is_below) {
      if (std::exchange(seen_at_[region_of_[e]], events_) != events_ && is_below) ++count;
    };
    for (const std::uint32_t e : event.right) take(e, !depths_->is_region_above(e));
    for (auto e = event.left.rbegin(); e != event.left.rend(); ++e) take(*e, depths_->is_region_above(*e));
    return count;
  }

  std::span<const LineSegment> edges_;
  std::span<const ObstacleId> region_of_;
  ObstacleId bounds_;
  std::vector<bool> is_left_out_;       // by region
  std::vector<std::uint64_t> seen_at_;  // by region, the last event with an edge of it
  std::optional<SweptDepths> depths_;
  std::vector<bool> covered_;
  std::uint64_t events_ = 0;
  bool has_crossings_ = false;
};

}  // namespace

Coverage sweep_coverage(std::span<const LineSegment> edges, std::span<const ObstacleId> region_of, ObstacleId bounds) {
  return Sweeper(edges, region_of, bounds).run();
}

}  // namespace arcway
