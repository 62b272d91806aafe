#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/report/statistics.h"

namespace arcway::report {

/// One series of a plot: points with the spread of their repetitions.
struct Curve {
  struct Point {
    double size, seconds, low, high;
  };
  std::string name;
  std::vector<Point> points;
  std::optional<PowerFit> fit;
};

/// An SVG element with the curves twice, as groups of class `log` (both axes logarithmic) and `linear`. Told apart by
/// colour (safe for the colour-blind), marker and dash. Colours of text and axes are those of the page; markers carry
/// their values as `data-tip`.
std::string plot_svg(const std::string& title, const std::string& x_label, std::span<const Curve> curves);

/// A small SVG element that shows line and marker of a curve by its index.
std::string legend_key(std::size_t index);

/// "12.3 ms"
std::string time_text(double seconds);

}  // namespace arcway::report
