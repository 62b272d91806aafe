#pragma once

#include <span>
#include <string>
#include <string_view>

#include "bench/report/plot.h"
#include "datasets/io/markup_text.h"

namespace arcway::internal::report {

/// Label of an axis of times; the marks have their units.
inline constexpr const char* kTimeLabel = "time for one answer, median";

/// An escaped text whose exponents, "n^1.07", are raised.
std::string with_superscripts(std::string_view escaped);

/// One number by a printf format.
std::string number_text(const char* format, double value);

/// A whole number with separators: "100,000".
std::string count_text(double value);

/// "a, b and c"
std::string listed(std::span<const std::string> names);

/// "3 ms – 8 ms"; one text where both are the same.
template <class Text>
std::string range_text(double low, double high, const Text& text) {
  const std::string from = text(low), to = text(high);
  return from == to ? from : from + " – " + to;
}

/// A plot with its legend and what it shows in a sentence, as HTML; the legend says a curve's slope where it has a fit.
std::string figure_html(const PlotAxes& axes, std::span<const Curve> curves, std::string_view caption);

}  // namespace arcway::internal::report
