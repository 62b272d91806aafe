#include "datasets/formats/vertex_list.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "datasets/formats/text_scanner.h"
#include "datasets/io/lowercase.h"
#include "datasets/io/number_text.h"
#include "datasets/io/shortened.h"

namespace arcway::internal {
namespace {

using Fields = std::vector<std::string>;

constexpr std::string_view kMarks = ",;\t";
constexpr std::string_view kMarksBesideDecimalCommas = ";\t";

// Parts between separators: marks, which may stand beside an empty part, or blanks where there are none.
Fields fields_of(std::string_view line, std::string_view separating = kMarks) {
  const bool marks = line.find_first_of(separating) != std::string_view::npos;
  const std::string_view separators = marks ? separating : " ";
  Fields fields;
  while (true) {
    const std::size_t end = std::min(line.find_first_of(separators), line.size());
    std::string_view field = line.substr(0, end);
    while (!field.empty() && (field.front() == ' ' || field.front() == '"')) field.remove_prefix(1);
    while (!field.empty() && (field.back() == ' ' || field.back() == '"' || field.back() == '\r'))
      field.remove_suffix(1);
    if (marks || !field.empty()) fields.emplace_back(field);
    if (end == line.size()) return fields;
    line.remove_prefix(end + 1);
  }
}

// Whether a line that names columns is one of a table whose numbers may have decimal commas.
bool allows_decimal_commas(std::string_view header) {
  return header.find(';') != std::string_view::npos && header.find(',') == std::string_view::npos;
}

bool is_nan(const std::string& field) { return detail::lowercase(field) == "nan"; }

// Meaning of the columns.
struct Columns {
  std::size_t x = 0, y = 1, count = 2;
  std::optional<std::size_t> group{};
  bool degrees = false;
  std::string unread{};
};

std::optional<Columns> columns_of(const Fields& names) {
  Columns columns;
  columns.count = names.size();
  bool has_x = false, has_y = false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = detail::lowercase(names[i]);
    const auto is_one_of = [&](std::initializer_list<std::string_view> words) {
      return std::ranges::find(words, std::string_view(name)) != words.end();
    };
    if (is_one_of({"x", "lon", "lng", "long", "longitude", "easting", "x_m"}) && !has_x) {
      has_x = true;
      columns.x = i;
      columns.degrees = name[0] == 'l';
    } else if (is_one_of({"y", "lat", "latitude", "northing", "y_m"}) && !has_y) {
      has_y = true;
      columns.y = i;
    } else if (is_one_of(
                   {"id", "polygon", "obstacle", "ring", "feature", "shape", "part", "polygon_id", "obstacle_id"}) &&
               !columns.group) {
      columns.group = i;
    } else if (is_one_of({"yaw", "heading", "theta", "curvature"})) {
      return std::nullopt;  // poses of a path
    } else {
      columns.unread += (columns.unread.empty() ? "" : ", ") + detail::quoted(names[i]);
    }
  }
  if (!has_x || !has_y) return std::nullopt;
  return columns;
}

class VertexReader {
 public:
  VertexReader(std::string_view text, std::string_view name, const VectorOptions& options)
      : text_(text, name), map_(name, options) {}

  MapFile read() {
    bool first = true;
    while (!text_.at_end()) {
      const std::size_t line = text_.line();
      const std::string place = text_.place();
      const std::string_view whole = text_.rest_of_line();
      if (whole.starts_with('#')) continue;
      const Fields fields = fields_of(whole, marks_);
      if (std::ranges::all_of(fields, [](const std::string& field) { return field.empty() || is_nan(field); })) {
        end_polygon();
        continue;
      }
      if (std::exchange(first, false) && read_header(fields)) {
        if (allows_decimal_commas(whole)) marks_ = kMarksBesideDecimalCommas;
        continue;
      }
      if (fields.size() != columns_.count)
        throw FormatError(place + ": expected " + std::to_string(columns_.count) + " numbers, found " +
                          std::to_string(fields.size()) + " in " + detail::quoted(whole) +
                          "; a first line as \"id,x,y\" names columns, one as \"id;x;y\" allows decimal commas");
      add(fields, line, place);
    }
    end_polygon();
    return map_.finish();
  }

 private:
  bool read_header(const Fields& fields) {
    const std::optional<Columns> columns = columns_of(fields);
    if (!columns) return false;
    columns_ = *columns;
    if (columns_.degrees) map_.set_system("longitude and latitude");
    if (!columns_.unread.empty())
      map_.warn("line 1", "columns that are not read: " + shortened(columns_.unread, kMostOfParser));
    return true;
  }
  void add(const Fields& fields, std::size_t line, const std::string& place) {
    const auto number = [&](std::size_t column) {
      std::string digits = fields[column];
      if (marks_ == kMarksBesideDecimalCommas) std::ranges::replace(digits, ',', '.');
      const std::optional<double> value = read_number(digits);
      if (!value) throw FormatError(place + ": expected a number, found " + detail::quoted(fields[column]));
      return *value;
    };
    if (columns_.group && fields[*columns_.group] != group_) {
      end_polygon();
      group_ = fields[*columns_.group];
    }
    if (positions_.empty()) place_ = "line " + std::to_string(line);
    positions_.emplace_back(number(columns_.x), number(columns_.y));
    if (!columns_.group && positions_.size() > 3 && positions_.back() == positions_.front()) end_polygon();
  }
  void end_polygon() {
    if (positions_.empty()) return;
    map_.add_polygon({map_.ring(std::exchange(positions_, {}), /*closed=*/false, place_), {}}, place_);
  }

  detail::TextScanner text_;
  detail::VectorMapBuilder map_;
  Columns columns_;
  std::string_view marks_ = kMarks;
  Ring positions_;  // positions of the polygon so far
  std::string place_, group_;
};

}  // namespace

MapFile read_vertex_list(std::string_view text, std::string_view name, const VectorOptions& options) {
  return VertexReader(text, name, options).read();
}

bool is_vertex_list(std::string_view text) {
  constexpr std::size_t kLines = 1000;  // number of lines examined
  detail::TextScanner scanner(text, "");
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < kLines && !scanner.at_end(); ++i) {
    const std::string_view line = scanner.rest_of_line();
    if (line.empty() || line.front() == '#') continue;
    const Fields fields = fields_of(line);
    if (fields.size() != 2) return false;
    for (const std::string& field : fields)
      if (!read_number(field) && !is_nan(field)) return false;
    ++vertices;
  }
  return vertices > 0;
}

bool has_vertex_header(std::string_view text) {
  detail::TextScanner scanner(text, "");
  scanner.skip_space();
  return columns_of(fields_of(scanner.rest_of_line())).has_value();
}

}  // namespace arcway::internal
