#pragma once

#include <string>
#include <string_view>

namespace arcway::report {

/// With the characters that mean something in HTML replaced.
std::string escaped(std::string_view text);

/// One number by a printf format.
std::string number_text(const char* format, double value);

}  // namespace arcway::report
