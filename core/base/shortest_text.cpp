#include "core/base/shortest_text.h"

#include <charconv>

namespace arcway::internal {

std::string shortest_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace arcway::internal
