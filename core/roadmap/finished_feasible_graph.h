#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/roadmap/feasible_graph.h"

namespace arcway::internal {

/// A feasible graph as a table of all free headings and all kept links. Immutable. See build_feasible_graph.
class FinishedFeasibleGraph final : public FeasibleGraph {
 public:
  /// @param headings, rows  by circle; the rows have the kept links only.
  FinishedFeasibleGraph(std::shared_ptr<const CircleChecks> checks, std::vector<HeadingSet> headings, LinkRows rows);

  [[nodiscard]] const HeadingSet& free_headings(std::uint32_t circle) const override { return headings_[circle]; }
  [[nodiscard]] std::span<const Link> links_from(std::uint32_t circle, const StopClock& /*clock*/ = {}) const override {
    return rows_.of(circle);
  }
  [[nodiscard]] bool is_kept(std::uint32_t /*circle*/, std::size_t /*index*/) const override { return true; }
  [[nodiscard]] FeasibleGraphCounts counts() const override { return counts_; }

  [[nodiscard]] const FinishedFeasibleGraph* finished() const override { return this; }
  [[nodiscard]] const HeadingSet* known_headings(std::uint32_t circle) const override { return &headings_[circle]; }
  [[nodiscard]] std::optional<CheckedRow> known_row(std::uint32_t circle) const override;

  /// All kept links, by circle.
  [[nodiscard]] std::span<const Link> links() const { return rows_.links; }
  /// The graph as flat arrays; see restore_feasible_graph.
  [[nodiscard]] FeasibleGraphSnapshot snapshot() const;

 private:
  std::vector<HeadingSet> headings_;
  LinkRows rows_;
  FeasibleGraphCounts counts_;
};

}  // namespace arcway::internal
