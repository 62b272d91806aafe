#include "arcway/datasets/detect_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "arcway/datasets/prepared_map.h"
#include "arcway/datasets/wkt.h"
#include "datasets/formats/text_scanner.h"
#include "datasets/formats/vertex_list.h"
#include "datasets/io/number_text.h"

namespace arcway {

using namespace internal;
namespace {

using detail::split_at_blanks;
using detail::TextScanner;

constexpr std::size_t kLooked = std::size_t{1} << 16;  // bytes that are looked at, where not all are

struct FormatWord {
  std::string_view word;
  MapFormat format;
  const char* name;
};
constexpr FormatWord kFormats[] = {{"geojson", MapFormat::kGeoJson, "GeoJSON"},
                                   {"wkt", MapFormat::kWkt, "WKT"},
                                   {"text", MapFormat::kTextPolygons, "text of polygons"},
                                   {"vertices", MapFormat::kVertexList, "list of vertices"},
                                   {"tpcap", MapFormat::kTpcap, "TPCAP case"},
                                   {"movingai", MapFormat::kMovingAiMap, "MovingAI map"},
                                   {"scenario", MapFormat::kMovingAiScenario, "MovingAI scenario"},
                                   {"ros", MapFormat::kRosMap, "ROS map"},
                                   {"pgm", MapFormat::kPgm, "PGM image"},
                                   {"png", MapFormat::kPng, "PNG image"},
                                   {"svg", MapFormat::kSvg, "SVG"},
                                   {"prepared", MapFormat::kPrepared, "prepared map"}};

// Known formats that are not read, by their first bytes.
struct Foreign {
  std::string_view magic, what;
};
using namespace std::string_view_literals;
constexpr Foreign kForeign[] = {{"P1", "a PBM image; save it as PGM or PNG"},
                                {"P4", "a PBM image; save it as PGM or PNG"},
                                {"P3", "a PPM image; save it as PGM or PNG"},
                                {"P6", "a PPM image; save it as PGM or PNG"},
                                {"\xFF\xD8\xFF", "a JPEG image; save it as PNG"},
                                {"BM", "a BMP image; save it as PNG"},
                                {"GIF8", "a GIF image; save it as PNG"},
                                {"II*\0"sv, "a TIFF image; save it as PNG"},
                                {"MM\0*"sv, "a TIFF image; save it as PNG"},
                                {"%PDF", "a PDF document; save its drawing as SVG"},
                                {"PK\x03\x04", "a ZIP archive; unpack it"},
                                {"SQLite format 3", "a database as GeoPackage; export it as GeoJSON"},
                                {"fgb", "a FlatGeobuf file; export it as GeoJSON"},
                                {"PAR1", "a Parquet file; export it as GeoJSON"},
                                {"\0\0\x27\x0A"sv, "a shapefile; export it as GeoJSON"},
                                {"AC10", "a DWG drawing; save it as SVG"},
                                {"\xFF\xFE", "text in UTF-16; save it as UTF-8"},
                                {"\xFE\xFF", "text in UTF-16; save it as UTF-8"},
                                {"poly\n", "Polyanya's polygons; save them as WKT"},
                                {"mesh\n", "Polyanya's mesh; save its polygons as WKT"},
                                {"voxel", "a MovingAI map in three dimensions"},
                                {"  0\nSECTION", "a DXF drawing; save it as SVG"},
                                {"0\nSECTION", "a DXF drawing; save it as SVG"}};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_ground(char c) { return c == '.' || c == '@' || c == '#'; }

// Whether a line is one of a map in letters: of letters and `.@#` alone, with some of the latter.
bool is_row(std::string_view line) {
  return !line.empty() && std::ranges::any_of(line, is_ground) &&
         std::ranges::all_of(line, [](char c) { return is_letter(c) || is_ground(c); });
}

// Rows of one length, without a header.
bool is_bare_grid(std::string_view content) {
  TextScanner scanner(content, "");
  const std::string_view first = scanner.rest_of_line(), second = scanner.rest_of_line();
  return first.size() > 1 && first.size() == second.size() && is_row(first) && is_row(second);
}

// `height,width` or `height width`, some lines of counts, then rows of that width.
bool is_sized_grid(TextScanner scanner) {
  constexpr int kCounts = 4;  // lines of counts: endpoints, robots, steps
  std::string head(scanner.rest_of_line());
  std::ranges::replace(head, ',', ' ');
  const auto sizes = split_at_blanks(head);
  const auto whole = [](std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
  };
  if (sizes.size() != 2 || !whole(sizes[0]) || !whole(sizes[1])) return false;
  for (int i = 0; i <= kCounts; ++i) {
    const std::string_view line = scanner.rest_of_line();
    if (is_row(line)) return static_cast<double>(line.size()) == read_number(sizes[1]);
    if (!whole(line) || line.empty()) return false;
  }
  return false;
}

// A task's line: nine fields, the second one no number.
bool is_bare_scenario(TextScanner scanner) {
  const auto fields = split_at_blanks(scanner.rest_of_line());
  return fields.size() >= 9 && !read_number(fields[1]) && read_number(fields.back());
}

// Whether the numbers are as many as the counts among them say.
bool is_tpcap_case(std::string_view content) {
  constexpr std::size_t kPoses = 6;
  TextScanner scanner(content, "");
  std::vector<double> numbers;
  while (true) {
    scanner.skip_space();
    if (scanner.accept(',')) scanner.skip_space();
    if (scanner.at_end()) break;
    const std::optional<double> number = read_number(scanner.word(","));
    if (!number) return false;
    numbers.push_back(*number);
  }
  if (numbers.size() <= kPoses) return false;
  const auto all = static_cast<double>(numbers.size());
  double expected = static_cast<double>(kPoses + 1) + numbers[kPoses];
  if (!(numbers[kPoses] >= 0.0 && expected <= all)) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(numbers[kPoses]); ++i) expected += 2.0 * numbers[kPoses + 1 + i];
  return expected == all;
}

MapFormat format_of_numbers(const TextScanner& scanner, std::string_view content) {
  if (is_sized_grid(scanner)) return MapFormat::kMovingAiMap;
  if (is_bare_scenario(scanner)) return MapFormat::kMovingAiScenario;
  if (is_tpcap_case(content)) return MapFormat::kTpcap;
  if (is_vertex_list(content)) return MapFormat::kVertexList;
  TextScanner line = scanner;
  std::string first(line.rest_of_line());
  const bool commas = first.find(',') != std::string::npos;
  std::ranges::replace(first, ',', ' ');
  const std::size_t count = split_at_blanks(first).size();
  if (commas && count > 1 && count < 6) return MapFormat::kVertexList;  // whose columns have no names
  return count == 1 || (commas && count % 2 != 0) ? MapFormat::kTpcap : MapFormat::kTextPolygons;
}

// Whether `key: ...` stands at the beginning of a line or of an entry in braces.
bool has_yaml_key(std::string_view content, std::string_view key) {
  content = content.substr(0, kLooked);
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  for (std::size_t at = content.find(key); at != std::string_view::npos; at = content.find(key, at + 1)) {
    std::size_t before = at, after = at + key.size();
    const char quote = before > 0 ? content[before - 1] : '\n';
    if (quote == '"' || quote == '\'') {
      if (after >= content.size() || content[after] != quote) continue;
      --before;
      ++after;
    }
    while (before > 0 && is_blank(content[before - 1])) --before;
    while (after < content.size() && is_blank(content[after])) ++after;
    const char in_front = before > 0 ? content[before - 1] : '\n';
    if (after < content.size() && content[after] == ':' &&
        (in_front == '\n' || in_front == '{' || in_front == ',' || in_front == '\xBF'))
      return true;
  }
  return false;
}

bool is_ros_map(std::string_view content) {
  return has_yaml_key(content, "image") &&
         (has_yaml_key(content, "resolution") || has_yaml_key(content, "origin") || !content.starts_with('{'));
}

void refuse_foreign(std::string_view content, std::string_view name) {
  for (const auto& [magic, what] : kForeign)
    if (content.starts_with(magic))
      throw FormatError(std::string(name) + ": this is " + std::string(what) + "; it is not read as a map");
}

// JSON that is no GeoJSON: of this project, and of others.
void refuse_other_json(std::string_view content, std::string_view name) {
  const std::string_view begin = content.substr(0, 400);
  for (const auto& [mark, what] : {std::pair{"\"Topology\"", "TopoJSON"},
                                   {"\"esriGeometry", "Esri JSON"},
                                   {"\"spatialReference\"", "Esri JSON"},
                                   {"\"osm3s\"", "JSON of OpenStreetMap"}})
    if (begin.find(mark) != std::string_view::npos)
      throw FormatError(std::string(name) + ": this is " + what + "; export it as GeoJSON");
  // Those first that may hold a robot or a plan.
  for (const std::string_view own :
       {"arcway-benchmark", "arcway-scenario", "arcway-plan", "arcway-robot", "arcway-doctor", "arcway-graph"})
    if (begin.find("\"" + std::string(own) + "\"") != std::string_view::npos)
      throw FormatError(std::string(name) + ": this is a file of the format " + std::string(own) + ", not a map");
}

bool is_wkt_keyword(std::string_view word) {
  const std::string type = wkt_type(word);
  for (const std::string_view keyword :
       {"SRID", "POINT", "MULTIPOINT", "LINESTRING", "MULTILINESTRING", "POLYGON", "MULTIPOLYGON", "GEOMETRYCOLLECTION",
        "CURVEPOLYGON", "MULTISURFACE", "TRIANGLE", "TIN", "POLYHEDRALSURFACE", "CIRCULARSTRING", "COMPOUNDCURVE",
        "MULTICURVE"})
    if (type == keyword) return true;
  return false;
}

}  // namespace

