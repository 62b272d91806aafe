#include "core/geometry/spline_tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "arcway/angle.h"

namespace arcway::internal {
namespace {

constexpr double kSameParameter = 1e-9;
constexpr double kMinWidth = 0x1p-46;  // width of the smallest interval that is halved

// A polynomial on [0, 1] by its Bernstein coefficients: it has at most as many roots as they have changes of sign.
template <std::size_t N>
struct Bernstein {
  std::array<double, N> b;

  [[nodiscard]] int sign_changes() const {
    int changes = 0, last = 0;
    for (const double value : b) {
      const int sign = sign_of(value);
      if (sign != 0 && last != 0 && sign != last) ++changes;
      if (sign != 0) last = sign;
    }
    return changes;
  }
  // Just after 0 and just before 1; 0 of the zero polynomial.
  [[nodiscard]] int first_sign() const { return first_of(b.begin(), b.end()); }
  [[nodiscard]] int last_sign() const { return first_of(b.rbegin(), b.rend()); }
  [[nodiscard]] std::array<Bernstein, 2> halves() const {
    Bernstein left, right, work = *this;
    for (std::size_t k = 0; k < N; ++k) {
      left.b[k] = work.b[0];
      right.b[N - 1 - k] = work.b[N - 1 - k];
      for (std::size_t i = 0; i + 1 < N - k; ++i) work.b[i] = 0.5 * (work.b[i] + work.b[i + 1]);
    }
    return {left, right};
  }

 private:
  static int sign_of(double value) { return (value > 0.0) - (value < 0.0); }
  template <class Iterator>
  static int first_of(Iterator begin, Iterator end) {
    const Iterator found = std::find_if(begin, end, [](double value) { return value != 0.0; });
    return found == end ? 0 : sign_of(*found);
  }
};

// Appends the roots on [low, low + width]; of those at its ends only what changes sign within.
template <std::size_t N>
void append_roots(const Bernstein<N>& polynomial, double low, double width, std::vector<double>& roots) {
  const int changes = polynomial.sign_changes();
  if (changes == 0) return;
  if (width < kMinWidth) {
    roots.push_back(low + 0.5 * width);
    return;
  }
  const auto [left, right] = polynomial.halves();
  // A root in the very middle is an end of both halves, and no change of sign in either.
  if (right.b[0] == 0.0 && left.last_sign() != right.first_sign()) roots.push_back(low + 0.5 * width);
  append_roots(left, low, 0.5 * width, roots);
  append_roots(right, low + 0.5 * width, 0.5 * width, roots);
}

// cross(curve - point, curve') of a piece.
Bernstein<6> tangency(const CubicBezier& piece, const Vec2& point) {
  constexpr std::array<double, 4> kCubic{1.0, 3.0, 3.0, 1.0};
  constexpr std::array<double, 3> kQuadratic{1.0, 2.0, 1.0};
  constexpr std::array<double, 6> kQuintic{1.0, 5.0, 10.0, 10.0, 5.0, 1.0};
  Bernstein<6> f{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      f.b[i + j] +=
          kCubic[i] * kQuadratic[j] / kQuintic[i + j] * cross(piece.p[i] - point, piece.p[j + 1] - piece.p[j]);
  }
  return f;
}

// cross(curve', curve'') of a piece: its sign is that of the curvature.
Bernstein<4> bend(const CubicBezier& piece) {
  const std::array<Vec2, 3> d{piece.p[1] - piece.p[0], piece.p[2] - piece.p[1], piece.p[3] - piece.p[2]};
  const std::array<Vec2, 2> e{d[1] - d[0], d[2] - d[1]};
  return {{cross(d[0], e[0]), (cross(d[0], e[1]) + 2.0 * cross(d[1], e[0])) / 3.0,
           (2.0 * cross(d[1], e[1]) + cross(d[2], e[0])) / 3.0, cross(d[2], e[1])}};
}

// Sorted by parameter, those that nearly coincide left out; the parameter is cyclic.
template <class Item, class Parameter>
void keep_different(std::vector<Item>& items, Parameter parameter, double period) {
  std::ranges::sort(items, {}, parameter);
  std::vector<Item> kept;
  for (const Item& item : items)
    if (kept.empty() || parameter(item) - parameter(kept.back()) > kSameParameter) kept.push_back(item);
  while (kept.size() > 1 && parameter(kept.front()) + period - parameter(kept.back()) <= kSameParameter)
    kept.pop_back();
  items = std::move(kept);
}

// A part of a curve that bends one way and turns by less than a right angle.
struct Arc {
  CubicBezier piece;
  double t, width;   // the curve's parameter at its start, and how far it runs
  double low, high;  // headings of its tangents
  Vec2 middle;
  double radius;  // no point of it is farther from the middle

