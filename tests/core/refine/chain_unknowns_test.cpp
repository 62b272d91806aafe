#include "core/refine/chain_unknowns.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <set>
#include <vector>

#include "arcway/angle.h"
#include "tests/support/arc_chains.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

constexpr double kUnknownsTightest = 1.3;  // [m]

// A chain whose equations do not hold: their derivatives have to be right all the same.
ArcChain random_unjoined_arcs(test::RandomInputs& random, bool in_both_gears = false) {
  ArcChain chain;
  const auto arcs = random.integer(1, 7);
  const auto pose = [&] { return Pose{random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), 0.0}; };
  chain.start = pose();
  chain.goal = pose();
  for (std::int64_t i = 0; i <= arcs; ++i) {
    const bool is_tied = i > 0 && i < arcs && random.unit() < 0.5;
    const double heading = random.uniform(-4.0, 4.0);
    chain.lines.push_back({heading, is_tied ? 0.0 : random.uniform(0.2, 9.0), is_tied, direction_of(heading)});
    if (i == arcs) break;
    const double sign = random.unit() < 0.5 ? 1.0 : -1.0;
    chain.arcs.push_back(
        {random.point(-9.0, 9.0), random.uniform(1.3, 5.0), sign, random.uniform(0.5, 9.0), random.uniform(0.5, 9.0)});
  }
  if (in_both_gears) test::set_random_gears(random, chain);
  return chain;
}

// The chain after a change of one unknown, without placing anything.
ArcChain changed_by(const ArcChain& chain, const ChainUnknowns& unknowns, std::size_t number, double change) {
  ArcChain result = chain;
  const auto part = [&](int of) { return of == static_cast<int>(number) ? change : 0.0; };
  for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
    const Numbers& at = unknowns.of_arc(i);
    result.arcs[i].center += Vec2(part(at[kCenterX]), part(at[kCenterY]));
    result.arcs[i].radius += part(at[kRadius]);
  }
  for (std::size_t i = 0; i < chain.lines.size(); ++i) {
    result.lines[i].length += part(unknowns.of_line(i)[kLength]);
    result.lines[i].heading += part(unknowns.of_line(i)[kHeading]);
    result.lines[i].ahead = direction_of(result.lines[i].heading);
  }
  return result;
}

// How far the equation of each line is from 0.
Eigen::VectorXd residuals_of(const ArcChain& chain) {
  Eigen::VectorXd result(2 * static_cast<Eigen::Index>(chain.lines.size()));
  for (std::size_t i = 0; i < chain.lines.size(); ++i)
    result.segment<2>(2 * static_cast<Eigen::Index>(i)) = test::residual_of(chain, i);
  return result;
}

// The entries of a band matrix, by its solutions.
Eigen::MatrixXd entries_of(BandedLdlt& matrix) {
  constexpr double kLarge = 1e4;  // makes the matrix positive definite
  const auto n = static_cast<Eigen::Index>(matrix.size());
  EXPECT_TRUE(matrix.factorize(std::vector(matrix.size(), 1.0), kLarge, 0));
  Eigen::MatrixXd inverse(n, n);
  for (Eigen::Index column = 0; column < n; ++column) {
    std::vector<double> x(matrix.size(), 0.0);
    x[static_cast<std::size_t>(column)] = 1.0;
    matrix.solve(x);
    inverse.col(column) = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
  }
  return inverse.inverse() - kLarge * Eigen::MatrixXd::Identity(n, n);
}

// Each unknown's value is its number.
std::vector<double> own_numbers(const ChainUnknowns& unknowns) {
  std::vector<double> values(unknowns.size());
  std::iota(values.begin(), values.end(), 0.0);
  return values;
}

void add_numbers(const Numbers& numbers, std::set<int>& all) {
  for (const int number : numbers)
    if (number != kGiven) all.insert(number);
}

