#include "datasets/formats/svg_world.h"

#include <algorithm>
#include <optional>
#include <pugixml.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "core/geometry/ray_parity.h"
#include "datasets/formats/svg_path.h"
#include "datasets/formats/svg_style.h"
#include "datasets/formats/text_scanner.h"
#include "datasets/formats/vector_map.h"
#include "datasets/io/number_text.h"
#include "datasets/io/shortened.h"

namespace arcway::internal {
namespace {

constexpr int kDeepest = 100;                // groups in groups
constexpr double kClosing = 1e-4;            // gap of a closed subpath, by its size
constexpr std::size_t kMostSubpaths = 5000;  // subpaths of a path

/// Scales, then moves.
struct Transform {
  Vec2 scale{1.0, 1.0}, shift{0.0, 0.0};
  [[nodiscard]] Vec2 operator()(const Vec2& p) const { return scale.cwiseProduct(p) + shift; }
  /// The inner transform first.
  [[nodiscard]] Transform after(const Transform& inner) const {
    return {scale.cwiseProduct(inner.scale), scale.cwiseProduct(inner.shift) + shift};
  }
};

class SvgReader {
 public:
  SvgReader(std::string_view text, std::string_view name, const VectorOptions& options)
      : text_(text),
        map_(name, {.free_polygons = options.free_polygons, .curve_tolerance = options.curve_tolerance}),
        view_is_bounds_(!options.free_polygons) {
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
                "expected <svg>, found <" + shortened(root.name()) + ">; " + other_kind(local_name(root)));
    style_.emplace(root);
    if (view_is_bounds_) read_bounds(root);
    if (style_->display(root) == detail::SvgStyle::Display::kNone) {
      hidden_ += count_paths(root);
    } else {
      read_children(root, {.scale = {1.0, -1.0}}, style_->visible(root, true), 0);
    }
    report_hidden();
    if (closed_ > 0)
      map_.map().notes.push_back(std::to_string(closed_) + " outlines closed that ended beside their beginning");
    map_.set_planar();
    return map_.finish();
  }

 private:
  // What XML of another kind is.
  static std::string other_kind(std::string_view root) {
    constexpr std::pair<std::string_view, const char*> kKinds[] = {
        {"kml", "a KML document"},         {"FeatureCollection", "a GML document"},
        {"osm", "a map of OpenStreetMap"}, {"additional", "polygons of SUMO"},
        {"net", "a road network of SUMO"}, {"OpenDRIVE", "an OpenDRIVE document"},
        {"html", "a page of HTML"}};
    for (const auto& [name, kind] : kKinds)
      if (root == name) return "this is " + std::string(kind) + ", save its polygons as GeoJSON";
    return "of XML only SVG is read";
  }

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
    std::string place = "line " + std::to_string(line_of(node.offset_debug())) + ", " + shortened(local_name(node));
    if (const pugi::xml_attribute id = node.attribute("id")) place += " " + detail::quoted(id.value());
    return place;
  }

