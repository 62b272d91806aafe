#include "datasets/formats/svg_world.h"

#include <algorithm>
#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/ray_parity.h"
#include "datasets/file_io.h"
#include "datasets/formats/text_scanner.h"
#include "datasets/formats/vector_map.h"
#include "datasets/number_text.h"

namespace arcway {
namespace {

constexpr int kDeepest = 100;                // groups in groups
constexpr double kClosing = 1e-4;            // gap of a closed subpath, by its size
constexpr std::size_t kMostSubpaths = 5000;  // of a path

/// Scales, then moves.
struct Transform {
  Vec2 scale{1.0, 1.0}, shift{0.0, 0.0};
  [[nodiscard]] Vec2 operator()(const Vec2& p) const { return scale.cwiseProduct(p) + shift; }
  /// The inner transform first.
  [[nodiscard]] Transform after(const Transform& inner) const {
    return {scale.cwiseProduct(inner.scale), scale.cwiseProduct(inner.shift) + shift};
  }
};

/// Numbers and words of an attribute, between blanks and commas.
class Attribute {
 public:
  explicit Attribute(std::string_view text) : text_(text) {}
  bool at_end() {
    const std::size_t next = text_.find_first_not_of(" \t\r\n,");
    text_.remove_prefix(std::min(next, text_.size()));
    return text_.empty();
  }
  [[nodiscard]] char peek() const { return text_.front(); }
  char letter() {
    const char c = text_.front();
    text_.remove_prefix(1);
    return c;
  }
  std::optional<double> number() { return at_end() ? std::nullopt : take_number(text_); }
  std::string_view until(char c) {
    const std::size_t end = std::min(text_.find(c), text_.size());
    const std::string_view part = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    return part;
  }

 private:
  std::string_view text_;
};

class Reader {
 public:
  Reader(std::string_view text, std::string_view name) : text_(text), map_(name, {}) {
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
      line_ends_.push_back(static_cast<std::ptrdiff_t>(at));
  }

  MapFile read() {
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer(text_.data(), text_.size());
    if (!result) map_.fail("line " + std::to_string(line_of(result.offset)), result.description());
    const pugi::xml_node root = document.document_element();
    if (local_name(root) != "svg")
      map_.fail("line " + std::to_string(line_of(root.offset_debug())),
                "expected <svg>, found <" + std::string(root.name()) + ">");
    read_bounds(root);
    read_children(root, {.scale = {1.0, -1.0}}, 0);
    if (closed_ > 0)
      map_.map().notes.push_back(std::to_string(closed_) + " outlines closed that ended beside their beginning");
    map_.set_planar();
    return map_.finish();
  }

 private:
  [[nodiscard]] std::size_t line_of(std::ptrdiff_t offset) const {
    const auto after = std::lower_bound(line_ends_.begin(), line_ends_.end(), offset);
    return 1 + static_cast<std::size_t>(after - line_ends_.begin());
  }
  static std::string_view local_name(const pugi::xml_node& node) {
    std::string_view name = node.name();
    if (name.starts_with("svg:")) name.remove_prefix(4);
    return name;
  }
  [[nodiscard]] std::string place_of(const pugi::xml_node& node) const {
    std::string place = "line " + std::to_string(line_of(node.offset_debug())) + ", " + std::string(local_name(node));
    if (const pugi::xml_attribute id = node.attribute("id")) place += " " + detail::quoted(id.value());
    return place;
  }

