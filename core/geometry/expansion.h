#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace arcway::internal {

/// \file
/// Exact sums of doubles [Shewchuk 1997, sections 2.2-2.4]. Needs rounding to nearest, no
/// contraction, and products that neither overflow nor underflow.

struct TwoTerms {
  double value;  ///< the rounded result
  double error;  ///< exact result - value
};

inline TwoTerms two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

inline TwoTerms two_product(double a, double b) {
  // Dekker's split rather than fma: the same bits and the same speed on every instruction set.
  constexpr double kSplitter = 134217729.0;  // 2^27 + 1
  const double product = a * b;
  const double a_big = kSplitter * a;
  const double a_high = a_big - (a_big - a);
  const double a_low = a - a_high;
  const double b_big = kSplitter * b;
  const double b_high = b_big - (b_big - b);
  const double b_low = b - b_high;
  const double error = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
  return {product, error};
}

/// Adds `b` to an expansion of `size` non-overlapping components, smallest first, in place; zeros
/// are dropped. There must be room for one more. Returns the new size.
inline std::size_t grow_expansion(double* components, std::size_t size, double b) {
  std::size_t kept = 0;
  double carry = b;
  for (std::size_t i = 0; i < size; ++i) {
    const TwoTerms sum = two_sum(carry, components[i]);
    carry = sum.value;
    if (sum.error != 0.0) components[kept++] = sum.error;
  }
  if (carry != 0.0) components[kept++] = carry;
  return kept;
}

inline int sign_of(double x) { return (x > 0.0) - (x < 0.0); }

/// Exact sum of at most `Capacity` doubles, on the stack.
template <std::size_t Capacity>
class FixedExpansion {
 public:
  void add(double b) { size_ = grow_expansion(components_.data(), size_, b); }
  void add_product(double a, double b) {
    const TwoTerms product = two_product(a, b);
    add(product.error);
    add(product.value);
  }
  /// The last component exceeds the sum of all others.
  [[nodiscard]] int sign() const { return size_ == 0 ? 0 : sign_of(components_[size_ - 1]); }
  /// The sum, correct to a unit or two in the last place.
  [[nodiscard]] double value() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < size_; ++i) sum += components_[i];
    return sum;
  }

 private:
  std::array<double, Capacity> components_;
  std::size_t size_ = 0;
};

/// Exact sum of any number of doubles.
class Expansion {
 public:
  void add(double b) {
    components_.push_back(0.0);
    components_.resize(grow_expansion(components_.data(), components_.size() - 1, b));
  }
  void add_product(double a, double b) {
    const TwoTerms product = two_product(a, b);
    add(product.error);
    add(product.value);
  }
  [[nodiscard]] int sign() const { return components_.empty() ? 0 : sign_of(components_.back()); }

 private:
  std::vector<double> components_;
};

}  // namespace arcway::internal
