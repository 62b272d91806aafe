#pragma once

// Private to datasets/*.cpp: nlohmann_json is not part of the interface.

#include <functional>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "arcway/datasets/file_io.h"
#include "arcway/path.h"
#include "datasets/io/nearest_word.h"

namespace arcway::internal::detail {

/// Shortest text that reads back to the same double; null if not finite.
void append_number(std::string& out, double value);
/// [x,y,heading]
void append_pose(std::string& out, const Pose& pose);
/// A text in quotes with escapes; invalid UTF-8 is replaced.
void append_string(std::string& out, std::string_view text);

/// An array at the top of a document that is read as a stream: its elements are handed over one by one and not kept.
/// Memory follows the largest element, not the document.
struct JsonElements {
  std::string_view key;
  std::function<void()> restart;                       ///< the key comes again: the last one counts
  std::function<void(const nlohmann::json&)> element;  ///< called in order
};

enum class RepeatedKeys { kLastCounts, kRefused };

/// Skips a byte-order mark.
/// @param elements    if not null, the array of this key is left empty in the result.
/// @param first_line  number of the text's first line.
/// @throws FormatError, "name: line 3: ...", also if arrays and objects nest more than 100 deep.
nlohmann::json parse_json(std::string_view text, std::string_view name, const JsonElements* elements = nullptr,
                          std::size_t first_line = 1, RepeatedKeys repeated = RepeatedKeys::kLastCounts);

/// A value and where it is, for messages: "robot.json: turn_speed.table[2][0]: expected a number, found null".
struct JsonPlace {
  const nlohmann::json& value;
  std::string path;  ///< begins with the source's name

  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void expected(const char* what) const;
  [[nodiscard]] double number() const;
  [[nodiscard]] std::string string() const;
  [[nodiscard]] Pose pose() const;
  [[nodiscard]] JsonPlace at(std::string_view key) const;  ///< a required key
  [[nodiscard]] JsonPlace at(std::size_t index) const;
  [[nodiscard]] bool has(std::string_view key) const { return value.contains(key); }
  void require_object() const;
  void require_array() const;
  /// Refuses any other key.
  /// @param synonyms  of the keys, for the message.
  void allow_keys(std::initializer_list<std::string_view> keys, std::span<const Synonym> synonyms = {}) const;
  /// Refuses any other "format" and "version".
  void require_format(std::string_view format, int version) const;
  /// Refuses any other "format" and "version", where they are given.
  void allow_format(std::string_view format, int version) const;
};

/// The value as text, cut if long.
std::string shown(const nlohmann::json& value);

}  // namespace arcway::internal::detail