TEST(ChainUnknowns, HaveDistinctNumbersAlongThePath) {
  test::RandomInputs random(1);
  ChainUnknowns unknowns;
  for (int i = 0; i < 100; ++i) {
    const ArcChain chain = random_unjoined_arcs(random, i % 2 == 1);
    unknowns.number(chain, kUnknownsTightest);
    const std::size_t n = chain.arcs.size();
    const auto tied = static_cast<std::size_t>(std::ranges::count(chain.lines, true, &ArcChain::Line::is_tied));
    std::size_t speeds = 0;
    for (std::size_t k = 0; k < n; ++k) {
      speeds += !chain.stops_before(k) && !chain.lines[k].is_tied;
      speeds += !chain.stops_behind(k);
    }
    // Of an arc: center and radius, and two speeds but for those at stops; a tied line has one speed. Of a line: its
    // length, two tensions, and its heading.
    EXPECT_EQ(unknowns.size(), 3 * n + speeds + (n + 1 - tied) + 2 * (n + 1) + (n - 1));
    EXPECT_EQ(unknowns.equations(), 2 * (n + 1));
    std::set<int> all;
    for (std::size_t k = 0; k < n; ++k) {
      add_numbers(unknowns.of_arc(k), all);
      add_numbers(unknowns.of_line(k), all);
    }
    add_numbers(unknowns.of_line(n), all);
    const std::vector<double> values = own_numbers(unknowns);
    for (std::size_t k = 0; k <= n; ++k)
      for (const double number : unknowns.tension(k, values)) {
        EXPECT_TRUE(unknowns.is_tension(static_cast<std::size_t>(number)));
        EXPECT_TRUE(all.insert(static_cast<int>(number)).second);
      }
    ASSERT_EQ(all.size(), unknowns.size());
    EXPECT_EQ(*all.begin(), 0);
    EXPECT_EQ(*all.rbegin() + 1, static_cast<int>(unknowns.size()));
  }
}

TEST(ChainUnknowns, NeighborsShareWhatTheyHaveInCommon) {
  test::RandomInputs random(2);
  ChainUnknowns unknowns;
  for (int i = 0; i < 100; ++i) {
    const ArcChain chain = random_unjoined_arcs(random);
    unknowns.number(chain, kUnknownsTightest);
    const std::size_t n = chain.arcs.size();
    const Numbers& first = unknowns.of_line(0);
    for (const int number : {kCenterX, kCenterY, kRadius, kHeading, kEntry})
      EXPECT_EQ(first[static_cast<std::size_t>(number)], kGiven);
    EXPECT_EQ(unknowns.of_line(n)[kHeading], kGiven);
    EXPECT_EQ(unknowns.of_line(n)[kExit], kGiven);
    for (std::size_t k = 0; k < n; ++k) {
      const Numbers &arc = unknowns.of_arc(k), &before = unknowns.of_line(k), &behind = unknowns.of_line(k + 1);
      EXPECT_EQ(arc[kHeading], before[kHeading]);
      EXPECT_EQ(arc[kNextHeading], behind[kHeading]);
      EXPECT_EQ(arc[kEntry], before[kExit]);
      EXPECT_EQ(arc[kExit], behind[kEntry]);
      for (const LocalNumber number : {kCenterX, kCenterY, kRadius}) EXPECT_EQ(arc[number], behind[number]);
      const bool is_tied = chain.lines[k].is_tied;
      EXPECT_EQ(before[kLength] == kGiven, is_tied);
      EXPECT_EQ(before[kEntry] == before[kExit], is_tied);
      for (const LocalNumber number : {kCenterX, kCenterY, kRadius, kEntry, kExit}) EXPECT_NE(arc[number], kGiven);
    }
  }
}

