#pragma once

#include <string>
#include <string_view>

namespace arcway::internal::detail {

/// Latin letters in lower case, whatever the locale; all else as it is.
inline char lowercase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
inline std::string lowercase(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = lowercase(c);
  return result;
}

}  // namespace arcway::internal::detail
