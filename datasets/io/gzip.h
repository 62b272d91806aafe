#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace arcway::internal {

bool is_gzip(std::string_view bytes);

/// All members that follow each other; zeros behind the last one are skipped, as gzip does.
/// @param max_bytes  of the text; more are refused.
/// @throws FormatError naming the source if it is damaged, cut off, too large or goes on with anything else.
std::string expand_gzip(std::string_view bytes, std::string_view name, std::size_t max_bytes = std::size_t{1} << 29);

}  // namespace arcway::internal
