#include "datasets/formats/text_polygons.h"

#include <utility>

#include "datasets/formats/text_scanner.h"

namespace arcway::internal {

MapFile read_text_polygons(std::string_view text, std::string_view name, const VectorOptions& options) {
  detail::TextScanner scanner(text, name);
  detail::VectorMapBuilder map(name, options);
  for (scanner.skip_space(); !scanner.at_end(); scanner.skip_space()) {
    if (scanner.peek() == '#') {
      scanner.rest_of_line();
      continue;
    }
    const std::string place = "line " + std::to_string(scanner.line());
    Ring positions;
    const auto skip_separator = [&] {
      scanner.skip_blanks();
      if (!scanner.accept(',')) scanner.accept(';');
      scanner.skip_blanks();
    };
    do {
      const double x = scanner.number("a number");
      skip_separator();
      const double y = scanner.number("a number, as positions are x y");
      positions.emplace_back(x, y);
      skip_separator();
    } while (!scanner.at_end() && scanner.peek() != '\n');
    map.add_polygon({map.ring(std::move(positions), /*closed=*/false, place), {}}, place);
  }
  return map.finish();
}

}  // namespace arcway::internal
