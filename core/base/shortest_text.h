#pragma once

#include <string>

namespace arcway::internal {

/// Shortest text that reads back to the same double, in any locale; "inf", "nan" if not finite.
std::string shortest_text(double value);

}  // namespace arcway::internal
