#pragma once

#include "core/attach/search_attachments.h"
#include "core/attach/search_context.h"

namespace arcway::internal {

/// A lower bound on what driving close to obstacles costs on the last part of all paths of a search that lead over the
/// graph [s]; 0 if nothing is preferred.
///
/// Such a path ends with a goal link: a line off a circle of the graph, an arc on a circle of a goal attachment, and
/// the attachment's connection. From every arrival on the graph, and from the start, all of a link is still ahead.
/// Close driving costs the same at every speed. So the rest of a path costs at least its least time, plus the cost of
/// the cheapest link. Links whose line is not free lead nowhere and do not count. Lines are measured for the kMostLines
/// links that are cheapest without them, or until the next one without its line costs as much as the cheapest one. The
/// others count without their lines, arcs of circles behind the first kMostArcs as nothing: that is less, and so a
/// lower bound still.
double least_goal_cost(SearchContext& context, SearchAttachments& attachments);

}  // namespace arcway::internal
