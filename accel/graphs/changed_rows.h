#pragma once

#include <memory>
#include <optional>

#include "accel/graphs/lazy_rows.h"
#include "arcway/visibility_query.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "core/model/vertex_map.h"

namespace arcway::internal {

/// Rows of a world after some changes, without a triangulation of it. A vertex that sees nothing of the places of
/// removed and added obstacles keeps its row. Of the other rows, edges that meet no place are kept. Others lead from
/// one vertex that sees a place to another one, and visibility queries decide about those when a row is first asked
/// for. Who sees a place is found once, and known in all later changes. Thread-safe.
///
/// What was added and removed again takes no part, so that an obstacle may move for ever. Nothing if much more changed,
/// or if regions of one of the worlds touch themselves; new lazy rows are better then.
/// @param base  rows of the world before all changes.
/// @param map  from that world to `after`.
/// @param visibility  of `after`.
std::optional<VisibilityRows::Changed> change_rows(const std::shared_ptr<const LazyRows>& base, const World& after,
                                                   const VertexMap& map,
                                                   std::shared_ptr<const VisibilityQuery> visibility);

/// New lazy rows of a world after a change, and what may differ. Nothing if regions of one of the worlds touch
/// themselves.
/// @param map  from the world before to `after`.
std::optional<VisibilityRows::Changed> rows_made_anew(const World& before, const World& after, const VertexMap& map);

}  // namespace arcway::internal