  // The parameter where the tangent has this heading.
  [[nodiscard]] double parameter_of(double heading) const {
    const Vec2 direction = direction_of(heading);
    const double a = cross(direction, piece.p[1] - piece.p[0]), b = cross(direction, piece.p[2] - piece.p[1]),
                 c = cross(direction, piece.p[3] - piece.p[2]);
    // Roots of a (1-u)^2 + 2 b u (1-u) + c u^2; of the two forms of each the one without cancellation.
    const double root = std::sqrt(std::max(0.0, b * b - a * c));
    const double q = (a - b) + (a - b >= 0.0 ? root : -root);
    const double first = q / (a - 2.0 * b + c), second = a / q;
    const auto outside = [](double u) { return std::isfinite(u) ? std::max({0.0, -u, u - 1.0}) : 2.0; };
    return std::clamp(outside(first) <= outside(second) ? first : (std::isfinite(second) ? second : 0.0), 0.0, 1.0);
  }
};

void append_arcs(const CubicBezier& piece, double t, double width, std::vector<Arc>& arcs) {
  const Vec2 d0 = piece.p[1] - piece.p[0], d1 = piece.p[2] - piece.p[1], d2 = piece.p[3] - piece.p[2];
  const auto turn = [](const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); };
  // The tangents' directions lie between those of the control polygon's edges.
  const double turns[] = {turn(d0, d1), turn(d1, d2)};
  if (std::abs(turns[0]) + std::abs(turns[1]) > 0.45 * kPi && width > 0x1p-30) {
    const auto [first, second] = piece.halves();
    append_arcs(first, t, 0.5 * width, arcs);
    append_arcs(second, t + 0.5 * width, 0.5 * width, arcs);
    return;
  }
  const double start = std::atan2(d0.y(), d0.x()), end = start + turns[0] + turns[1];
  Arc arc{piece, t, width, std::min(start, end), std::max(start, end), Vec2(0.0, 0.0), 0.0};
  for (const Vec2& p : piece.p) arc.middle += 0.25 * p;
  for (const Vec2& p : piece.p) arc.radius = std::max(arc.radius, (p - arc.middle).norm());
  arcs.push_back(arc);
}

std::vector<Arc> arcs_of(const ClosedSpline& curve) {
  std::vector<Arc> arcs;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const CubicBezier& piece = curve.pieces()[i];
    std::vector<double> cuts{0.0};
    append_roots(bend(piece), 0.0, 1.0, cuts);
    std::ranges::sort(cuts);
    cuts.push_back(1.0);
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      if (cuts[k] - cuts[k - 1] <= 0x1p-40) continue;
      append_arcs(piece.part(cuts[k - 1], cuts[k]), static_cast<double>(i) + cuts[k - 1], cuts[k] - cuts[k - 1], arcs);
    }
  }
  return arcs;
}

// Common tangents of two arcs by their common heading.
class ArcPair {
 public:
  ArcPair(const Arc& first, const Arc& second, double shift)
      : first_(first),
        second_(second),
        shift_(shift),
        slope_((1.0 + 1e-12) * ((second.middle - first.middle).norm() + first.radius + second.radius)) {}

