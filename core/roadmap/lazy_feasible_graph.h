#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/found_links.h"

namespace arcway::internal {

class FoundBefore;

/// A feasible graph that finds headings, rows and verdicts when a search first asks for them, and remembers them. It
/// never takes more memory than one link for each candidate. links_from gives the links whose first heading is free.
class LazyFeasibleGraph final : public FeasibleGraph {
 public:
  /// @param executor  used during construction only.
  LazyFeasibleGraph(const FeasibleGraphInputs& inputs, const Executor& executor);
  explicit LazyFeasibleGraph(std::shared_ptr<const CircleChecks> checks);
  /// Asks another graph for the headings of the circles that are that one's.
  /// @param checks  whose first circles are those of `base`.
  LazyFeasibleGraph(std::shared_ptr<const CircleChecks> checks, std::shared_ptr<const FeasibleGraph> base);

  /// Takes what a graph before a change has found.
  /// @param found  refers to `checks`.
  LazyFeasibleGraph(std::shared_ptr<const CircleChecks> checks, std::unique_ptr<const FoundBefore> found);
  ~LazyFeasibleGraph() override;

  [[nodiscard]] const HeadingSet& free_headings(std::uint32_t circle) const override;
  [[nodiscard]] std::span<const Link> links_from(std::uint32_t circle, const StopClock& clock = {}) const override;
  [[nodiscard]] bool is_kept(std::uint32_t circle, std::size_t index) const override;
  [[nodiscard]] FeasibleGraphCounts counts() const override;
  [[nodiscard]] const HeadingSet* known_headings(std::uint32_t circle) const override;
  [[nodiscard]] std::optional<CheckedRow> known_row(std::uint32_t circle) const override;

  /// What this graph has found, and what it knows from graphs before changes; the latter may be null.
  [[nodiscard]] const std::shared_ptr<const FoundLinks>& found() const { return own_; }
  [[nodiscard]] const FoundBefore* found_before() const { return found_.get(); }

  /// Remembers the free headings of a circle, found elsewhere. No effect if they are known.
  void learn_headings(std::uint32_t circle, HeadingSet headings);
  /// Remembers the links that leave a circle, found elsewhere: at least the kept ones. No effect if they are known.
  void learn_row(std::uint32_t circle, CheckedRow row);

 private:
  [[nodiscard]] const FoundLinks::Row& row_of(std::uint32_t circle, const StopClock& clock = {}) const;

  std::shared_ptr<const FeasibleGraph> base_;  // may be null
  std::size_t base_count_;                     // circles whose headings it knows
  std::unique_ptr<const FoundBefore> found_;   // may be null
  std::shared_ptr<const FoundLinks> own_;      // without the headings that `base_` knows
};

}  // namespace arcway::internal
