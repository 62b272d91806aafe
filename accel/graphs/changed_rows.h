#pragma once

#include <memory>
#include <optional>

#include "accel/graphs/lazy_rows.h"
#include "arcway/visibility_query.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "arcway/world_change.h"

namespace arcway::internal {

/// Rows of a world after a change, and what may differ, without a triangulation of that world. Nothing if regions of
/// one of the worlds touch themselves.
///
/// A vertex that sees nothing of the places of removed and added obstacles keeps its row. Of the other rows, edges that
/// meet no added obstacle are kept. Lines of sight in the triangles of the world before all changes, where removed
/// obstacles hide nothing, lead to other ones, and visibility queries decide about these when a row is first asked for.
/// Thread-safe.
///
/// What was added and removed again takes no part, so that an obstacle may move for ever. Rows are made anew, with a
/// triangulation, once a quarter of the vertices has changed, or where places lie beyond all triangles or across each
/// other.
/// @param base  rows of the world before the change. Rows that result follow further changes from there.
/// @param visibility  of `after`.
std::optional<VisibilityRows::Changed> change_rows(const std::shared_ptr<const LazyRows>& base, const World& after,
                                                   const WorldChange& change,
                                                   std::shared_ptr<const VisibilityQuery> visibility);

}  // namespace arcway::internal
