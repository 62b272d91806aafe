#pragma once

#include <span>
#include <string>
#include <string_view>

namespace arcway::internal {

/// The known word that was most likely meant; empty if there is none near enough. A known word is near if at most a
/// third of its letters are changed, added, left out or swapped with the next one. It is also near if one word is part
/// of the other. Case does not count.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known);

/// Another word for a known one.
struct Synonym {
  std::string_view word;   ///< in lower case, letters and digits alone: "maxvelocity"
  std::string_view known;  ///< "max_speed"
};

/// Says that a word is not known: `unknown key "widht", did you mean "width"? There are length, width`.
/// @param synonyms  looked up before the nearest word is; case, and signs such as `_`, do not count.
std::string unknown_word(std::string_view what, std::string_view word, std::span<const std::string_view> known,
                         std::span<const Synonym> synonyms = {});

}  // namespace arcway::internal
