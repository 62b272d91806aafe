#include "core/roadmap/find_circle_rows.h"

#include <cstddef>
#include <utility>

#include "core/geometry/tiles.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kRowsAtOnce = 16;  // circles that a thread takes at once

// The circles along a curve, near ones one after the other: they ask about the same parts of the map.
// @returns places in `circles`.
std::vector<std::uint32_t> places_along_curve(const CircleChecks& checks, std::span<const std::uint32_t> circles) {
  const Tiles tiles(checks.world().box(), circles.size());
  std::vector<std::uint32_t> tile;
  tile.reserve(circles.size());
  for (const std::uint32_t c : circles) tile.push_back(tiles.of(checks.circles().all()[c].center));
  return sorted_by_tile(std::move(tile), tiles.count());
}

LinkRow kept_links(const CircleChecks& checks, std::span<const HeadingSet> headings, std::uint32_t circle,
                   const StopClock& clock) {
  LinkRow row = checks.departures(circle, headings[circle], clock);
  row.counts.arrivals = static_cast<std::uint32_t>(
      std::erase_if(row.links, [&](const FeasibleLink& link) { return !headings[link.to].contains(link.heading); }));
  std::vector<std::uint8_t> free(row.links.size());
  checks.are_free(row.links, free);
  std::vector<FeasibleLink> kept;
  for (std::size_t i = 0; i < row.links.size(); ++i)
    if (free[i]) kept.push_back(row.links[i]);
  row.counts.straights = static_cast<std::uint32_t>(row.links.size() - kept.size());
  row.links = std::move(kept);
  return row;
}

}  // namespace

void find_headings(const CircleChecks& checks, std::span<const std::uint32_t> circles, const Executor& executor,
                   std::span<HeadingSet> headings) {
  const std::vector<std::uint32_t> order = places_along_curve(checks, circles);
  executor.begin_stage("free headings");
  executor.for_ranges(circles.size(), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> chunk;
    for (std::size_t i = begin; i < end; ++i)
      if (checks.circles().is_used(circles[order[i]])) chunk.push_back(circles[order[i]]);
    std::vector<HeadingSet> found(chunk.size());
    checks.free_headings(chunk, found);
    for (std::size_t i = 0; i < chunk.size(); ++i) headings[chunk[i]] = std::move(found[i]);
  });
}

std::vector<LinkRow> find_kept_links(const CircleChecks& checks, std::span<const HeadingSet> headings,
                                     std::span<const std::uint32_t> circles, const Executor& executor) {
  std::vector<LinkRow> found(circles.size());
  const std::vector<std::uint32_t> order = places_along_curve(checks, circles);
  const StopClock clock = executor.clock();
  executor.begin_stage("bitangents");
  executor.for_ranges(circles.size(), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[order[i]] = kept_links(checks, headings, circles[order[i]], clock);
  });
  return found;
}

}  // namespace arcway::internal
