#include "datasets/io/json_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "datasets/io/nearest_word.h"
#include "datasets/io/shortened.h"

namespace arcway::internal::detail {

using nlohmann::json;

namespace {

constexpr std::size_t kDeepest = 100;

/// Steps through a text and tells how far it is.
struct TrackedIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  const char** shared;

  const char& operator*() const { return *at; }
  TrackedIterator& operator++() {
    *shared = ++at;
    return *this;
  }
  bool operator==(const TrackedIterator& other) const { return at == other.at; }
  bool operator!=(const TrackedIterator& other) const { return at != other.at; }
};

/// Builds the tree that json::parse would, but for the streamed elements, and no deeper than kDeepest.
class TreeBuilder : public nlohmann::json_sax<json> {
 public:
  TreeBuilder(const JsonElements* elements, RepeatedKeys repeated) : elements_(elements), repeated_(repeated) {}

  /// Empty if all went well.
  [[nodiscard]] const std::string& error() const { return error_; }
  json take_root() { return std::move(root_); }

  bool null() override { return add_leaf(nullptr); }
  bool boolean(bool value) override { return add_leaf(value); }
  bool number_integer(number_integer_t value) override { return add_leaf(value); }
  bool number_unsigned(number_unsigned_t value) override { return add_leaf(value); }
  bool number_float(number_float_t value, const string_t&) override { return add_leaf(value); }
  bool string(string_t& value) override { return add_leaf(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // not in text
  bool start_object(std::size_t) override { return open(json::value_t::object); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(json::value_t::array); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    if (elements_ != nullptr && open_.size() == 1) {
      streaming_ = name == elements_->key;
      if (streaming_ && open_.back()->contains(name)) elements_->restart();
    }
    if (repeated_ == RepeatedKeys::kRefused && open_.back()->contains(name)) {
      error_ = "the key " + shown(name) + " comes twice";
      return false;
    }
    member_ = &(*open_.back())[name];
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const json::exception& exception) override {
    // "[json.exception.parse_error.101] parse error at line 1, column 3: syntax error ..."
    const std::string what = exception.what();
    const std::size_t colon = what.find(": "), bracket = what.find("] ");
    error_ = shortened(what.substr(colon != std::string::npos     ? colon + 2
                                   : bracket != std::string::npos ? bracket + 2
                                                                  : 0),
                       kMostOfParser);
    return false;
  }

 private:
  json* add(json value) {
    if (open_.empty()) return &(root_ = std::move(value));
    if (!open_.back()->is_array()) return &(*member_ = std::move(value));
    open_.back()->push_back(std::move(value));
    return &open_.back()->back();
  }
  bool add_leaf(json value) {
    add(std::move(value));
    hand_over();
    return true;
  }
  bool open(json::value_t type) {
    if (open_.size() == kDeepest) {
      error_ = "arrays and objects are nested more than " + std::to_string(kDeepest) + " deep";
      return false;
    }
    open_.push_back(add(json(type)));
    return true;
  }
  bool close() {
    open_.pop_back();
    hand_over();
    return true;
  }
  // After a value is complete: whether it is one of the streamed elements.
  void hand_over() {
    if (!streaming_ || open_.size() != 2 || !open_.back()->is_array()) return;
    elements_->element(open_.back()->back());
    open_.back()->clear();
  }

  const JsonElements* elements_;
  RepeatedKeys repeated_;
  json root_;
  std::vector<json*> open_;  // from the root to the innermost array or object
  json* member_ = nullptr;   // member of the innermost object that gets the next value
  bool streaming_ = false;   // the root's current member is the streamed one
  std::string error_;
};

}  // namespace

void append_number(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
  } else if (value == 0.0) {
    out += std::signbit(value) ? "-0.0" : "0";  // -0 would be read as an integer
  } else {
    char buffer[32];
    out.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  }
}

void append_pose(std::string& out, const Pose& pose) {
  out += '[';
  append_number(out, pose.x);
  out += ',';
  append_number(out, pose.y);
  out += ',';
  append_number(out, pose.heading);
  out += ']';
}

void append_string(std::string& out, std::string_view text) {
  out += json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

json parse_json(std::string_view text, std::string_view name, const JsonElements* elements, std::size_t first_line,
                RepeatedKeys repeated) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw FormatError(std::string(name) + ": empty file, expected JSON");
  // The parser takes a zero for the end, and would pass over what follows.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    const auto line = first_line + static_cast<std::size_t>(std::count(text.begin(), text.begin() + zero, '\n'));
    throw FormatError(std::string(name) + ": line " + std::to_string(line) + ": a byte 0, which JSON does not have");
  }
  const char* at = text.data();
  TreeBuilder builder(elements, repeated);
  json::sax_parse(TrackedIterator{at, &at}, TrackedIterator{text.data() + text.size(), nullptr}, &builder);
  if (builder.error().empty()) return builder.take_root();

