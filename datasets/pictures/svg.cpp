#include "arcway/datasets/svg.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "arcway/zone.h"
#include "core/base/shortest_text.h"
#include "datasets/io/markup_text.h"
#include "datasets/pictures/svg_style.h"
#include "datasets/pictures/svg_text.h"
#include "datasets/pictures/zone_style.h"

namespace arcway {

using namespace internal;
namespace {

constexpr double kLineHeight = 22.0;  // height of a line of a caption [px]
constexpr std::size_t kMostEdges = 50'000;
constexpr double kTallest = 1.5;  // height of a map by its width
constexpr const char* kOutlineColor = "#2b3340";

Box region_of(const World& world) {
  if (!world.box().empty()) return world.box();
  Box box;
  box.extend(Vec2(0.0, 0.0));
  box.extend(Vec2(1.0, 1.0));
  return box;
}

}  // namespace

SvgPicture::SvgPicture(const World& world, double width) : SvgPicture(world, region_of(world), width) {}

SvgPicture::SvgPicture(const World& world, const Box& view, double width) : view_(view) {
  // A view without extent would have no scale.
  const Vec2 extent = (view.max - view.min).cwiseMax(1e-9 * std::max(1.0, (view.max - view.min).maxCoeff()));
  scale_ = width / extent.x();
  if (extent.y() * scale_ > kTallest * width) scale_ = kTallest * width / extent.y();
  width_ = extent.x() * scale_ + 2.0 * kBorder;
  height_ = extent.y() * scale_ + 2.0 * kBorder;
  // Readers compute in floats: far from the origin the map's own coordinates would be too coarse for them.
  const double far = 1024.0 * extent.maxCoeff();
  if (view.min.cwiseAbs().maxCoeff() > far) origin_ = view.min.array().round();
  parts_ = std::pow(10.0, std::clamp(std::ceil(std::log10(10.0 * scale_)), 0.0, 12.0));
  add_map(world);
  add_zones(world);
}

void SvgPicture::append_point(std::string& out, const Vec2& p) const {
  append(out, p.x() - origin_.x(), parts_);
  out += ' ';
  append(out, p.y() - origin_.y(), parts_);
}

std::string SvgPicture::stroke(std::string_view color, double pixels) const {
  char buffer[32];
  const char* end = std::to_chars(buffer, buffer + sizeof buffer, pixels / scale_, std::chars_format::general, 4).ptr;
  return "stroke=\"" + std::string(color) + "\" stroke-width=\"" + std::string(static_cast<const char*>(buffer), end) +
         '"';
}

Vec2 SvgPicture::to_picture(const Vec2& p) const {
  return {kBorder + (p.x() - view_.min.x()) * scale_, kBorder + (view_.max.y() - p.y()) * scale_};
}

void SvgPicture::add_map(const World& world) {
  for (ObstacleId o = 0; o < world.region_count(); ++o) {
    const bool bounds = o == world.obstacle_count();
    if (!bounds && (!world.box_of(o).overlaps(view_) || world.keep_out_of(o) != kNone)) continue;
    std::string& out = bounds ? bounds_ : obstacles_;
    out += "<path d=\"";
    add_rings(out, world.polygon_of(o));
    out += "\"/>\n";
  }
}

void SvgPicture::add_ring(std::string& out, std::span<const Vec2> ring) const {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    out += i == 0 ? 'M' : 'L';
    append_point(out, ring[i]);
  }
  out += 'Z';
}

void SvgPicture::add_rings(std::string& out, const Polygon& polygon) const {
  add_ring(out, polygon.outer);
  for (const Ring& hole : polygon.holes) add_ring(out, hole);
}

