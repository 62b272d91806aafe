#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace arcway::internal {

/// Bytes of a file's or a user's word that a message repeats: enough to find it there.
inline constexpr std::size_t kMostRepeated = 80;
/// Bytes of what a parser of another project says, which may repeat a whole word of the file.
inline constexpr std::size_t kMostOfParser = 300;

/// The text, or its first `most` bytes and "...". Does not cut a character of UTF-8.
std::string shortened(std::string_view text, std::size_t most = kMostRepeated);

}  // namespace arcway::internal
