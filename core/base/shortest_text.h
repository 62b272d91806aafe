#pragma once

#include <string>

namespace arcway::internal {

/// The shortest text that reads back to the same double, in any locale; "inf" or "nan" if not finite.
std::string shortest_text(double value);

}  // namespace arcway::internal
