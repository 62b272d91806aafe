#pragma once

#include <string>

#include "arcway/path.h"
#include "arcway/vec2.h"
#include "core/base/shortest_text.h"

namespace arcway::internal {

/// "(x, y)", each number as shortest_text(double) writes it [m].
std::string shortest_text(const Vec2& p);
/// "(x, y, heading)" [m, m, rad].
std::string shortest_text(const Pose& pose);

}  // namespace arcway::internal
