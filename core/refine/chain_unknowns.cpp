#include "core/refine/chain_unknowns.h"

#include <algorithm>
#include <cstdlib>

namespace arcway::internal {

namespace {

// Scales of headings [rad], and of radii and squares of speeds as shares of them.
constexpr double kHeadingScale = 0.3, kRadiusScale = 0.3, kSpeedScale = 0.3;
constexpr std::size_t kMostEntries = 8;

std::size_t at(int number) { return static_cast<std::size_t>(number); }

// How the equation of one line depends on its unknowns.
struct Equation {
  struct Entry {
    int number;
    Vec2 by;
  };
  std::array<Entry, kMostEntries> entries;
  std::size_t count = 0;

  void enter(int number, const Vec2& by) {
    if (number != kGiven) entries[count++] = {number, by};
  }
};

}  // namespace

void ChainUnknowns::number(const ArcChain& chain, double tightest) {
  const std::size_t n = chain.arcs.size();
  Numbers none;
  none.fill(kGiven);
  arcs_.assign(n, none);
  lines_.assign(n + 1, none);
  tensions_.resize(n + 1);
  inverse_squares_.clear();
  const auto unknown = [&](double scale) {
    inverse_squares_.push_back(scale > 0.0 ? 1.0 / (scale * scale) : 0.0);
    return static_cast<int>(inverse_squares_.size()) - 1;
  };
  for (std::size_t i = 0; i <= n; ++i) {
    Numbers& line = lines_[i];
    if (i > 0)
      for (const auto k : {kCenterX, kCenterY, kRadius}) line[k] = arcs_[i - 1][k];
    if (i > 0) line[kEntry] = arcs_[i - 1][kExit];
    // From rest, the time for a short line is so concave in its length that whole steps would be damped for it.
    if (!chain.lines[i].is_tied) line[kLength] = unknown(std::min(tightest, chain.lines[i].length));
    if (i > 0 && i < n) line[kHeading] = unknown(kHeadingScale);
    if (i > 0) arcs_[i - 1][kNextHeading] = line[kHeading];
    if (i < n) {
      Numbers& arc = arcs_[i];
      arc[kHeading] = line[kHeading];
      if (chain.lines[i].is_tied) {
        arc[kEntry] = line[kEntry];
      } else if (!chain.stops_before(i)) {
        arc[kEntry] = unknown(kSpeedScale * chain.arcs[i].entry);
      }
      line[kExit] = arc[kEntry];
      arc[kCenterX] = unknown(tightest);
      arc[kCenterY] = unknown(tightest);
      arc[kRadius] = unknown(kRadiusScale * chain.arcs[i].radius);
      if (!chain.stops_behind(i)) arc[kExit] = unknown(kSpeedScale * chain.arcs[i].exit);
    }
    tensions_[i] = {unknown(0.0), unknown(0.0)};
  }
}

void ChainUnknowns::add_equations(const ArcChain& chain, std::span<const Vec2> tensions, double stiffness,
                                  BandedLdlt& matrix) const {
  const std::size_t n = chain.arcs.size();
  const auto put = [&matrix](int a, int b, double value) {
    if (a != kGiven && b != kGiven) matrix.add(at(a), at(b), value);
  };
  for (std::size_t i = 0; i <= n; ++i) {
    const ArcChain::Line& line = chain.lines[i];
    const Vec2& ahead = line.ahead;
    const Vec2 left = perpendicular(ahead);
    const double offset = chain.offset(i);
    const double before = i > 0 ? chain.arcs[i - 1].sign : 0.0, behind = i < n ? chain.arcs[i].sign : 0.0;
    const Numbers& own = lines_[i];
    const int length = own[kLength], heading = own[kHeading], radius = own[kRadius];
    const int next_radius = i < n ? arcs_[i][kRadius] : kGiven;

    Equation equation;
    equation.enter(length, -line.gear * ahead);
    equation.enter(heading, offset * ahead - line.along() * left);
    equation.enter(own[kCenterX], {-1.0, 0.0});
    equation.enter(own[kCenterY], {0.0, -1.0});
    equation.enter(radius, before * left);
    if (i < n) {
      equation.enter(arcs_[i][kCenterX], {1.0, 0.0});
      equation.enter(arcs_[i][kCenterY], {0.0, 1.0});
      equation.enter(next_radius, -behind * left);
    }
    for (std::size_t a = 0; a < equation.count; ++a) {
      const auto& [number, by] = equation.entries[a];
      for (std::size_t b = 0; b <= a; ++b)
        put(number, equation.entries[b].number, stiffness * by.dot(equation.entries[b].by));
      put(tensions_[i][0], number, by.x());
      put(tensions_[i][1], number, by.y());
    }
    const Vec2& f = tensions[i];
    put(heading, heading, f.dot(line.along() * ahead + offset * left));
    put(heading, length, -line.gear * f.dot(left));
    put(heading, radius, -before * f.dot(ahead));
    put(heading, next_radius, behind * f.dot(ahead));
  }
}

void add(const Numbers& numbers, const Term::Hessian& hessian, double weight, BandedLdlt& matrix) {
  for (int a = 0; a < kLocalNumbers; ++a) {
    const int row = numbers[at(a)];
    if (row == kGiven) continue;
    for (int b = 0; b <= a; ++b) {
      const int column = numbers[at(b)];
      if (column != kGiven && hessian(a, b) != 0.0) matrix.add(at(row), at(column), weight * hessian(a, b));
    }
  }
}

// Few entries of a gradient are not zero.
void add_square(const Numbers& numbers, const Term::Gradient& gradient, double weight, BandedLdlt& matrix) {
  std::array<int, kLocalNumbers> used;
  std::size_t count = 0;
  for (int a = 0; a < kLocalNumbers; ++a) {
    if (gradient[a] == 0.0 || numbers[at(a)] == kGiven) continue;
    used[count++] = a;
    for (std::size_t b = 0; b < count; ++b)
      matrix.add(at(numbers[at(a)]), at(numbers[at(used[b])]), weight * (gradient[a] * gradient[used[b]]));
  }
}

void add(const Numbers& numbers, const Term::Gradient& gradient, double weight, std::span<double> to) {
  for (int a = 0; a < kLocalNumbers; ++a)
    if (numbers[at(a)] != kGiven) to[at(numbers[at(a)])] += weight * gradient[a];
}

double along(const Numbers& numbers, const Term::Gradient& gradient, std::span<const double> step) {
  double sum = 0.0;
  for (int a = 0; a < kLocalNumbers; ++a) sum += gradient[a] * part_of(step, numbers[at(a)]);
  return sum;
}

}  // namespace arcway::internal
