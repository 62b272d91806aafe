#include "arcway/datasets/wkt.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/model/pose_text.h"
#include "datasets/formats/text_scanner.h"
#include "datasets/formats/vector_map.h"

namespace arcway {

using namespace internal;
namespace {

constexpr int kMaxDepth = 32;  // nesting of geometry collections

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return capitals;
}

class WktReader {
 public:
  WktReader(std::string_view text, std::string_view name, const VectorOptions& options)
      : text_(text, name), map_(name, options) {}

  MapFile read() {
    for (text_.skip_space(); !text_.at_end(); text_.skip_space()) {
      place_ = "line " + std::to_string(text_.line());
      read_srid();
      read_geometry(0);
      text_.skip_space();
      text_.accept(';');
    }
    return map_.finish();
  }

 private:
  // A keyword in capitals; "" if none is next.
  std::string keyword() {
    text_.skip_space();
    return in_capitals(text_.word("(),;=0123456789"));
  }

  void read_srid() {
    TextScanner before = text_;
    if (keyword() != "SRID") {
      text_ = before;
      return;
    }
    text_.skip_space();
    if (!text_.accept('=')) text_.expected("\"=\" after SRID");
    text_.skip_space();
    const std::string_view number = text_.word(";");
    if (!text_.accept(';')) text_.expected("\";\" after the SRID");
    if (number != "0") map_.set_system("EPSG:" + std::string(number));  // 0 of PostGIS: not stated
  }

  void open() {
    text_.skip_space();
    if (!text_.accept('(')) text_.expected("\"(\"");
  }
  // After an element: whether another one follows.
  bool more() {
    text_.skip_space();
    if (text_.accept(',')) return true;
    if (!text_.accept(')')) text_.expected("\",\" or \")\"");
    return false;
  }
  // A list of what `element` reads, or EMPTY.
  template <class Element>
  void list(Element element) {
    if (accept_empty()) return;
    open();
    do element();
    while (more());
  }
  bool accept_empty() {
    TextScanner before = text_;
    if (keyword() == "EMPTY") return true;
    text_ = before;
    return false;
  }

  void read_geometry(int depth) {
    if (depth > kMaxDepth) text_.fail("geometry collections nested more than " + std::to_string(kMaxDepth) + " deep");
    const std::string type = wkt_type(keyword());
    {  // Z, M and ZM, behind a blank or not, say how many ordinates there are, which shows anyway
      TextScanner before = text_;
      if (const std::string word = keyword(); word != "Z" && word != "M" && word != "ZM") text_ = before;
    }
    if (type == "POLYGON") {
      read_polygon(place_);
    } else if (type == "MULTIPOLYGON") {
      std::size_t i = 0;
      list([&] { read_polygon(place_ + ", polygon " + std::to_string(i++)); });
    } else if (type == "GEOMETRYCOLLECTION") {
      list([&] { read_geometry(depth + 1); });
    } else if (type == "LINESTRING") {
      map_.add_line(positions(), place_);
    } else if (type == "MULTILINESTRING") {
      std::size_t i = 0;
      list([&] { map_.add_line(positions(), place_ + ", line " + std::to_string(i++)); });
    } else if (type == "POINT" || type == "MULTIPOINT") {
      list([&] {  // MULTIPOINT may put each of its points in parentheses
        text_.skip_space();
        const bool enclosed = text_.accept('(');
        position();
        if (enclosed && more()) text_.expected("\")\"");
      });
      map_.pass_over(place_, type);
    } else {
      text_.fail("expected a geometry as POLYGON or MULTIPOLYGON, found " + detail::quoted(type));
    }
  }

  Vec2 position() {
    text_.skip_space();
    const double x = text_.number("a number");
    text_.skip_space();
    const double y = text_.number("a number");
    for (text_.skip_space(); text_.peek() != ',' && text_.peek() != ')'; text_.skip_space())
      if (!accept_missing()) text_.number("a number, \",\" or \")\"");
    return {x, y};
  }
  // Z and M that a writer had no value for: "nan", "-inf", "NULL".
  bool accept_missing() {
    TextScanner before = text_;
    std::string word = in_capitals(text_.word(",()"));
    if (word.starts_with('-') || word.starts_with('+')) word.erase(0, 1);
    for (const std::string_view missing : {"NAN", "INF", "INFINITY", "NULL"})
      if (word == missing) return true;
    text_ = before;
    return false;
  }
  std::vector<Vec2> positions() {
    std::vector<Vec2> result;
    list([&] { result.push_back(position()); });
    return result;
  }

  void read_polygon(const std::string& place) {
    Polygon polygon;
    std::size_t rings = 0;
    list([&] {
      Ring ring = map_.ring(positions(), /*closed=*/true, place + ", ring " + std::to_string(rings));
      (rings++ == 0 ? polygon.outer : polygon.holes.emplace_back()) = std::move(ring);
    });
    if (rings > 0) map_.add_polygon(std::move(polygon), place);
  }

  using TextScanner = detail::TextScanner;
  TextScanner text_;
  detail::VectorMapBuilder map_;
  std::string place_;  // place of the geometry, for messages
};

void append_ring(std::string& out, const Ring& ring) {
  out += '(';
  for (std::size_t i = 0; i <= ring.size() && !ring.empty(); ++i) {
    const Vec2& p = ring[i < ring.size() ? i : 0];
    if (i > 0) out += ", ";
    out += shortest_text(p.x());
    out += ' ';
    out += shortest_text(p.y());
  }
  out += ')';
}

}  // namespace

std::string wkt_type(std::string_view keyword) {
  std::string type = in_capitals(keyword);
  if (type.ends_with('M')) type.pop_back();
  if (type.ends_with('Z')) type.pop_back();
  return type;
}

MapFile read_wkt(std::string_view text, std::string_view name, const VectorOptions& options) {
  return WktReader(text, name, options).read();
}

std::string to_wkt(const MapFile& map) {
  if (map.obstacles.empty()) return "GEOMETRYCOLLECTION EMPTY\n";
  std::string out;
  for (const Polygon& polygon : map.obstacles) {
    out += "POLYGON (";
    append_ring(out, polygon.outer);
    for (const Ring& hole : polygon.holes) {
      out += ", ";
      append_ring(out, hole);
    }
    out += ")\n";
  }
  return out;
}

}  // namespace arcway
