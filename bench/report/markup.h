#pragma once

#include <span>
#include <string>
#include <string_view>

#include "bench/report/plot.h"
#include "datasets/io/markup_text.h"

namespace arcway::internal::report {

/// One number by a printf format.
std::string number_text(const char* format, double value);

/// A whole number with separators: "100,000".
std::string count_text(double value);

/// A plot with its legend and what it shows in a sentence, as HTML; the legend says a curve's slope where it has a fit.
std::string figure_html(const PlotAxes& axes, std::span<const Curve> curves, std::string_view caption);

}  // namespace arcway::internal::report
