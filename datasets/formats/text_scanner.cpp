#include "datasets/formats/text_scanner.h"

#include <algorithm>

#include "arcway/datasets/file_io.h"
#include "datasets/io/number_text.h"

namespace arcway::internal::detail {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

}  // namespace

TextScanner::TextScanner(std::string_view text, std::string_view name) : rest_(text), name_(name) {
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

void TextScanner::skip_blanks() {
  while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
}

void TextScanner::skip_space() {
  for (; !rest_.empty() && (is_blank(rest_.front()) || rest_.front() == '\n'); rest_.remove_prefix(1))
    if (rest_.front() == '\n') ++line_;
}

bool TextScanner::accept(char c) {
  if (peek() != c || at_end()) return false;
  rest_.remove_prefix(1);
  if (c == '\n') ++line_;
  return true;
}

std::string_view TextScanner::word(std::string_view stops) {
  const auto end = std::find_if(rest_.begin(), rest_.end(), [&](char c) {
    return is_blank(c) || c == '\n' || stops.find(c) != std::string_view::npos;
  });
  const std::string_view result = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  rest_.remove_prefix(result.size());
  return result;
}

std::string_view TextScanner::rest_of_line() {
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  std::string_view result = rest_.substr(0, end);
  rest_.remove_prefix(end);
  accept('\n');
  while (!result.empty() && is_blank(result.back())) result.remove_suffix(1);
  return result;
}

double TextScanner::number(std::string_view what) {
  const std::optional<double> value = take_number(rest_);
  if (!value) expected(what);
  return *value;
}

std::string TextScanner::place() const { return std::string(name_) + ": line " + std::to_string(line_); }

void TextScanner::fail(std::string_view message) const { throw FormatError(place() + ": " + std::string(message)); }

void TextScanner::expected(std::string_view what) const {
  TextScanner rest = *this;
  const std::string_view next = rest.word();
  fail("expected " + std::string(what) + ", found " +
       (!next.empty() ? quoted(next)
        : at_end()    ? "the end of the file"
                      : "the end of the line"));
}

std::vector<std::string_view> split_at_blanks(std::string_view line) {
  std::vector<std::string_view> parts;
  while (true) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    if (line.empty()) return parts;
    const auto end = std::find_if(line.begin(), line.end(), is_blank);
    parts.push_back(line.substr(0, static_cast<std::size_t>(end - line.begin())));
    line.remove_prefix(parts.back().size());
  }
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string result = "\"" + std::string(text.substr(0, kLongest));
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7E) c = '?';
  return result + (text.size() > kLongest ? "...\"" : "\"");
}

}  // namespace arcway::internal::detail
