#pragma once

#include <charconv>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace arcway::internal::bench {

/// The query of a benchmark that took longest. Its label keeps it, as a report shows it.
struct SlowestQuery {
  std::string world;      ///< catalog name
  std::size_t query = 0;  ///< counted from 0
  double seconds = 0.0;   ///< processor time
};

/// "slowest: query 17 of clutter/convex/n100/m10/f30/s1, 0.213 s"
inline std::string label_of(const SlowestQuery& slowest) {
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.3g s", slowest.seconds);
  return "slowest: query " + std::to_string(slowest.query) + " of " + slowest.world + ", " + seconds;
}

/// What `label_of` wrote; nothing for other labels.
inline std::optional<SlowestQuery> slowest_query_of(std::string_view label) {
  constexpr std::string_view kBegin = "slowest: query ", kOf = " of ", kComma = ", ";
  if (!label.starts_with(kBegin)) return std::nullopt;
  label.remove_prefix(kBegin.size());
  const std::size_t of = label.find(kOf), comma = label.rfind(kComma);
  if (of == std::string_view::npos || comma == std::string_view::npos || comma < of + kOf.size()) return std::nullopt;
  SlowestQuery slowest;
  slowest.world = label.substr(of + kOf.size(), comma - of - kOf.size());
  const auto read = [](std::string_view text, auto& value) {
    return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
  };
  if (!read(label.substr(0, of), slowest.query) || !read(label.substr(comma + kComma.size()), slowest.seconds))
    return std::nullopt;
  return slowest;
}

}  // namespace arcway::internal::bench
