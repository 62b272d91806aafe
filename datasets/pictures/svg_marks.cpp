// Members of SvgPicture for marks on a map: poses and places with labels, axes, numbers of obstacles, an inset.

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "arcway/datasets/svg.h"
#include "core/base/shortest_text.h"
#include "datasets/io/markup_text.h"
#include "datasets/pictures/svg_style.h"
#include "datasets/pictures/svg_text.h"

namespace arcway {

using namespace internal;
namespace {

constexpr double kMinOutline = 14.0;  // below this the body cannot be made out [px]
constexpr const char* kGapColor = "#d00000";
constexpr const char* kStartColor = "#1b9e5a";
constexpr const char* kGoalColor = "#7b3fc4";
constexpr const char* kPlaceColor = "#0b7285";
constexpr std::size_t kMostNumbers = 2000;  // obstacles that are numbered; more would hide the map
constexpr double kInset = 0.33;             // side of an inset by the map's shorter side
constexpr double kInsetBorder = 44.0;       // between an inset and the map's edge, for the marks of axes [px]

// The largest of 1, 2, 5, 10, 20, ... times a power of ten that is at most this.
double round_step(double at_most) {
  const double power = std::pow(10.0, std::floor(std::log10(at_most)));
  return at_most >= 5.0 * power ? 5.0 * power : at_most >= 2.0 * power ? 2.0 * power : power;
}

}  // namespace

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
  const Vec2 first = (view_.min / step).array().ceil();
  for (int i = 0; (first.x() + i) * step <= view_.max.x(); ++i) {
    const double meters = (first.x() + i) * step, x = to_picture({meters, view_.min.y()}).x();
    if (x > left + kCorner && x < width_ - kCorner) add_tick({x, bottom}, {0.0, -kTick}, meters);
  }
  for (int i = 0; (first.y() + i) * step <= view_.max.y(); ++i) {
    const double meters = (first.y() + i) * step, y = to_picture({view_.min.x(), meters}).y();
    if (y > kCorner && y < bottom - kCorner) add_tick({left, y}, {kTick, 0.0}, meters);
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

}  // namespace arcway
