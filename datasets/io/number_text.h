#pragma once

#include <optional>
#include <string_view>

namespace arcway::internal {

/// The whole text as a finite number, in any locale; a leading plus is taken, blanks are not.
std::optional<double> read_number(std::string_view text);

/// The number that the text begins with, which is cut off its front. Nothing, and the text as it was, if it does not
/// begin with a finite number.
std::optional<double> take_number(std::string_view& text);

}  // namespace arcway::internal
