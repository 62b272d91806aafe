#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/report/statistics.h"

namespace arcway::internal::report {

/// One series of a plot: points with the spread of their repetitions.
struct Curve {
  struct Point {
    double x, y, low, high;  ///< y from low to high in the repetitions
    std::string noise = {};  ///< why it is noisy; empty if it is not
  };
  std::string name;
  std::vector<Point> points;
  std::optional<PowerFit> fit;
};

/// The points that a fit takes: those that are not noisy.
std::vector<SizePoint> fitted_points(const Curve& curve);

/// "12.3 ms"
std::string time_text(double seconds);
/// "316", "31.6k"
std::string size_text(double size);
/// "0.0123", "1.23", "123"
std::string ratio_text(double ratio);

/// What is on the axes, and how their values are written.
struct PlotAxes {
  std::string title, x_label, y_label;
  std::string (*x_text)(double) = size_text;
  std::string (*y_text)(double) = time_text;
  std::optional<double> level = std::nullopt;  ///< a horizontal line across
};

/// An SVG element with the curves twice, as groups of class `log` (both axes logarithmic) and `linear`. Told apart by
/// color (safe for the color-blind), marker and dash. Colors of text and axes are those of the page; markers carry
/// their values as `data-tip`. Those of noisy points are hollow, of class `noisy`, and their tip says why.
std::string plot_svg(const PlotAxes& axes, std::span<const Curve> curves);

/// A small SVG element that shows line and marker of a curve by its index.
std::string legend_key(std::size_t index);

}  // namespace arcway::internal::report