TEST(ChainUnknowns, AreScaledByWhatTheyAre) {
  test::RandomInputs random(3);
  ChainUnknowns unknowns;
  ArcChain chain = random_unjoined_arcs(random);
  const auto expect_scale = [&](int number, double scale) {
    const auto at = static_cast<std::size_t>(number);
    EXPECT_FALSE(unknowns.is_tension(at));
    EXPECT_NEAR(unknowns.inverse_squares()[at] * scale * scale, 1.0, 1e-12);
  };
  chain.lines.front().length = 0.01;
  unknowns.number(chain, kUnknownsTightest);
  for (std::size_t k = 0; k < chain.arcs.size(); ++k) {
    const Numbers& arc = unknowns.of_arc(k);
    expect_scale(arc[kCenterX], kUnknownsTightest);
    expect_scale(arc[kCenterY], kUnknownsTightest);
    expect_scale(arc[kRadius], 0.3 * chain.arcs[k].radius);
    expect_scale(arc[kExit], 0.3 * chain.arcs[k].exit);
    if (!chain.lines[k].is_tied) {
      expect_scale(arc[kEntry], 0.3 * chain.arcs[k].entry);
      expect_scale(unknowns.of_line(k)[kLength], std::min(kUnknownsTightest, chain.lines[k].length));
    }
    if (k > 0) expect_scale(arc[kHeading], 0.3);
  }
}

TEST(ChainUnknowns, TheBandIsAsWideAsTheirDependencies) {
  test::RandomInputs random(4);
  ChainUnknowns unknowns;
  int widest_of_all = 0;
  for (int i = 0; i < 100; ++i) {
    const ArcChain chain = random_unjoined_arcs(random);
    unknowns.number(chain, kUnknownsTightest);
    int widest = 0;
    const auto depend = [&widest](const std::set<int>& on_each_other) {
      widest = std::max(widest, *on_each_other.rbegin() - *on_each_other.begin());
    };
    const std::vector<double> values = own_numbers(unknowns);
    for (std::size_t k = 0; k < chain.lines.size(); ++k) {
      std::set<int> line;
      add_numbers(unknowns.of_line(k), line);
      if (!line.empty()) depend(line);
      // An equation depends on no speeds.
      std::set<int> equation;
      for (const LocalNumber number : {kCenterX, kCenterY, kRadius, kHeading, kNextHeading})
        equation.insert(unknowns.of_line(k)[number]);
      for (const double number : unknowns.tension(k, values)) equation.insert(static_cast<int>(number));
      if (k < chain.arcs.size()) {
        std::set<int> arc;
        add_numbers(unknowns.of_arc(k), arc);
        depend(arc);
        for (const LocalNumber number : {kCenterX, kCenterY, kRadius}) equation.insert(unknowns.of_arc(k)[number]);
      }
      equation.erase(kGiven);
      depend(equation);
    }
    ASSERT_LE(widest, static_cast<int>(BandedLdlt::kBand)) << "chain " << i;
    widest_of_all = std::max(widest_of_all, widest);
  }
  EXPECT_EQ(widest_of_all, static_cast<int>(BandedLdlt::kBand));
}

