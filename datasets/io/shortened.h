#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace arcway::internal {

/// Most bytes that a message quotes of a word from a file or of an argument: enough to find it there.
inline constexpr std::size_t kMostRepeated = 80;
/// Most bytes that a message quotes of the message of a third-party parser, which may quote the file itself.
inline constexpr std::size_t kMostOfParser = 300;

/// The text, or its first `most` bytes and "...". Does not cut a character of UTF-8.
std::string shortened(std::string_view text, std::size_t most = kMostRepeated);

}  // namespace arcway::internal
