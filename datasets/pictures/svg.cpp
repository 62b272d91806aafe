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

#include "arcway/angle.h"
#include "arcway/zone.h"
#include "core/geometry/convex_prism.h"
#include "core/model/pose_text.h"
#include "datasets/io/markup_text.h"
#include "datasets/pictures/svg_text.h"
#include "datasets/pictures/viridis.h"
#include "datasets/pictures/zone_style.h"

namespace arcway {

using namespace internal;
namespace {

constexpr double kBorder = 16.0;      // around the map [px]
constexpr double kLineHeight = 22.0;  // height of a line of a caption [px]
constexpr std::size_t kMostEdges = 50'000;
constexpr double kMinOutline = 14.0;  // below this the body cannot be made out [px]
constexpr double kTallest = 1.5;      // height of a map by its width
constexpr const char* kOutlineColor = "#2b3340";
constexpr const char* kFreeColor = "#fbfcfe";
constexpr const char* kOutsideColor = "#aeb7c4";
constexpr const char* kPathColor = "#e4572e";
constexpr const char* kReverseColor = "#1f6fd1";
// Colors of Okabe and Ito's palette that stand out from paths and from white.
constexpr std::string_view kAlternativeColors[] = {"#0072b2", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"};
constexpr const char* kGapColor = "#d00000";
constexpr const char* kStartColor = "#1b9e5a";
constexpr const char* kGoalColor = "#7b3fc4";
constexpr const char* kPlaceColor = "#0b7285";

constexpr std::string_view kHalo = R"( stroke="#ffffff" stroke-width="3" paint-order="stroke")";
constexpr double kLetter = 8.6;             // width of a bold letter, on the safe side [px]
constexpr std::size_t kMostNumbers = 2000;  // obstacles that are numbered; more would hide the map
constexpr double kSpeedColors = 40.0;       // steps of color from rest to the highest speed
constexpr double kDriven = 10.0;            // between points of a path that are counted in corners [px]
constexpr double kInset = 0.33;             // side of an inset by the map's shorter side
constexpr double kInsetBorder = 44.0;       // between an inset and the map's edge, for the marks of axes [px]
// The largest of 1, 2, 5, 10, 20, ... times a power of ten that is at most this.
double round_step(double at_most) {
  const double power = std::pow(10.0, std::floor(std::log10(at_most)));
  return at_most >= 5.0 * power ? 5.0 * power : at_most >= 2.0 * power ? 2.0 * power : power;
}

Box region_of(const World& world) {
  if (!world.box().empty()) return world.box();
  Box box;
  box.extend(Vec2(0.0, 0.0));
  box.extend(Vec2(1.0, 1.0));
  return box;
}

// What a convex polygon sweeps on its way along +x.
std::vector<Vec2> driven_ahead(const Ring& piece, double length) {
  std::vector<Vec2> to, prism;
  std::vector<signed char> ahead;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const double rise = piece[(i + 1) % piece.size()].y() - piece[i].y();
    ahead.push_back(static_cast<signed char>((rise > 0.0) - (rise < 0.0)));
    to.push_back(piece[i] + Vec2(length, 0.0));
  }
  convex_prism(piece, to, ahead, prism);
  return prism;
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

void SvgPicture::add_run(std::span<const PathSegment> run, bool bodies, const Colors& colors) {
  std::string line = "M";
  append_point(line, run.front().start.position());
  for (const PathSegment& segment : run) {
    // By chords: the arc of an SVG path is ambiguous at half a turn and jumps when its ends are rounded.
    const double turn = std::abs(segment.length * segment.curvature);
    const double pixels = segment.is_line() ? 0.0 : scale_ / std::abs(segment.curvature);
    // A chord leaves its arc by radius * angle^2 / 8: at most 0.05 px.
    const double steps = std::clamp(std::ceil(turn * std::sqrt(pixels / 0.4)), 1.0, 1000.0);
    for (double i = 1.0; i <= steps; ++i) {
      line += 'L';
      append_point(line, segment.at(segment.length * (i / steps)).position());
    }
  }
  // Bodies that can be seen lie above a thin line; a light edge sets off the line where they cannot.
  if (!bodies) path_ += "<path d=\"" + line + "\" " + stroke("#ffffff", 5.0) + " stroke-opacity=\"0.85\"/>\n";
  const bool forward = run.front().gear == Gear::kForward;
  backwards_ = backwards_ || !forward;
  path_ += "<path d=\"" + line + "\" " + stroke(forward ? colors.forward : colors.reverse, bodies ? 1.8 : 2.6);
  if (!forward) path_ += " stroke-dasharray=\"" + shortest_text(7.0 / scale_) + ' ' + shortest_text(4.0 / scale_) + '"';
  path_ += "/>\n";
}

void SvgPicture::add_line(std::span<const PathSegment> path, const Body& body, const Colors& colors) {
  for (std::size_t first = 0; first < path.size();) {
    std::size_t last = first + 1;
    while (last < path.size() && path[last].gear == path[first].gear) ++last;
    add_run(path.subspan(first, last - first), body.width() * scale_ >= 5.0, colors);
    first = last;
  }
}

void SvgPicture::add_alternative(std::span<const PathSegment> path, const Body& body, std::string_view text) {
  const std::string_view color = kAlternativeColors[alternatives_++ % std::size(kAlternativeColors)];
  add_line(path, body, {color, color});
  captions_.push_back(square(color) + escaped(text));
}

void SvgPicture::add_path(std::span<const PathSegment> path, const Body& body, std::string_view text) {
  if (path.empty()) return;
  const bool alone = alternatives_ == 0;
  add_line(path, body, {kPathColor, alone ? kReverseColor : kPathColor});
  for (const Vec2& p : polyline(path, kDriven / scale_)) driven_.push_back(to_picture(p));
  if (!text.empty()) captions_.insert(captions_.begin(), (alone ? "" : square(kPathColor)) + escaped(text));
  const double spacing = std::max(2.0 * body.length(), 40.0 / scale_);
  std::vector<Pose> poses{path.front().start};
  double next = spacing;  // from the segment's start to the next outline
  std::size_t left = 20000;
  Gear gear = path.front().gear;
  for (const PathSegment& segment : path) {
    if (segment.gear != gear && left > 0) {
      --left;
      poses.push_back(segment.start);
      add_dot(to_picture(segment.start.position()), kReverseColor, 3.0);
    }
    gear = segment.gear;
    for (; next < segment.length && left > 0; next += spacing, --left) poses.push_back(segment.at(next));
    next -= segment.length;
  }
  poses.push_back(path.back().end());
  add_bodies(poses, body);
  add_poses(path.front().start, path.back().end(), body);
}

void SvgPicture::add_bodies(std::span<const Pose> poses, const Body& body) {
  robot_ += "<path d=\"";
  for (const Pose& pose : poses) add_outline(robot_, pose, body, 0.0);
  robot_ += "\"/>\n";
}

void SvgPicture::add_outline(std::string& out, const Pose& pose, const Body& body, double ahead) const {
  const Vec2 u = direction_of(pose.heading), n = perpendicular(u);
  const auto append_ring = [&](std::span<const Vec2> ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      out += i == 0 ? 'M' : 'L';
      append_point(out, pose.position() + ring[i].x() * u + ring[i].y() * n);
    }
    out += 'Z';
  };
  if (body.shape == nullptr) {
    append_ring(Box{{-body.rear, -body.right}, {body.front + ahead, body.left}}.corners());
  } else if (ahead == 0.0) {
    for (const Ring& ring : body.shape->outline) append_ring(ring);
  } else {
    for (const Ring& piece : body.shape->pieces) append_ring(driven_ahead(piece, ahead));
  }
}

void SvgPicture::add_swept_area(std::span<const PathSegment> path, const Body& body) {
  swept_ += "<path d=\"";
  for (const PathSegment& segment : path) {
    if (segment.is_line()) {
      add_outline(swept_, segment.forwards().start, body, segment.length);
      continue;
    }
    // Outlines a pixel apart at the farthest corner: the notches between them are at most half of that deep.
    const double radius = 1.0 / std::abs(segment.curvature);
    const double reach = swept_annulus(body, segment.curvature > 0.0 ? Side::kLeft : Side::kRight, radius).outer;
    const double turn = segment.length / radius;
    const double steps = std::clamp(std::ceil(turn * reach * scale_), 1.0, 2000.0);
    for (double i = 0.0; i <= steps; ++i) add_outline(swept_, segment.at(segment.length * (i / steps)), body, 0.0);
  }
  swept_ += "\"/>\n";
}

void SvgPicture::add_poses(const Pose& start, const Pose& goal, const Body& body) {
  add_marker(start, body, kStartColor, "start");
  add_marker(goal, body, kGoalColor, "goal");
}

void SvgPicture::add_gap(const Vec2& a, const Vec2& b, std::string_view text) {
  const Vec2 p = to_picture(a), q = to_picture(b);
  for (const auto& [color, width] : {std::pair("#ffffff", "7"), std::pair(kGapColor, "3.5")}) {
    markers_ += "<path d=\"M";
    append(markers_, p);
    markers_ += 'L';
    append(markers_, q);
    markers_ += "\" stroke=\"" + std::string(color) + "\" stroke-width=\"" + width + "\" stroke-linecap=\"round\"/>\n";
  }
  const Vec2 middle = 0.5 * (p + q);
  markers_ += "<circle cx=\"";
  append(markers_, middle.x());
  markers_ += "\" cy=\"";
  append(markers_, middle.y());
  markers_ += "\" r=\"12\" fill=\"none\" stroke=\"" + std::string(kGapColor) + "\" stroke-width=\"1.5\"/>\n";
  add_label(middle + Vec2(0.0, -8.0), kGapColor, text);
}

void SvgPicture::add_label(const Vec2& beside, std::string_view color, std::string_view text) {
  // On the side that has the room, and as far in as it takes.
  const double room = kLetter * static_cast<double>(text.size());
  const bool right = beside.x() + 12.0 + room < width_ || beside.x() < 0.5 * width_;
  markers_ += "<text x=\"";
  append(markers_, right ? std::max(0.0, std::min(beside.x() + 12.0, width_ - room))
                         : std::min(width_, std::max(beside.x() - 12.0, room)));
  markers_ += "\" y=\"";
  append(markers_, std::clamp(beside.y(), 16.0, height_ - 6.0));
  markers_ += right ? "\"" : "\" text-anchor=\"end\"";
  markers_ += " fill=\"" + std::string(color) + R"(" stroke="#ffffff" stroke-width="3" paint-order="stroke">)";
  markers_ += escaped(text) + "</text>\n";
}

void SvgPicture::add_speeds(const Trajectory& trajectory) {
  double top = 0.0;
  const std::vector<TrajectoryState> states =
      trajectory.sample({.max_length = std::max(1.0 / scale_, trajectory.length() / 20'000.0), .max_angle = kTwoPi});
  for (const TrajectoryState& state : states) top = std::max(top, state.speed);
  if (!(top > 0.0)) return;
  path_.clear();
  backwards_ = false;  // the legend of speeds takes the place of that of gears
  const auto step_of = [&](std::size_t i) {
    return std::round(0.5 * (states[i - 1].speed + states[i].speed) / top * kSpeedColors);
  };
  for (std::size_t i = 1; i < states.size();) {
    const double step = step_of(i);
    const Gear gear = states[i - 1].gear;
    path_ += "<path d=\"M";
    append_point(path_, states[i - 1].pose.position());
    for (; i < states.size() && step_of(i) == step && states[i - 1].gear == gear; ++i) {
      path_ += 'L';
      append_point(path_, states[i].pose.position());
    }
    path_ += "\" " + stroke(viridis(step / kSpeedColors), 3.0);
    if (gear == Gear::kReverse)
      path_ += " stroke-dasharray=\"" + shortest_text(7.0 / scale_) + ' ' + shortest_text(4.0 / scale_) + '"';
    path_ += "/>\n";
  }
  legend_ = "<linearGradient id=\"speeds\">";
  for (std::size_t i = 0; i < kViridisSteps; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kViridisSteps - 1);
    legend_ += "<stop offset=\"" + shortest_text(share) + "\" stop-color=\"" + viridis(share) + "\"/>";
  }
  legend_ += "</linearGradient>\n<g id=\"legend\" fill=\"#2b3340\" transform=\"translate(" + shortest_text(kBorder) +
             " {y})\"><text y=\"12\">0</text><rect x=\"16\" width=\"160\" height=\"14\" fill=\"url(#speeds)\"/>"
             "<text x=\"184\" y=\"12\">" +
             rounded_text(top) + " m/s</text></g>\n";
}

void SvgPicture::add_tick(const Vec2& at, const Vec2& line, double meters) {
  axes_ += "<path stroke=\"#2b3340\" d=\"M";
  append(axes_, at);
  axes_ += 'L';
  append(axes_, at + line);
  axes_ += "\"/><text" + std::string(kHalo) + " x=\"";
  const bool is_below = line.x() == 0.0;
  append(axes_, at.x() + (is_below ? 0.0 : line.x() + 3.0));
  axes_ += "\" y=\"";
  append(axes_, at.y() + (is_below ? line.y() - 3.0 : 4.0));
  axes_ += std::string("\"") + (is_below ? " text-anchor=\"middle\"" : "") + ">" + rounded_text(meters) + "</text>\n";
}

void SvgPicture::add_axes() {
  constexpr double kTick = 6.0, kSpace = 110.0, kLongestBar = 160.0;  // [px]
  constexpr double kCorner = 48.0;                                    // kept free of marks [px]
  const double step = round_step(kSpace / scale_);
  const double left = 0.5 * kBorder, bottom = height_ - 0.5 * kBorder;
  for (double i = std::ceil(view_.min.x() / step); i * step <= view_.max.x(); ++i) {
    const double x = to_picture({i * step, view_.min.y()}).x();
    if (x > left + kCorner && x < width_ - kCorner) add_tick({x, bottom}, {0.0, -kTick}, i * step);
  }
  for (double i = std::ceil(view_.min.y() / step); i * step <= view_.max.y(); ++i) {
    const double y = to_picture({view_.min.x(), i * step}).y();
    if (y > kCorner && y < bottom - kCorner) add_tick({left, y}, {kTick, 0.0}, i * step);
  }
  const double bar = round_step(std::min(kLongestBar, 0.4 * width_) / scale_), pixels = bar * scale_;
  const Vec2 end(width_ - kBorder - 4.0, bottom - 30.0), begin = end - Vec2(pixels, 0.0);
  axes_ += "<path id=\"scale\" stroke=\"#2b3340\" stroke-width=\"3\" d=\"M";
  append(axes_, begin);
  axes_ += 'L';
  append(axes_, end);
  axes_ += "\"/><text" + std::string(kHalo) + " text-anchor=\"middle\" x=\"";
  append(axes_, 0.5 * (begin.x() + end.x()));
  axes_ += "\" y=\"";
  append(axes_, end.y() - 6.0);
  axes_ += "\">" + rounded_text(bar) + " m</text>\n";
}

void SvgPicture::add_obstacle_numbers(const World& world) {
  if (world.obstacle_count() > kMostNumbers) return;
  for (ObstacleId o = 0; o < world.obstacle_count(); ++o) {
    const Box& box = world.box_of(o);
    if (!box.overlaps(view_) || world.keep_out_of(o) != kNone) continue;
    const Vec2 middle = to_picture(view_.closest_point(0.5 * (box.min + box.max)));
    numbers_ += "<text x=\"";
    append(numbers_, std::clamp(middle.x(), 20.0, width_ - 20.0));
    numbers_ += "\" y=\"";
    append(numbers_, std::clamp(middle.y() + 4.0, 16.0, height_ - 6.0));
    numbers_ += "\">" + std::to_string(o) + "</text>\n";
  }
}

void SvgPicture::add_place(const Vec2& place, std::string_view text) {
  const Vec2 p = to_picture(place);
  add_dot(p, kPlaceColor, 6.0);
  add_label(p + Vec2(0.0, -10.0), kPlaceColor, text);
}

void SvgPicture::add_dot(const Vec2& at, std::string_view color, double radius) {
  markers_ += "<circle cx=\"";
  append(markers_, at.x());
  markers_ += "\" cy=\"";
  append(markers_, at.y());
  markers_ += "\" r=\"" + shortest_text(radius) + "\" fill=\"" + std::string(color) +
              R"(" stroke="#ffffff" stroke-width="1.5"/>)" + "\n";
}

void SvgPicture::add_marker(const Pose& pose, const Body& body, std::string_view color, std::string_view label) {
  const Vec2 p = to_picture(pose.position());
  // Picture coordinates: y down.
  const Vec2 u(std::cos(pose.heading), -std::sin(pose.heading)), n(-u.y(), u.x());
  const double size = std::clamp(body.front * scale_, kMinOutline, 40.0);
  add_dot(p, color, 6.0);
  markers_ += "<path d=\"M";
  append(markers_, p + u * (size + 8.0));
  markers_ += 'L';
  append(markers_, p + u * size * 0.6 + n * 5.0);
  markers_ += 'L';
  append(markers_, p + u * size * 0.6 - n * 5.0);
  markers_ += "Z\" fill=\"" + std::string(color) + R"(" stroke="#ffffff" stroke-width="1"/>)" + "\n";
  // Below where the arrow points up, and would lie under the label.
  add_label(p + Vec2(0.0, u.y() < 0.0 ? 18.0 : -10.0), color, label);
}

void SvgPicture::add_inset(const Vec2& place, double side, std::string_view text) {
  inset_ = Inset{place, side, escaped(text)};
}

Vec2 SvgPicture::corner_for_inset(double size) const {
  const double right = width_ - kInsetBorder - size, bottom = height_ - kInsetBorder - size;
  Vec2 best(kInsetBorder, kInsetBorder);
  std::size_t least = driven_.size() + 1;
  for (const Vec2& corner :
       {Vec2(kInsetBorder, kInsetBorder), Vec2(right, kInsetBorder), Vec2(kInsetBorder, bottom), Vec2(right, bottom)}) {
    const Box box{corner, corner + Vec2(size, size)};
    const auto covered =
        static_cast<std::size_t>(std::ranges::count_if(driven_, [&](const Vec2& p) { return box.contains(p); }));
    if (covered < least) best = corner;
    least = std::min(least, covered);
  }
  return best;
}

void SvgPicture::append_inset(std::string& out) const {
  if (!inset_) return;
  const double size = kInset * std::min(width_, height_), shown = inset_->side * scale_;
  const Vec2 corner = corner_for_inset(size), from = to_picture(inset_->place) - Vec2(0.5 * shown, 0.5 * shown);
  const auto square_at = [](const Vec2& at, double side, double parts) {
    std::string x, y, s;
    append(x, at.x(), parts);
    append(y, at.y(), parts);
    append(s, side, parts);
    return "x=\"" + x + "\" y=\"" + y + "\" width=\"" + s + "\" height=\"" + s + "\"";
  };
  std::string view;
  for (const double number : {from.x(), from.y(), shown, shown}) {
    if (!view.empty()) view += ' ';
    append(view, number, 1000.0);
  }
  out += "<g id=\"inset\">\n<rect " + square_at(from, shown, 10.0) +
         " fill=\"none\" stroke=\"#2b3340\" stroke-dasharray=\"4 3\"/>\n";
  out += "<svg " + square_at(corner, size, 10.0) + " viewBox=\"" + view + "\">\n<rect " +
         square_at(from, shown, 1000.0) + " fill=\"" + (bounds_.empty() ? kFreeColor : kOutsideColor) +
         "\"/>\n<use href=\"#map\"/>\n</svg>\n";
  out += "<rect " + square_at(corner, size, 10.0) + " fill=\"none\" stroke=\"#2b3340\" stroke-width=\"1.5\"/>\n";
  out += "<text" + std::string(kHalo) + " font-size=\"12\" fill=\"#2b3340\" x=\"";
  append(out, corner.x());
  out += "\" y=\"";
  append(out, corner.y() - 6.0);
  out += "\">" + inset_->text + "</text>\n</g>\n";
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
