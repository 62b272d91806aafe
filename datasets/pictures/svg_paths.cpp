// Members of SvgPicture for paths, the bodies that drive them, what these sweep, and speeds.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/svg.h"
#include "core/base/shortest_text.h"
#include "core/geometry/convex_prism.h"
#include "datasets/io/markup_text.h"
#include "datasets/pictures/svg_style.h"
#include "datasets/pictures/svg_text.h"
#include "datasets/pictures/viridis.h"

namespace arcway {

using namespace internal;
namespace {

// Colors of Okabe and Ito's palette that stand out from paths and from white.
constexpr std::string_view kAlternativeColors[] = {"#0072b2", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"};
constexpr double kSpeedColors = 40.0;  // steps of color from rest to the highest speed
constexpr double kDriven = 10.0;       // between points of a path that are counted in corners [px]

// Marks what is driven backwards, at so many pixels a meter.
std::string dashes(double scale) {
  return " stroke-dasharray=\"" + shortest_text(7.0 / scale) + ' ' + shortest_text(4.0 / scale) + '"';
}

// The pose after so many of equal steps along a segment.
Pose pose_along(const PathSegment& segment, int step, int steps) {
  return segment.at(segment.length * (static_cast<double>(step) / static_cast<double>(steps)));
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

void SvgPicture::add_run(std::span<const PathSegment> run, bool bodies, const Colors& colors) {
  std::string line = "M";
  append_point(line, run.front().start.position());
  for (const PathSegment& segment : run) {
    // By chords: the arc of an SVG path is ambiguous at half a turn and jumps when its ends are rounded.
    const double turn = std::abs(segment.length * segment.curvature);
    const double pixels = segment.is_line() ? 0.0 : scale_ / std::abs(segment.curvature);
    // A chord leaves its arc by radius * angle^2 / 8: at most 0.05 px.
    const auto steps = static_cast<int>(std::clamp(std::ceil(turn * std::sqrt(pixels / 0.4)), 1.0, 1000.0));
    for (int i = 1; i <= steps; ++i) {
      line += 'L';
      append_point(line, pose_along(segment, i, steps).position());
    }
  }
  // Bodies that can be seen lie above a thin line; a light edge sets off the line where they cannot.
  if (!bodies) path_ += "<path d=\"" + line + "\" " + stroke("#ffffff", 5.0) + " stroke-opacity=\"0.85\"/>\n";
  const bool forward = run.front().gear == Gear::kForward;
  backwards_ = backwards_ || !forward;
  path_ += "<path d=\"" + line + "\" " + stroke(forward ? colors.forward : colors.reverse, bodies ? 1.8 : 2.6);
  if (!forward) path_ += dashes(scale_);
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
    const auto steps = static_cast<int>(std::clamp(std::ceil(turn * reach * scale_), 1.0, 2000.0));
    for (int i = 0; i <= steps; ++i) add_outline(swept_, pose_along(segment, i, steps), body, 0.0);
  }
  swept_ += "\"/>\n";
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
    if (gear == Gear::kReverse) path_ += dashes(scale_);
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

}  // namespace arcway
