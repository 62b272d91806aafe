#pragma once

#include <string>
#include <string_view>

namespace arcway::internal {

/// Text for XML and HTML: characters that mean something there replaced, control characters by blanks.
std::string escaped(std::string_view text);

}  // namespace arcway::internal
