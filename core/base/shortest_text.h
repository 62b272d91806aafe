#pragma once

#include <string>

namespace arcway::internal {

/// The shortest text that reads back to the same double, in any locale; "inf" or "nan" if not finite.
std::string shortest_text(double value);

/// A number as people read it, as a length to a millimeter: three decimals, without trailing zeros.
std::string rounded_text(double value);

}  // namespace arcway::internal
