#include "datasets/formats/svg_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "arcway/angle.h"
#include "datasets/formats/text_scanner.h"
#include "datasets/io/number_text.h"

namespace arcway::internal::detail {
namespace {

constexpr double kArcPart = kPi / 16.0;  // angle of an ellipse's part that becomes one cubic; error 4e-10 of the radius

class PathReader {
 public:
  explicit PathReader(std::string_view data) : data_(data) {}

  std::vector<SvgSubpath> read() {
    while (!data_.at_end()) {
      const char c = data_.peek();
      if ((c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z')) {
        command_ = data_.letter();
      } else if (command_ == 0) {
        throw std::invalid_argument("expected a path command, found " + quoted({&c, 1}));
      }
      step();
    }
    return std::move(subpaths_);
  }

 private:
  void step() {
    const bool relative = command_ >= 'a';
    const char upper = relative ? static_cast<char>(command_ - 'a' + 'A') : command_;
    const Vec2 from = relative ? at_ : Vec2(0.0, 0.0);
    if (upper != 'M' && subpaths_.empty()) throw std::invalid_argument("a path begins with M");
    const char before = std::exchange(last_, upper);
    switch (upper) {
      case 'M':
        at_ = first_ = from + point();
        subpaths_.push_back({first_, {}});
        open_ = true;
        command_ = relative ? 'l' : 'L';  // further pairs are lines
        break;
      case 'Z':
        at_ = first_;
        open_ = false;
        command_ = 0;
        break;
      case 'L':
        line_to(from + point());
        break;
      case 'H':
        line_to({from.x() + number(), at_.y()});
        break;
      case 'V':
        line_to({at_.x(), from.y() + number()});
        break;
      case 'C':
      case 'S': {
        // The smooth one goes on in the direction of a cubic before it.
        const Vec2 a = upper == 'C'                     ? from + point()
                       : before == 'C' || before == 'S' ? Vec2(2.0 * at_ - control_)
                                                        : at_;
        control_ = from + point();
        curve_to(a, control_, from + point());
        break;
      }
      case 'Q':
      case 'T': {
        control_ = upper == 'Q' ? from + point() : before == 'Q' || before == 'T' ? Vec2(2.0 * at_ - control_) : at_;
        const Vec2 end = from + point();
        curve_to(at_ + 2.0 / 3.0 * (control_ - at_), end + 2.0 / 3.0 * (control_ - end), end);
        break;
      }
      case 'A': {
        const Vec2 radii = point().cwiseAbs();
        const double tilt = number() * kPi / 180.0;
        const bool large = flag(), sweep = flag();
        arc_to(radii, tilt, large, sweep, from + point());
        break;
      }
      default:
        throw std::invalid_argument("path command " + quoted({&command_, 1}) + " is not known");
    }
  }

  double number() {
    const std::optional<double> value = data_.number();
    if (!value) throw std::invalid_argument("expected a number after path command " + quoted({&command_, 1}));
    return *value;
  }
  Vec2 point() {
    const double x = number();
    return {x, number()};
  }
  // One character, which may stand right before the next number.
  bool flag() {
    if (data_.at_end() || (data_.peek() != '0' && data_.peek() != '1'))
      throw std::invalid_argument("expected a flag, 0 or 1, after path command " + quoted({&command_, 1}));
    return data_.letter() == '1';
  }

  void add(const CubicBezier& piece) {
    if (!std::exchange(open_, true)) subpaths_.push_back({first_, {}});
    subpaths_.back().pieces.push_back(piece);
    at_ = piece.p[3];
  }
  void line_to(const Vec2& end) { add({{at_, at_, end, end}}); }
  void curve_to(const Vec2& a, const Vec2& b, const Vec2& end) {
    add({{at_, a, b, end}});
    subpaths_.back().curved = true;
  }

  // The implementation notes of SVG: the ellipse becomes the unit circle, where u and -u are the ends and c the center.
  void arc_to(const Vec2& given_radii, double tilt, bool large, bool sweep, const Vec2& end) {
    const Vec2 start = at_, middle = 0.5 * (start + end);
    if (start == end || given_radii.x() == 0.0 || given_radii.y() == 0.0) return line_to(end);
    const Vec2 axis = direction_of(tilt), half = 0.5 * (start - end);
    Vec2 u = Vec2(axis.dot(half), cross(axis, half)).cwiseQuotient(given_radii);
    const double too_far = std::max(1.0, u.norm());  // radii that do not reach are enlarged
    const Vec2 radii = too_far * given_radii;
    u /= too_far;
    const double away = std::sqrt(std::max(0.0, 1.0 / u.squaredNorm() - 1.0));
    const Vec2 c = (large == sweep ? 1.0 : -1.0) * away * perpendicular(u);
    const double from = std::atan2(u.y() - c.y(), u.x() - c.x());
    double turn = std::atan2(-u.y() - c.y(), -u.x() - c.x()) - from;
    if (sweep && turn <= 0.0) turn += kTwoPi;
    if (!sweep && turn >= 0.0) turn -= kTwoPi;

    const auto place = [&](const Vec2& p) {
      const Vec2 q = radii.cwiseProduct(c + p);
      return Vec2(middle + q.x() * axis + q.y() * perpendicular(axis));
    };
    const double parts = std::clamp(std::ceil(std::abs(turn) / kArcPart), 1.0, 64.0);
    const double step = turn / parts, reach = 4.0 / 3.0 * std::tan(0.25 * step);
    for (double i = 1.0; i <= parts; ++i) {
      const Vec2 a = direction_of(from + (i - 1.0) * step), b = direction_of(from + i * step);
      curve_to(place(a + reach * perpendicular(a)), place(b - reach * perpendicular(b)), i < parts ? place(b) : end);
    }
  }

  SvgAttribute data_;
  char command_ = 0;
  char last_ = 0;  // command, in upper case
  Vec2 at_{0.0, 0.0}, first_{0.0, 0.0}, control_{0.0, 0.0};
  bool open_ = false;  // a subpath that is not closed
  std::vector<SvgSubpath> subpaths_;
};

}  // namespace

bool SvgAttribute::at_end() {
  const std::size_t next = text_.find_first_not_of(" \t\r\n,");
  text_.remove_prefix(std::min(next, text_.size()));
  return text_.empty();
}

char SvgAttribute::letter() {
  const char c = text_.front();
  text_.remove_prefix(1);
  return c;
}

std::optional<double> SvgAttribute::number() { return at_end() ? std::nullopt : take_number(text_); }

std::string_view SvgAttribute::until(char c) {
  const std::size_t end = std::min(text_.find(c), text_.size());
  const std::string_view part = text_.substr(0, end);
  text_.remove_prefix(std::min(end + 1, text_.size()));
  return part;
}

std::vector<SvgSubpath> read_svg_path(std::string_view data) { return PathReader(data).read(); }

}  // namespace arcway::internal::detail
