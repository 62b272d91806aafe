#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace [[gnu::visibility("default")]] arcway {

bool is_gzip(std::string_view bytes);

/// @param max_bytes  of the text; more are refused.
/// @throws FormatError naming the source if it is damaged, cut off or too large.
std::string expand_gzip(std::string_view bytes, std::string_view name, std::size_t max_bytes = std::size_t{1} << 29);

}  // namespace arcway