  void read_bounds(const pugi::xml_node& root) {
    const pugi::xml_attribute attribute = root.attribute("viewBox");
    if (!attribute) return;
    Attribute numbers(attribute.value());
    double v[4];
    for (double& value : v) {
      const std::optional<double> number = numbers.number();
      if (!number) map_.fail("viewBox", "expected four numbers, found " + detail::quoted(attribute.value()));
      value = *number;
    }
    if (!(v[2] > 0.0 && v[3] > 0.0)) map_.fail("viewBox", "expected width and height above 0");
    const double left = v[0], right = v[0] + v[2], bottom = -(v[1] + v[3]), top = -v[1];
    map_.set_bounds({{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, {}}, "viewBox");
  }

  void read_children(const pugi::xml_node& parent, const Transform& transform, int depth) {
    if (depth > kDeepest) map_.fail(place_of(parent), "groups nested more than " + std::to_string(kDeepest) + " deep");
    for (const pugi::xml_node& node : parent.children()) {
      if (node.type() != pugi::node_element) continue;
      const std::string_view name = local_name(node);
      if (name == "g" || name == "a" || name == "svg") {
        read_children(node, transform.after(transform_of(node)), depth + 1);
      } else if (name == "path") {
        read_path(node, transform.after(transform_of(node)));
      } else if (name != "defs" && name != "metadata" && name != "title" && name != "desc" && name != "style" &&
                 name.find(':') == std::string_view::npos) {
        map_.fail(place_of(node), "element <" + std::string(name) + "> is not supported, only paths in groups are");
      }
    }
  }

  [[nodiscard]] Transform transform_of(const pugi::xml_node& node) const {
    const pugi::xml_attribute attribute = node.attribute("transform");
    Transform result;
    if (!attribute) return result;
    Attribute list(attribute.value());
    while (!list.at_end()) {
      std::string_view function = list.until('(');
      while (!function.empty() && function.back() == ' ') function.remove_suffix(1);
      Attribute values(list.until(')'));
      const std::optional<double> x = values.number(), y = values.number();
      const bool translate = function == "translate";
      if ((!translate && function != "scale") || !x || !values.at_end())
        map_.fail(place_of(node), "transform " + detail::quoted(attribute.value()) +
                                      " is not supported, only translate(x, y) and scale(x, y) are");
      result = result.after(translate ? Transform{.shift = {*x, y.value_or(0.0)}}
                                      : Transform{.scale = {*x, y.value_or(*x)}});
    }
    return result;
  }

  void read_path(const pugi::xml_node& node, const Transform& transform) {
    const std::string place = place_of(node);
    Attribute data(node.attribute("d").value());
    std::vector<Ring> subpaths;
    Vec2 at(0.0, 0.0), first(0.0, 0.0);
    char command = 0;
    bool closed = false;
    while (!data.at_end()) {
      const char c = data.peek();
      if ((c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z')) command = data.letter();
      const auto number = [&] {
        const std::optional<double> value = data.number();
        if (!value) map_.fail(place, "expected a number after path command " + detail::quoted({&command, 1}));
        return *value;
      };
      const Vec2 from = command >= 'a' ? at : Vec2(0.0, 0.0);  // lower case is relative
      switch (command) {
        case 'M':
        case 'm':
          at.x() = from.x() + number();
          at.y() = from.y() + number();
          first = at;
          subpaths.push_back({transform(at)});
          closed = false;
          command = command == 'M' ? 'L' : 'l';  // further pairs are lines
          continue;
        case 'L':
        case 'l':
          at.x() = from.x() + number();
          at.y() = from.y() + number();
          break;
        case 'H':
        case 'h':
          at.x() = from.x() + number();
          break;
        case 'V':
        case 'v':
          at.y() = from.y() + number();
          break;
        case 'Z':
        case 'z':
          at = first;
          command = 0;
          closed = true;
          continue;
        case 0:
          map_.fail(place, "expected a path command, found " + detail::quoted({&c, 1}));
        default:
          map_.fail(place, "path command " + detail::quoted({&command, 1}) +
                               " is not supported, only M L H V Z and m l h v z are");
      }
      if (subpaths.empty()) map_.fail(place, "a path begins with M");
      if (std::exchange(closed, false)) subpaths.push_back({transform(first)});
      subpaths.back().push_back(transform(at));
    }
    add_subpaths(std::move(subpaths), place);
  }

  void add_subpaths(std::vector<Ring> subpaths, const std::string& place) {
    if (subpaths.size() > kMostSubpaths)
      map_.fail(place,
                std::to_string(subpaths.size()) + " subpaths; at most " + std::to_string(kMostSubpaths) + " are read");
    std::vector<Ring> rings;
    for (Ring& subpath : subpaths) {
      close(subpath);
      // A third point beside the first and any other.
      const auto other = std::find_if(subpath.begin(), subpath.end(), [&](const Vec2& p) { return p != subpath[0]; });
      if (std::any_of(other, subpath.end(), [&](const Vec2& p) { return p != subpath[0] && p != *other; }))
        rings.push_back(map_.ring(std::move(subpath), /*closed=*/false, place));
    }
    if (rings.size() < subpaths.size()) map_.warn(place, "a subpath without area was passed over");
    std::vector<std::vector<bool>> inside(rings.size(), std::vector<bool>(rings.size(), false));
    std::vector<std::size_t> depth(rings.size(), 0);
    for (std::size_t i = 0; i < rings.size(); ++i) {
      for (std::size_t k = 0; k < rings.size(); ++k) {
        if (i == k || !lies_inside(rings[i], rings[k])) continue;
        inside[i][k] = true;
        ++depth[i];
      }
    }
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if (depth[i] % 2 != 0) continue;
      Polygon polygon{rings[i], {}};
      for (std::size_t k = 0; k < rings.size(); ++k)
        if (inside[k][i] && depth[k] == depth[i] + 1) polygon.holes.push_back(rings[k]);
      map_.add_obstacle(std::move(polygon), place);
    }
  }

  // Relative coordinates add up their rounding: the end is then beside the beginning, and the edge between them may
  // cross others.
  void close(Ring& subpath) {
    Box box;
    for (const Vec2& p : subpath) box.extend(p);
    const double reach = kClosing * (box.max - box.min).maxCoeff();
    bool moved = false;
    while (subpath.size() > 1 && (subpath.back() - subpath.front()).cwiseAbs().maxCoeff() <= reach) {
      moved = moved || subpath.back() != subpath.front();
      subpath.pop_back();
    }
    closed_ += moved ? 1 : 0;
  }

  // Of rings that do not cross.
  static bool lies_inside(const Ring& ring, const Ring& other) {
    Box box;
    for (const Vec2& p : other) box.extend(p);
    if (!box.contains(ring[0])) return false;
    for (const Vec2& p : ring) {
      RayParity parity(p);
      for (std::size_t i = 0, last = other.size() - 1; i < other.size(); last = i++) parity.add(other[last], other[i]);
      if (parity.location() != PointLocation::kBoundary) return parity.location() == PointLocation::kInside;
    }
    return false;
  }

  std::string_view text_;
  std::vector<std::ptrdiff_t> line_ends_;
  std::size_t closed_ = 0;  // outlines whose end was not quite at their beginning
  detail::VectorMapBuilder map_;
};

}  // namespace

MapFile read_svg_world(std::string_view text, std::string_view name) { return Reader(text, name).read(); }

}  // namespace arcway