  void append(std::vector<CommonTangent>& tangents, std::size_t& budget) {
    const double low = std::max(first_.low, second_.low + shift_), high = std::min(first_.high, second_.high + shift_);
    if (low > high) return;
    search(low, high, tangents, budget);
  }

 private:
  struct Touch {
    double u, v;
    Vec2 first, second;
    double distance;  // of the two parallel tangents
  };
  [[nodiscard]] Touch at(double heading) const {
    Touch touch{first_.parameter_of(heading), second_.parameter_of(heading - shift_), {}, {}, 0.0};
    touch.first = first_.piece.at(touch.u);
    touch.second = second_.piece.at(touch.v);
    touch.distance = cross(direction_of(heading), touch.second - touch.first);
    return touch;
  }
  void search(double low, double high, std::vector<CommonTangent>& tangents, std::size_t& budget) {
    if (budget-- == 0) throw std::invalid_argument("common tangents: the curves run along each other");
    const double half = 0.5 * (high - low), middle = low + half;
    const Touch touch = at(middle);
    if (std::abs(touch.distance) > slope_ * (half + kNoise)) return;
    if (half > kNoise) {
      search(low, middle, tangents, budget);
      search(middle, high, tangents, budget);
      return;
    }
    tangents.push_back({first_.t + first_.width * touch.u, second_.t + second_.width * touch.v, touch.first,
                        touch.second, std::cos(shift_) < 0.0});
  }

  static constexpr double kNoise = 1e-13;  // rounding of headings [rad]
  const Arc& first_;
  const Arc& second_;
  double shift_;
  double slope_;
};

}  // namespace

std::vector<PointTangent> tangents_from(const Vec2& point, const ClosedSpline& curve) {
  const auto pieces = curve.pieces();
  std::vector<double> roots;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Bernstein<6> f = tangency(pieces[i], point);
    std::vector<double> within;
    append_roots(f, 0.0, 1.0, within);
    for (const double u : within) roots.push_back(static_cast<double>(i) + u);
    // The next piece begins with the same value up to a factor and rounding.
    const std::size_t next = (i + 1) % pieces.size();
    if (f.last_sign() != tangency(pieces[next], point).first_sign()) roots.push_back(static_cast<double>(next));
  }
  keep_different(
      roots, [](double t) { return t; }, static_cast<double>(pieces.size()));
  std::vector<PointTangent> tangents;
  for (const double t : roots) {
    const Vec2 touch = curve.at(t);
    tangents.push_back({t, touch, curve.derivative(t).dot(touch - point) > 0.0});
  }
  return tangents;
}

std::vector<CommonTangent> common_tangents(const ClosedSpline& first, const ClosedSpline& second) {
  const std::vector<Arc> first_arcs = arcs_of(first), second_arcs = arcs_of(second);
  std::vector<CommonTangent> tangents;
  for (const Arc& a : first_arcs) {
    for (const Arc& b : second_arcs) {
      std::size_t budget = 100'000;
      for (int half_turns = -4; half_turns <= 4; ++half_turns) ArcPair(a, b, half_turns * kPi).append(tangents, budget);
    }
  }
  // Neighboring intervals and arcs find the same tangent.
  std::ranges::sort(tangents, {}, &CommonTangent::t_first);
  std::vector<CommonTangent> kept;
  const double period = static_cast<double>(first.size());
  const double scale = std::max((first.at(0.0) - second.at(0.0)).norm(), 1e-300);
  for (const CommonTangent& tangent : tangents) {
    const bool known = std::ranges::any_of(kept, [&](const CommonTangent& other) {
      const double apart = std::abs(tangent.t_first - other.t_first);
      return std::min(apart, period - apart) <= 1e-6 && (tangent.second - other.second).norm() <= 1e-5 * scale;
    });
    if (!known) kept.push_back(tangent);
  }
  return kept;
}

}  // namespace arcway::internal
