#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arcway/executor.h"
#include "core/roadmap/circle_checks.h"
#include "core/roadmap/link_rows.h"

namespace arcway::internal {

/// Finds the free headings of some circles.
/// @param headings  by circle; those of the others stay.
void find_headings(const CircleChecks& checks, std::span<const std::uint32_t> circles, const Executor& executor,
                   std::span<HeadingSet> headings);

/// Finds the kept links that leave some circles.
/// @param headings  by circle, all of them found.
/// @returns the rows in the order of the circles.
[[nodiscard]] std::vector<LinkRow> find_kept_links(const CircleChecks& checks, std::span<const HeadingSet> headings,
                                                   std::span<const std::uint32_t> circles, const Executor& executor);

}  // namespace arcway::internal