  void read_bounds(const pugi::xml_node& root) {
    const pugi::xml_attribute attribute = root.attribute("viewBox");
    if (!attribute) return;
    detail::SvgAttribute numbers(attribute.value());
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

  void read_children(const pugi::xml_node& parent, const Transform& transform, bool visible, int depth) {
    if (depth > kDeepest) map_.fail(place_of(parent), "groups nested more than " + std::to_string(kDeepest) + " deep");
    for (const pugi::xml_node& node : parent.children()) {
      if (node.type() != pugi::node_element) continue;
      const std::string_view name = local_name(node);
      if (is_never_drawn(name)) continue;
      const bool shown = style_->visible(node, visible);
      if (style_->display(node) == detail::SvgStyle::Display::kNone) {
        hidden_ += count_paths(node);
      } else if (name == "g" || name == "a" || name == "svg") {
        read_children(node, transform.after(transform_of(node)), shown, depth + 1);
      } else if (!shown) {
        ++hidden_;
      } else if (name == "path") {
        read_path(node, transform.after(transform_of(node)));
      } else {
        map_.fail(place_of(node), "element <" + shortened(name) + "> is not supported, only paths in groups are");
      }
    }
  }
  // What is drawn only where something refers to it, and what is no shape.
  static bool is_never_drawn(std::string_view name) {
    for (const std::string_view other : {"defs", "metadata", "title", "desc", "style", "script", "symbol", "clipPath",
                                         "mask", "marker", "pattern", "linearGradient", "radialGradient", "filter"})
      if (name == other) return true;
    return name.find(':') != std::string_view::npos;
  }
  static std::size_t count_paths(const pugi::xml_node& hidden) {
    struct Counter : pugi::xml_tree_walker {
      std::size_t paths = 0;
      bool for_each(pugi::xml_node& node) override {
        paths += local_name(node) == "path" ? 1 : 0;
        return true;
      }
    } counter;
    pugi::xml_node node = hidden;
    node.traverse(counter);
    return counter.paths + (local_name(hidden) == "path" ? 1 : 0);
  }
  void report_hidden() {
    if (hidden_ > 0)
      map_.map().notes.push_back(std::to_string(hidden_) +
                                 (hidden_ == 1 ? " shape that is hidden (display or visibility) is no obstacle"
                                               : " shapes that are hidden (display or visibility) are no obstacles"));
    for (const std::string& selector : style_->unknown_selectors())
      map_.warn("style",
                "selector " + detail::quoted(selector) + " is not understood; what it may hide is kept as an obstacle");
  }

  [[nodiscard]] Transform transform_of(const pugi::xml_node& node) const {
    const pugi::xml_attribute attribute = node.attribute("transform");
    Transform result;
    if (!attribute) return result;
    detail::SvgAttribute list(attribute.value());
    while (!list.at_end()) {
      std::string_view function = list.until('(');
      while (!function.empty() && function.back() == ' ') function.remove_suffix(1);
      detail::SvgAttribute values(list.until(')'));
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
    std::vector<detail::SvgSubpath> subpaths;
    try {
      subpaths = detail::read_svg_path(node.attribute("d").value());
    } catch (const std::invalid_argument& error) {
      map_.fail(place, error.what());
    }
    if (subpaths.size() > kMostSubpaths)
      map_.fail(place,
                std::to_string(subpaths.size()) + " subpaths; at most " + std::to_string(kMostSubpaths) + " are read");
    const std::size_t drawn = subpaths.size();
    std::erase_if(subpaths, [&](detail::SvgSubpath& subpath) {
      for (CubicBezier& piece : subpath.pieces)
        for (Vec2& p : piece.p) p = transform(p);
      close(subpath);
      return !has_area(subpath);
    });
    if (subpaths.size() < drawn) map_.warn(place, "a subpath without area was passed over");
    add_subpaths(subpaths, place);
  }

  // A third point beside the first and any other.
  static bool has_area(const detail::SvgSubpath& subpath) {
    std::vector<Vec2> points;
    for (const CubicBezier& piece : subpath.pieces) points.insert(points.end(), piece.p.begin(), piece.p.end());
    const auto other = std::find_if(points.begin(), points.end(), [&](const Vec2& p) { return p != points[0]; });
    return std::any_of(other, points.end(), [&](const Vec2& p) { return p != points[0] && p != *other; });
  }

  Ring ring(detail::SvgSubpath& subpath, int wanted, const std::string& place) {
    if (subpath.curved) return map_.curved_ring(subpath.pieces, wanted, place);
    Ring points;
    for (const CubicBezier& piece : subpath.pieces) points.push_back(piece.p[0]);
    return map_.ring(std::move(points), /*closed=*/false, place);
  }

  void add_subpaths(std::vector<detail::SvgSubpath>& subpaths, const std::string& place) {
    std::vector<Ring> rings;
    for (detail::SvgSubpath& subpath : subpaths) rings.push_back(ring(subpath, map_.outer_winding(), place));
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
      Polygon polygon{std::move(rings[i]), {}};
      detail::VectorMapBuilder::Curves curves{curve_of(subpaths[i])};
      for (std::size_t k = 0; k < rings.size(); ++k) {
        if (!inside[k][i] || depth[k] != depth[i] + 1) continue;
        polygon.holes.push_back(ring(subpaths[k], -map_.outer_winding(), place));
        curves.push_back(curve_of(subpaths[k]));
      }
      map_.add_polygon(std::move(polygon), place, std::move(curves));
    }
  }

  static std::vector<CubicBezier> curve_of(detail::SvgSubpath& subpath) {
    return subpath.curved ? std::move(subpath.pieces) : std::vector<CubicBezier>{};
  }

  // Leads the last piece to the beginning. Relative coordinates add up their rounding: the end is then beside the
  // beginning, and a line between them may cross others.
  void close(detail::SvgSubpath& subpath) {
    std::vector<CubicBezier>& pieces = subpath.pieces;
    std::erase_if(pieces, [](const CubicBezier& piece) {
      return std::all_of(piece.p.begin(), piece.p.end(), [&](const Vec2& p) { return p == piece.p[0]; });
    });
    if (pieces.empty()) return;
    const Vec2 first = pieces[0].p[0];
    Box box;
    for (const CubicBezier& piece : pieces)
      for (const Vec2& p : piece.p) box.extend(p);
    const double reach = kClosing * (box.max - box.min).maxCoeff();
    const auto is_first = [&](const Vec2& p) { return (p - first).cwiseAbs().maxCoeff() <= reach; };
    // Lines that do not leave the place where the path began.
    while (pieces.size() > 1 && std::all_of(pieces.back().p.begin(), pieces.back().p.end(), is_first))
      pieces.pop_back();
    const Vec2 last = pieces.back().p[3];
    if (last == first) return;
    if (!is_first(last)) return pieces.push_back({{last, last, first, first}});
    CubicBezier& end = pieces.back();
    if (end.p[2] == last) end.p[2] = first;
    end.p[3] = first;
    ++closed_;
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
  std::optional<detail::SvgStyle> style_;
  std::size_t hidden_ = 0;  // shapes
  std::size_t closed_ = 0;  // outlines whose end was not quite at their beginning
  detail::VectorMapBuilder map_;
  bool view_is_bounds_;  // not where what is drawn is free space
};

}  // namespace

MapFile read_svg_world(std::string_view text, std::string_view name, const VectorOptions& options) {
  return SvgReader(text, name, options).read();
}

}  // namespace arcway::internal