void SvgPicture::add_zones(const World& world) {
  std::map<std::string, std::string> legends;  // by role
  for (std::size_t i = 0; i < world.zones().size(); ++i) {
    const Zone& zone = world.zones()[i];
    const std::string role = role_of(zone);
    const std::string color(zone_color(zone));
    // Zones of one role share a pattern, but for arrows: each has a heading of its own.
    const bool shared = !std::holds_alternative<OneWay>(zone.rule);
    const std::string pattern = "hatch-" + role + (shared ? "" : "-" + std::to_string(i));
    if (!shared || !legends.contains(role)) zones_ += zone_pattern(zone, pattern, scale_);
    zones_ += "<path fill=\"url(#" + pattern + ")\" " + stroke(color, 1.2) + " d=\"";
    add_rings(zones_, zone.area);
    zones_ += "\"/>\n";
    std::string& legend = legends[role];
    legend += (legend.empty() ? square(color) + escaped(role) + ": " : ", ") + escaped(legend_text(zone, i));
  }
  for (auto& [role, legend] : legends) zone_legends_.push_back(std::move(legend));
}

std::size_t SvgPicture::add_edges(std::span<const LineSegment> edges, const EdgeStyle& style, std::string_view id) {
  graph_ += open_layer(escaped(id), "fill=\"none\" " + stroke(escaped(style.color), style.width) +
                                        " stroke-opacity=\"" + shortest_text(style.opacity) + "\"") +
            "<path d=\"";
  const std::size_t stride = std::max<std::size_t>(1, (edges.size() + kMostEdges - 1) / kMostEdges);
  for (std::size_t i = 0; i < edges.size(); i += stride) {
    const LineSegment& edge = edges[i];
    graph_ += 'M';
    append_point(graph_, edge.a);
    graph_ += 'L';
    append_point(graph_, edge.b);
  }
  graph_ += "\"/>\n</g>\n";
  return stride;
}

std::span<const std::string_view> SvgPicture::layers() {
  static constexpr std::string_view kLayers[] = {"bounds", "obstacles", "zones",   "graph", "swept",
                                                 "robot",  "path",      "numbers", "axes",  "markers"};
  return kLayers;
}

void SvgPicture::show(std::span<const std::string> layers) {
  for (const std::string& layer : layers)
    if (std::ranges::find(SvgPicture::layers(), layer) == SvgPicture::layers().end())
      throw std::invalid_argument("there is no layer \"" + layer + "\" in a picture");
  const auto hide = [&](std::string_view layer, std::string& content) {
    if (std::ranges::find(layers, layer) == layers.end()) content.clear();
  };
  hide("bounds", bounds_);
  hide("obstacles", obstacles_);
  hide("zones", zones_);
  hide("graph", graph_);
  hide("swept", swept_);
  hide("path", path_);
  hide("path", legend_);
  hide("numbers", numbers_);
  hide("axes", axes_);
  hide("robot", robot_);
  hide("markers", markers_);
}

std::vector<std::string> SvgPicture::wrapped(std::string_view text) const {
  const auto most = static_cast<std::size_t>(std::max(20.0, (width_ - 2.0 * kBorder) / kLetter));
  std::vector<std::string> lines;
  while (text.size() > most) {
    const std::size_t blank = text.rfind(' ', most);
    const std::size_t end = blank == std::string_view::npos || blank == 0 ? most : blank;
    lines.push_back(escaped(text.substr(0, end)));
    text.remove_prefix(end == blank ? end + 1 : end);
  }
  lines.push_back(escaped(text));
  return lines;
}

void SvgPicture::add_caption(std::string_view text) {
  for (std::string& line : wrapped(text)) captions_.push_back(std::move(line));
}

void SvgPicture::set_title(std::string_view title, std::string_view description) {
  title_ = escaped(title);
  description_ = escaped(description);
}

void SvgPicture::append_captions(std::string& out, const std::vector<std::string>& captions) const {
  if (!captions.empty()) {
    out += "<g id=\"caption\" fill=\"#2b3340\">\n";
    for (std::size_t i = 0; i < captions.size(); ++i) {
      out += "<text x=\"";
      append(out, kBorder);
      out += "\" y=\"";
      append(out, height_ + kLineHeight * static_cast<double>(i) + 8.0);
      out += "\">" + captions[i] + "</text>\n";
    }
    out += "</g>\n";
  }
  if (!legend_.empty()) {
    std::string legend = legend_, y;
    append(y, height_ + kLineHeight * static_cast<double>(captions.size()) - 4.0);
    out += legend.replace(legend.find("{y}"), 3, y);
  }
}

