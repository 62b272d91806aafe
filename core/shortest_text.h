#pragma once

#include <string>

#include "core/geometry/vec2.h"
#include "core/path/path.h"

namespace [[gnu::visibility("default")]] arcway {

/// Shortest text that reads back to the same double, in any locale; "inf", "nan" if not finite.
std::string shortest_text(double value);
/// "(x, y)"
std::string shortest_text(const Vec2& p);
/// "(x, y, heading)"
std::string shortest_text(const Pose& pose);

}  // namespace arcway