TEST(ChainUnknowns, EquationsAddTheirDerivatives) {
  constexpr double kStep = 1e-3;
  constexpr double kWeight = 0.7;
  test::RandomInputs random(5);
  ChainUnknowns unknowns;
  BandedLdlt matrix;
  for (int i = 0; i < 20; ++i) {
    const ArcChain chain = random_unjoined_arcs(random, i % 2 == 1);
    unknowns.number(chain, kUnknownsTightest);
    const auto n = static_cast<Eigen::Index>(unknowns.size());
    std::vector<Vec2> tensions(chain.lines.size());
    Eigen::VectorXd forces(2 * static_cast<Eigen::Index>(tensions.size()));
    for (std::size_t k = 0; k < tensions.size(); ++k) {
      tensions[k] = random.point(-2.0, 2.0);
      forces.segment<2>(2 * static_cast<Eigen::Index>(k)) = tensions[k];
    }
    matrix.reset(unknowns.size());
    unknowns.add_equations(chain, tensions, kWeight, matrix);

    const auto after = [&](Eigen::Index number, double change) {
      return changed_by(chain, unknowns, static_cast<std::size_t>(number), change);
    };
    Eigen::MatrixXd rows(forces.size(), n);
    for (Eigen::Index k = 0; k < n; ++k)
      rows.col(k) = (8.0 * (residuals_of(after(k, kStep)) - residuals_of(after(k, -kStep))) -
                     (residuals_of(after(k, 2.0 * kStep)) - residuals_of(after(k, -2.0 * kStep)))) /
                    (12.0 * kStep);
    Eigen::MatrixXd expected = kWeight * rows.transpose() * rows;
    const auto pull = [&](Eigen::Index a, double by_a, Eigen::Index b, double by_b) {
      return forces.dot(residuals_of(changed_by(after(a, by_a), unknowns, static_cast<std::size_t>(b), by_b)));
    };
    for (Eigen::Index a = 0; a < n; ++a)
      for (Eigen::Index b = 0; b < n; ++b)
        expected(a, b) += (pull(a, kStep, b, kStep) - pull(a, kStep, b, -kStep) - pull(a, -kStep, b, kStep) +
                           pull(a, -kStep, b, -kStep)) /
                          (4.0 * kStep * kStep);
    const std::vector<double> values = own_numbers(unknowns);
    for (std::size_t k = 0; k < tensions.size(); ++k)
      for (const int axis : {0, 1}) {
        const auto number = static_cast<Eigen::Index>(unknowns.tension(k, values)[axis]);
        const Eigen::Index row = 2 * static_cast<Eigen::Index>(k) + axis;
        expected.row(number) += rows.row(row);
        expected.col(number) += rows.row(row).transpose();
      }
    EXPECT_NEAR((entries_of(matrix) - expected).cwiseAbs().maxCoeff(), 0.0, 1e-4) << "chain " << i;
  }
}

TEST(ChainUnknowns, TermsAreAddedByTheirNumbers) {
  test::RandomInputs random(6);
  const Numbers numbers{2, 0, kGiven, 5, 3, kGiven, 1};
  Term term;
  for (int a = 0; a < kLocalNumbers; ++a) {
    term.gradient[a] = random.uniform(-1.0, 1.0);
    for (int b = 0; b <= a; ++b) term.curve(a, b, random.uniform(-1.0, 1.0));
  }
  BandedLdlt matrix;
  matrix.reset(6);
  add(numbers, term.hessian, 2.0, matrix);
  add(numbers, term.hessian, 0.5, matrix);
  add_square(numbers, term.gradient, -1.5, matrix);
  std::vector<double> to(6, 1.0), step(6);
  for (double& part : step) part = random.uniform(-1.0, 1.0);
  add(numbers, term.gradient, -3.0, to);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(6, 6);
  std::vector<double> expected_to(6, 1.0);
  double expected_along = 0.0;
  for (int a = 0; a < kLocalNumbers; ++a) {
    const int row = numbers[static_cast<std::size_t>(a)];
    EXPECT_EQ(part_of(step, row), row == kGiven ? 0.0 : step[static_cast<std::size_t>(row)]);
    if (row == kGiven) continue;
    expected_to[static_cast<std::size_t>(row)] -= 3.0 * term.gradient[a];
    expected_along += term.gradient[a] * step[static_cast<std::size_t>(row)];
    for (int b = 0; b < kLocalNumbers; ++b)
      if (const int column = numbers[static_cast<std::size_t>(b)]; column != kGiven)
        expected(row, column) += 2.5 * term.hessian(a, b) - 1.5 * term.gradient[a] * term.gradient[b];
  }
  EXPECT_NEAR((entries_of(matrix) - expected).cwiseAbs().maxCoeff(), 0.0, 1e-9);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_DOUBLE_EQ(to[i], expected_to[i]);
  EXPECT_NEAR(along(numbers, term.gradient, step), expected_along, 1e-14);
}

}  // namespace
}  // namespace arcway::internal
