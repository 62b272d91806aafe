#include "core/model/world_coverage.h"

#include <optional>
#include <utility>

#include "core/geometry/edge_sweep.h"

namespace arcway::internal {
namespace {

// Largest number of sweeps; each takes regions that do not cross each other.
constexpr int kMostSweeps = 8;

// A region just below a point contains it, or has it on its boundary if an edge of the region passes there.
class Sweeper final : public EdgeSweep::Visitor {
 public:
  Sweeper(std::span<const LineSegment> edges, std::span<const ObstacleId> region_of, ObstacleId bounds)
      : edges_(edges),
        region_of_(region_of),
        bounds_(bounds),
        is_left_out_(region_of.empty() ? 0 : region_of.back() + std::size_t{1}),
        seen_at_(is_left_out_.size(), 0) {}

  Coverage run() {
    Coverage coverage{std::vector<bool>(edges_.size(), false), {}};
    std::vector<bool> waits(is_left_out_.size(), true);
    bool any = true;
    for (int i = 0; i < kMostSweeps && any; ++i) {
      is_left_out_ = waits;
      is_left_out_.flip();
      // One of two regions that cross is left out while the sweep goes on. The remaining ones do not cross.
      has_crossings_ = false;
      has_come_before_.assign(waits.size(), false);
      sweep();
      if (has_crossings_) sweep();
      any = false;
      for (std::size_t region = 0; region < waits.size(); ++region) {
        waits[region] = waits[region] && is_left_out_[region];
        any = any || waits[region];
      }
      for (std::size_t v = 0; v < covered_.size(); ++v) coverage.covered[v] = coverage.covered[v] || covered_[v];
    }
    for (ObstacleId region = 0; region < waits.size(); ++region)
      if (waits[region]) coverage.left_over.push_back(region);
    return coverage;
  }

  void visit(const EdgeSweep::Event& event) override {
    if (depths_->below(event) > touching_below(event))
      for (const std::uint32_t e : event.ends)
        if (edges_[e].a == event.at) covered_[e] = true;
    depths_->pass(event);
  }

  bool crosses(std::uint32_t e, std::uint32_t f) override {
    // One of two crossing regions is left out, unless one of them is already. A region for which another one was left
    // out stays, if possible: else all but one might be left out of a row of regions, each of which crosses the next.
    ObstacleId stays = region_of_[e], goes = region_of_[f];
    if (has_come_before_[goes]) std::swap(stays, goes);
    if (!is_left_out_[stays] && !is_left_out_[goes]) is_left_out_[goes] = has_come_before_[stays] = true;
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
  std::vector<bool> has_come_before_;   // by region: another one was left out on its account
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

}  // namespace arcway::internal
