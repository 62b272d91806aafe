#include "core/base/shortest_text.h"

#include <charconv>

namespace arcway::internal {

std::string shortest_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string rounded_text(double value) {
  char text[400];  // the largest double has 309 digits
  std::string out(text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 3).ptr);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

}  // namespace arcway::internal
