#pragma once

#include <span>
#include <vector>

#include "arcway/heading_set.h"
#include "arcway/process_group.h"
#include "core/roadmap/link_rows.h"

namespace arcway::internal {

/// Gives the headings of each process's share of the circles to all processes.
/// @param headings  by circle; those of this process's share are found, the others are written.
void exchange_headings(std::span<HeadingSet> headings, const ProcessGroup& process_group);

/// The rows of all circles from those of each process's share.
/// @param share  rows of this process's share of the circles.
[[nodiscard]] LinkRows exchange_links(std::span<const LinkRow> share, const ProcessGroup& process_group);

}  // namespace arcway::internal