  const std::string_view read = text.substr(0, static_cast<std::size_t>(at - text.data()));
  // The parser has read the line end behind a token that ends there.
  const auto breaks = std::count(read.begin(), read.end() - (read.empty() ? 0 : 1), '\n');
  const std::string place =
      std::string(name) + ": line " + std::to_string(first_line + static_cast<std::size_t>(breaks)) + ": ";
  // The parser stops somewhere in the word.
  for (const std::string_view word : {"NaN", "nan", "Inf", "inf"})
    if (text.substr(read.size() - std::min<std::size_t>(read.size(), 3), 6).find(word) != std::string_view::npos)
      throw FormatError(place + "found " + std::string(word) +
                        ", which is not a number in JSON; numbers must be finite");
  throw FormatError(place + builder.error());
}

std::string shown(const json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array() && value.size() > 4) return "an array of " + std::to_string(value.size());
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

void JsonPlace::fail(const std::string& message) const { throw FormatError(path + ": " + message); }

void JsonPlace::expected(const char* what) const { fail(std::string("expected ") + what + ", found " + shown(value)); }

double JsonPlace::number() const {
  if (!value.is_number()) expected("a number");
  return value.get<double>();
}

std::string JsonPlace::string() const {
  if (!value.is_string()) expected("a string");
  return value.get<std::string>();
}

Pose JsonPlace::pose() const {
  if (!value.is_array() || value.size() != 3) expected("a pose [x, y, heading]");
  return {at(0).number(), at(1).number(), at(2).number()};
}

JsonPlace JsonPlace::at(std::string_view key) const {
  require_object();
  const auto found = value.find(key);
  if (found == value.end()) fail("missing key \"" + std::string(key) + "\"");
  // The source's name and the first key are two parts, further keys are joined with a dot.
  return {*found, path + (path.find(": ") == std::string::npos ? ": " : ".") + std::string(key)};
}

JsonPlace JsonPlace::at(std::size_t index) const { return {value.at(index), path + "[" + std::to_string(index) + "]"}; }

void JsonPlace::require_object() const {
  if (!value.is_object()) expected("an object");
}

void JsonPlace::require_array() const {
  if (!value.is_array()) expected("an array");
}

void JsonPlace::allow_keys(std::initializer_list<std::string_view> keys, std::span<const Synonym> synonyms) const {
  require_object();
  for (const auto& [key, unused] : value.items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      fail(unknown_word("key", key, std::span(keys.begin(), keys.size()), synonyms));
}

void JsonPlace::require_format(std::string_view format, int version) const {
  if (at("format").value == format) static_cast<void>(at("version"));
  allow_format(format, version);
}

void JsonPlace::allow_format(std::string_view format, int version) const {
  if (has("format") && at("format").value != format) at("format").expected(("\"" + std::string(format) + "\"").c_str());
  if (has("version") && at("version").value != version) at("version").expected(std::to_string(version).c_str());
}

}  // namespace arcway::internal::detail
