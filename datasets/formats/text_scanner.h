#pragma once

// Private to datasets/*.cpp.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace arcway::internal::detail {

/// Walks through a text from front to back and knows the line that it is in, for messages.
class TextScanner {
 public:
  /// Skips a byte-order mark.
  /// @param name  of the source, for messages.
  TextScanner(std::string_view text, std::string_view name);

  /// Skips blanks and line ends.
  void skip_space();
  /// Skips blanks within the line.
  void skip_blanks();
  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  /// The next character; 0 at the end.
  [[nodiscard]] char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
  /// Takes the character if it is next.
  bool accept(char c);
  /// Takes all up to the next blank, line end or one of `stops`; may be empty.
  std::string_view word(std::string_view stops = "");
  /// Takes the rest of the line and its end; without the line end and blanks before it.
  std::string_view rest_of_line();
  /// Takes a number. @param what  is expected, for the message.
  double number(std::string_view what);

  /// Line of the next character, from 1.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// "name: line 3"
  [[nodiscard]] std::string place() const;
  /// @throws FormatError, "name: line 3: message"
  [[noreturn]] void fail(std::string_view message) const;
  /// "name: line 3: expected <what>, found <the next word>"
  [[noreturn]] void expected(std::string_view what) const;

 private:
  std::string_view rest_;
  std::string_view name_;
  std::size_t line_ = 1;
};

/// Parts between blanks.
std::vector<std::string_view> split_at_blanks(std::string_view line);
/// Text in double quotes, cut if long, bytes that are not printable ASCII replaced.
std::string quoted(std::string_view text);

}  // namespace arcway::internal::detail
