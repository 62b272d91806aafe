#include "datasets/formats/movingai.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "arcway/angle.h"
#include "arcway/datasets/file_io.h"
#include "datasets/formats/text_scanner.h"
#include "datasets/io/number_text.h"
#include "datasets/io/random.h"
#include "datasets/io/shortened.h"

namespace arcway::internal {
namespace {

using detail::quoted;
using detail::TextScanner;

constexpr std::size_t kMostCells = 1'000'000'000;  // along a side: products with those of a map do not overflow

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Cell> cell_of(char c, const GridOptions& options) {
  if (options.free_letters && options.free_letters->find(c) != std::string::npos) return Cell::kFree;
  switch (c) {
    case '.':
    case 'G':
      return Cell::kFree;
    case 'S':
      return options.swamp_is_free ? Cell::kFree : Cell::kOccupied;
    case '@':
    case '#':
    case 'O':
    case 'T':
    case 'W':
      return Cell::kOccupied;
    default:
      return options.free_letters ? std::optional(Cell::kOccupied) : std::nullopt;
  }
}

struct GridSize {
  std::size_t height, width;
};

std::size_t size_after(TextScanner& scanner, std::string_view what) {
  scanner.skip_blanks();
  const TextScanner before = scanner;
  const std::optional<std::size_t> value = whole_number(scanner.word(","));
  if (!value || *value == 0) before.expected(std::string(what) + " as a whole number above 0");
  return *value;
}

// `type octile`, `height h` and `width w` in any order, then `map`.
GridSize read_header(TextScanner& scanner) {
  std::optional<std::size_t> height, width;
  while (true) {
    scanner.skip_space();
    const TextScanner before = scanner;
    const std::string_view key = scanner.word();
    if (key == "type") {
      scanner.rest_of_line();
    } else if (key == "height" && !height) {
      height = size_after(scanner, "height");
    } else if (key == "width" && !width) {
      width = size_after(scanner, "width");
    } else if (key == "map" && height && width) {
      scanner.rest_of_line();
      return {*height, *width};
    } else {
      before.expected(!height ? "\"height\"" : !width ? "\"width\"" : "\"map\"");
    }
  }
}

// `height,width`, as maps of warehouses have it, and lines of other counts.
GridSize read_sizes(TextScanner& scanner) {
  const std::size_t height = size_after(scanner, "height");
  scanner.accept(',');
  const std::size_t width = size_after(scanner, "width");
  scanner.rest_of_line();
  while (true) {
    const TextScanner before = scanner;
    const std::string_view line = scanner.rest_of_line();
    if (line.size() != width && whole_number(line)) continue;
    scanner = before;
    return {height, width};
  }
}

// Without a header: as many rows as there are, as wide as the first one.
GridSize count_rows(TextScanner scanner) {
  GridSize size{1, scanner.rest_of_line().size()};
  while (!scanner.rest_of_line().empty()) ++size.height;
  return size;
}

GridSize read_size(TextScanner& scanner) {
  scanner.skip_space();
  if (const char c = scanner.peek(); c >= '0' && c <= '9') return read_sizes(scanner);
  TextScanner ahead = scanner;
  const std::string_view word = ahead.word();
  return word == "type" || word == "height" || word == "width" ? read_header(scanner) : count_rows(scanner);
}

}  // namespace

OccupancyGrid read_movingai_map(std::string_view text, std::string_view name, const GridOptions& options) {
  TextScanner scanner(text, name);
  OccupancyGrid grid;
  const auto [height, width] = read_size(scanner);
  grid.height = height;
  grid.width = width;
  if (width == 0 || width > options.max_cells / height)
    scanner.fail(std::to_string(width) + " x " + std::to_string(height) + " cells; at most " +
                 std::to_string(options.max_cells) + " are read");
  grid.cell_size = options.cell_size.value_or(1.0);
  for (std::size_t row = 0; row < grid.height; ++row) {
    if (scanner.at_end())
      scanner.fail("the map ends after " + std::to_string(row) + " of " + std::to_string(grid.height) + " rows");
    const std::string place = scanner.place();
    const std::string_view line = scanner.rest_of_line();
    if (line.size() != grid.width)
      throw FormatError(place + ": expected " + std::to_string(grid.width) + " cells, found " +
                        std::to_string(line.size()));
    grid.cells.resize(grid.cells.size() + grid.width);  // the rows themselves, not a header, say how much
    for (std::size_t x = 0; x < grid.width; ++x) {
      const std::optional<Cell> cell = cell_of(line[x], options);
      if (!cell)
        throw FormatError(place + ", column " + std::to_string(x + 1) + ": unknown cell " + quoted(line.substr(x, 1)) +
                          "; name the letters that are free with --free-letters, others are obstacles then");
      grid.cells[row * grid.width + x] = *cell;
    }
  }
  scanner.skip_space();
  if (!scanner.at_end()) scanner.expected("the end of the file after " + std::to_string(grid.height) + " rows");
  flip_rows(grid);
  return grid;
}

std::vector<MovingAiTask> read_movingai_scenario(std::string_view text, std::string_view name) {
  TextScanner scanner(text, name);
  scanner.skip_space();
  const TextScanner first = scanner;
  const auto words = detail::split_at_blanks(scanner.rest_of_line());
  if (words.size() >= 9) {
    scanner = first;  // tasks without a line of their version
  } else if (words.size() != 2 || words[0] != "version" || (words[1] != "1" && words[1] != "1.0")) {
    first.expected("\"version 1\"");
  }
  std::vector<MovingAiTask> tasks;
  for (scanner.skip_space(); !scanner.at_end(); scanner.skip_space()) {
    const std::size_t line = scanner.line();
    const std::string place = scanner.place() + ": ";
    const std::string_view whole = scanner.rest_of_line();
    const auto fields = detail::split_at_blanks(whole);
    if (fields.size() < 9)
      throw FormatError(place +
                        "expected 9 fields (bucket, map, its width and height, start x y, goal x y, length), found " +
                        std::to_string(fields.size()));
    // From the end: the map's name may have blanks.
    const auto field = [&](std::size_t column) { return fields[fields.size() - 9 + column]; };
    const auto count = [&](std::size_t column, const char* what) {
      const std::optional<std::size_t> value = whole_number(field(column));
      if (!value) throw FormatError(place + "expected " + what + " as a whole number, found " + quoted(field(column)));
      return *value;
    };
    MovingAiTask task;
    const char* map_begin = fields[1].data();
    const std::string_view last = field(1);
    task.map = std::string(map_begin, static_cast<std::size_t>(last.data() + last.size() - map_begin));
    task.width = count(2, "the map's width");
    task.height = count(3, "the map's height");
    if (std::max(task.width, task.height) > kMostCells)
      throw FormatError(place + "a map of " + std::to_string(task.width) + " x " + std::to_string(task.height) +
                        " cells, at most " + std::to_string(kMostCells) + " are read along a side");
    task.start_x = count(4, "start x");
    task.start_y = count(5, "start y");
    task.goal_x = count(6, "goal x");
    task.goal_y = count(7, "goal y");
    for (const std::size_t column : {4, 5, 6, 7}) {
      const std::size_t limit = column % 2 == 0 ? task.width : task.height;
      if (count(column, "a cell") >= limit)
        throw FormatError(place + "cell " + shortened(field(column)) + " is outside of the map of " +
                          std::to_string(task.width) + " x " + std::to_string(task.height) + " cells");
    }
    const std::optional<double> length = read_number(field(8));
    if (!length) throw FormatError(place + "expected the optimal length, found " + quoted(field(8)));
    task.optimal_length = *length;
    task.line = line;
    tasks.push_back(std::move(task));
  }
  return tasks;
}

TaskHeadings draw_headings(std::uint64_t seed, std::size_t task) {
  Random random(seed + 0x9E3779B97F4A7C15u * (static_cast<std::uint64_t>(task) + 1));
  const double start = random.uniform(-kPi, kPi);
  return {wrap_signed(start), wrap_signed(random.uniform(-kPi, kPi))};
}

}  // namespace arcway::internal
