#include "core/motion/reeds_shepp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "arcway/angle.h"
#include "core/base/infinity.h"

namespace arcway::internal {
namespace {

constexpr double kWordRounding = 64.0 * std::numeric_limits<double>::epsilon();
constexpr double kMostRounding =
    1e-9;  // of the direction of a line between circles to either side: the end moves by that
constexpr double kQuarter = 0.5 * kPi;

/// Signed lengths of the letters, backwards negative; arcs as angles.
using SignedParts = std::optional<std::array<double, 5>>;

/// An angle as a turn within [0, pi]; nothing if it is none. Rounding may have put it on the other side of either end.
/// @param rounding  at 0.
std::optional<double> ahead(double angle, double rounding = kWordRounding) {
  const double turn = wrap_signed(angle);
  if (turn >= 0.0) return turn;
  if (turn >= -rounding) return 0.0;
  if (turn <= -kPi + kWordRounding) return kPi;
  return std::nullopt;
}
/// The rounding of a line's direction, which the shorter it is the less is known of: up to `most`.
double rounding_of_line(double length, double most) {
  return kWordRounding / std::clamp(length, kWordRounding / most, 1.0);
}
/// The angle within [-pi, 0], if it is there.
std::optional<double> back(double angle) {
  const auto turn = ahead(-angle);
  return turn ? std::optional(-*turn) : std::nullopt;
}

SignedParts parts_of(std::optional<double> first, double second, double third, double fourth,
                     std::optional<double> last) {
  if (!first || !last) return std::nullopt;
  return std::array{*first, second, third, fourth, *last};
}

// Rounding of lengths, in radii: what is longer than another length by less than this may also be shorter.
constexpr double kLengthSlack = 1e-8;

/// The least sum of two turns, each within [0, pi], that make an angle together.
double least_sum(double angle) {
  const double turn = wrap_signed(angle);
  return turn < -kLengthSlack ? turn + kTwoPi : std::abs(turn);
}
/// The least sum of two turns, each within [0, pi], whose difference is an angle.
double least_apart(double angle) { return std::abs(wrap_signed(angle)); }

using Target = ReedsSheppTarget;

double angle_of(const Vec2& v) { return std::atan2(v.y(), v.x()); }

/// (8.1). Where an arc vanishes up to rounding, the other one makes the whole turn; so in (8.2).
SignedParts left_straight_left(const Target& g, double most) {
  const double u = g.left_distance();
  if (u + least_sum(g.heading()) > most) return std::nullopt;
  if (g.to_left().isZero(kWordRounding)) return parts_of(0.0, u, 0.0, 0.0, ahead(g.heading()));
  const double rounding = rounding_of_line(u, 1.0);
  const auto first = ahead(g.left_direction(), rounding);
  if (!first || *first == 0.0) return parts_of(first, u, 0.0, 0.0, ahead(g.heading()));
  const auto last = ahead(g.heading() - *first, rounding);
  return last == 0.0 ? parts_of(ahead(g.heading()), u, 0.0, 0.0, 0.0) : parts_of(first, u, 0.0, 0.0, last);
}

/// (8.2)
SignedParts left_straight_right(const Target& g, double most) {
  const Vec2& c = g.to_right();
  const double square = c.squaredNorm() - 4.0;
  if (square < -kWordRounding) return std::nullopt;
  const double u = std::sqrt(std::max(0.0, square));
  if (u + std::abs(g.heading()) > most) return std::nullopt;
  const double rounding = rounding_of_line(u, kMostRounding);
  const auto first = ahead(angle_of(c) + std::atan2(2.0, u), rounding);
  if (!first || *first == 0.0) return parts_of(first, u, 0.0, 0.0, ahead(-g.heading()));
  const auto last = ahead(*first - g.heading(), rounding);
  return last == 0.0 ? parts_of(ahead(g.heading()), u, 0.0, 0.0, 0.0) : parts_of(first, u, 0.0, 0.0, last);
}

/// (8.3), (8.4): the last arc forwards or backwards.
SignedParts left_right_left(const Target& g, bool last_ahead, double most) {
  const double distance = g.left_distance();
  if (distance > 4.0 * (1.0 + kWordRounding) || 0.5 * distance > most) return std::nullopt;
  const double u = g.left_bend();
  const double bend = g.heading() + u;
  if ((last_ahead ? least_sum(bend) : least_apart(bend)) - u > most) return std::nullopt;
  const auto first = ahead(g.left_direction() + 0.5 * u + kPi);
  if (!first) return std::nullopt;
  const double last = g.heading() - *first + u;
  return parts_of(first, u, 0.0, 0.0, last_ahead ? ahead(last) : back(last));
}

/// First and last angle of the words of four arcs, the middle ones being u and v.
std::array<double, 2> outer_arcs(double u, double v, const Vec2& c, double heading) {
  const double delta = u - v;
  const double a = std::sin(u) - std::sin(delta);
  const double b = std::cos(u) - std::cos(delta) - 1.0;
  const double t = std::atan2(c.y() * a - c.x() * b, c.x() * a + c.y() * b);
  const bool turned = 2.0 * (std::cos(delta) - std::cos(v) - std::cos(u)) + 3.0 < 0.0;
  const double first = turned ? t + kPi : t;
  return {first, first - u + v - heading};
}

/// (8.7)
SignedParts left_right_cusp_left_right(const Target& g, double most) {
  const Vec2& c = g.to_right();
  const double rho = 0.25 * (2.0 + c.norm());
  if (rho > 1.0 + kWordRounding) return std::nullopt;
  const double u = std::acos(std::min(1.0, rho));
  if (2.0 * u + least_sum(g.heading() + 2.0 * u) > most) return std::nullopt;
  const auto [first, last] = outer_arcs(u, -u, c, g.heading());
  return parts_of(ahead(first), u, -u, 0.0, back(last));
}

/// (8.8)
SignedParts left_cusp_right_left_cusp_right(const Target& g, double most) {
  const Vec2& c = g.to_right();
  const double rho = (20.0 - c.squaredNorm()) / 16.0;
  if (rho < -kWordRounding || rho > 1.0 + kWordRounding) return std::nullopt;
  const double u = -std::acos(std::clamp(rho, 0.0, 1.0));
  if (std::abs(g.heading()) - 2.0 * u > most) return std::nullopt;
  const auto [first, last] = outer_arcs(u, u, c, g.heading());
  return parts_of(ahead(first), u, u, 0.0, ahead(last));
}

/// (8.9), the last arc to the left
SignedParts left_right_straight_left(const Target& g, double most) {
  const double square = g.to_left().squaredNorm() - 4.0;
  if (square < -kWordRounding) return std::nullopt;
  const double r = std::sqrt(std::max(0.0, square));
  if (2.0 - r > kWordRounding || kQuarter + r - 2.0 + least_apart(g.heading() - kQuarter) > most) return std::nullopt;
  const auto first = ahead(g.left_direction() + std::atan2(r, -2.0));
  return first ? parts_of(first, -kQuarter, std::min(0.0, 2.0 - r), 0.0, back(g.heading() - kQuarter - *first))
               : std::nullopt;
}

/// (8.10), the last arc to the right
SignedParts left_right_straight_right(const Target& g, double most) {
  const Vec2& c = g.to_right();
  const double rho = c.norm();
  if (rho < 2.0 - kWordRounding || kQuarter + rho - 2.0 + least_sum(g.heading() - kQuarter) > most) return std::nullopt;
  const auto first = ahead(std::atan2(c.x(), -c.y()));
  return first ? parts_of(first, -kQuarter, std::min(0.0, 2.0 - rho), 0.0, back(*first + kQuarter - g.heading()))
               : std::nullopt;
}

/// (8.11)
SignedParts left_right_straight_left_right(const Target& g, double most) {
  const Vec2& c = g.to_right();
  const double square = c.squaredNorm() - 4.0;
  if (square < 0.0) return std::nullopt;
  const double u = 4.0 - std::sqrt(square);
  if (u > kWordRounding || kPi - u + std::abs(g.heading()) > most) return std::nullopt;
  const auto first = ahead(std::atan2((4.0 - u) * c.x() - 2.0 * c.y(), -2.0 * c.x() + (u - 4.0) * c.y()));
  return first ? parts_of(first, -kQuarter, std::min(0.0, u), -kQuarter, ahead(*first - g.heading())) : std::nullopt;
}

/// A word to the left and forwards at its beginning; its last letter is that of the last part.
struct Form {
  /// Nothing too where the word is surely longer than the second argument, in radii.
  SignedParts (*solve)(const Target&, double most);
  std::string_view letters;
};
constexpr std::array<Form, 6> kSymmetric = {
    {{left_straight_left, "LSL"},
     {left_straight_right, "LSR"},
     {[](const Target& g, double most) { return left_right_left(g, true, most); }, "LRL"},
     {left_right_cusp_left_right, "LRLR"},
     {left_cusp_right_left_cusp_right, "LRLR"},
     {left_right_straight_left_right, "LRSLR"}}};
/// The forms that differ from themselves when read from the end.
constexpr std::array<Form, 3> kDirected = {
    {{[](const Target& g, double most) { return left_right_left(g, false, most); }, "LRL"},
     {left_right_straight_left, "LRSL"},
     {left_right_straight_right, "LRSR"}}};
static_assert(4 * kSymmetric.size() + 8 * kDirected.size() == kReedsSheppWords);

/// A word is a form, driven the other way (flip), in a mirror, or from its last letter to its first.
struct Word {
  Form form;
  bool flip, mirror, from_end;
};
constexpr Word word_of(std::size_t index) {
  const std::size_t symmetric = 4 * kSymmetric.size();
  const std::size_t code = index < symmetric ? index % 4 : (index - symmetric) % 8;
  const Form& form = index < symmetric ? kSymmetric[index / 4] : kDirected[(index - symmetric) / 8];
  return {form, (code & 1) != 0, (code & 2) != 0, (code & 4) != 0};
}

constexpr std::array<Word, kReedsSheppWords> kWords = [] {
  std::array<Word, kReedsSheppWords> words{};
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = word_of(i);
  return words;
}();

/// The number of a view of the goal: that of a word.
std::size_t view_of(const Word& word) {
  return (word.flip ? 1u : 0u) + (word.mirror ? 2u : 0u) + (word.from_end ? 4u : 0u);
}

Vec2 seen_from(const Pose& start, const Pose& goal, double radius) {
  if (!(radius > 0.0) || !std::isfinite(radius)) {
    throw std::invalid_argument("reeds_shepp: radius must be finite and > 0");
  }
  const Vec2 d = (goal.position() - start.position()) / radius;
  const Vec2 axis = direction_of(start.heading);
  return {axis.dot(d), cross(axis, d)};
}

}  // namespace

ReedsSheppTarget::ReedsSheppTarget(const Vec2& goal, double heading, double sine, double cosine)
    : heading_(heading),
      to_left_(goal.x() - sine, goal.y() - 1.0 + cosine),
      to_right_(goal.x() + sine, goal.y() - 1.0 - cosine) {}

double ReedsSheppTarget::left_distance() const {
  if (left_distance_ < 0.0) left_distance_ = to_left_.norm();
  return left_distance_;
}

double ReedsSheppTarget::left_direction() const {
  if (!left_direction_) left_direction_ = angle_of(to_left_);
  return *left_direction_;
}

double ReedsSheppTarget::left_bend() const {
  if (!left_bend_) left_bend_ = -2.0 * std::asin(std::min(1.0, 0.25 * left_distance()));
  return *left_bend_;
}

ReedsSheppWords::ReedsSheppWords(const Pose& start, const Pose& goal, double radius) : start_(start), radius_(radius) {
  const Vec2 d = seen_from(start, goal, radius);
  const double heading = wrap_signed(goal.heading - start.heading);
  const double s = std::sin(heading), c = std::cos(heading);
  const Vec2 from_end{d.x() * c + d.y() * s, d.x() * s - d.y() * c};
  for (std::size_t view = 0; view < views_.size(); ++view) {
    const Vec2& p = (view & 4) != 0 ? from_end : d;
    const bool flip = (view & 1) != 0, mirror = (view & 2) != 0, turned = flip != mirror;
    views_[view] = {{flip ? -p.x() : p.x(), mirror ? -p.y() : p.y()}, turned ? -heading : heading, turned ? -s : s, c};
  }
}

std::optional<ReedsSheppWords::Solution> ReedsSheppWords::solve(std::size_t index) const {
  const Word& word = kWords[index];
  const SignedParts parts = word.form.solve(views_[view_of(word)], kInfinity);
  if (!parts) return std::nullopt;
  Solution solution{{}, word.form.letters.size()};
  for (std::size_t i = 0; i < solution.count; ++i) {
    const double length = i + 1 < solution.count ? (*parts)[i] : parts->back();
    char kind = word.form.letters[i];
    if (word.mirror && kind != 'S') kind = kind == 'L' ? 'R' : 'L';
    solution.letters[word.from_end ? solution.count - 1 - i : i] = {kind, word.flip ? -length : length};
  }
  return solution;
}

double ReedsSheppWords::length(std::size_t index, double most) const {
  const Word& word = kWords[index];
  const SignedParts parts = word.form.solve(views_[view_of(word)], most / radius_ + kLengthSlack);
  if (!parts) return kInfinity;
  // Parts that a word does not have are zero. They are added in the order of the letters.
  double length = 0.0;
  if (word.from_end) {
    for (std::size_t i = parts->size(); i-- > 0;) length += std::abs((*parts)[i]);
  } else {
    for (const double part : *parts) length += std::abs(part);
  }
  return radius_ * length;
}

std::optional<Path> ReedsSheppWords::path(std::size_t word) const {
  const auto solution = solve(word);
  if (!solution) return std::nullopt;
  Path path;
  path.reserve(solution->count);
  for (std::size_t i = 0; i < solution->count; ++i) {
    const auto [kind, length] = solution->letters[i];
    if (std::abs(length) <= kWordRounding) continue;
    const double curvature = kind == 'S' ? 0.0 : (kind == 'L' ? 1.0 : -1.0) / radius_;
    path.push_back({path.empty() ? start_ : path.back().end(), radius_ * std::abs(length), curvature,
                    length > 0.0 ? Gear::kForward : Gear::kReverse});
  }
  return path;
}

std::optional<Path> reeds_shepp_path(std::size_t word, const Pose& start, const Pose& goal, double radius) {
  return ReedsSheppWords(start, goal, radius).path(word);
}

double reeds_shepp_length(std::size_t word, const Pose& start, const Pose& goal, double radius) {
  return ReedsSheppWords(start, goal, radius).length(word);
}

double reeds_shepp_distance(const Pose& start, const Pose& goal, double radius) {
  const ReedsSheppWords words(start, goal, radius);
  double shortest = kInfinity;
  for (std::size_t word = 0; word < kReedsSheppWords; ++word)
    shortest = std::min(shortest, words.length(word, shortest));
  return shortest;
}

}  // namespace arcway::internal
