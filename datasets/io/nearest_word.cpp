#include "datasets/io/nearest_word.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "datasets/io/lowercase.h"

namespace arcway::internal {
namespace {

constexpr std::size_t kLongest = 64;  // letters that are compared, and shown

std::string compared(std::string_view text) { return detail::lowercase(text.substr(0, kLongest)); }

// Letters to change, add, leave out or swap with the next one (optimal string alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t k = 0; k <= b.size(); ++k) {
      if (i == 0 || k == 0) {
        d[i][k] = i + k;
        continue;
      }
      d[i][k] = std::min({d[i - 1][k] + 1, d[i][k - 1] + 1, d[i - 1][k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1)});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        d[i][k] = std::min(d[i][k], d[i - 2][k - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

std::string_view meant_by(std::string_view word, std::span<const std::string_view> known,
                          std::span<const Synonym> synonyms) {
  std::string letters = compared(word);
  std::erase_if(letters, [](unsigned char c) { return std::isalnum(c) == 0; });
  const auto synonym = std::ranges::find(synonyms, letters, &Synonym::word);
  return synonym != synonyms.end() ? synonym->known : nearest_word(word, known);
}

}  // namespace

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known) {
  constexpr std::size_t kPart = 4;  // letters of a word that is part of another
  const std::string given = compared(word);
  std::string_view nearest;
  std::size_t least = std::string_view::npos;
  for (const std::string_view candidate : known) {
    const std::string text = compared(candidate);
    const bool part = std::min(given.size(), text.size()) >= kPart &&
                      (text.find(given) != std::string::npos || given.find(text) != std::string::npos);
    const std::size_t off = part ? 1 : distance(given, text);
    if (off > std::max<std::size_t>(1, text.size() / 3) || off >= text.size() || off >= least) continue;
    least = off;
    nearest = candidate;
  }
  return nearest;
}

std::string unknown_word(std::string_view what, std::string_view word, std::span<const std::string_view> known,
                         std::span<const Synonym> synonyms) {
  std::string text = "unknown " + std::string(what) + " \"";
  for (const char c : word.substr(0, kLongest))
    text += static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7E ? '?' : c;
  text += word.size() > kLongest ? "...\"" : "\"";
  if (const std::string_view nearest = meant_by(word, known, synonyms); !nearest.empty())
    text.append(", did you mean \"").append(nearest).append("\"?").append(" There are ");
  else
    text += "; there are ";
  for (std::size_t i = 0; i < known.size(); ++i) text.append(i > 0 ? ", " : "").append(known[i]);
  return text;
}

}  // namespace arcway::internal