std::string SvgPicture::str() const {
  std::vector<std::string> captions = captions_;
  if (!zones_.empty()) captions.insert(captions.end(), zone_legends_.begin(), zone_legends_.end());
  if (backwards_ && !path_.empty())
    captions.push_back(alternatives_ == 0 ? square(kPathColor) + "forwards, " + square(kReverseColor) + "backwards"
                                          : "dashed: backwards");
  const double height = height_ + kLineHeight * (static_cast<double>(captions.size()) + (legend_.empty() ? 0.0 : 1.0));
  std::string w, h;
  append(w, width_);
  append(h, height);
  std::string out =
      R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" viewBox="0 0 )" +
      w + ' ' + h + "\" width=\"" + w + "\" height=\"" + h +
      "\" role=\"img\" font-family=\"'DejaVu Sans',Helvetica,Arial,sans-serif\" font-size=\"14\">\n";
  out += "<title>" + (title_.empty() ? "Map" : title_) + "</title>\n";
  if (!description_.empty()) out += "<desc>" + description_ + "</desc>\n";
  out += R"(<rect width="100%" height="100%" fill="#ffffff"/>)";
  out += '\n';
  // Layers may reach beyond the view, the caption's ground may not be drawn on.
  std::string map_w, map_h, border;
  append(map_w, width_ - kBorder);
  append(map_h, height_ - kBorder);
  append(border, 0.5 * kBorder);
  const std::string area = "x=\"" + border + "\" y=\"" + border + "\" width=\"" + map_w + "\" height=\"" + map_h + '"';
  out += "<clipPath id=\"view\"><rect " + area + "/></clipPath>\n<g clip-path=\"url(#view)\">\n";
  // Beyond the bounds nothing is free.
  out += "<rect " + area + " fill=\"" + (bounds_.empty() ? kFreeColor : kOutsideColor) + "\"/>\n";
  // Meters, y up.
  const Vec2 corner = to_picture(origin_);
  const std::string scale = shortest_text(scale_);
  out += "<g id=\"map\" transform=\"matrix(" + scale + " 0 0 -" + scale + ' ' + shortest_text(corner.x()) + ' ' +
         shortest_text(corner.y()) + ")\">\n";
  const auto add_layer = [&](const char* id, const std::string& attributes, const std::string& content) {
    if (!content.empty()) out += open_layer(id, attributes) + content + "</g>\n";
  };
  const std::string fill = "fill=\"", joined = " stroke-linejoin=\"round\"";
  add_layer("bounds", fill + kFreeColor + "\" " + stroke(kOutlineColor, 2.0) + joined, bounds_);
  add_layer("obstacles", "fill-rule=\"evenodd\" fill=\"#3d4757\" " + stroke(kOutlineColor, 0.8) + joined, obstacles_);
  add_layer("zones", "fill-rule=\"evenodd\"" + joined, zones_);
  out += graph_;
  add_layer("swept", R"(fill="#f6d9a8" fill-opacity="0.6" stroke="none")", swept_);
  add_layer("robot", "fill=\"#f6b26b\" fill-opacity=\"0.45\" " + stroke("#a8441c", 0.8), robot_);
  add_layer("path", R"(fill="none" stroke-linejoin="round" stroke-linecap="round")", path_);
  out += "</g>\n";
  add_layer("numbers", R"(font-size="11" text-anchor="middle" fill="#2b3340")" + std::string(kHalo), numbers_);
  // Marks are dark, their texts have a light edge.
  add_layer("axes", R"(font-size="11" fill="#2b3340")", axes_);
  add_layer("markers", R"(font-weight="bold")", markers_);
  append_inset(out);
  out += "</g>\n";
  append_captions(out, captions);
  out += "</svg>\n";
  return out;
}

}  // namespace arcway
