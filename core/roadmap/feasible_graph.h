#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "arcway/feasible_graph_snapshot.h"
#include "arcway/heading_set.h"
#include "arcway/stop_clock.h"
#include "arcway/vec2.h"
#include "core/roadmap/circle_checks.h"
#include "core/roadmap/link_rows.h"
#include "core/roadmap/turn_circle.h"
#include "core/roadmap/turn_circles.h"

namespace arcway::internal {

class FinishedFeasibleGraph;

/// What a check of a link has found.
enum class LinkVerdict : std::uint8_t {
  kUnknown,  ///< not checked yet
  kKept,     ///< the vehicle may drive the link
  kArrival,  ///< the heading is not free on the circle where it ends
  kStraight  ///< its swept rectangle is not free
};

/// A row of links, with what is known of each.
struct CheckedRow {
  LinkRow row;
  std::vector<LinkVerdict> verdicts;  ///< by link
  Box around;                         ///< see CircleChecks::departures; empty: not known
};

/// The feasible visibility graph as searches ask for it: turn circles with their free headings, and the directed
/// bitangents (links) whose swept rectangle is free. Arcs are not stored. From an arrival on a circle every departure
/// is reachable that lies ahead within the same free interval.
///
/// Graphs of the same inputs give the same kept links and headings, whichever class they are of. Thread-safe.
class FeasibleGraph {
 public:
  using Link = FeasibleLink;
  virtual ~FeasibleGraph() = default;
  FeasibleGraph(const FeasibleGraph&) = delete;
  FeasibleGraph& operator=(const FeasibleGraph&) = delete;

  /// The turn circles, in the order of TurnCircles::all.
  [[nodiscard]] std::span<const TurnCircle> circles() const { return circles_; }
  [[nodiscard]] const TurnCircles& turn_circles() const { return checks_->circles(); }
  /// See CircleChecks::free_headings.
  [[nodiscard]] virtual const HeadingSet& free_headings(std::uint32_t circle) const = 0;
  /// Links that leave a circle, by heading, then `to`: at least the kept ones. All others leave at a free heading.
  /// @throws Canceled if the clock is over before they are found: where vertices see thousands of others that takes up
  ///   to a second.
  [[nodiscard]] virtual std::span<const Link> links_from(std::uint32_t circle, const StopClock& clock = {}) const = 0;
  /// Whether links_from(circle)[index] is kept: whether the vehicle may drive it.
  [[nodiscard]] virtual bool is_kept(std::uint32_t circle, std::size_t index) const = 0;
  /// Counts of what has been decided so far. What a graph before a change has decided counts once it was asked for.
  [[nodiscard]] virtual FeasibleGraphCounts counts() const = 0;

  /// This graph if all is known of it, else null.
  [[nodiscard]] virtual const FinishedFeasibleGraph* finished() const { return nullptr; }
  /// The free headings of a circle if they have been found, else null.
  [[nodiscard]] virtual const HeadingSet* known_headings(std::uint32_t circle) const = 0;
  /// links_from(circle) with what has been decided of them, if they have been found.
  [[nodiscard]] virtual std::optional<CheckedRow> known_row(std::uint32_t circle) const = 0;
  /// What decides about the circles and links of this graph.
  [[nodiscard]] const CircleChecks& checks() const { return *checks_; }

 protected:
  explicit FeasibleGraph(std::shared_ptr<const CircleChecks> checks)
      : checks_(std::move(checks)), circles_(checks_->circles().all()) {}

 private:
  std::shared_ptr<const CircleChecks> checks_;
  std::span<const TurnCircle> circles_;
};

}  // namespace arcway::internal
