#pragma once

#include <string>

#include "core/base/shortest_text.h"
#include "core/geometry/vec2.h"
#include "core/model/path.h"

namespace [[gnu::visibility("default")]] arcway {

/// "(x, y)", each number as shortest_text(double) writes it [m].
std::string shortest_text(const Vec2& p);
/// "(x, y, heading)" [m, m, rad].
std::string shortest_text(const Pose& pose);

}  // namespace arcway