const char* name_of(MapFormat format) {
  const auto found = std::ranges::find(kFormats, format, &FormatWord::format);
  return found == std::end(kFormats) ? "?" : found->name;
}

std::span<const std::string_view> format_words() {
  static const std::vector<std::string_view> words = [] {
    std::vector<std::string_view> list;
    for (const FormatWord& format : kFormats) list.push_back(format.word);
    return list;
  }();
  return words;
}

std::optional<MapFormat> format_of_word(std::string_view word) {
  const auto found = std::ranges::find(kFormats, word, &FormatWord::word);
  return found == std::end(kFormats) ? std::nullopt : std::optional(found->format);
}

bool has_polygons(MapFormat format) {
  return format == MapFormat::kGeoJson || format == MapFormat::kWkt || format == MapFormat::kTextPolygons ||
         format == MapFormat::kVertexList || format == MapFormat::kSvg;
}

bool is_guess(MapFormat format) {
  return format == MapFormat::kTextPolygons || format == MapFormat::kVertexList || format == MapFormat::kTpcap ||
         format == MapFormat::kMovingAiMap || format == MapFormat::kMovingAiScenario;
}

MapFormat detect_format(std::string_view content, std::string_view name) {
  if (content.starts_with("P2") || content.starts_with("P5")) return MapFormat::kPgm;
  if (content.starts_with("\x89PNG")) return MapFormat::kPng;
  if (is_prepared_map(content)) return MapFormat::kPrepared;
  refuse_foreign(content, name);
  if (is_bare_grid(content)) return MapFormat::kMovingAiMap;
  TextScanner scanner(content, name);
  if (scanner.peek() == '\x1E') return MapFormat::kGeoJson;
  scanner.skip_space();
  while (scanner.peek() == '#') {
    scanner.rest_of_line();
    scanner.skip_space();
  }
  if (scanner.at_end()) throw FormatError(std::string(name) + ": empty file, expected a map");
  if (scanner.peek() == '<') return MapFormat::kSvg;
  if (scanner.peek() == '{' || scanner.peek() == '[') {
    refuse_other_json(content, name);
    const bool flow = scanner.peek() == '{' && !has_yaml_key(content, "type") && is_ros_map(content);
    return flow ? MapFormat::kRosMap : MapFormat::kGeoJson;
  }
  TextScanner ahead = scanner;
  const std::string_view word = ahead.word("(=;,:0123456789");
  ahead.skip_blanks();
  const bool key = ahead.peek() == ':';
  if (!key && (word == "type" || word == "height" || word == "width")) return MapFormat::kMovingAiMap;
  if (!key && word == "version") return MapFormat::kMovingAiScenario;
  if (has_vertex_header(content)) return MapFormat::kVertexList;  // before WKT, as a column may be "polygon"
  if (!key && is_wkt_keyword(word)) return MapFormat::kWkt;
  if (const char c = scanner.peek(); word != "---" && ((c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.'))
    return format_of_numbers(scanner, content);
  if (is_ros_map(content)) return MapFormat::kRosMap;
  TextScanner first = scanner;
  const std::string begin = "it begins with " + detail::quoted(first.rest_of_line());
  if (key) scanner.fail("this looks like YAML, but has no key \"image\" as a ROS map has; " + begin);
  if (begin.find_first_of(",;\t") != std::string::npos && begin.find('(') == std::string::npos)
    scanner.fail("this looks like a table without columns x and y (or lon and lat), which a list of vertices has; " +
                 begin);
  scanner.fail("this is no map of a known format, " + begin + "; --format NAME reads it as one");
}

}  // namespace arcway
